//! What a study was made on: times mean nothing without it.

use luch_render::SimdLevel;
use serde::{Deserialize, Serialize};
use std::collections::HashSet;
use std::fs;

/// A machine and the program on it. What the system does not tell is `None`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// The processor's name.
    pub cpu: Option<String>,
    /// Its cores, two threads of one core counted once.
    pub cores: Option<u32>,
    /// Threads that it runs at the same time.
    pub hardware_threads: Option<u32>,
    /// Threads that this process may run at the same time.
    pub usable_threads: u32,
    /// Memory.
    pub memory_bytes: Option<u64>,
    /// The instruction set that was used.
    pub simd: String,
    /// The operating system.
    pub os: String,
    /// The processor's family, as `x86_64`.
    pub arch: String,
    /// The program's version.
    pub version: String,
    /// `release`, or `debug` for a build whose times say little.
    pub profile: String,
    /// How many threads of other programs wanted to run, in the mean of the minute before the study.
    pub load_before: Option<f64>,
}

impl Machine {
    /// This machine, with the instruction set that `simd` stands for on it.
    #[must_use]
    pub fn this(simd: SimdLevel) -> Self {
        let read = |path| fs::read_to_string(path).unwrap_or_default();
        let processor = Processor::of_cpuinfo(&read("/proc/cpuinfo"));
        let usable = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self {
            cpu: processor.name,
            cores: processor.cores,
            hardware_threads: processor.threads,
            usable_threads: u32::try_from(usable).unwrap_or(u32::MAX),
            memory_bytes: memory_of_meminfo(&read("/proc/meminfo")),
            simd: simd.resolved().word().to_owned(),
            os: os_name(&read("/etc/os-release"), &read("/proc/sys/kernel/osrelease")),
            arch: std::env::consts::ARCH.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            profile: if cfg!(debug_assertions) { "debug" } else { "release" }.to_owned(),
            load_before: read("/proc/loadavg").split_whitespace().next().and_then(|word| word.parse().ok()),
        }
    }

    /// How many threads can have a core of their own: more of them share.
    #[must_use]
    pub fn cores_for_threads(&self) -> u32 {
        self.cores.map_or(self.usable_threads, |cores| cores.min(self.usable_threads)).max(1)
    }
}

/// What Linux tells of the processor.
#[derive(Debug, Default, PartialEq)]
struct Processor {
    name: Option<String>,
    cores: Option<u32>,
    threads: Option<u32>,
}

impl Processor {
    fn of_cpuinfo(text: &str) -> Self {
        let values = |key: &'static str| {
            text.lines().filter_map(move |line| {
                let (name, value) = line.split_once(':')?;
                (name.trim() == key).then(|| value.trim())
            })
        };
        let count = |n: usize| u32::try_from(n).ok().filter(|n| *n > 0);
        let threads = count(values("processor").count());
        // A core is told by its number and the socket's; without sockets there is one.
        let mut sockets = values("physical id");
        let cores: HashSet<(&str, &str)> =
            values("core id").map(|core| (sockets.next().unwrap_or_default(), core)).collect();
        // 64-bit ARM names the maker in numbers only.
        let name = values("model name").chain(values("Model")).next().filter(|name| !name.is_empty());
        Self { name: name.map(str::to_owned), cores: count(cores.len()), threads }
    }
}

fn memory_of_meminfo(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix("MemTotal:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok()?.checked_mul(1024)
}

/// The name that the system gives itself, and its kernel's version.
fn os_name(release: &str, kernel: &str) -> String {
    let pretty = release.lines().find_map(|line| line.strip_prefix("PRETTY_NAME="));
    let pretty = pretty.map(|name| name.trim_matches('"')).filter(|name| !name.is_empty());
    let (name, kernel) = (pretty.unwrap_or(std::env::consts::OS), kernel.trim());
    if kernel.is_empty() { name.to_owned() } else { format!("{name}, {kernel}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_CORES_OF_TWO_THREADS: &str = "processor\t: 0\nmodel name\t: Some CPU @ 3 GHz: fast\nphysical id\t: 0\n\
        core id\t\t: 0\n\nprocessor\t: 1\nmodel name\t: Some CPU @ 3 GHz: fast\nphysical id\t: 0\ncore id\t\t: 1\n\n\
        processor\t: 2\nphysical id\t: 0\ncore id\t\t: 0\n\nprocessor\t: 3\nphysical id\t: 0\ncore id\t\t: 1\n";

    #[test]
    fn threads_of_one_core_are_one_core() {
        let processor = Processor::of_cpuinfo(TWO_CORES_OF_TWO_THREADS);
        let name = Some("Some CPU @ 3 GHz: fast".to_owned());
        assert_eq!(processor, Processor { name, cores: Some(2), threads: Some(4) });
        assert_eq!(Processor::of_cpuinfo("nonsense\n"), Processor::default());
        let two_sockets = "processor: 0\nphysical id: 0\ncore id: 0\nprocessor: 1\nphysical id: 1\ncore id: 0\n";
        assert_eq!(Processor::of_cpuinfo(two_sockets).cores, Some(2));
    }

    #[test]
    fn the_system_has_a_name() {
        assert_eq!(os_name("ID=x\nPRETTY_NAME=\"Some Linux 12\"\n", "6.1.0\n"), "Some Linux 12, 6.1.0");
        assert_eq!(os_name("", ""), std::env::consts::OS);
        assert_eq!(memory_of_meminfo("MemTotal:  2 kB\n"), Some(2048));
    }

    #[test]
    fn this_machine_runs_at_least_one_thread() {
        let machine = Machine::this(SimdLevel::Auto);
        assert!(machine.usable_threads >= 1 && machine.cores_for_threads() >= 1);
        assert_ne!(machine.simd, "auto");
        let many = Machine { cores: Some(12), usable_threads: 20, ..machine.clone() };
        assert_eq!(many.cores_for_threads(), 12);
        let few = Machine { cores: Some(12), usable_threads: 4, ..machine };
        assert_eq!(few.cores_for_threads(), 4, "a container may be given less than the machine has");
    }
}

//! The program at a terminal: a pseudo-terminal stands for it.

use super::program;
use rustix::process::{Pid, Signal, kill_process};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use std::fs::{File, OpenOptions};
use std::io::Read;
use std::os::unix::ffi::OsStringExt;
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// A run whose stderr is a terminal.
pub(crate) struct Session {
    child: Child,
    screen: File,
    seen: Vec<u8>,
    over: Arc<AtomicBool>,
}

impl Session {
    pub(crate) fn start(folder: &Path, args: &[&str], environment: &[(&str, &str)]) -> Self {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&master).unwrap();
        unlockpt(&master).unwrap();
        let name = ptsname(&master, Vec::new()).unwrap();
        let name = std::ffi::OsString::from_vec(name.into_bytes());
        let slave = OpenOptions::new().read(true).write(true).open(name).unwrap();
        let mut command = program(folder, args);
        command.env("TERM", "xterm").envs(environment.iter().copied()).stdout(Stdio::piped()).stderr(slave);
        let child = command.spawn().unwrap();
        let over = Arc::new(AtomicBool::new(false));
        let session = Self { child, screen: File::from(master), seen: Vec::new(), over };
        session.guard();
        session
    }

    /// Reads the screen until it has shown one of the words; `false` if the program ended first.
    pub(crate) fn wait_for(&mut self, words: &[&str]) -> bool {
        let mut piece = [0; 4096];
        loop {
            if words.iter().any(|word| self.text().contains(word)) {
                return true;
            }
            match self.screen.read(&mut piece) {
                // Linux answers with an error when the last reader of the other side has gone.
                Ok(0) | Err(_) => return false,
                Ok(count) => self.seen.extend(&piece[..count]),
            }
        }
    }

    pub(crate) fn signal(&self, signal: Signal) {
        let _ = kill_process(self.pid(), signal);
    }

    /// Waits for the end; answers with the exit code, what the screen showed and what stdout got.
    pub(crate) fn end(mut self) -> (i32, String, String) {
        self.wait_for(&["\0 never shown"]);
        let mut stdout = String::new();
        self.child.stdout.take().unwrap().read_to_string(&mut stdout).unwrap();
        let status = self.child.wait().unwrap();
        self.over.store(true, Ordering::Relaxed);
        (status.code().unwrap_or(-1), self.text(), stdout)
    }

    /// The names of the program's threads.
    #[cfg(target_os = "linux")]
    pub(crate) fn thread_names(&self) -> Vec<String> {
        let tasks = std::fs::read_dir(format!("/proc/{}/task", self.child.id())).unwrap();
        tasks.filter_map(|task| std::fs::read_to_string(task.ok()?.path().join("comm")).ok()).collect()
    }

    fn text(&self) -> String {
        String::from_utf8_lossy(&self.seen).into_owned()
    }

    fn pid(&self) -> Pid {
        Pid::from_child(&self.child)
    }

    /// Kills a program that hangs, so that the test fails instead of hanging too.
    fn guard(&self) {
        let (pid, over) = (self.pid(), Arc::clone(&self.over));
        std::thread::Builder::new()
            .name("guard".to_owned())
            .spawn(move || {
                std::thread::sleep(Duration::from_secs(120));
                if !over.load(Ordering::Relaxed) {
                    let _ = kill_process(pid, Signal::KILL);
                }
            })
            .unwrap();
    }
}

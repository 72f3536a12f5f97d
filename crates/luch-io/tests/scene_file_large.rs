//! Large scene files: in seconds, within a gigabyte, and hostile ones without a crash.
//!
//! One test after the other, for the peak of memory is the process's.

#![allow(clippy::print_stdout, reason = "figures, for who asks with --nocapture")]

use luch_io::{Error, ErrorKind, Report, parse_scene, read_scene};
use luch_scene::Scene;
use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

fn parse(text: &str) -> Result<Scene, Error> {
    let mut no_mesh = |_: &str, _: &mut Report| panic!("no mesh is named");
    parse_scene(text.as_bytes(), Path::new("large.toml"), &mut no_mesh, &mut Report::default())
}

/// The time that this process computed, where the system tells: a machine that is busy elsewhere must not fail the test.
struct Stopwatch(Duration, Instant);

impl Stopwatch {
    fn start() -> Self {
        Self(computed().unwrap_or_default(), Instant::now())
    }

    fn elapsed(&self) -> Duration {
        computed().map_or_else(|| self.1.elapsed(), |now| now - self.0)
    }
}

fn computed() -> Option<Duration> {
    let status = std::fs::read_to_string("/proc/self/stat").ok()?;
    // Behind the name in brackets: state is the third field of the line, user and system time the 14th and 15th.
    let fields: Vec<&str> = status.rsplit_once(')')?.1.split_whitespace().collect();
    let ticks = fields.get(11)?.parse::<u64>().ok()? + fields.get(12)?.parse::<u64>().ok()?;
    Some(Duration::from_millis(ticks * 10))
}

/// The most memory that the process ever held, in bytes, where the system tells.
fn peak_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? << 10)
}

fn a_million_objects_are_read_in_seconds() {
    const OBJECTS: usize = 1_000_000;
    let mut text = String::from("luch = 1\n[[light]]\nposition = [0, 9, 0]\n");
    for i in 0..OBJECTS {
        let (x, z) = (i % 1000, i / 1000);
        // Every second object has a name of its own; the others get one.
        let name = if i % 2 == 0 { format!("name = \"Ball {i}\"\n") } else { String::new() };
        writeln!(
            text,
            "\n[[object]]\n{name}sphere = {{ center = [{x}.5, 1, {z}.5], radius = 0.4 }}\ncolor = \"#c83232\""
        )
        .unwrap();
    }
    let start = Stopwatch::start();
    let scene = parse(&text).unwrap();
    let read = start.elapsed();
    println!(
        "{OBJECTS} objects, {} MB: {read:?}, peak {:?} bytes with the text",
        text.len() / 1_000_000,
        peak_memory()
    );
    assert_eq!(scene.objects.len(), OBJECTS);
    assert_eq!(scene.objects[999_999].name, "Sphere 500000");
    assert!(read < Duration::from_secs(10), "{read:?}");
    if let Some(peak) = peak_memory() {
        assert!(peak < 1 << 30, "{peak} bytes");
    }
    let start = Stopwatch::start();
    let written = luch_io::write_scene(&scene);
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
    assert!(written.len() > OBJECTS * 80);
}

fn hostile_texts_end_with_an_error_soon() {
    let million = 1_000_000;
    let sections = |text: &str| format!("luch = 1\n{}", text.repeat(million));
    for (what, text, kind) in [
        ("open brackets", format!("luch = 1\nname = {}", "[".repeat(40 * million)), ErrorKind::Limit),
        ("open brackets in a section", format!("luch = 1\nname = {}", "[".repeat(2 * million)), ErrorKind::Malformed),
        ("open braces", format!("luch = 1\nname = {}", "{a=".repeat(600_000)), ErrorKind::Malformed),
        ("a dotted key", format!("luch = 1\na{} = 1", ".a".repeat(million)), ErrorKind::Malformed),
        ("a dotted header", format!("luch = 1\n[a{}]", ".a".repeat(million)), ErrorKind::Malformed),
        ("a long key", format!("luch = 1\n{} = 1", "a".repeat(2 * million)), ErrorKind::Malformed),
        ("a long name", format!("luch = 1\nname = \"{}\"", "a".repeat(2 * million)), ErrorKind::Malformed),
        ("a long number", format!("luch = 1\nambient = {}", "9".repeat(2 * million)), ErrorKind::Malformed),
        ("a long list", format!("luch = 1\nbackground = [{}]", "1,".repeat(million)), ErrorKind::Malformed),
        ("an open string", format!("luch = 1\nname = \"\"\"{}", "a\n".repeat(20 * million)), ErrorKind::Limit),
        (
            "many keys",
            {
                let keys: String = (0..150_000).fold(String::new(), |text, i| text + &format!("k{i} = 1\n"));
                format!("luch = 1\n{keys}")
            },
            ErrorKind::Malformed,
        ),
        ("many unknown tables", sections("[x]\n"), ErrorKind::Malformed),
        ("many empty objects", sections("[[object]]\n"), ErrorKind::Malformed),
        ("many renders", sections("[render]\n"), ErrorKind::Malformed),
        (
            "many tables of one object",
            format!("luch = 1\n[[object]]\n{}", "[object.a]\n".repeat(150_000)),
            ErrorKind::Malformed,
        ),
        ("quotes", format!("luch = 1\n{}", "\"".repeat(2 * million)), ErrorKind::Malformed),
    ] {
        let start = Stopwatch::start();
        let error = parse(&text).unwrap_err();
        let took = start.elapsed();
        println!("{what}: {took:?}");
        assert_eq!(error.kind, kind, "{what}: {}", error.text);
        assert!(error.to_string().len() < 4_000, "{what}: {} bytes of error", error.to_string().len());
        assert!(took < Duration::from_secs(10), "{what}: {took:?}");
    }
    // A million comments are no reason to refuse anything.
    assert!(parse(&format!("luch = 1\n[render]\n{}", "# x\n".repeat(million / 2 - 100))).is_ok());
    if let Some(peak) = peak_memory() {
        println!("peak {peak} bytes");
        assert!(peak < 1 << 30, "{peak} bytes");
    }
}

fn a_file_above_the_limit_is_refused_before_it_is_read() {
    let path = std::env::temp_dir().join(format!("luch-large-{}.toml", std::process::id()));
    // A file with a hole: it has the size, but not on the disk.
    std::fs::File::create(&path).unwrap().set_len((256 << 20) + 1).unwrap();
    let start = Stopwatch::start();
    let error = read_scene(&path, &mut |_, _| panic!("no mesh"), &mut Report::default()).unwrap_err();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(error.kind, ErrorKind::Limit, "{error}");
    assert!(start.elapsed() < Duration::from_secs(1));
}

#[test]
fn large_files() {
    a_million_objects_are_read_in_seconds();
    hostile_texts_end_with_an_error_soon();
    a_file_above_the_limit_is_refused_before_it_is_read();
}

//! A save leaves the old file or the new one, never a part of either.

use luch_io::atomic_save::save;
use luch_io::{Error, ErrorKind};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder of its own for a test, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let n = NEXT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("luch-atomic-save-{}-{n}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// The names in the folder: a stale temporary file would be one of them.
    fn names(&self) -> Vec<String> {
        let mut names: Vec<String> =
            fs::read_dir(&self.0).unwrap().map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn write_text(path: &Path, text: &str) -> Result<(), Error> {
    save(path, |out| out.write_all(text.as_bytes()))
}

fn refused(path: &Path) -> Error {
    let error = write_text(path, "new").unwrap_err();
    assert_eq!((error.kind, error.exit_code(), error.file.as_path()), (ErrorKind::Output, 6, path));
    error
}

#[test]
fn a_file_is_made_and_replaced() {
    let folder = Folder::new();
    let file = folder.file("картина №1.png");
    write_text(&file, "first").unwrap();
    write_text(&file, "second, and longer").unwrap();
    assert_eq!(fs::read_to_string(&file).unwrap(), "second, and longer");
    assert_eq!(folder.names().len(), 1);
}

#[test]
fn a_write_that_fails_at_any_moment_leaves_the_old_file_and_nothing_else() {
    let folder = Folder::new();
    let file = folder.file("a.png");
    write_text(&file, "old").unwrap();
    for fail_after in 0..6 {
        let error = save(&file, |out| {
            for part in 0..6 {
                if part == fail_after {
                    return Err(io::Error::other("the pipe of the test is cut"));
                }
                // More than is buffered, so that a part of it is in the file by then.
                out.write_all(&vec![b'x'; 300 << 10])?;
            }
            Ok(())
        })
        .unwrap_err();
        assert_eq!(error.to_string(), format!("{}: cannot be written: the pipe of the test is cut", file.display()));
        assert_eq!(fs::read_to_string(&file).unwrap(), "old");
        assert_eq!(folder.names(), ["a.png"]);
    }
}

#[test]
fn a_panic_while_writing_leaves_the_old_file_and_nothing_else() {
    let folder = Folder::new();
    let file = folder.file("a.png");
    write_text(&file, "old").unwrap();
    let path = file.clone();
    let worker = std::thread::Builder::new().name("panics".into());
    let joined = worker.spawn(move || save(&path, |_| panic!("for the test"))).unwrap().join();
    assert!(joined.is_err());
    assert_eq!((fs::read_to_string(&file).unwrap().as_str(), folder.names().len()), ("old", 1));
}

#[test]
fn many_savers_of_one_name_leave_one_of_their_files_whole() {
    let folder = Folder::new();
    let file = folder.file("a.png");
    std::thread::scope(|scope| {
        for letter in ["a", "b", "c", "d"] {
            let file = &file;
            scope.spawn(move || {
                for _ in 0..25 {
                    write_text(file, &letter.repeat(100_000)).unwrap();
                    let read = fs::read_to_string(file).unwrap();
                    assert_eq!(read.len(), 100_000);
                    assert!(read.bytes().all(|b| b == read.as_bytes()[0]));
                }
            });
        }
    });
    assert_eq!(folder.names(), ["a.png"]);
}

#[test]
fn folders_missing_folders_and_wrong_paths_are_refused() {
    let folder = Folder::new();
    fs::create_dir(folder.file("dir")).unwrap();
    fs::write(folder.file("file"), "x").unwrap();
    assert!(refused(&folder.file("dir")).text.starts_with("is a folder"));
    let missing = refused(&folder.file("none/a.png"));
    assert!(missing.text.starts_with("there is no folder") && missing.text.ends_with("none"), "{missing}");
    assert!(refused(&folder.file("file/a.png")).text.contains("no folder"));
    assert!(refused(&folder.0.join("..")).text.starts_with("is a folder"));
    assert!(refused(Path::new("")).text.contains("no file name"));
    assert!(refused(&folder.file(&"x".repeat(300))).text.contains("too long"));
    assert_eq!(folder.names(), ["dir", "file"]);
}

#[test]
fn the_longest_name_that_the_disk_takes_is_written() {
    let folder = Folder::new();
    let file = folder.file(&format!("{}.png", "x".repeat(251)));
    write_text(&file, "new").unwrap();
    assert_eq!(folder.names().len(), 1);
}

#[test]
fn a_read_only_file_is_refused_and_kept() {
    let folder = Folder::new();
    let file = folder.file("a.png");
    write_text(&file, "old").unwrap();
    let mut permissions = fs::metadata(&file).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(&file, permissions).unwrap();
    assert!(refused(&file).text.starts_with("is read-only"));
    assert_eq!(fs::read_to_string(&file).unwrap(), "old");
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};

    #[test]
    fn the_permissions_of_the_old_file_are_kept() {
        let folder = Folder::new();
        let file = folder.file("a.png");
        write_text(&file, "old").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        write_text(&file, "new").unwrap();
        assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    }

    #[test]
    fn a_link_is_written_through_and_stays_a_link() {
        let folder = Folder::new();
        fs::create_dir(folder.file("real")).unwrap();
        fs::write(folder.file("real/a.png"), "old").unwrap();
        symlink("real/a.png", folder.file("one")).unwrap();
        symlink("one", folder.file("two")).unwrap();
        symlink("real/new.png", folder.file("dangling")).unwrap();
        write_text(&folder.file("two"), "new").unwrap();
        write_text(&folder.file("dangling"), "made").unwrap();
        assert_eq!(fs::read_to_string(folder.file("real/a.png")).unwrap(), "new");
        assert_eq!(fs::read_to_string(folder.file("real/new.png")).unwrap(), "made");
        assert!(fs::symlink_metadata(folder.file("two")).unwrap().is_symlink());
        assert!(fs::symlink_metadata(folder.file("one")).unwrap().is_symlink());
        assert_eq!(folder.names(), ["dangling", "one", "real", "two"]);
    }

    #[test]
    fn a_loop_of_links_ends() {
        let folder = Folder::new();
        symlink("b", folder.file("a")).unwrap();
        symlink("a", folder.file("b")).unwrap();
        assert!(refused(&folder.file("a")).text.contains("loop"));
    }

    /// Makes a pipe or device in the test's own folder. The system's own `/dev/null` is no place to test this: as root, a
    /// save gone wrong would replace it for everybody.
    fn make(folder: &Folder, name: &str, options: &[&str]) -> Option<PathBuf> {
        let path = folder.file(name);
        let status = std::process::Command::new("mknod").arg(&path).args(options).output();
        status.is_ok_and(|o| o.status.success()).then_some(path)
    }

    #[test]
    fn a_pipe_is_written_to_and_not_replaced() {
        use std::os::unix::fs::FileTypeExt;
        let folder = Folder::new();
        let Some(pipe) = make(&folder, "pipe", &["p"]) else { return };
        let read = std::thread::scope(|scope| {
            let reader = scope.spawn(|| fs::read_to_string(&pipe).unwrap());
            write_text(&pipe, "through").unwrap();
            reader.join().unwrap()
        });
        assert_eq!(read, "through");
        assert!(fs::metadata(&pipe).unwrap().file_type().is_fifo());
        assert_eq!(folder.names(), ["pipe"]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_device_is_told_and_not_replaced() {
        let folder = Folder::new();
        // Only root makes devices, and not everywhere may they be opened.
        let Some(full) = make(&folder, "full", &["c", "1", "7"]) else { return };
        if fs::File::open(&full).is_err() {
            return;
        }
        assert_eq!(refused(&full).text, "cannot be written: the disk is full");
        assert!(!fs::metadata(&full).unwrap().is_file());
    }

    /// Mounts a disk of its own where the test may (as root on Linux); elsewhere there is nothing to test.
    #[cfg(target_os = "linux")]
    #[test]
    fn full_and_read_only_disks_leave_the_old_file() {
        use std::process::Command;
        let folder = Folder::new();
        let mount = |options: &str| {
            let status =
                Command::new("mount").args(["-t", "tmpfs", "-o", options, "luch-test"]).arg(&folder.0).output();
            status.is_ok_and(|o| o.status.success())
        };
        if !mount("size=1m") {
            return;
        }
        let file = folder.file("a.png");
        write_text(&file, "old").unwrap();
        let error = save(&file, |out| out.write_all(&vec![0; 3 << 20])).unwrap_err();
        let full = (error.text, fs::read_to_string(&file).unwrap(), folder.names());
        let read_only = mount("remount,ro").then(|| (refused(&file).text, fs::read_to_string(&file).unwrap()));
        // Unmounted before anything is asserted, so that a failure leaves no mount behind.
        let unmounted = Command::new("umount").arg(&folder.0).status().unwrap();
        assert!(unmounted.success());
        assert_eq!(full, ("cannot be written: the disk is full".into(), "old".into(), vec!["a.png".into()]));
        if let Some(read_only) = read_only {
            assert_eq!(read_only, ("cannot be written: the disk is read-only".into(), "old".into()));
        }
    }
}

//! The meshes of the program, shared with the threads that read and write files.

use luch_io::library::MeshLibrary;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};

/// The meshes that were read. Who looks where a mesh lies never waits for a file that is being read.
#[derive(Debug, Clone, Default)]
pub(crate) struct Library {
    meshes: Arc<Mutex<MeshLibrary>>,
    reading: Arc<Mutex<()>>,
}

impl Library {
    /// Reads files. One thread does at a time, so that no file is read twice.
    pub(crate) fn read<R>(&self, read: impl FnOnce(&mut MeshLibrary) -> R) -> R {
        let _one = self.reading.lock().unwrap_or_else(PoisonError::into_inner);
        let mut known = {
            let mut meshes = self.lock();
            meshes.forget_unused();
            meshes.clone()
        };
        let result = read(&mut known);
        self.lock().absorb(known);
        result
    }

    /// What is known of the meshes.
    pub(crate) fn lock(&self) -> MutexGuard<'_, MeshLibrary> {
        self.meshes.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The same without waiting; `None` if somebody else has it.
    pub(crate) fn try_lock(&self) -> Option<MutexGuard<'_, MeshLibrary>> {
        match self.meshes.try_lock() {
            Ok(meshes) => Some(meshes),
            Err(TryLockError::Poisoned(poisoned)) => Some(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_io::Report;
    use luch_io::budget::Budget;
    use std::sync::mpsc::sync_channel;
    use std::thread;

    #[test]
    fn a_long_read_keeps_nobody_from_looking_and_leaves_what_it_read() {
        let library = Library::default();
        let folder = std::env::temp_dir().join(format!("luch-library-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let model = folder.join("a.obj");
        std::fs::write(&model, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let (begun, begins) = sync_channel(0);
        let (go_on, goes_on) = sync_channel::<()>(0);
        let (reader, path) = (library.clone(), model.clone());
        let reading = move || {
            reader.read(|meshes| {
                begun.send(()).unwrap();
                goes_on.recv().unwrap();
                luch_io::load_model(&path, meshes, &mut Budget::default(), &mut Report::default()).unwrap().mesh
            })
        };
        let read = thread::Builder::new().name("reader".into()).spawn(reading).unwrap();
        begins.recv().unwrap();
        // This would wait for ever if the reader had the meshes.
        drop(library.lock());
        assert!(library.try_lock().is_some());
        go_on.send(()).unwrap();
        let first = read.join().unwrap();
        let second = library.read(|meshes| {
            luch_io::load_model(&model, meshes, &mut Budget::default(), &mut Report::default()).unwrap().mesh
        });
        assert_eq!(first.id(), second.id(), "it was not read again");
        std::fs::remove_dir_all(&folder).unwrap();
    }
}

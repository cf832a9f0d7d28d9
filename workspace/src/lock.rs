//! A file that only one run may use at a time.
//!
//! A run that uses `plant.retain` holds a lock on `.plant.retain.lock` next to it: the file itself is replaced with each
//! save, and a lock would go with it. The operating system releases it however the process ends; what then stays is an empty
//! file, which the next run takes over and removes.

use crate::error::{FileError, Problem};
use crate::regular;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

/// Tries so often to lock a file that others remove at the same moment.
const TRIES: usize = 100;

/// The lock, until it is dropped.
#[derive(Debug)]
pub(crate) struct Lock {
    _file: File,
    /// The file that is removed with it.
    lock_file: Option<PathBuf>,
}

impl Lock {
    /// Locks a file, which need not be there.
    pub(crate) fn of(path: &Path) -> Result<Option<Lock>, FileError> {
        let lock_file = name(path);
        for _ in 0..TRIES {
            let file = match open(&lock_file) {
                Ok(file) => file,
                Err(error) if is_refused(&error) => return Lock::on_itself(path),
                Err(error) => return Err(FileError::writing(path, error)),
            };
            lock(&file, path)?;
            // Who held it before has perhaps removed it meanwhile.
            if is_the_one_at(&file, &lock_file) {
                return Ok(Some(Lock {
                    _file: file,
                    lock_file: Some(lock_file),
                }));
            }
        }
        Err(FileError::new(path, Problem::InUse))
    }

    /// In a folder that takes no new file, the file is written in its place and stays the one that it is.
    fn on_itself(path: &Path) -> Result<Option<Lock>, FileError> {
        if !path.exists() {
            return Ok(None);
        }
        let (file, _) = regular::open_regular(path, File::options().read(true))?;
        lock(&file, path)?;
        Ok(Some(Lock {
            _file: file,
            lock_file: None,
        }))
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        if let Some(lock_file) = &self.lock_file {
            let _ = fs::remove_file(lock_file);
        }
    }
}

fn lock(file: &File, path: &Path) -> Result<(), FileError> {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Err(FileError::new(path, Problem::InUse)),
        // A file system that knows no locks.
        Ok(()) | Err(TryLockError::Error(_)) => Ok(()),
    }
}

fn name(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.lock"))
}

/// Opens the file for the lock, without following a link and without waiting for a pipe. One that holds something is
/// another user's, and is not used.
fn open(lock_file: &Path) -> io::Result<File> {
    let mut options = File::options();
    options.read(true).write(true);
    #[cfg(unix)]
    {
        use rustix::fs::OFlags;
        use std::os::unix::fs::OpenOptionsExt;
        options.custom_flags((OFlags::NOFOLLOW | OFlags::NONBLOCK).bits() as i32);
    }
    let file = options.create(true).truncate(false).open(lock_file)?;
    let metadata = file.metadata()?;
    if metadata.is_file() && metadata.len() == 0 {
        return Ok(file);
    }
    Err(io::Error::other(format!(
        "{} should be an empty file, and is something else",
        crate::shown::path(lock_file)
    )))
}

fn is_refused(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem
    )
}

fn is_the_one_at(file: &File, path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let same = |a: &fs::Metadata, b: &fs::Metadata| (a.dev(), a.ino()) == (b.dev(), b.ino());
        match (file.metadata(), fs::symlink_metadata(path)) {
            (Ok(held), Ok(there)) => same(&held, &there),
            _ => false,
        }
    }
    #[cfg(not(unix))]
    {
        let _ = (file, path);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_at_a_time() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plant.retain");
        let first = Lock::of(&path).unwrap().unwrap();
        let refused = Lock::of(&path).unwrap_err();
        assert!(matches!(refused.problem, Problem::InUse), "{refused}");
        // What a killed process leaves.
        drop(first);
        File::create(name(&path)).unwrap();
        drop(Lock::of(&path).unwrap().unwrap());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn many_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plant.retain");
        let inside = std::sync::atomic::AtomicUsize::new(0);
        std::thread::scope(|scope| {
            for _ in 0..8 {
                scope.spawn(|| {
                    for _ in 0..200 {
                        if let Ok(lock) = Lock::of(&path) {
                            let others = inside.fetch_add(1, std::sync::atomic::Ordering::SeqCst);
                            assert_eq!(others, 0);
                            inside.fetch_sub(1, std::sync::atomic::Ordering::SeqCst);
                            drop(lock);
                        }
                    }
                });
            }
        });
    }

    #[test]
    fn what_holds_something_is_not_ours() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plant.retain");
        fs::write(name(&path), "mine").unwrap();
        let refused = Lock::of(&path).unwrap_err().to_string();
        assert!(
            refused.contains(".plant.retain.lock should be an empty file"),
            "{refused}"
        );
        assert_eq!(fs::read_to_string(name(&path)).unwrap(), "mine");
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("plant.retain");
        std::os::unix::fs::symlink("elsewhere", name(&path)).unwrap();
        assert!(Lock::of(&path).is_err());
        assert!(!folder.path().join("elsewhere").exists());
    }
}

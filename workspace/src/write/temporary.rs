//! A file under a temporary name, `.motor.clad.ladder-tmp`, until it is renamed.
//!
//! The name follows from that of the target, and the file is locked while it is in use. So what a process leaves behind
//! that was killed is found, and removed, by the next one that writes the same file.

use super::folder_of;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// This many processes may write one file at once.
const MOST: usize = 16;
/// A file that is not locked and that is so old was left behind. A younger one may be about to be locked.
const STALE: Duration = Duration::from_secs(60);

/// The file; it is removed when it is dropped.
#[derive(Debug)]
pub(super) struct Temporary {
    file: File,
    /// None once it has its true name.
    path: Option<PathBuf>,
}

impl Temporary {
    /// A new file. `private`: no other user may read it yet.
    pub(super) fn new(target: &Path, private: bool) -> io::Result<Temporary> {
        take_name(target, |path| {
            let mut options = File::options();
            options.read(true).write(true).create_new(true);
            #[cfg(unix)]
            {
                use std::os::unix::fs::OpenOptionsExt;
                options.mode(if private { 0o600 } else { 0o666 });
            }
            #[cfg(not(unix))]
            let _ = private;
            let file = options.open(path)?;
            // Where there are no locks, age alone says what was left behind.
            let _ = file.try_lock();
            Ok(file)
        })
    }

    /// Names a file that has no name.
    #[cfg(target_os = "linux")]
    pub(super) fn named(file: File, target: &Path) -> io::Result<Temporary> {
        use rustix::fs::{AtFlags, CWD, linkat};
        use std::os::fd::AsRawFd;
        let _ = file.try_lock();
        let nameless = format!("/proc/self/fd/{}", file.as_raw_fd());
        let named = take_name(target, |path| {
            linkat(CWD, nameless.as_str(), CWD, path, AtFlags::SYMLINK_FOLLOW)?;
            file.try_clone()
        })?;
        Ok(named)
    }

    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Puts it in the target's place.
    pub(super) fn rename(mut self, target: &Path) -> io::Result<()> {
        if let Some(path) = &self.path {
            fs::rename(path, target)?;
        }
        self.path = None;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            let _ = fs::remove_file(path);
        }
    }
}

/// Makes the file under the first free name.
fn take_name(target: &Path, make: impl Fn(&Path) -> io::Result<File>) -> io::Result<Temporary> {
    let mut taken = None;
    for number in 0..MOST {
        let path = name(target, number);
        let made = match make(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                remove_stale(&path);
                make(&path)
            }
            made => made,
        };
        match made {
            Ok(file) => {
                return Ok(Temporary {
                    file,
                    path: Some(path),
                });
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => taken = Some(error),
            Err(error) => return Err(error),
        }
    }
    Err(taken.unwrap_or_else(|| io::ErrorKind::AlreadyExists.into()))
}

fn name(target: &Path, number: usize) -> PathBuf {
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    // The names of most file systems end after 255 bytes.
    let name: String = name.chars().take(50).collect();
    let number = match number {
        0 => String::new(),
        number => format!(".{number}"),
    };
    folder_of(target).join(format!(".{name}.ladder-tmp{number}"))
}

/// Removes a file that a process left behind, if that is what it is.
fn remove_stale(path: &Path) {
    let Ok(metadata) = path.symlink_metadata() else {
        return;
    };
    let age = metadata.modified().ok().and_then(|at| at.elapsed().ok());
    if !metadata.is_file() || age.is_none_or(|age| age < STALE) {
        return;
    }
    let Ok(file) = File::options().read(true).open(path) else {
        return;
    };
    if file.try_lock().is_ok() {
        let _ = fs::remove_file(path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs::FileTimes;
    use std::time::SystemTime;

    fn names(folder: &Path) -> Vec<String> {
        let names = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> = names
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// As a process leaves it that is killed: unlocked, and a while ago.
    fn abandoned(path: &Path) {
        let file = File::create(path).unwrap();
        let then = SystemTime::now() - STALE * 2;
        file.set_times(FileTimes::new().set_modified(then)).unwrap();
    }

    #[test]
    fn what_a_killed_process_left_is_removed_by_the_next() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.clad");
        abandoned(&name(&target, 0));
        let temporary = Temporary::new(&target, true).unwrap();
        assert_eq!(names(folder.path()), [".a.clad.ladder-tmp"]);
        let written = temporary.file().metadata().unwrap().modified().unwrap();
        assert!(written.elapsed().unwrap() < STALE);
        temporary.rename(&target).unwrap();
        assert_eq!(names(folder.path()), ["a.clad"]);
    }

    #[test]
    fn one_that_is_in_use_is_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.clad");
        let first = Temporary::new(&target, true).unwrap();
        // However long it takes.
        let then = SystemTime::now() - STALE * 2;
        first
            .file()
            .set_times(FileTimes::new().set_modified(then))
            .unwrap();
        let second = Temporary::new(&target, true).unwrap();
        assert_eq!(
            names(folder.path()),
            [".a.clad.ladder-tmp", ".a.clad.ladder-tmp.1"]
        );
        drop((first, second));
        assert!(names(folder.path()).is_empty());
    }

    #[test]
    fn long_names() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("ö".repeat(120));
        Temporary::new(&target, false).unwrap().rename(&target).unwrap();
        assert!(target.is_file());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_without_a_name_gets_one() {
        use rustix::fs::{Mode, OFlags, open};
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.clad");
        abandoned(&name(&target, 0));
        let flags = OFlags::TMPFILE | OFlags::RDWR;
        let Ok(file) = open(folder.path(), flags, Mode::from_raw_mode(0o600)) else {
            eprintln!(
                "skipped: the file system of {} knows no files without a name",
                folder.path().display()
            );
            return;
        };
        let temporary = Temporary::named(File::from(file), &target).unwrap();
        assert_eq!(names(folder.path()), [".a.clad.ladder-tmp"]);
        temporary.rename(&target).unwrap();
        assert_eq!(names(folder.path()), ["a.clad"]);
    }
}

//! The disk of the operating system.

use super::{Disk, Keeper};
use crate::error::{FileError, Problem};
use crate::lock::Lock;
use crate::named::{self, Named};
use crate::root::Root;
use crate::search::{self, Survey};
use crate::settings::Files;
use crate::stamp::Stamp;
use crate::write::write;
use crate::{regular, text};
use ladder_analysis::Cancel;
use ladder_syntax::MAX_FILE_BYTES;
use std::fs::{self, File};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, Instant};

/// Whether a file is free is asked again after this time.
const AGAIN: Duration = Duration::from_millis(20);

/// The disk of the operating system.
#[derive(Debug, Clone, Copy, Default)]
pub struct SystemDisk;

impl Disk for SystemDisk {
    fn root_of(&self, program: &Path) -> io::Result<Root> {
        Root::of(program)
    }

    fn stamp(&self, file: &Path) -> Stamp {
        Stamp::of(file)
    }

    fn is_there(&self, path: &Path) -> bool {
        path.symlink_metadata().is_ok()
    }

    fn is_file(&self, path: &Path) -> bool {
        path.is_file()
    }

    fn is_whole(&self, path: &Path) -> bool {
        path.is_absolute()
    }

    fn is_link(&self, path: &Path) -> bool {
        path.is_symlink()
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        path.canonicalize()
    }

    fn names_in(&self, folder: &Path, most: usize) -> Vec<String> {
        let entries = fs::read_dir(folder).into_iter().flatten();
        let names = entries.take(most).flatten();
        names
            .filter_map(|entry| entry.file_name().into_string().ok())
            .collect()
    }

    fn read(&self, file: &Path) -> Result<String, FileError> {
        text::read(file)
    }

    fn read_own(&self, file: &Path) -> Result<String, FileError> {
        named::read_own(file)
    }

    fn locate(&self, file: &Named) -> Result<PathBuf, FileError> {
        file.locate()
    }

    fn read_named(&self, file: &Named) -> Result<Vec<u8>, FileError> {
        file.read_bytes()
    }

    fn programs(&self, root: &Root, files: &Files) -> Vec<PathBuf> {
        root.programs(files)
    }

    fn holds(&self, root: &Root, program: &Path, files: &Files) -> bool {
        root.holds(program, files)
    }

    fn companions(&self, folders: &[PathBuf]) -> Vec<PathBuf> {
        search::find_files(folders, &search::is_companion).0
    }

    fn survey(&self, folder: &Path, most: usize, cancel: &Cancel) -> Survey {
        search::survey(folder, most, cancel)
    }

    fn files_below(&self, folder: &Path, most: usize) -> Vec<PathBuf> {
        search::files_below(folder, most)
    }

    fn read_below(&self, folder: &Path, file: &Path) -> Result<Vec<u8>, FileError> {
        named::read_below(folder, file)
    }

    fn keeper(&self, file: &Named) -> Result<Box<dyn Keeper>, FileError> {
        Ok(Box::new(KeptFile::at(&file.locate()?)))
    }
}

/// A file that keeps values, with the lock on it.
#[derive(Debug)]
pub(crate) struct KeptFile {
    path: PathBuf,
    lock: Option<Lock>,
}

impl KeptFile {
    pub(crate) fn at(path: &Path) -> KeptFile {
        KeptFile {
            path: path.to_owned(),
            lock: None,
        }
    }
}

impl Keeper for KeptFile {
    fn path(&self) -> &Path {
        &self.path
    }

    fn read(&self) -> Result<Option<Vec<u8>>, FileError> {
        let file = match regular::open_plain(&self.path, File::options().read(true)) {
            Ok((file, _)) => file,
            Err(FileError {
                problem: Problem::Missing,
                ..
            }) => return Ok(None),
            Err(error) => return Err(error),
        };
        let mut bytes = Vec::new();
        file.take(MAX_FILE_BYTES as u64)
            .read_to_end(&mut bytes)
            .map_err(|error| FileError::reading(&self.path, error))?;
        Ok(Some(bytes))
    }

    fn lock(&mut self, patience: Duration) -> Result<(), FileError> {
        let begun = Instant::now();
        self.lock = loop {
            match Lock::of(&self.path) {
                Err(error) if matches!(error.problem, Problem::InUse) && begun.elapsed() < patience => {
                    thread::sleep(AGAIN);
                }
                locked => break locked?,
            }
        };
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), FileError> {
        write(&self.path, bytes)
    }

    fn put_aside(&mut self) -> Result<PathBuf, FileError> {
        let path = &*self.path;
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        for number in 1.. {
            let aside = path.with_file_name(match number {
                1 => format!("{name}.damaged"),
                _ => format!("{name}.damaged.{number}"),
            });
            if fs::symlink_metadata(&aside).is_ok() {
                continue;
            }
            // A second name first: unlike a renaming it takes the place of nothing that came there meanwhile.
            let moved = match fs::hard_link(path, &aside) {
                Ok(()) => fs::remove_file(path),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => continue,
                Err(_) => fs::rename(path, &aside),
            };
            return match moved {
                Ok(()) => Ok(aside),
                Err(error) => Err(FileError::writing(&aside, error)),
            };
        }
        Err(FileError::new(path, Problem::ReadOnly))
    }
}

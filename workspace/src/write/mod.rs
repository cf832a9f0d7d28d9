//! Putting a new text in a file's place in one step.
//!
//! ```text
//! a file of its own, or a new one     a new file without a name, then the name     next to
//! one of several names, or of another
//! owner, or in a folder that takes
//! no new file                         a backup, then over the old bytes            in_place
//! a device, a pipe                    straight through
//! ```

mod in_place;
mod new_file;
mod temporary;

use crate::error::{FileError, Problem};
use in_place::InPlace;
use new_file::NewFile;
use std::fs::{self, File, Metadata};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a file, all of it or nothing: see [`Replacement::of`].
///
/// # Errors
/// As for a [`Replacement`].
pub fn write(path: &Path, content: &[u8]) -> Result<(), FileError> {
    Replacement::of(path)?.filled(content)
}

/// Writes a file that a command makes, likewise: see [`Replacement::made`].
///
/// # Errors
/// As for a [`Replacement`].
pub fn write_made(path: &Path, content: &[u8]) -> Result<(), FileError> {
    Replacement::made(path)?.filled(content)
}

/// What becomes of a link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Links {
    Followed,
    Replaced,
}

/// A new content for a file. The old one is there until [`commit`](Replacement::commit), and stays if that is
/// never called; then the new one is on the disk, not only on its way there. An existing file keeps its mode, its owner
/// and its other names (hard links). What is not a file (a pipe,
/// `/dev/stdout`) is written to as it is.
#[derive(Debug)]
pub struct Replacement {
    path: PathBuf,
    sink: Sink,
}

#[derive(Debug)]
enum Sink {
    /// A new file, which takes the name at the end.
    NewFile(NewFile),
    /// The file must stay the one that it is.
    InPlace(InPlace),
    /// To replace a device or a pipe by a file would break what it connects to.
    Through(File),
}

impl Replacement {
    /// Begins to write a file that someone edits: a link is followed to the file that it means.
    ///
    /// # Errors
    /// The file is write-protected, is a folder, or the operating system refuses.
    pub fn of(path: &Path) -> Result<Replacement, FileError> {
        Replacement::begin(path, Links::Followed)
    }

    /// Begins to write a file that a command makes: a file takes the place of a link, and what that leads to stays as it is. A
    /// link to a device or a pipe is followed, for nothing is lost there.
    ///
    /// # Errors
    /// As for [`Replacement::of`].
    pub fn made(path: &Path) -> Result<Replacement, FileError> {
        Replacement::begin(path, Links::Replaced)
    }

    fn begin(path: &Path, links: Links) -> Result<Replacement, FileError> {
        let is_link = || fs::symlink_metadata(path).is_ok_and(|own| own.is_symlink());
        let replaces_link = links == Links::Replaced && is_link();
        let there = match fs::metadata(path) {
            Ok(metadata) if replaces_link && metadata.is_file() => None,
            Ok(metadata) => Some(metadata),
            Err(error) if replaces_link || error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(FileError::writing(path, error)),
        };
        let sink = match there.as_ref() {
            Some(there) if there.is_dir() => return Err(FileError::new(path, Problem::Directory)),
            Some(there) if !there.is_file() => File::options().write(true).open(path).map(Sink::Through),
            // Replacing needs leave to write the folder only; the mark on the file is to be respected all the same.
            Some(there) if there.permissions().readonly() => {
                return Err(FileError::new(path, Problem::ReadOnly));
            }
            None if replaces_link => sink(path.to_owned(), None),
            there => target(path).and_then(|target| sink(target, there)),
        };
        let sink = sink.map_err(|error| FileError::writing(path, error))?;
        Ok(Replacement {
            path: path.to_owned(),
            sink,
        })
    }

    fn filled(mut self, content: &[u8]) -> Result<(), FileError> {
        self.write_all(content)
            .map_err(|error| FileError::writing(&self.path, error))?;
        self.commit()
    }

    /// Puts what was written in the file's place.
    ///
    /// # Errors
    /// The operating system refuses. The old content is then untouched; where it could only be written over in its
    /// place, the error may say where it is kept.
    pub fn commit(self) -> Result<(), FileError> {
        let path = self.path;
        match self.sink {
            Sink::NewFile(new) => new.commit().map_err(|error| FileError::writing(&path, error)),
            Sink::InPlace(new) => new.commit().map_err(|problem| FileError::new(&path, problem)),
            Sink::Through(_) => Ok(()),
        }
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.sink {
            Sink::NewFile(new) => new.file().write(bytes),
            Sink::InPlace(new) => new.spool().write(bytes),
            Sink::Through(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.sink {
            Sink::NewFile(new) => new.file().flush(),
            Sink::InPlace(new) => new.spool().flush(),
            Sink::Through(file) => file.flush(),
        }
    }
}

fn sink(target: PathBuf, there: Option<&Metadata>) -> io::Result<Sink> {
    if there.is_some_and(has_other_names) {
        return InPlace::of(target).map(Sink::InPlace);
    }
    let new = match (NewFile::of(&target, there), there) {
        (Ok(new), _) => new,
        (Err(error), None) => return Err(error),
        // A folder that takes no new file may hold one that can be written all the same.
        (Err(error), Some(_)) => return InPlace::of(target).map(Sink::InPlace).map_err(|_| error),
    };
    match there {
        Some(there) if !new.belongs_to_the_owner_of(there) => InPlace::of(target).map(Sink::InPlace),
        _ => Ok(Sink::NewFile(new)),
    }
}

/// A file of several names has them all as long as it stays the file that it is.
fn has_other_names(there: &Metadata) -> bool {
    #[cfg(unix)]
    return std::os::unix::fs::MetadataExt::nlink(there) > 1;
    #[cfg(not(unix))]
    {
        let _ = there;
        false
    }
}

/// The file that a path means in the end. A link that leads nowhere yet means the file that it names.
fn target(path: &Path) -> io::Result<PathBuf> {
    match path.canonicalize() {
        Ok(target) => Ok(target),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(match fs::read_link(path) {
            Ok(link) => folder_of(path).join(link),
            Err(_) => path.to_owned(),
        }),
        Err(error) => Err(error),
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

//! Putting a new text in a file's place in one step.

use crate::{FileError, Problem};
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// Writes a file, all of it or nothing: see [`Replacement`].
///
/// # Errors
/// As for a [`Replacement`]; the old content is then untouched.
pub fn write(path: &Path, content: &[u8]) -> Result<(), FileError> {
    let mut replacement = Replacement::of(path)?;
    replacement
        .write_all(content)
        .map_err(|error| FileError::writing(path, error))?;
    replacement.commit()
}

/// A new content for a file. The old one is there until [`commit`](Replacement::commit), and stays if that is
/// never called. An existing file keeps its mode, and a link is followed to the file that it means. What is no file
/// (a pipe, `/dev/stdout`) is written to as it is.
#[derive(Debug)]
pub struct Replacement {
    path: PathBuf,
    sink: Sink,
}

#[derive(Debug)]
enum Sink {
    /// A file beside the target, since a rename cannot leave its file system.
    Beside {
        file: NamedTempFile,
        target: PathBuf,
        /// The mode to keep; none for a new file.
        mode: Option<Permissions>,
    },
    /// To replace a device or a pipe by a file would break what stands behind it.
    Through(File),
}

impl Replacement {
    /// Begins to write.
    ///
    /// # Errors
    /// The file is write-protected, is a folder, or the operating system refuses.
    pub fn of(path: &Path) -> Result<Replacement, FileError> {
        let metadata = match fs::metadata(path) {
            Ok(metadata) => Some(metadata),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(FileError::writing(path, error)),
        };
        let sink = match &metadata {
            Some(there) if there.is_dir() => return Err(FileError::new(path, Problem::Directory)),
            Some(there) if !there.is_file() => File::options().write(true).open(path).map(Sink::Through),
            // Replacing needs leave to write the folder only; the mark on the file is to be respected all the same.
            Some(there) if there.permissions().readonly() => {
                return Err(FileError::new(path, Problem::ReadOnly));
            }
            _ => beside(path, metadata.map(|there| there.permissions())),
        };
        let sink = sink.map_err(|error| FileError::writing(path, error))?;
        Ok(Replacement {
            path: path.to_owned(),
            sink,
        })
    }

    /// Puts what was written in the file's place.
    ///
    /// # Errors
    /// The operating system refuses; the old content is then untouched.
    pub fn commit(self) -> Result<(), FileError> {
        let Sink::Beside { file, target, mode } = self.sink else {
            return Ok(());
        };
        mode.map_or(Ok(()), |mode| file.as_file().set_permissions(mode))
            .and_then(|()| file.persist(target).map_err(|error| error.error))
            .map_err(|error| FileError::writing(&self.path, error))?;
        Ok(())
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.sink {
            Sink::Beside { file, .. } => file.write(bytes),
            Sink::Through(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.sink {
            Sink::Beside { file, .. } => file.flush(),
            Sink::Through(file) => file.flush(),
        }
    }
}

fn beside(path: &Path, mode: Option<Permissions>) -> io::Result<Sink> {
    let target = target(path)?;
    let mut builder = tempfile::Builder::new();
    builder.prefix(".ladder-").suffix(".tmp");
    #[cfg(unix)]
    if mode.is_none() {
        use std::os::unix::fs::PermissionsExt;
        // A new file: what the process's umask leaves of this.
        builder.permissions(Permissions::from_mode(0o666));
    }
    let file = builder.tempfile_in(folder_of(&target))?;
    Ok(Sink::Beside { file, target, mode })
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

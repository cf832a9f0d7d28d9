//! Putting a new text in a file's place in one step.

use crate::{FileError, Problem};
use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes a file: its old content is there until the new one is complete. An existing file keeps its mode, and
/// a link is followed to the file that it means. What is no file (a pipe, `/dev/stdout`) is written to as it is.
///
/// # Errors
/// The file is write-protected, is a folder, or the operating system refuses; the old content is then untouched.
pub fn write(path: &Path, content: &[u8]) -> Result<(), FileError> {
    let metadata = match fs::metadata(path) {
        Ok(metadata) => Some(metadata),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(FileError::writing(path, error)),
    };
    match &metadata {
        Some(there) if there.is_dir() => return Err(FileError::new(path, Problem::Directory)),
        // To replace a device or a pipe by a file would break what stands behind it.
        Some(there) if !there.is_file() => return write_into(path, content),
        // Replacing needs leave to write the folder only; the mark on the file is to be respected all the same.
        Some(there) if there.permissions().readonly() => {
            return Err(FileError::new(path, Problem::ReadOnly));
        }
        _ => {}
    }
    let target = target(path).map_err(|error| FileError::writing(path, error))?;
    let mode = metadata.map(|there| there.permissions());
    replace(&target, content, mode).map_err(|error| FileError::writing(path, error))
}

fn write_into(path: &Path, content: &[u8]) -> Result<(), FileError> {
    File::options()
        .write(true)
        .open(path)
        .and_then(|mut file| file.write_all(content))
        .map_err(|error| FileError::writing(path, error))
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

fn replace(target: &Path, content: &[u8], mode: Option<Permissions>) -> io::Result<()> {
    // In the same folder, since a rename cannot leave its file system.
    let mut builder = tempfile::Builder::new();
    builder.prefix(".ladder-").suffix(".tmp");
    #[cfg(unix)]
    if mode.is_none() {
        use std::os::unix::fs::PermissionsExt;
        // A new file: what the process's umask leaves of this.
        builder.permissions(Permissions::from_mode(0o666));
    }
    let mut file = builder.tempfile_in(folder_of(target))?;
    file.write_all(content)?;
    if let Some(mode) = mode {
        file.as_file().set_permissions(mode)?;
    }
    file.persist(target)?;
    Ok(())
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    }
}

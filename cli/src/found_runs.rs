//! `--write`: runs that were found, as a file of scenarios next to the program that they are of.

use crate::outcome::Failure;
use crate::terminal;
use std::path::{Path, PathBuf};

/// The only one of which there are runs. None: there are none at all, which is reported.
///
/// # Errors
/// There are runs of several: what to do.
pub(crate) fn of_one<T: Copy>(all: &[T], several: &str) -> Result<Option<T>, Failure> {
    match all {
        [] => {
            terminal::note(&"no run was found: nothing is written");
            Ok(None)
        }
        [one] => Ok(Some(*one)),
        _ => Err(Failure::new(several)),
    }
}

/// Whether two files are in one folder: a file of scenarios names its program from its own.
pub(crate) fn are_together(one: &Path, other: &Path) -> bool {
    folder_of(one) == folder_of(other)
}

fn folder_of(file: &Path) -> Option<PathBuf> {
    let folder = file.parent()?;
    let is_here = folder.as_os_str().is_empty();
    let folder = if is_here { Path::new(".") } else { folder };
    folder.canonicalize().ok()
}

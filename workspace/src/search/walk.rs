//! Going through folders, by the rules of `.gitignore`, and what is passed over on the way.

use crate::error::{FileError, Problem};
use crate::{named, regular};
use ignore::{DirEntry, WalkBuilder};
use ladder_syntax::MAX_FILE_BYTES;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

/// The files that say what is passed over.
const IGNORE_FILES: [&str; 2] = [".gitignore", ".ignore"];

/// A way through what lies below a folder, and what is wrong with folders that are not entered.
pub(crate) struct Walker {
    pub(crate) builder: WalkBuilder,
    refused: Arc<Mutex<Vec<FileError>>>,
}

impl Walker {
    /// What lies below a folder, sorted; of the folders in it only those that are wanted. A folder whose ignore file is no
    /// file is not entered: to read a pipe would be to wait for ever.
    pub(crate) fn below(
        folder: &Path,
        wanted: impl Fn(&DirEntry) -> bool + Send + Sync + 'static,
    ) -> Result<Walker, FileError> {
        let absolute = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
        // Those of the folders above are read, too.
        absolute.ancestors().try_for_each(ignore_files)?;
        let mut builder = WalkBuilder::new(folder);
        // A folder that is not a repository (yet) has its `.gitignore` applied too. What git keeps next to it is one person's
        // own, and may be said to lie anywhere.
        builder
            .require_git(false)
            .git_exclude(false)
            .sort_by_file_path(Path::cmp);
        let refused = Arc::<Mutex<Vec<FileError>>>::default();
        let notes = Arc::clone(&refused);
        builder.filter_entry(move |entry| {
            if !wanted(entry) {
                return false;
            }
            let is_folder = entry.file_type().is_some_and(|kind| kind.is_dir());
            match ignore_files(entry.path()) {
                Err(error) if is_folder => {
                    notes.lock().unwrap_or_else(PoisonError::into_inner).push(error);
                    false
                }
                _ => true,
            }
        });
        Ok(Walker { builder, refused })
    }

    /// What is wrong with folders that were not entered, once all others were.
    pub(crate) fn refused(self) -> Vec<FileError> {
        std::mem::take(&mut *self.refused.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

/// Whether the ignore files of a folder can be read.
pub(crate) fn ignore_files(folder: &Path) -> Result<(), FileError> {
    for name in IGNORE_FILES {
        let path = folder.join(name);
        let Ok(own) = path.symlink_metadata() else {
            continue;
        };
        // A link to another machine is not followed; one that leads nowhere is not a file to read.
        let metadata = match own.is_symlink() {
            true if cfg!(windows) && path.read_link().is_ok_and(|to| to.has_root()) => own,
            true => match path.metadata() {
                Ok(metadata) => metadata,
                Err(_) => continue,
            },
            false => own,
        };
        let problem = match regular::special(metadata.file_type()) {
            Some(special) => Problem::Special(special),
            None if metadata.len() > MAX_FILE_BYTES as u64 => Problem::TooLarge,
            None => continue,
        };
        return Err(FileError::new(&path, problem));
    }
    Ok(())
}

/// Whether what was found in a folder is a file, and lies in that folder or in its own workspace. Asked through links: a
/// linked file is a program like any other.
pub(crate) fn is_own_file(folder: &Path, path: &Path) -> bool {
    match path.symlink_metadata() {
        Ok(metadata) if metadata.is_symlink() => named::stays_inside(folder, path) && path.is_file(),
        Ok(metadata) => metadata.is_file(),
        Err(_) => false,
    }
}

//! Files that a workspace names: in its settings, and in its scenarios.
//!
//! A workspace may come from anybody, and a person opens it to see what it is. So what it names is relative, lies inside
//! it after all links are resolved, and is a regular file of bounded size (LANGUAGE §9). Links are followed one by one,
//! and none that leads outside is touched: on Windows even a check of a file on another machine sends it the name of
//! the person.

mod name;
mod resolve;

use crate::error::{FileError, Problem};
use crate::root::Root;
use crate::{regular, text};
use std::fs::{File, Metadata};
use std::io;
use std::path::{Path, PathBuf};

/// A file that a workspace names. The file itself has not been checked yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Named {
    /// The workspace.
    root: PathBuf,
    /// The folder that the name is seen from.
    folder: PathBuf,
    name: String,
}

impl Named {
    /// A name in a settings file: seen from the folder of that.
    pub fn in_settings(folder: &Path, name: &str) -> Named {
        Named {
            root: folder.to_owned(),
            folder: folder.to_owned(),
            name: name.to_owned(),
        }
    }

    /// A name in another file of a workspace: seen from the folder of that file.
    pub fn in_file(file: &Path, name: &str) -> Named {
        Named::seen_from(file, name, Root::of(file))
    }

    /// A file named in another, whose workspace is known if it has one.
    pub(crate) fn seen_from(file: &Path, name: &str, root: io::Result<Root>) -> Named {
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        let root = root.map_or_else(|_| folder.clone(), |root| root.folder().to_owned());
        Named {
            root,
            folder,
            name: name.to_owned(),
        }
    }

    /// The path as a message shows it.
    pub fn path(&self) -> PathBuf {
        self.folder.join(&self.name)
    }

    /// What is wrong with the name, whatever lies there.
    pub(crate) fn error(&self) -> Option<Problem> {
        match name::parts(&self.name) {
            Err(problem) => Some(problem),
            Ok(parts) if self.folder == self.root && name::climbs_out(&parts) => Some(Problem::Outside),
            Ok(_) => None,
        }
    }

    /// Where the file lies, with the links to it resolved; it need not be there.
    ///
    /// # Errors
    /// The name is not relative, or leads out of the workspace.
    pub fn locate(&self) -> Result<PathBuf, FileError> {
        let refused = |problem| FileError::new(&self.path(), problem);
        let parts = name::parts(&self.name).map_err(refused)?;
        resolve::inside(&self.root, &self.folder, parts).map_err(refused)
    }

    /// The same where there are no links.
    pub(crate) fn locate_without_links(&self) -> Result<PathBuf, FileError> {
        let refused = |problem| FileError::new(&self.path(), problem);
        let parts = name::parts(&self.name).map_err(refused)?;
        resolve::without_links(&self.root, &self.folder, parts).map_err(refused)
    }

    /// The file's text.
    ///
    /// # Errors
    /// As for [`Named::locate`]; or the file is missing, is not a regular one, is too large, is not UTF-8, or the
    /// operating system refuses.
    pub fn read(&self) -> Result<String, FileError> {
        text::read_from(self.open()?, &self.path())
    }

    /// As [`Named::read`], for a file that may be in another notation, which need not be text.
    ///
    /// # Errors
    /// As for [`Named::read`], but for what is not UTF-8.
    pub fn read_bytes(&self) -> Result<Vec<u8>, FileError> {
        text::bytes_from(self.open()?, &self.path())
    }

    fn open(&self) -> Result<(File, Metadata), FileError> {
        let path = self.locate()?;
        let renamed = |error: FileError| FileError::new(&self.path(), error.problem);
        regular::open_plain(&path, File::options().read(true)).map_err(renamed)
    }
}

/// Reads a program that was found in a workspace: a link to it stays inside of that.
///
/// # Errors
/// As for [`Named::read`].
pub fn read_own(path: &Path) -> Result<String, FileError> {
    let folder = path.parent().unwrap_or(Path::new(""));
    if path.is_symlink() && !stays_inside(folder, path) {
        return Err(FileError::new(path, Problem::Outside));
    }
    text::read_from(regular::open_plain(path, File::options().read(true))?, path)
}

/// The bytes of a file that was found below a folder: a regular one, and no link on the way to it leads out of that, or of
/// its own workspace.
pub(crate) fn read_below(folder: &Path, path: &Path) -> Result<Vec<u8>, FileError> {
    let mut way = path.ancestors().take_while(|inner| *inner != folder);
    if way.any(Path::is_symlink) && !stays_inside(folder, path) {
        return Err(FileError::new(path, Problem::Outside));
    }
    text::bytes_from(regular::open_plain(path, File::options().read(true))?, path)
}

/// Whether a file that was found in a folder lies inside of it, or of its own workspace, after links are resolved.
pub(crate) fn stays_inside(folder: &Path, file: &Path) -> bool {
    let within = |root: &Path| {
        let Some(name) = file.file_name() else {
            return false;
        };
        let parent = file.parent().unwrap_or(Path::new(""));
        resolve::inside(root, parent, vec![name::PathComponent::Name(name.to_owned())]).is_ok()
    };
    within(folder) || Root::of(file).is_ok_and(|root| within(root.folder()))
}

#[cfg(test)]
mod tests;

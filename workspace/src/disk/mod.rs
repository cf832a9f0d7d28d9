//! Where files are: what the language server asks of a disk, in one trait.
//!
//! [`SystemDisk`] is that of the operating system, with all that this crate promises of it. [`MemoryDisk`] is what a page has in
//! its place, and what tests have.

mod memory;
mod system;

pub use memory::MemoryDisk;
pub(crate) use system::KeptFile;
pub use system::SystemDisk;

use crate::error::FileError;
use crate::named::Named;
use crate::root::Root;
use crate::search::Survey;
use crate::settings::Files;
use crate::stamp::Stamp;
use crate::text;
use ladder_analysis::Cancel;
use std::fmt::Debug;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A place with files.
pub trait Disk: Debug + Send + Sync {
    /// The root of a program, which need not be there.
    ///
    /// # Errors
    /// The path is relative, and there is no current folder.
    fn root_of(&self, program: &Path) -> io::Result<Root>;

    /// Which state of a file is there.
    fn stamp(&self, file: &Path) -> Stamp;

    /// Whether something has this name, and be it a link that leads nowhere.
    fn is_there(&self, path: &Path) -> bool;

    /// Whether a file has this name.
    fn is_file(&self, path: &Path) -> bool;

    /// Whether a path begins at the top, so that it means the same in every folder.
    fn is_whole(&self, path: &Path) -> bool;

    /// Whether a link has this name.
    fn is_link(&self, path: &Path) -> bool;

    /// The one path of what has this name, without links.
    ///
    /// # Errors
    /// Nothing has this name.
    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf>;

    /// The names in a folder, in any order, up to so many; none if it cannot be read.
    fn names_in(&self, folder: &Path, most: usize) -> Vec<String>;

    /// The text of a file.
    ///
    /// # Errors
    /// It cannot be read, is too large or no text.
    fn read(&self, file: &Path) -> Result<String, FileError>;

    /// The text of a file that was found in a workspace: a regular one, which lies in it.
    ///
    /// # Errors
    /// It lies outside, cannot be read, is too large or no text.
    fn read_own(&self, file: &Path) -> Result<String, FileError>;

    /// Where a file lies that a workspace names. It need not be there.
    ///
    /// # Errors
    /// It lies outside, or its name is none.
    fn locate(&self, file: &Named) -> Result<PathBuf, FileError>;

    /// The bytes of a file that a workspace names.
    ///
    /// # Errors
    /// It lies outside, cannot be read or is too large.
    fn read_named(&self, file: &Named) -> Result<Vec<u8>, FileError>;

    /// The programs of a workspace, sorted. See [`Root::programs`].
    fn programs(&self, root: &Root, files: &Files) -> Vec<PathBuf>;

    /// Whether a program is one of the workspace. See [`Root::holds`].
    fn holds(&self, root: &Root, program: &Path, files: &Files) -> bool;

    /// The files of scenarios and the scenes below these folders: what names the tags of a program next to it.
    fn companions(&self, folders: &[PathBuf]) -> Vec<PathBuf>;

    /// What lies below a folder. See [`survey`](crate::survey).
    fn survey(&self, folder: &Path, most: usize, cancel: &Cancel) -> Survey;

    /// The files below a folder, by the rules of `.gitignore`, up to so many files and folders.
    fn files_below(&self, folder: &Path, most: usize) -> Vec<PathBuf>;

    /// The bytes of a file that was found below a folder.
    ///
    /// # Errors
    /// It is not a regular file, leads out of the folder and its workspace, cannot be read or is too large.
    fn read_below(&self, folder: &Path, file: &Path) -> Result<Vec<u8>, FileError>;

    /// What keeps values in a file that a workspace names.
    ///
    /// # Errors
    /// It lies outside.
    fn keeper(&self, file: &Named) -> Result<Box<dyn Keeper>, FileError>;

    /// A file that a file names, as [`Named::in_file`].
    fn named_in(&self, file: &Path, name: &str) -> Named {
        Named::seen_from(file, name, self.root_of(file))
    }

    /// The text of a file that a workspace names.
    ///
    /// # Errors
    /// As [`Disk::read_named`], and it is not a text.
    fn read_text(&self, file: &Named) -> Result<String, FileError> {
        text::decode(&file.path(), self.read_named(file)?)
    }

    /// The text of a settings file that was found in a workspace.
    ///
    /// # Errors
    /// It lies outside, or cannot be read.
    fn settings_text(&self, file: &Path) -> Result<String, FileError> {
        let folder = file.parent().unwrap_or(Path::new(""));
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        self.read_text(&Named::in_settings(folder, &name))
    }
}

/// Where the values of one run are kept: nobody else has the file meanwhile.
pub trait Keeper: Debug + Send {
    /// The file.
    fn path(&self) -> &Path;

    /// Its content; nothing if there is no file.
    ///
    /// # Errors
    /// It cannot be read.
    fn read(&self) -> Result<Option<Vec<u8>>, FileError>;

    /// Keeps others from the file until this is dropped. One that has it may let go of it in the time `patience`.
    ///
    /// # Errors
    /// Another run uses it.
    fn lock(&mut self, patience: Duration) -> Result<(), FileError>;

    /// Writes it, whole or not at all.
    ///
    /// # Errors
    /// It cannot be written.
    fn write(&mut self, bytes: &[u8]) -> Result<(), FileError>;

    /// Puts a damaged file out of the way, under a name that no other file has.
    ///
    /// # Errors
    /// It cannot be moved.
    fn put_aside(&mut self) -> Result<PathBuf, FileError>;
}

//! The workspace of a program (LANGUAGE §4).

use ladder_notations::of_workspaces;
use std::io;
use std::path::{Component, Path, PathBuf};

/// The settings file that marks a workspace's root.
pub const SETTINGS_FILE: &str = "ladder.toml";

/// What the name of a program ends in, without the dot.
const EXTENSION: &str = "clad";

/// Whether a file is a program of a workspace by its name: ladder text, or of a notation whose files lie next to that.
pub fn is_program(path: &Path) -> bool {
    is_ladder_text(path) || of_workspaces(path).is_some()
}

/// Whether a file is ladder text by its name.
pub fn is_ladder_text(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case(EXTENSION))
}

/// The folder whose programs share their global tags, functions and user-defined blocks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Root {
    /// The nearest folder above the program with a settings file, sub-folders included.
    Settings(PathBuf),
    /// No settings file: the program's own folder, without its sub-folders.
    Folder(PathBuf),
}

impl Root {
    /// The root of a program. The file need not exist.
    ///
    /// # Errors
    /// The path is relative and the process has no current folder.
    pub fn of(program: &Path) -> io::Result<Root> {
        let program = std::path::absolute(program)?;
        let folder = &without_parents(program.parent().unwrap_or(&program));
        let settings = folder
            .ancestors()
            .find(|above| is_settings_file(&above.join(SETTINGS_FILE)));
        Ok(match settings {
            Some(root) => Root::Settings(root.to_owned()),
            None => Root::Folder(folder.to_owned()),
        })
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        match self {
            Root::Settings(folder) | Root::Folder(folder) => folder,
        }
    }

    /// The settings file, if there is one.
    pub fn settings_file(&self) -> Option<PathBuf> {
        match self {
            Root::Settings(folder) => Some(folder.join(SETTINGS_FILE)),
            Root::Folder(_) => None,
        }
    }
}

/// A link counts without being followed: its reader says what is wrong with it.
fn is_settings_file(path: &Path) -> bool {
    path.symlink_metadata()
        .is_ok_and(|metadata| metadata.is_file() || metadata.is_symlink())
}

/// The folder without `..`: what is above `plant/../line` is not above `plant`. Links in it are then resolved too.
pub(crate) fn without_parents(folder: &Path) -> PathBuf {
    let climbs = folder.components().any(|part| part == Component::ParentDir);
    let canonical = climbs.then(|| folder.canonicalize().ok()).flatten();
    canonical.unwrap_or_else(|| folder.to_owned())
}

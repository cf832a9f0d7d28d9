//! The workspace of a program (LANGUAGE §4).

use crate::search::{is_program, programs_below};
use crate::settings::{Files, Settings, SettingsError};
use std::io;
use std::path::{Path, PathBuf};

/// The settings file that marks a workspace's root.
pub const SETTINGS_FILE: &str = "ladder.toml";

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
        let folder = program.parent().unwrap_or(&program);
        let settings = folder
            .ancestors()
            .find(|above| above.join(SETTINGS_FILE).is_file());
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

    /// The settings of the workspace; without a file those that hold anyway.
    ///
    /// # Errors
    /// There is a settings file that cannot be read, or something in it is wrong.
    pub fn settings(&self) -> Result<Settings, SettingsError> {
        match self.settings_file() {
            Some(file) => Settings::read(&file),
            None => Ok(Settings::default()),
        }
    }

    /// The programs of the workspace, sorted; `files` are those that its settings ask for. What cannot be read is
    /// left out: a program must be usable beside a folder that is not.
    pub fn programs(&self, files: &Files) -> Vec<PathBuf> {
        match self {
            Root::Settings(folder) => {
                let mut programs = programs_below(folder);
                programs.retain(|program| files.contain(program));
                programs
            }
            Root::Folder(folder) => {
                let mut programs: Vec<PathBuf> = std::fs::read_dir(folder)
                    .into_iter()
                    .flatten()
                    .filter_map(|entry| Some(entry.ok()?.path()))
                    .filter(|path| is_program(path) && path.is_file())
                    .collect();
                programs.sort();
                programs
            }
        }
    }
}

//! How files on disk were when they were read.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use ladder_syntax::{LineColumn, TextRange};
use ladder_workspace::{Disk, Files, Root, SETTINGS_FILE, SettingError, Settings, Stamp, errors_on_disk};

/// A settings file as it was read.
#[derive(Debug)]
pub struct SettingsFile {
    /// The file.
    pub path: PathBuf,
    /// Its text; empty if it cannot be read.
    pub text: String,
    /// What is wrong in it. The rest of it holds.
    pub errors: Vec<SettingError>,
    pub(crate) stamp: Stamp,
}

impl SettingsFile {
    /// Reads it, as far as it can be read.
    pub(crate) fn read(disk: &dyn Disk, path: PathBuf) -> (Settings, SettingsFile) {
        let stamp = disk.stamp(&path);
        let (text, settings, errors) = match disk.settings_text(&path) {
            Ok(text) => {
                let (settings, mut errors) = Settings::examine(&path, &text);
                errors.extend(errors_on_disk(&settings, &text, disk));
                (text, settings, errors)
            }
            Err(error) => {
                let unreadable = SettingError {
                    range: TextRange::default(),
                    place: LineColumn { line: 1, column: 1 },
                    message: error.problem.to_string(),
                };
                (String::new(), Settings::default(), vec![unreadable])
            }
        };
        let file = SettingsFile {
            path,
            text,
            errors,
            stamp,
        };
        (settings, file)
    }
}

/// How the files of a workspace were when they were read.
pub(crate) struct Seen {
    /// The settings file, if there was one.
    pub(crate) settings_file: Option<Stamp>,
    /// Which programs belong to it.
    pub(crate) files: Files,
    /// Its programs.
    pub(crate) programs: BTreeMap<PathBuf, Stamp>,
}

impl Seen {
    /// Those that are not so any more.
    pub(crate) fn changed(&self, disk: &dyn Disk, root: &Path) -> Vec<PathBuf> {
        let settings_file = root.join(SETTINGS_FILE);
        let now = disk.stamp(&settings_file);
        // A link that leads nowhere is there, too: reading it says so.
        let is_there = disk.is_there(&settings_file);
        if is_there != self.settings_file.is_some() || self.settings_file.is_some_and(|it| it != now) {
            return vec![settings_file];
        }
        let found = match self.settings_file {
            Some(_) => Root::Settings(root.to_owned()),
            None => Root::Folder(root.to_owned()),
        };
        let there = disk.programs(&found, &self.files);
        let gone = self
            .programs
            .keys()
            .filter(|path| there.binary_search(path).is_err());
        let mut changed: Vec<PathBuf> = gone.cloned().collect();
        let other = there
            .iter()
            .filter(|path| self.programs.get(*path) != Some(&disk.stamp(path)));
        changed.extend(other.cloned());
        changed
    }
}

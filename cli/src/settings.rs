//! What the `ladder.toml` above each of many programs asks for.

use crate::outcome::Failure;
use ladder_workspace::{Root, Settings};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Settings by the folder they are in. Each file is read, and complained of, once.
#[derive(Default)]
pub(crate) struct SettingsFiles {
    read: HashMap<Option<PathBuf>, Option<Settings>>,
}

impl SettingsFiles {
    /// The settings that hold for a program. None: its settings file cannot be used, and that has been reported.
    ///
    /// # Errors
    /// The settings file cannot be used, and that has not been reported yet.
    pub(crate) fn of(&mut self, program: &Path) -> Result<Option<&Settings>, Failure> {
        let root = Root::of(program).ok();
        let file = root.as_ref().and_then(Root::settings_file);
        if !self.read.contains_key(&file) {
            let settings = match &file {
                Some(file) => Settings::read(file),
                None => Ok(Settings::default()),
            };
            match settings {
                Ok(settings) => self.read.insert(file.clone(), Some(settings)),
                Err(error) => {
                    self.read.insert(file, None);
                    return Err(error.into());
                }
            };
        }
        Ok(self.read[&file].as_ref())
    }
}

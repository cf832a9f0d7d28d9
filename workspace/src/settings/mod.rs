//! The settings file of a workspace, `ladder.toml` (LANGUAGE §9).
//!
//! Every key may be left out. What the command line gives wins over what stands here.

mod error;
mod files;
mod format;
mod lint;
mod reader;
mod simulate;

pub use error::{Mistake, SettingsError};
pub use files::Files;
pub use lint::{Levels, Lint};
pub use simulate::Simulate;

use crate::Root;
use ladder_analysis::RuleSettings;
use reader::Reader;
use std::path::{Path, PathBuf};

/// What a workspace asks for.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// `[format]`: how diagrams are laid out.
    pub format: ladder_format::Options,
    /// `[lint]`: how much the findings of a rule matter, where that is not what the rule itself says.
    pub lint: Lint,
    /// `[simulate]`: how programs are run.
    pub simulate: Simulate,
    /// `[workspace]`: which files belong to it.
    pub files: Files,
}

impl Settings {
    /// The settings that hold for a program: those of the nearest `ladder.toml` above it, or none at all.
    ///
    /// # Errors
    /// There is a settings file that cannot be read, or something in it is wrong.
    pub fn of(program: &Path) -> Result<Settings, SettingsError> {
        match Root::of(program).ok().and_then(|root| root.settings_file()) {
            Some(file) => Settings::read(&file),
            None => Ok(Settings::default()),
        }
    }

    /// What the rules are told before they look at a program.
    pub fn rules_for(&self, program: &Path) -> RuleSettings {
        let mut rules = RuleSettings {
            scan_interval: self.simulate.options().interval,
            ..RuleSettings::default()
        };
        for (rule, level) in self.lint.levels_of(program) {
            rules.set(rule, level);
        }
        rules
    }

    /// Reads a settings file.
    ///
    /// # Errors
    /// It cannot be read, or something in it is wrong.
    pub fn read(file: &Path) -> Result<Settings, SettingsError> {
        let text = crate::read(file).map_err(SettingsError::File)?;
        Settings::parse(file, &text)
    }

    /// As [`Settings::read`], from its text. `file` names it in messages and says where its paths start.
    ///
    /// # Errors
    /// Something in it is wrong; all that is wrong is told.
    pub fn parse(file: &Path, text: &str) -> Result<Settings, SettingsError> {
        let folder = file.parent().map_or_else(PathBuf::new, Path::to_owned);
        let mut reader = Reader::new(text);
        let mut settings = Settings::default();
        if let Some(mut top) = reader.document() {
            if let Some(table) = top.table(&mut reader, "format") {
                settings.format = format::read(table, &mut reader);
            }
            if let Some(table) = top.table(&mut reader, "lint") {
                settings.lint = lint::read(table, &folder, &mut reader);
            }
            if let Some(table) = top.table(&mut reader, "simulate") {
                settings.simulate = simulate::read(table, &folder, &mut reader);
            }
            if let Some(table) = top.table(&mut reader, "workspace") {
                settings.files = files::read(table, &folder, &mut reader);
            }
            top.finish(&mut reader);
        }
        reader.finish(file).map(|()| settings)
    }
}

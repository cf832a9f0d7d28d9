//! The settings file of a workspace, `ladder.toml` (LANGUAGE §9).
//!
//! Every key may be left out. What the command line gives wins over what is here.

mod device;
mod editor;
mod error;
mod files;
mod format;
mod given;
mod lint;
mod misfit;
mod online;
mod project;
mod reader;
mod serve;
mod simulate;
mod switch_off;
pub mod table;
mod tasks;

pub use device::{Device, Placed};
pub use editor::EditorSettings;
pub use error::{SettingError, SettingsError};
pub use files::Files;
pub(crate) use files::LibraryFolder;
pub use given::Tree;
pub use lint::{Levels, Lint};
pub use misfit::Misfit;
pub use online::Online;
pub use project::Project;
pub use serve::{Run, ServeModbus};
pub use simulate::{Plant, Simulate};
pub use tasks::Task;
pub(crate) use tasks::scan_of;

use crate::error::FileError;
use crate::named::Named;
use crate::root::Root;
use ladder_analysis::rules::rule_named;
use ladder_analysis::{Level, RuleSettings};
use ladder_syntax::{LineIndex, TextRange, TextSize};
use online::ONLINE;
use reader::{Reader, Source, Table};
use std::ops::Range;
use std::path::{Path, PathBuf};
use table::{DEVICE, FORMAT, LINT, MODBUS, PROJECT, RUN, SIMULATE, TASK, WORKSPACE};
use toml::de::DeTable;

/// What a workspace asks for.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// `[format]`: how diagrams are laid out.
    pub format: ladder_format::Options,
    /// `[lint]`: how much the findings of a rule matter, where that is not what the rule itself says.
    pub lint: Lint,
    /// `[simulate]`: how programs are run.
    pub simulate: Simulate,
    /// `[run]`: how programs run in real time.
    pub run: Run,
    /// `[serve.modbus]`: what a Modbus server shows of them; none if there is to be none.
    pub modbus: Option<ServeModbus>,
    /// `[[device]]`: what is at the other end of a network.
    pub devices: Vec<Device>,
    /// `[online]`: the controller that programs are watched on, if there is one.
    pub online: Option<Online>,
    /// `[workspace]`: which files belong to it.
    pub files: Files,
    /// `[project]`: what the project is.
    pub project: Project,
}

impl Root {
    /// The settings of the workspace; without a file those that hold anyway.
    ///
    /// # Errors
    /// There is a settings file that cannot be read, or something in it is wrong.
    pub fn settings(&self) -> Result<Settings, SettingsError> {
        match self.settings_file() {
            Some(file) => Settings::read_own(&file),
            None => Ok(Settings::default()),
        }
    }
}

/// A settings file that is larger than this, in bytes, is none, or one that keeps others busy.
const MOST_BYTES: usize = 1 << 20;

impl Settings {
    /// The settings that hold for a program: those of the nearest `ladder.toml` above it, or none at all.
    ///
    /// # Errors
    /// There is a settings file that cannot be read, or something in it is wrong.
    pub fn of(program: &Path) -> Result<Settings, SettingsError> {
        match Root::of(program).ok().and_then(|root| root.settings_file()) {
            Some(file) => Settings::read_own(&file),
            None => Ok(Settings::default()),
        }
    }

    /// The settings of the rules.
    pub fn rules_for(&self, program: &Path) -> RuleSettings {
        let mut rules = RuleSettings {
            scan_interval: self.simulate.interval_of(program),
            ..RuleSettings::default()
        };
        if self.files.is_in_library(program)
            && let Some(rule) = rule_named("library-name")
        {
            rules.set(rule, Level::Shown(rule.default_severity()));
        }
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
        let text = crate::text::read(file).map_err(SettingsError::File)?;
        Settings::parse(file, &text)
    }

    /// As [`Settings::read`], for the settings file that was found in a workspace, which lies inside of that.
    ///
    /// # Errors
    /// It lies outside, cannot be read, or something in it is wrong.
    pub fn read_own(file: &Path) -> Result<Settings, SettingsError> {
        let text = Settings::own_text(file).map_err(SettingsError::File)?;
        Settings::parse(file, &text)
    }

    /// The text of a settings file that was found in a workspace.
    ///
    /// # Errors
    /// It lies outside, or cannot be read.
    pub fn own_text(file: &Path) -> Result<String, FileError> {
        let folder = file.parent().unwrap_or(Path::new(""));
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        Named::in_settings(folder, &name).read()
    }

    /// As [`Settings::read`], from its text. `file` names it in messages and says where its paths start.
    ///
    /// # Errors
    /// Something in it is wrong; all errors are listed.
    pub fn parse(file: &Path, text: &str) -> Result<Settings, SettingsError> {
        let (settings, errors) = Settings::examine(file, text);
        if errors.is_empty() {
            return Ok(settings);
        }
        Err(SettingsError::Content {
            file: file.to_owned(),
            errors,
        })
    }

    /// What only shows next to a program, of the settings file that holds for it: each with its place in that.
    ///
    /// None if no settings file does.
    pub fn found_wrong(program: &Path, found: Vec<Misfit>) -> Option<SettingsError> {
        let file = Root::of(program).ok()?.settings_file()?;
        Some(match Settings::own_text(&file) {
            Ok(text) => SettingsError::Content {
                errors: errors(&text, found),
                file,
            },
            Err(error) => SettingsError::File(error),
        })
    }

    /// As [`Settings::parse`], for those who go on with what is right in it: an editor, whose text is half written
    /// most of the time.
    pub fn examine(file: &Path, text: &str) -> (Settings, Vec<SettingError>) {
        let folder = file.parent().map_or_else(PathBuf::new, Path::to_owned);
        let mut reader = Reader::new(Source::File);
        if text.len() > MOST_BYTES {
            reader.wrong(0..0, "a ladder.toml has at most 1 MiB, and this one is larger");
            return (Settings::default(), errors(text, reader.finish()));
        }
        let settings = match DeTable::parse(text) {
            Ok(document) => {
                let mut top = reader.top(given::from_toml(document));
                let settings = Settings::take(&mut top, &folder, &mut reader);
                top.finish(&mut reader);
                settings
            }
            Err(error) => {
                let range = error.span().unwrap_or(0..0);
                reader.wrong(range, format!("this is not TOML: {}", error.message()));
                Settings::default()
            }
        };
        (settings, errors(text, reader.finish()))
    }

    /// Takes the sections that are the project's out of all that is set.
    fn take(top: &mut Table, folder: &Path, reader: &mut Reader) -> Settings {
        let mut settings = Settings::default();
        if let Some(table) = reader.section(top, &FORMAT) {
            settings.format = format::read(table, reader);
        }
        if let Some(table) = reader.section(top, &LINT) {
            settings.lint = lint::read(table, folder, reader);
        }
        if let Some(table) = reader.section(top, &SIMULATE) {
            settings.simulate = simulate::read(table, folder, reader);
        }
        let tasks = reader.sections(top, &TASK);
        settings.simulate.tasks = tasks::read(tasks, folder, reader);
        if let Some(table) = reader.section(top, &RUN) {
            settings.run = serve::read_run(table, reader);
        }
        if let Some(table) = reader.section(top, &MODBUS) {
            settings.modbus = Some(serve::read_modbus(table, reader));
        }
        let devices = reader.sections(top, &DEVICE);
        settings.devices = device::read(devices, reader);
        if let Some(table) = reader.section(top, &ONLINE) {
            settings.online = Some(online::read(table, reader));
        }
        if let Some(table) = reader.section(top, &WORKSPACE) {
            settings.files = files::read(table, folder, reader);
        }
        if let Some(table) = reader.section(top, &PROJECT) {
            settings.project = project::read(table, reader);
        }
        settings
    }
}

/// What was found to be wrong in a text, with its places.
pub(crate) fn errors(text: &str, found: Vec<(Range<usize>, String)>) -> Vec<SettingError> {
    let index = LineIndex::new(text);
    let offset = |at: usize| TextSize::new(at.min(text.len()) as u32);
    let found = found.into_iter().map(|(range, message)| {
        let (start, end) = (offset(range.start), offset(range.end));
        SettingError {
            range: TextRange::new(start, end.max(start)),
            place: index.line_column(text, start),
            message,
        }
    });
    found.collect()
}

//! What can be wrong with a settings file.

use crate::error::FileError;
use crate::shown::{self, from_here};
use ladder_syntax::{LineColumn, TextRange};
use std::fmt;
use std::path::PathBuf;

/// A settings file that cannot be used.
#[derive(Debug)]
pub enum SettingsError {
    /// It cannot be read.
    File(FileError),
    /// Something in it is wrong.
    Content {
        /// The file.
        file: PathBuf,
        /// What is wrong, in the order of the text; at least one.
        errors: Vec<SettingError>,
    },
}

/// One thing that is wrong in a settings file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SettingError {
    /// Where, in bytes.
    pub range: TextRange,
    /// Where it starts, as people count.
    pub place: LineColumn,
    /// What is wrong and what to do.
    pub message: String,
}

impl fmt::Display for SettingsError {
    /// `plant/ladder.toml:3:1: ..`, a line for each error.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (file, errors) = match self {
            SettingsError::File(error) => return error.fmt(f),
            SettingsError::Content { file, errors } => (file, errors),
        };
        for (index, error) in errors.iter().enumerate() {
            let line_end = if index > 0 { "\n" } else { "" };
            let LineColumn { line, column } = error.place;
            let file = shown::path(from_here(file));
            write!(
                f,
                "{line_end}{file}:{line}:{column}: {}",
                shown::line(&error.message)
            )?;
        }
        Ok(())
    }
}

impl std::error::Error for SettingsError {}

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
    Mistakes {
        /// The file.
        file: PathBuf,
        /// What is wrong, in the order of the text; at least one.
        mistakes: Vec<Mistake>,
    },
}

/// One thing that is wrong in a settings file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mistake {
    /// Where, in bytes.
    pub range: TextRange,
    /// Where it starts, as people count.
    pub place: LineColumn,
    /// What is wrong and what to do.
    pub message: String,
}

impl fmt::Display for SettingsError {
    /// `plant/ladder.toml:3:1: ..`, a line for each mistake.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (file, mistakes) = match self {
            SettingsError::File(error) => return error.fmt(f),
            SettingsError::Mistakes { file, mistakes } => (file, mistakes),
        };
        for (index, mistake) in mistakes.iter().enumerate() {
            let line_end = if index > 0 { "\n" } else { "" };
            let LineColumn { line, column } = mistake.place;
            let file = shown::path(from_here(file));
            write!(
                f,
                "{line_end}{file}:{line}:{column}: {}",
                shown::line(&mistake.message)
            )?;
        }
        Ok(())
    }
}

impl std::error::Error for SettingsError {}

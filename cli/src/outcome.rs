//! How a command ends.

use crate::terminal;
use ladder_notations::ReadError;
use ladder_workspace::{FileError, shown};
use std::fmt;
use std::path::Path;
use std::process::ExitCode;

/// What a command has found. The worse of two is the larger.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Outcome {
    /// Nothing to complain about.
    Fine,
    /// Errors in a program, a file that would change.
    Findings,
    /// Some of the work could not be done; what was wrong has been reported.
    Failed,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> ExitCode {
        match outcome {
            Outcome::Fine => ExitCode::SUCCESS,
            Outcome::Findings => ExitCode::from(1),
            Outcome::Failed => ExitCode::from(2),
        }
    }
}

/// Says which files cannot be read; the others go on.
pub(crate) fn unreadable(errors: &[FileError]) -> Outcome {
    for error in errors {
        terminal::error(error);
    }
    if errors.is_empty() {
        Outcome::Fine
    } else {
        Outcome::Failed
    }
}

/// Says what went wrong, if anything did, and returns the exit status.
pub(crate) fn exit(result: Result<Outcome, Failure>) -> ExitCode {
    match result {
        Ok(outcome) => outcome.into(),
        Err(failure) => {
            terminal::error(&failure);
            Outcome::Failed.into()
        }
    }
}

/// Why a command could not do its work: a message for the person who started it.
#[derive(Debug)]
pub(crate) struct Failure {
    message: String,
    /// The same with the lines that it is about.
    excerpt: Option<String>,
}

impl Failure {
    /// With a message of one line: what others wrote in it makes no other.
    pub(crate) fn new(message: impl AsRef<str>) -> Failure {
        Failure {
            message: shown::line(message.as_ref()).into_owned(),
            excerpt: None,
        }
    }

    /// With a message of several lines, each of which makes no other.
    pub(crate) fn of_lines(lines: impl IntoIterator<Item = String>) -> Failure {
        let lines = lines.into_iter().map(|line| shown::line(&line).into_owned());
        Failure {
            message: lines.collect::<Vec<_>>().join("\n"),
            excerpt: None,
        }
    }

    /// The same with the lines that it is about, if there are any.
    #[must_use]
    pub(crate) fn with_excerpt(self, excerpt: Option<String>) -> Failure {
        Failure { excerpt, ..self }
    }

    /// A file of another system that cannot be read: `motor.rung:1:7: ...`.
    pub(crate) fn broken(file: &Path, error: &ReadError) -> Failure {
        let place = error.place.map(|place| format!(":{place}")).unwrap_or_default();
        Failure::new(format!("{}{place}: {}", shown::path(file), error.sentence()))
    }

    /// Says it as a command does that shows findings: with the lines that it is about, if there are any.
    pub(crate) fn show(&self) {
        match &self.excerpt {
            Some(excerpt) => terminal::plain(excerpt),
            None => terminal::error(self),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Failure {
        Failure::new(error.to_string())
    }
}

/// Writing to stdout is the only bare input or output of a command; files have their own errors.
impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Failure {
        Failure::new(format!("the output cannot be written: {error}"))
    }
}

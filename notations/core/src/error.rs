//! Why a program cannot be read, or written.

use ladder_syntax::LineColumn;
use std::fmt;

/// Why a foreign file cannot be read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReadError {
    /// Where it is wrong, if it is at one place.
    pub place: Option<LineColumn>,
    /// What is wrong and what to do.
    pub message: String,
    /// What is wrong besides, at other places.
    pub more: Vec<(LineColumn, String)>,
}

/// No more than this many places are named in one sentence.
const MOST_TOLD: usize = 20;

impl ReadError {
    /// Something is wrong at a place.
    pub fn at(place: LineColumn, message: impl Into<String>) -> ReadError {
        ReadError {
            place: Some(place),
            message: message.into(),
            more: Vec::new(),
        }
    }

    /// Something is wrong with the file as a whole.
    pub fn whole(message: impl Into<String>) -> ReadError {
        ReadError {
            place: None,
            message: message.into(),
            more: Vec::new(),
        }
    }

    /// All that is wrong in one sentence, without the first place.
    pub fn sentence(&self) -> String {
        let mut sentence = self.message.clone();
        for (place, message) in self.more.iter().take(MOST_TOLD) {
            sentence.push_str(&format!("; {place}: {message}"));
        }
        if self.more.len() > MOST_TOLD {
            sentence.push_str(&format!("; and {} more", self.more.len() - MOST_TOLD));
        }
        sentence
    }

    /// Everything that is wrong, each with its place.
    pub fn all(&self) -> impl Iterator<Item = (LineColumn, &str)> {
        let first = (self.place.unwrap_or(LineColumn::START), self.message.as_str());
        let more = self
            .more
            .iter()
            .map(|(place, message)| (*place, message.as_str()));
        std::iter::once(first).chain(more)
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Some(place) => write!(f, "{place}: {}", self.sentence()),
            None => f.write_str(&self.sentence()),
        }
    }
}

impl std::error::Error for ReadError {}

/// Why a program cannot be written in a notation: what it cannot say, and what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WriteError {
    /// See above.
    pub message: String,
}

impl WriteError {
    /// With its message.
    pub fn new(message: impl Into<String>) -> WriteError {
        WriteError {
            message: message.into(),
        }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for WriteError {}

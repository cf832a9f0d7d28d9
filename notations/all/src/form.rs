//! What a program is written in.

use super::{LADDER, NOTATIONS, Notation, by_name, recognise};
use std::fmt;
use std::path::Path;

/// What a program is written in.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// This project's own text.
    Ladder,
    /// The notation of another system.
    Foreign(&'static dyn Notation),
}

impl Form {
    /// The form of a name: [`LADDER`], or that of a notation.
    pub fn named(name: &str) -> Option<Form> {
        if name == LADDER {
            return Some(Form::Ladder);
        }
        by_name(name).map(Form::Foreign)
    }

    /// All names, the own one first.
    pub fn names() -> impl Iterator<Item = &'static str> {
        std::iter::once(LADDER).chain(NOTATIONS.iter().map(|notation| notation.name()))
    }

    /// What a file is written in: ladder text, if its name says so, whatever its content looks like; else what [`recognise`]
    /// says.
    pub fn of(path: &Path, bytes: &[u8], is_called_ladder: bool) -> Option<Form> {
        if is_called_ladder {
            return Some(Form::Ladder);
        }
        recognise(path, bytes).map(Form::Foreign)
    }

    /// What a command line calls it.
    pub fn name(self) -> &'static str {
        match self {
            Form::Ladder => LADDER,
            Form::Foreign(notation) => notation.name(),
        }
    }

    /// How the names of its files end, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Form::Ladder => LADDER,
            Form::Foreign(notation) => notation.extensions().first().copied().unwrap_or("txt"),
        }
    }

    /// Whether it is this project's own text.
    pub fn is_ladder(self) -> bool {
        matches!(self, Form::Ladder)
    }
}

impl fmt::Debug for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

//! What a program is written in: ladder text, or the notation of another system.

use clap::builder::{PossibleValue, PossibleValuesParser};
use ladder_interchange::notation::{LADDER, NOTATIONS, Notation, by_extension, by_name, recognise};
use ladder_workspace::is_program;
use std::path::Path;

/// What a program is written in.
#[derive(Clone, Copy)]
pub(super) enum Form {
    /// This project's own text.
    Ladder,
    /// The notation of another system.
    Foreign(&'static dyn Notation),
}

impl Form {
    /// One of [`names`].
    pub(super) fn named(name: &str) -> Form {
        by_name(name).map_or(Form::Ladder, Form::Foreign)
    }

    /// What a file is written in: by its content, since other systems share their file names; else by the name of ours.
    pub(super) fn of(path: &Path, bytes: &[u8]) -> Option<Form> {
        match recognise(bytes) {
            Some(notation) => Some(Form::Foreign(notation)),
            None => is_program(path).then_some(Form::Ladder),
        }
    }

    /// What the name of an output asks for.
    pub(super) fn by_extension(path: &Path) -> Option<Form> {
        if is_program(path) {
            return Some(Form::Ladder);
        }
        by_extension(path.extension()?.to_str()?).map(Form::Foreign)
    }

    /// How the names of its files end.
    pub(super) fn extension(self) -> &'static str {
        match self {
            Form::Ladder => ladder_workspace::EXTENSION,
            Form::Foreign(notation) => notation.extensions().first().copied().unwrap_or("txt"),
        }
    }

    pub(super) fn is_ladder(self) -> bool {
        matches!(self, Form::Ladder)
    }
}

/// The names that `--from` and `--to` take.
pub(super) fn names() -> PossibleValuesParser {
    let own = PossibleValue::new(LADDER).help("Ladder text");
    let others = NOTATIONS
        .iter()
        .map(|notation| PossibleValue::new(notation.name()).help(notation.title()));
    PossibleValuesParser::new(std::iter::once(own).chain(others))
}

//! What the file of a program is written in, by its name and its content.

use crate::outcome::Failure;
use clap::builder::{PossibleValue, PossibleValuesParser};
pub(crate) use ladder_notations::Form;
use ladder_notations::{LADDER, NOTATIONS, by_extension as notation_of, recognise};
use ladder_workspace::{is_ladder_text, shown};
use std::path::Path;

/// `--from`, of commands that take one program.
#[derive(Debug, clap::Args)]
pub(crate) struct Notation {
    /// The notation of the program, as for `ladder convert`; without it its content decides
    #[arg(long, value_name = "NOTATION", value_parser = names(), hide_possible_values = true)]
    from: Option<String>,
}

impl Notation {
    /// What the program is written in, if that is asked for.
    pub(crate) fn form(&self) -> Option<Form> {
        self.from.as_deref().map(named)
    }
}

/// The form of one of [`names`].
pub(crate) fn named(name: &str) -> Form {
    Form::named(name).unwrap_or(Form::Ladder)
}

/// What a file is written in that a command takes for a program. One whose name ends like ours is ladder text; a
/// finding tells where it is not. Any other name may be ladder text too, but for those that belong to other systems.
///
/// # Errors
/// The name is another system's, and the content is in no notation that is known.
pub(crate) fn of_program(path: &Path, bytes: &[u8]) -> Result<Form, Failure> {
    if is_ladder_text(path) {
        return Ok(Form::Ladder);
    }
    match recognise(path, bytes) {
        Some(notation) => Ok(Form::Foreign(notation)),
        None if is_foreign_name(path) => Err(Failure::new(format!(
            "{}: this is in no notation that is known; if it is, `ladder convert --from` takes it",
            shown::path(path)
        ))),
        None => Ok(Form::Ladder),
    }
}

/// What the name of an output asks for.
pub(crate) fn by_extension(path: &Path) -> Option<Form> {
    if is_ladder_text(path) {
        return Some(Form::Ladder);
    }
    notation_of(path.extension()?.to_str()?).map(Form::Foreign)
}

/// Any text may end in `.txt`.
fn is_foreign_name(path: &Path) -> bool {
    let extension = path.extension().and_then(|extension| extension.to_str());
    extension
        .is_some_and(|extension| !extension.eq_ignore_ascii_case("txt") && notation_of(extension).is_some())
}

/// The names that `--from` takes.
pub(crate) fn names() -> PossibleValuesParser {
    listed(|notation| notation.is_read())
}

/// The names that `--to` takes.
pub(crate) fn targets() -> PossibleValuesParser {
    listed(|notation| notation.is_written())
}

fn listed(takes: fn(&dyn ladder_notations::Notation) -> bool) -> PossibleValuesParser {
    let own = PossibleValue::new(LADDER).help("Ladder text");
    let others = NOTATIONS.iter().filter(|notation| takes(**notation));
    let others = others.map(|notation| PossibleValue::new(notation.name()).help(notation.title()));
    PossibleValuesParser::new(std::iter::once(own).chain(others))
}

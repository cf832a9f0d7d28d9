//! Ladder programs in the notations of other systems.
//!
//! ```text
//! foreign bytes --Notation::read--> ProgramSketch + Report --convert--> ladder text, places, report
//! ladder text   --analysis--------> Analysis --Notation::write-------> foreign text + Report
//! ```
//!
//! A notation is one folder here and one line in [`NOTATIONS`]. It knows no files and no layout: what it reads is a
//! sketch, which the one writer of `ladder-format` draws; what it writes comes from an analysed program. Nothing is
//! dropped silently: the [`Report`] says of each element what became of it.

pub mod circuit;
#[cfg(feature = "click")]
mod click;
mod comments;
mod cplc_draft;
mod finding;
mod foreign;
mod form;
mod iot;
pub mod ldmicro;
pub mod names;
mod place;
mod remark;
mod report;
mod source;
mod stand_in;
mod textbook;

pub use cplc_draft::conversion as conversion_of_cplc_draft;
pub use finding::Finding;
pub use foreign::{Foreign, Mark};
pub use form::Form;
pub use ladder_syntax::LineColumn;
pub use names::Names;
pub use place::Lines;
pub use remark::{Remark, remarks};
pub use report::{Entry, Outcome, Report, Tally};
pub use source::{Companion, Source};

use ladder_analysis::Analysis;
use ladder_format::program::{ProgramSketch, WrittenProgram};
use ladder_syntax::TextSize;
use std::fmt;

/// All of them, in the order in which they are asked whether a text is theirs.
pub const NOTATIONS: &[&dyn Notation] = &[
    &textbook::Textbook,
    &cplc_draft::CplcDraft,
    &ldmicro::Ldmicro,
    &ldmicro::LdmicroText,
    &iot::Iot,
    #[cfg(feature = "click")]
    &click::Click,
    #[cfg(feature = "click")]
    &click::ClickGrid,
];

/// The name of this project's own notation, beside those of [`NOTATIONS`].
pub const LADDER: &str = "clad";

/// A way to write ladder programs that is not this project's own.
pub trait Notation: Sync {
    /// What a command line calls it: `ldmicro`.
    fn name(&self) -> &'static str;

    /// What a person calls it: `LDmicro program`.
    fn title(&self) -> &'static str;

    /// How its files' names end, without the dot, the usual one first. Other systems may use the same; none: the
    /// names show nothing.
    fn extensions(&self) -> &'static [&'static str];

    /// Whether a file is in this notation, from its content alone. No more than the first lines are looked at.
    fn recognises(&self, bytes: &[u8]) -> bool;

    /// Whether a run of such a program is about its coils, and nothing else is shown of it unless asked for.
    fn shows_coils(&self) -> bool {
        false
    }

    /// Whether a file that lies beside a program belongs to it: `program` is the stem of the program's name, `file` the
    /// whole name of the other. Who reads the program from a folder hands such files in as [`Source::companions`].
    fn has_companion(&self, _program: &str, _file: &str) -> bool {
        false
    }

    /// Reads a program.
    ///
    /// # Errors
    ///
    /// If the file is not in this notation, is broken, or larger than what is read.
    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError>;

    /// Writes a program that has no errors.
    ///
    /// # Errors
    ///
    /// If nothing of it can be expressed in this notation. A part that cannot be is an entry of the report.
    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError>;
}

/// What was read.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Reading {
    /// The program, ready to be written.
    pub program: ProgramSketch,
    /// Where in the foreign file things are: the origins in the sketch are indices into this.
    pub places: Vec<LineColumn>,
    /// What became of each element.
    pub report: Report,
    /// What the other system itself would complain about.
    pub findings: Vec<Finding>,
}

impl Reading {
    /// Notes a place of the foreign file; what is made from it gets the number that comes back.
    pub fn origin(&mut self, place: LineColumn) -> u32 {
        self.places.push(place);
        self.places.len() as u32 - 1
    }
}

/// What was written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Writing {
    /// The foreign file.
    pub bytes: Vec<u8>,
    /// What belongs beside it, each under its own name.
    pub companions: Vec<Companion>,
    /// What became of each element; places are those of the ladder text.
    pub report: Report,
}

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

/// The notation with this name.
pub fn by_name(name: &str) -> Option<&'static dyn Notation> {
    NOTATIONS.iter().copied().find(|notation| notation.name() == name)
}

/// The notation that a file is in, by its content.
pub fn recognise(bytes: &[u8]) -> Option<&'static dyn Notation> {
    NOTATIONS
        .iter()
        .copied()
        .find(|notation| notation.recognises(bytes))
}

/// The notation that a file's name asks for when it is written: the only one, or the first, whose names end so.
pub fn by_extension(extension: &str) -> Option<&'static dyn Notation> {
    NOTATIONS
        .iter()
        .copied()
        .find(|notation| has_extension(*notation, extension))
}

/// Whether the names of a notation's files may end so.
pub fn has_extension(notation: &dyn Notation, extension: &str) -> bool {
    let mut own = notation.extensions().iter();
    own.any(|own| own.eq_ignore_ascii_case(extension))
}

/// A foreign program as ladder text.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Converted {
    /// The text, and the places in it that were made from something.
    pub written: WrittenProgram,
    /// Where in the foreign file that something is.
    pub places: Vec<LineColumn>,
    /// What became of each element.
    pub report: Report,
    /// What the other system itself would complain about.
    pub findings: Vec<Finding>,
}

impl Converted {
    /// The place of the foreign file that the text at an offset was made from; its beginning if it was made from
    /// nothing.
    pub fn place_of(&self, offset: TextSize) -> LineColumn {
        self.written
            .origin_at(offset)
            .and_then(|origin| self.places.get(origin as usize).copied())
            .unwrap_or(LineColumn::START)
    }
}

/// Reads a foreign program and writes it as ladder text.
///
/// # Errors
///
/// As [`Notation::read`].
pub fn convert(
    notation: &dyn Notation,
    source: &Source<'_>,
    options: &ladder_format::Options,
) -> Result<Converted, ReadError> {
    let Reading {
        program,
        places,
        report,
        findings,
    } = notation.read(source)?;
    Ok(Converted {
        written: program.write(options),
        places,
        report,
        findings,
    })
}

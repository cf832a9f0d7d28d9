//! Blocks of SIMATIC controllers as ladder text, and back: source documents (`.s7dcl` with `.s7res`) and SimaticML (`.xml`).
//!
//! ```text
//! .s7dcl, .scl --read--> Unit: declarations, and networks as wires between points, or as text
//! .xml ---xml--->    |        (what it uses of other files: project)
//!                    '--sketch--> sketch of a ladder program, report, findings
//! program ------write--> Unit: the program as a function block, and what it uses
//!                          |
//!                          +--document---> .s7dcl, .s7res
//!                          '--simaticml--> .xml
//! ```
#![forbid(unsafe_code)]

mod cursor;
mod model;
mod operand;
mod project;
mod read;
mod scope;
mod sketch;
mod standard;
mod write;
mod xml;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, Reach, ReadError, Reading, Source, Target, WriteError, Writing};
use model::{Kind, Unit};
use scope::Library;
use write::Made;

/// A longer line is not read: to say a place its line is counted through.
const LONGEST_LINE: usize = 64 << 10;

/// Source documents.
#[derive(Debug)]
pub struct Simatic;

/// SimaticML.
#[derive(Debug)]
pub struct SimaticMl;

/// Sources in SCL.
#[derive(Debug)]
pub struct SimaticScl;

/// The first lines of a file.
fn head(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(4 << 10)]).into_owned()
}

fn bounded<'s>(source: &Source<'s>) -> Result<&'s str, ReadError> {
    let text = source.text()?;
    if text.lines().any(|line| line.len() > LONGEST_LINE) {
        let message = format!(
            "a line is longer than {} KiB; exports have short ones",
            LONGEST_LINE >> 10
        );
        return Err(ReadError::whole(message));
    }
    Ok(text)
}

/// The sketch of a block, which uses what comes with it in its file, and what other files of its project declare.
fn sketched(source: &Source<'_>, unit: &Unit, next: &[Unit]) -> Reading {
    let declared = project::declared(source);
    let mut library: Library<'_> = Library::new();
    for unit in std::iter::once(unit).chain(next) {
        library.insert(unit.name.to_lowercase(), Ok(unit));
    }
    for (name, other) in declared.iter().flat_map(|file| &file.1) {
        let other = || other.as_ref().map_err(Clone::clone);
        library.entry(name.to_lowercase()).or_insert_with(other);
    }
    sketch::reading(unit, &library)
}

/// What the controllers have.
const TARGET: Target = Target {
    has_system_tag: standard::has,
    has_calls_in_formulas: false,
    ..Target::BLOCKS_ALONE
};

/// Writes the units of a program.
fn written(analysis: &Analysis, write: impl Fn(Made) -> Writing) -> Result<Writing, WriteError> {
    TARGET.write(analysis, |analysis, unwritable| {
        write::made(analysis, unwritable).map(&write)
    })
}

impl Notation for Simatic {
    fn name(&self) -> &'static str {
        "simatic"
    }

    fn title(&self) -> &'static str {
        "SIMATIC source document"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["s7dcl"]
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        read::recognises(&head(bytes))
    }

    fn has_companion(&self, _program: &str, file: &str) -> bool {
        project::is_file(file)
    }

    fn reach(&self) -> Reach {
        Reach::Project(None)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let text = bounded(source)?;
        let unit = read::unit(text, &project::texts(source, &source.name)?)?;
        Ok(sketched(source, &unit, &[]))
    }

    fn writes_other_files(&self) -> bool {
        true
    }

    fn writes_unread(&self) -> bool {
        true
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        written(analysis, write::document::writing)
    }
}

impl Notation for SimaticMl {
    fn name(&self) -> &'static str {
        "simaticml"
    }

    fn title(&self) -> &'static str {
        "SimaticML"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["xml"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        xml::recognises(&head(bytes))
    }

    fn has_companion(&self, _program: &str, file: &str) -> bool {
        project::is_file(file)
    }

    fn reach(&self) -> Reach {
        Reach::Project(None)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let unit = xml::unit(bounded(source)?)?;
        Ok(sketched(source, &unit, &[]))
    }

    fn writes_other_files(&self) -> bool {
        true
    }

    fn writes_unread(&self) -> bool {
        true
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        written(analysis, write::simaticml::writing)
    }
}

impl Notation for SimaticScl {
    fn name(&self) -> &'static str {
        "scl"
    }

    fn title(&self) -> &'static str {
        "SIMATIC source in SCL"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["scl"]
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn recognises(&self, _bytes: &[u8]) -> bool {
        false
    }

    fn is_written(&self) -> bool {
        false
    }

    fn has_companion(&self, _program: &str, file: &str) -> bool {
        project::is_file(file)
    }

    fn reach(&self) -> Reach {
        Reach::Project(None)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let mut units = read::source(bounded(source)?)?;
        // What runs is the organization block, else what comes last: it uses what is before it.
        let main = (units.iter().position(|unit| unit.kind == Kind::Organization))
            .or_else(|| units.iter().rposition(|unit| unit.kind.is_code()))
            .unwrap_or(units.len() - 1);
        let main = units.remove(main);
        Ok(sketched(source, &main, &units))
    }

    fn write(&self, _analysis: &Analysis) -> Result<Writing, WriteError> {
        Err(WriteError::new(
            "sources in SCL are not written: write a source document, `--to simatic`",
        ))
    }
}

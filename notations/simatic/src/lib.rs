//! Blocks of SIMATIC controllers as ladder text, and back: source documents (`.s7dcl` with `.s7res`) and SimaticML (`.xml`).
//!
//! ```text
//! .s7dcl, .scl --read--> Unit: declarations, and networks as wires between points, or as text
//! .xml ---xml--->    |
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
mod read;
mod scope;
mod sketch;
mod standard;
mod write;
mod xml;

use ladder_analysis::Analysis;
use ladder_notation::{Notation, ReadError, Reading, Source, Target, WriteError, Writing, text_of};
use model::{Kind, Unit};
use read::resource::Texts;
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

/// What the name of a file next to another ends with.
fn has_end(file: &str, end: &str) -> bool {
    let at = file.len().checked_sub(end.len());
    at.and_then(|at| file.get(at..))
        .is_some_and(|own| own.eq_ignore_ascii_case(end))
}

/// The blocks that stand next to one, in files whose names end so.
fn companions(
    source: &Source<'_>,
    end: &str,
    read: impl Fn(&str, &Source<'_>) -> Option<Result<Unit, ReadError>>,
) -> Vec<(String, Result<Unit, String>)> {
    let files = source.companions.iter().filter(|file| has_end(&file.name, end));
    files
        .filter_map(|file| {
            let stem = file.name[..file.name.len() - end.len()].to_owned();
            let unit = read(&stem, &Source::alone("", &file.bytes))?;
            Some(match unit {
                Ok(unit) => (unit.name.clone(), Ok(unit)),
                Err(error) => (stem, Err(error.to_string())),
            })
        })
        .collect()
}

/// The texts of the document with this stem.
fn texts(source: &Source<'_>, stem: &str) -> Result<Texts, ReadError> {
    let name = format!("{stem}.s7res");
    let file = source
        .companions
        .iter()
        .find(|file| file.name.eq_ignore_ascii_case(&name));
    file.map_or_else(
        || Ok(Texts::default()),
        |file| Ok(Texts::of(text_of(&file.bytes)?)),
    )
}

/// The sketch of a block, next to others and to tables of tags.
fn sketched(source: &Source<'_>, unit: &Unit, next: &[(String, Result<Unit, String>)]) -> Reading {
    let tables = source
        .companions
        .iter()
        .filter(|file| has_end(&file.name, ".xml") && xml::holds_tags(&head(&file.bytes)));
    // One that cannot be read declares nothing.
    let tags = tables.filter_map(|file| xml::tags(bounded(&Source::alone("", &file.bytes)).ok()?).ok());
    let tags: Vec<Unit> = tags.flatten().collect();
    let mut library: Library<'_> = Library::new();
    for tag in &tags {
        library.insert(tag.name.to_lowercase(), Ok(tag));
    }
    for (name, other) in next {
        library.insert(name.to_lowercase(), other.as_ref().map_err(Clone::clone));
    }
    library.insert(unit.name.to_lowercase(), Ok(unit));
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
        has_end(file, ".s7dcl") || has_end(file, ".s7res")
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let text = bounded(source)?;
        let unit = read::unit(text, &texts(source, &source.name)?)?;
        let next = companions(source, ".s7dcl", |stem, file| {
            Some(bounded(file).and_then(|text| read::unit(text, &texts(source, stem)?)))
        });
        Ok(sketched(source, &unit, &next))
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
        has_end(file, ".xml")
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let unit = xml::unit(bounded(source)?)?;
        let next = companions(source, ".xml", |_, file| {
            self.recognises(file.bytes)
                .then(|| bounded(file).and_then(xml::unit))
        });
        Ok(sketched(source, &unit, &next))
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
        has_end(file, ".scl") || has_end(file, ".xml")
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let mut units = read::source(bounded(source)?)?;
        // What runs is the organization block, else what comes last: it uses what is before it.
        let main = (units.iter().position(|unit| unit.kind == Kind::Organization))
            .or_else(|| units.iter().rposition(|unit| unit.kind.is_code()))
            .unwrap_or(units.len() - 1);
        let main = units.remove(main);
        let mut next = Vec::new();
        for file in source
            .companions
            .iter()
            .filter(|file| has_end(&file.name, ".scl"))
        {
            // One that cannot be read is reported where it is read itself.
            let others = bounded(&Source::alone("", &file.bytes)).and_then(read::source);
            next.extend(
                others
                    .unwrap_or_default()
                    .into_iter()
                    .map(|unit| (unit.name.clone(), Ok(unit))),
            );
        }
        next.extend(units.into_iter().map(|unit| (unit.name.clone(), Ok(unit))));
        Ok(sketched(source, &main, &next))
    }

    fn write(&self, _analysis: &Analysis) -> Result<Writing, WriteError> {
        Err(WriteError::new(
            "sources in SCL are not written: write a source document, `--to simatic`",
        ))
    }
}

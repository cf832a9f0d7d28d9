//! Programs of Rockwell's controllers as ladder text: L5X and L5K exports of Logix Designer, and rungs of RSLogix 500.
//!
//! ```text
//! L5X --l5x--> Project --survey--> tags with their values --sketch--> sketch of a ladder program, report, findings
//! L5K --l5k-->    |                                            |
//! rungs --slc-->  '--neutral--> rungs as parts --translate-----'
//! ```
//!
//! TIMER, COUNTER and CONTROL are structures here as they are there, and the instructions that keep their state in a tag
//! are blocks of the same name, which the program brings along: `TON(t,?,?)` is `[$TON]( t )`.
#![forbid(unsafe_code)]

mod aoi;
mod begin;
mod blocks;
mod calls;
mod declarations;
mod folder;
mod formula;
mod in_outs;
mod keep;
mod l5k;
mod l5x;
mod mnemonic;
mod model;
mod names;
mod opened;
mod operand;
mod plan;
mod renamed;
mod repeated;
mod scope;
mod sketch;
mod slc;
mod structured;
mod survey;
mod times;
mod translate;
mod types;
mod unit;
mod unread;
mod values;
mod words;
mod write;

use ladder_analysis::Analysis;
use ladder_notation::{
    Kept, LineColumn, Notation, Project, ReadError, Reading, Source, WriteError, Writing, WrittenProject,
    text_of,
};

/// A larger file is not read: whole projects are large.
const MOST_BYTES: usize = 64 << 20;
/// How many characters are counted through in all.
const MOST_WORK: u64 = 20_000_000_000;

/// L5X exports of Logix Designer.
#[derive(Debug)]
pub struct L5x;

/// L5K exports of Logix Designer.
#[derive(Debug)]
pub struct L5k;

/// Rungs of RSLogix 500.
#[derive(Debug)]
pub struct Rslogix500;

fn text<'s>(source: &Source<'s>) -> Result<&'s str, ReadError> {
    if source.bytes.len() > MOST_BYTES {
        let message = format!("the file is larger than {} MiB", MOST_BYTES >> 20);
        return Err(ReadError::whole(message));
    }
    let text = text_of(source.bytes)?;
    // To say the column of a place its line is counted through.
    let mut work = 0u64;
    for (number, line) in text.lines().enumerate() {
        let places = line.bytes().filter(|c| matches!(c, b'(' | b'<' | b';')).count();
        work += (line.len() as u64).saturating_mul(places as u64);
        if work > MOST_WORK {
            let place = LineColumn::line(number as u32 + 1);
            let message =
                "there is too much on one line; put each element on a line of its own, as exports have them";
            return Err(ReadError::at(place, message));
        }
    }
    Ok(text)
}

/// The first lines of a file.
fn head(bytes: &[u8]) -> String {
    String::from_utf8_lossy(&bytes[..bytes.len().min(16 << 10)]).into_owned()
}

fn not_written() -> WriteError {
    WriteError::new("such files are read, and not written")
}

impl Notation for L5x {
    fn name(&self) -> &'static str {
        "l5x"
    }

    fn title(&self) -> &'static str {
        "Logix L5X export"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["l5x"]
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        head(bytes).contains(&format!("<{}", l5x::ROOT))
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let text = text(source)?;
        let mut project = l5x::read(text)?;
        repeated::refuse_repeated(&mut project);
        in_outs::size_in_outs(&mut project);
        Ok(sketch::sketch(&project, text))
    }

    fn writes_unread(&self) -> bool {
        true
    }

    fn writes_other_files(&self) -> bool {
        true
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        write::write(analysis)
    }

    fn has_projects(&self) -> bool {
        true
    }

    fn write_project(
        &self,
        project: &Project,
        kept: Option<&Kept<'_>>,
    ) -> Result<WrittenProject, WriteError> {
        match kept {
            Some(kept) => keep::write(project, kept),
            None => write::write_project(project).map(|writing| WrittenProject {
                reports: project.reports(&writing.report),
                bytes: writing.bytes,
            }),
        }
    }
}

impl Notation for L5k {
    fn name(&self) -> &'static str {
        "l5k"
    }

    fn title(&self) -> &'static str {
        "Logix L5K export"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["l5k"]
    }

    fn owns_extension(&self) -> bool {
        true
    }

    fn is_written(&self) -> bool {
        false
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        l5k::recognises(&head(bytes))
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let text = text(source)?;
        let mut project = l5k::read(text)?;
        repeated::refuse_repeated(&mut project);
        in_outs::size_in_outs(&mut project);
        Ok(sketch::sketch(&project, text))
    }

    fn write(&self, _: &Analysis) -> Result<Writing, WriteError> {
        Err(not_written())
    }
}

impl Notation for Rslogix500 {
    fn name(&self) -> &'static str {
        "rslogix500"
    }

    fn title(&self) -> &'static str {
        "RSLogix 500 text"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["slc"]
    }

    fn is_written(&self) -> bool {
        false
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        slc::recognises(&head(bytes))
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let text = source.text()?;
        Ok(sketch::sketch(&slc::read(text)?, text))
    }

    fn write(&self, _: &Analysis) -> Result<Writing, WriteError> {
        Err(not_written())
    }
}

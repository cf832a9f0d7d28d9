//! From a file of another system to ladder text.

use super::{Companion, Content, Finding, LineColumn, Notation, ReadError, Reading, Report, Source};
use ladder_format::program::{Item, ProgramSketch, WrittenProgram};
use ladder_syntax::TextSize;
use std::collections::HashSet;

/// The rule about comments that switch off what is not found.
pub(super) const UNUSED: &str = "suppression-unused";

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
    /// The files of a project, for a folder; empty: the program is one file.
    pub files: Vec<Companion>,
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
        mut program,
        places,
        report,
        findings,
        files,
    } = notation.read(source)?;
    let mut written = program.write(options);
    if without_idle_directives(&mut program, &written.text) {
        written = program.write(options);
    }
    let files = files.into_iter().map(|file| Companion {
        name: file.name,
        bytes: match file.content {
            Content::Program(program) => program.write(options).text.into_bytes(),
            Content::Text(text) => text.into_bytes(),
        },
    });
    Ok(Converted {
        files: files.collect(),
        written,
        places,
        report,
        findings,
    })
}

/// Takes out the importer's comments that switch off what is not found: a finding about them would be one about a line that
/// nobody wrote. Comes back whether there were any.
fn without_idle_directives(program: &mut ProgramSketch, text: &str) -> bool {
    let is_allow = |item: &Item| matches!(item, Item::Directive(said) if said.starts_with("allow"));
    if !program.items.iter().any(is_allow) {
        return false;
    }
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(text).into(), "");
    let found = analysis.diagnostics().iter();
    let idle: HashSet<usize> = found
        .filter(|found| found.rule.name() == UNUSED)
        .map(|found| usize::from(found.range.start()))
        .collect();
    let mut at = 0;
    let before = program.items.len();
    program.items.retain(|item| {
        let Item::Directive(said) = item else { return true };
        let comment = format!("# ladder: {said} #");
        let Some(start) = text[at..].find(&comment).map(|start| at + start) else {
            return true;
        };
        at = start + comment.len();
        !idle.contains(&start)
    });
    program.items.len() < before
}

//! The two notations: what they share, and where they part.

use super::checks::{self, Words};
use super::python_name::python_name;
use super::{dsl, grid, model, nicknames, order, read_back, sketch};
use ladder_analysis::{Analysis, Severity};
use ladder_notation::{
    Finding, Notation, Outcome, Reach, ReadError, Reading, Source, Target, WriteError, Writing,
};

/// The Python DSL.
#[derive(Debug)]
pub struct Click;

impl Notation for Click {
    fn name(&self) -> &'static str {
        "click"
    }

    fn title(&self) -> &'static str {
        "Click program in Python"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["py"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        dsl::recognises(bytes)
    }

    fn editor_language(&self) -> Option<&'static str> {
        Some("ladder-click")
    }

    fn introduces(&self, line: &str) -> bool {
        // The rung of an `if True:` is on the line below.
        line.trim_start().starts_with("if ")
    }

    fn has_companion(&self, program: &str, file: &str) -> bool {
        nicknames::is_file_of(program, file)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        let mut nicknames = nicknames::next_to(source)?;
        let mut program = dsl::read_with(source.text()?, &nicknames.all)?;
        program.nicknames = std::mem::take(&mut nicknames.all);
        nicknames.unused(&program);
        let mut reading = reading(&program, Words::Dsl);
        reading.report.entries.splice(0..0, nicknames.report.entries);
        reading.findings.splice(0..0, nicknames.findings);
        Ok(reading)
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        Target::SERIES_AND_BRANCHES.write(analysis, |analysis, _| {
            let (mut program, mut report) = read_back::program(analysis)?;
            order::remarks(&program, order::Look::InPlace, &mut report);
            let text = dsl::write(&program, &mut report);
            report.entries.sort_by_key(|entry| entry.place);
            for nickname in &mut program.nicknames {
                nickname.name = python_name(&nickname.name);
            }
            Ok(Writing {
                bytes: text.into_bytes(),
                companions: nicknames::companion(&program.nicknames).into_iter().collect(),
                report,
            })
        })
    }
}

/// The grid of its ladders.
#[derive(Debug)]
pub struct ClickGrid;

impl Notation for ClickGrid {
    fn name(&self) -> &'static str {
        "click-csv"
    }

    fn title(&self) -> &'static str {
        "grid of a Click program"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["csv"]
    }

    fn recognises(&self, bytes: &[u8]) -> bool {
        grid::is_grid(bytes)
    }

    fn has_companion(&self, program: &str, file: &str) -> bool {
        nicknames::is_file_of(program, file) || grid::is_subroutine_of(program, file)
    }

    fn reach(&self) -> Reach {
        Reach::FolderAnd(grid::SUBROUTINES)
    }

    fn read(&self, source: &Source<'_>) -> Result<Reading, ReadError> {
        grid::read(source, |program| reading(program, Words::Grid))
    }

    fn write(&self, analysis: &Analysis) -> Result<Writing, WriteError> {
        Target::SERIES_AND_BRANCHES.write(analysis, |analysis, _| {
            let (program, mut report) = read_back::program(analysis)?;
            order::remarks(&program, order::Look::Before, &mut report);
            let (text, companions) = grid::write(&program, &mut report);
            report.entries.sort_by_key(|entry| entry.place);
            Ok(Writing {
                bytes: text.into_bytes(),
                companions,
                report,
            })
        })
    }
}

/// A program of either notation as ladder text, with what Click itself would complain about.
fn reading(program: &model::Program, words: Words) -> Reading {
    let mut reading = sketch::sketch(program);
    let mut findings = checks::findings(program, words);
    for entry in &reading.report.entries {
        let Outcome::Refused(why) = &entry.outcome else {
            continue;
        };
        let is_said = |finding: &Finding| finding.place == entry.place && finding.severity == Severity::Error;
        if !findings.iter().any(is_said) {
            let shown: String = entry.element.chars().take(80).collect();
            findings.push(Finding {
                place: entry.place,
                severity: Severity::Error,
                check: "click-element",
                message: format!("`{shown}` stays as a comment: {why}"),
            });
        }
    }
    if program.has_no_main() {
        // The main program is another file.
        findings.retain(|found| found.check != "click-c0201");
    }
    findings.sort_by_key(|finding| finding.place);
    reading.findings = findings;
    reading
}

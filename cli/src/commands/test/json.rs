//! Results for machines: one object. Its members are documented; nothing may be renamed.

use super::coverage;
use super::mutation;
use super::report::{CaseReport, DifferenceReport, FaultReport, FileReport, ViolationReport};
use super::{All, Writer};
use crate::findings::{FileRange, Problem};
use crate::json::to_writer;
use serde::Serialize;
use std::io::{self, Write};

/// The files come first, each as soon as it is there.
#[derive(Default)]
pub(super) struct Json {
    begun: bool,
}

impl Writer for Json {
    fn file(&mut self, report: &FileReport, out: &mut dyn Write) -> io::Result<()> {
        let before = if self.begun { ",\n" } else { "{\"files\": [\n" };
        self.begun = true;
        out.write_all(before.as_bytes())?;
        to_writer(out, &Suite::new(report))
    }

    fn end(&mut self, all: &All, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "\n],\n\"summary\": ")?;
        to_writer(
            out,
            &Summary {
                files: all.tally.files,
                passed: all.tally.passed,
                failed: all.tally.failed,
                not_run: all.tally.broken,
                seconds: all.seconds,
            },
        )?;
        if let Some(mutated) = all.mutated {
            write!(out, ",\n\"mutation\": ")?;
            to_writer(out, &mutation::json(mutated))?;
        }
        if let Some(covered) = all.covered {
            write!(out, ",\n\"coverage\": ")?;
            to_writer(out, &coverage::json(covered))?;
        }
        writeln!(out, "}}")
    }
}

#[derive(Serialize)]
struct Summary {
    files: usize,
    passed: usize,
    failed: usize,
    /// Files whose scenarios did not run.
    not_run: usize,
    seconds: f64,
}

#[derive(Serialize)]
struct Suite<'a> {
    file: &'a str,
    program: Option<&'a str>,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    unread_parts: &'a [String],
    seconds: f64,
    /// With the members of the findings of `ladder check`.
    errors: &'a [Problem],
    scenarios: Vec<Scenario<'a>>,
}

impl<'a> Suite<'a> {
    fn new(report: &'a FileReport) -> Suite<'a> {
        Suite {
            file: &report.file,
            program: report.program.as_ref().map(|program| program.file.as_str()),
            unread_parts: &report.unread_parts,
            seconds: report.seconds,
            errors: &report.problems,
            scenarios: report.cases.iter().map(Scenario::new).collect(),
        }
    }
}

#[derive(Serialize)]
struct Scenario<'a> {
    name: &'a str,
    line: u32,
    column: u32,
    passed: bool,
    steps: usize,
    scans: u64,
    seconds: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    stopped_in_step: Option<usize>,
    differences: Vec<Difference<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    violations: Vec<Violation<'a>>,
    /// Where it leaves what is assumed, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    outside: Option<&'a str>,
    faults: Vec<Fault<'a>>,
    /// What is shown to people.
    #[serde(skip_serializing_if = "String::is_empty")]
    diagram: String,
    /// The files with pictures of the machine.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    pictures: &'a [String],
}

impl<'a> Scenario<'a> {
    fn new(case: &'a CaseReport) -> Scenario<'a> {
        Scenario {
            name: &case.name,
            line: case.place.line,
            column: case.place.column,
            passed: case.passed,
            steps: case.steps,
            scans: case.scans,
            seconds: case.seconds,
            stopped_in_step: case.stopped,
            differences: case.differences.iter().map(Difference::new).collect(),
            violations: case.violations.iter().map(Violation::new).collect(),
            outside: case.outside.as_deref(),
            faults: case.faults.iter().map(Fault::new).collect(),
            diagram: case.drawn(),
            pictures: &case.pictures,
        }
    }
}

#[derive(Serialize)]
struct Difference<'a> {
    tag: &'a str,
    line: u32,
    column: u32,
    steps: &'a [usize],
    /// Where the values are that differ.
    places: Vec<Place>,
    message: &'a str,
}

impl<'a> Difference<'a> {
    fn new(difference: &'a DifferenceReport) -> Difference<'a> {
        Difference {
            tag: &difference.tag,
            line: difference.place.line,
            column: difference.place.column,
            steps: &difference.steps,
            places: difference.places.iter().map(Place::new).collect(),
            message: &difference.sentence,
        }
    }
}

#[derive(Serialize)]
struct Violation<'a> {
    property: &'a str,
    /// Of its name.
    line: u32,
    column: u32,
    scan: u64,
    steps: &'a [usize],
    message: &'a str,
}

impl<'a> Violation<'a> {
    fn new(violation: &'a ViolationReport) -> Violation<'a> {
        Violation {
            property: &violation.name,
            line: violation.place.line,
            column: violation.place.column,
            scan: violation.scan,
            steps: &violation.steps,
            message: &violation.sentence,
        }
    }
}

/// From 1, columns in characters; `end_column` is the one after the last.
#[derive(Serialize)]
struct Place {
    line: u32,
    column: u32,
    end_column: u32,
}

impl Place {
    fn new(place: &FileRange) -> Place {
        Place {
            line: place.line,
            column: place.column,
            end_column: place.end_column,
        }
    }
}

#[derive(Serialize)]
struct Fault<'a> {
    file: &'a str,
    line: u32,
    column: u32,
    scan: u64,
    message: &'a str,
}

impl<'a> Fault<'a> {
    fn new(fault: &'a FaultReport) -> Fault<'a> {
        Fault {
            file: &fault.place.file,
            line: fault.place.line,
            column: fault.place.column,
            scan: fault.scan,
            message: &fault.message,
        }
    }
}

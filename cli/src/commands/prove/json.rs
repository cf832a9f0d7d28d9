//! Answers for machines: one object. Its members are documented; nothing may be renamed.

use super::file::{FileAnswers, PropertyAnswer};
use crate::findings::Problem;
use crate::json::to_writer;
use ladder_analysis::values::value::Value;
use ladder_prover::{Shown, Verdict};
use ladder_simulator::{Point, value_text};
use serde::Serialize;
use std::io::{self, Write};

#[derive(Serialize)]
struct All<'a> {
    files: Vec<Suite<'a>>,
    seconds: f64,
}

#[derive(Serialize)]
struct Suite<'a> {
    file: &'a str,
    program: &'a str,
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    unread_parts: &'a [String],
    /// What the answers rest on, where there are plants: these, how much is assumed, and which of their outputs never change.
    #[serde(skip_serializing_if = "Option::is_none")]
    beside: Option<Beside<'a>>,
    seconds: f64,
    interval_ns: i64,
    /// With the members of the findings of `ladder check`.
    errors: &'a [Problem],
    properties: Vec<Property<'a>>,
}

#[derive(Serialize)]
struct Beside<'a> {
    plants: &'a [String],
    assumptions: usize,
    unchanging: &'a [String],
}

#[derive(Serialize)]
struct Property<'a> {
    name: &'a str,
    line: u32,
    column: u32,
    verdict: &'static str,
    /// `any` or `exact`: for which times it is proved.
    #[serde(skip_serializing_if = "Option::is_none")]
    times: Option<&'static str>,
    /// In which scan, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    scan: Option<usize>,
    /// How many scans were searched, where it is not decided.
    #[serde(skip_serializing_if = "Option::is_none")]
    scans: Option<usize>,
    /// Over how many scans the induction goes that proved it.
    #[serde(skip_serializing_if = "Option::is_none")]
    k: Option<usize>,
    never_triggered: bool,
    /// Of what is proved beside a plant and is not about that: whether it was not proved without.
    #[serde(skip_serializing_if = "Option::is_none")]
    needs_plant: Option<bool>,
    /// In which scan a fault happens in the property itself, from 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    fault_scan: Option<usize>,
    open: Vec<Open<'a>>,
    /// What the solver had when it was decided, and how long that took with those that were decided with it.
    clauses: u64,
    seconds: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    trace: Option<Vec<Row<'a>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    scenario: Option<&'a str>,
}

#[derive(Serialize)]
struct Open<'a> {
    what: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    file: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u32>,
}

#[derive(Serialize)]
struct Row<'a> {
    tag: &'a str,
    given: bool,
    /// One for each scan.
    values: Vec<String>,
}

fn row((point, values): &(Point, Vec<Value>), given: bool) -> Row<'_> {
    Row {
        tag: &point.name,
        given,
        values: values
            .iter()
            .map(|value| value_text::display(value, point.ty))
            .collect(),
    }
}

fn property(of: &PropertyAnswer) -> Property<'_> {
    let shown: Option<&Shown> = match &of.answer.verdict {
        Verdict::Violated(shown) | Verdict::Possible(shown) => Some(shown),
        _ => None,
    };
    let trace = shown.map(|shown| {
        let given = shown.given.iter().map(|values| row(values, true));
        let seen = shown.seen.iter().map(|values| row(values, false));
        given.chain(seen).collect()
    });
    Property {
        name: &of.name,
        line: of.place.line,
        column: of.place.column,
        verdict: of.answer.verdict.word(),
        times: of.answer.verdict.times(),
        scan: of.answer.verdict.scan(),
        scans: match of.answer.verdict {
            Verdict::Unknown(scans) => Some(scans),
            _ => None,
        },
        k: of.answer.k,
        never_triggered: of.answer.never_triggered,
        needs_plant: of.answer.needs_plant,
        fault_scan: of.answer.fault,
        clauses: of.answer.clauses,
        seconds: of.answer.time.as_secs_f64(),
        open: (of.open.iter())
            .map(|(what, place)| Open {
                what,
                file: place.as_ref().map(|place| place.file.as_str()),
                line: place.as_ref().map(|place| place.line),
            })
            .collect(),
        trace,
        scenario: of.scenario.as_deref(),
    }
}

pub(super) fn write(all: &[FileAnswers], seconds: f64, out: &mut dyn Write) -> io::Result<()> {
    let files = all.iter().map(|answers| Suite {
        file: &answers.file,
        program: &answers.program,
        unread_parts: &answers.unread_parts,
        beside: (!answers.basis.plants.is_empty()).then_some(Beside {
            plants: &answers.basis.plants,
            assumptions: answers.basis.assumptions,
            unchanging: &answers.basis.unchanging,
        }),
        seconds: answers.seconds,
        interval_ns: answers.interval,
        errors: &answers.problems,
        properties: answers.properties.iter().map(property).collect(),
    });
    let all = All {
        files: files.collect(),
        seconds,
    };
    to_writer(out, &all)?;
    writeln!(out)
}

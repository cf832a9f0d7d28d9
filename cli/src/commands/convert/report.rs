//! What became of the elements, for people and for machines.

use crate::json::to_writer_pretty;
use crate::outcome::{Failure, Outcome};
use crate::output::{Existing, Output};
use crate::terminal;
use ladder_analysis::Severity;
use ladder_ide::markdown::escaped;
use ladder_notations::{Finding, LineColumn, Outcome as Became, Report, Tally};
use ladder_workspace::shown;
use serde::Serialize;
use std::io::Write;
use std::path::Path;

/// Whose places a report has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    /// Those of the file that was named.
    Source,
    /// Those of the ladder text between two foreign notations, which nobody sees.
    Between,
}

/// What became of one program.
pub(super) struct Account {
    file: String,
    entries: Vec<Entry>,
    tally: Tally,
    has_errors: bool,
}

/// One element, or a finding. The names of the members are documented; nothing may be renamed.
#[derive(Serialize)]
struct Entry {
    file: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    column: Option<u32>,
    outcome: &'static str,
    element: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

impl Entry {
    /// `12:5`: nothing where it is in a text that nobody sees.
    fn place(&self) -> Option<String> {
        Some(format!("{}:{}", self.line?, self.column?))
    }

    fn line(&self) -> String {
        let place = self.place().map(|place| format!(":{place}")).unwrap_or_default();
        let element = shown::line(&self.element);
        let reason = self.reason.as_deref().map(shown::line);
        let reason = reason.map(|reason| format!(": {reason}")).unwrap_or_default();
        format!("{}{place}: {}: {element}{reason}", self.file, self.outcome)
    }
}

impl Account {
    pub(super) fn new(file: String) -> Account {
        Account {
            file,
            entries: Vec::new(),
            tally: Tally::default(),
            has_errors: false,
        }
    }

    pub(super) fn add(&mut self, side: Side, report: &Report, findings: &[Finding]) {
        for entry in &report.entries {
            let (outcome, reason) = match &entry.outcome {
                Became::Translated => ("translated", None),
                Became::Approximated(why) => ("approximated", Some(why.clone())),
                Became::Refused(why) => ("refused", Some(why.clone())),
            };
            self.push(side, entry.place, outcome, entry.element.clone(), reason);
        }
        let told = report.told();
        for found in findings {
            self.has_errors |= found.severity == Severity::Error;
            if told(found) {
                continue;
            }
            let severity = found.severity.name();
            self.push(
                side,
                found.place,
                severity,
                found.check.to_owned(),
                Some(found.message.clone()),
            );
        }
        self.entries.sort_by_key(|entry| (entry.line, entry.column));
        let tally = report.tally();
        self.tally.translated += tally.translated;
        self.tally.approximated += tally.approximated;
        self.tally.refused += tally.refused;
    }

    fn push(
        &mut self,
        side: Side,
        place: LineColumn,
        outcome: &'static str,
        element: String,
        reason: Option<String>,
    ) {
        let place = (side == Side::Source).then_some(place);
        self.entries.push(Entry {
            file: self.file.clone(),
            line: place.map(|place| place.line),
            column: place.map(|place| place.column),
            outcome,
            element,
            reason,
        });
    }

    fn counts(&self) -> String {
        let Tally {
            translated,
            approximated,
            refused,
        } = self.tally;
        format!("{translated} translated, {approximated} approximated, {refused} refused")
    }

    /// What was refused, and errors in the program, are findings.
    pub(super) fn outcome(&self) -> Outcome {
        if self.tally.refused > 0 || self.has_errors {
            Outcome::Findings
        } else {
            Outcome::Fine
        }
    }
}

/// A line for each remark, and one for each program.
pub(super) fn people(accounts: &[Account]) {
    let mut out = String::new();
    for account in accounts {
        for entry in &account.entries {
            if entry.reason.is_some() {
                out.push_str(&entry.line());
                out.push('\n');
            }
        }
        out.push_str(&format!("{}: {}\n", account.file, account.counts()));
    }
    if !out.is_empty() {
        terminal::plain(&out.trim_end());
    }
}

/// One array of objects, on stderr: stdout may be the program.
pub(super) fn json(accounts: &[Account]) -> Result<(), Failure> {
    let mut err = terminal::stderr();
    write_json(accounts, &mut err)?;
    err.flush()?;
    Ok(())
}

fn write_json(accounts: &[Account], out: &mut impl Write) -> Result<(), Failure> {
    let entries: Vec<&Entry> = accounts.iter().flat_map(|account| &account.entries).collect();
    to_writer_pretty(&mut *out, &entries)
        .map_err(|error| Failure::new(format!("the report cannot be written: {error}")))?;
    writeln!(out)?;
    Ok(())
}

/// A heading and a table for each program.
fn write_markdown(accounts: &[Account], out: &mut impl Write) -> std::io::Result<()> {
    for (index, account) in accounts.iter().enumerate() {
        let before = if index > 0 { "\n" } else { "" };
        writeln!(
            out,
            "{before}# {}\n\n{}",
            escaped(&account.file),
            account.counts()
        )?;
        if account.entries.is_empty() {
            continue;
        }
        writeln!(
            out,
            "\n| place | element | outcome | reason |\n| --- | --- | --- | --- |"
        )?;
        for entry in &account.entries {
            let place = entry.place().unwrap_or_default();
            let element = shown::line(&entry.element);
            let reason = shown::line(entry.reason.as_deref().unwrap_or_default());
            writeln!(
                out,
                "| {place} | {} | {} | {} |",
                escaped(&element),
                entry.outcome,
                escaped(&reason)
            )?;
        }
    }
    Ok(())
}

/// Every element in a file, whose name says how: the same JSON, a page of Markdown, or a line for each.
pub(super) fn file(accounts: &[Account], file: &Path, existing: Existing) -> Result<(), Failure> {
    let mut output = Output::open(Some(file), existing)?;
    let extension = file.extension().unwrap_or_default().to_ascii_lowercase();
    match extension.to_str() {
        Some("json") => write_json(accounts, &mut output)?,
        Some("md" | "markdown") => write_markdown(accounts, &mut output)?,
        _ => {
            for entry in accounts.iter().flat_map(|account| &account.entries) {
                writeln!(output, "{}", entry.line())?;
            }
        }
    }
    output.finish()
}

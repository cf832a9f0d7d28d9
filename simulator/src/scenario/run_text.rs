//! A run as the text of a scenario: a letter a step where that is short, else a column for each stretch in which nothing
//! changes, in pieces that fit on a screen.

use super::layout::layout;
use super::parse::TIME;
use crate::value_text;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::fmt::Write;
use unicode_width::UnicodeWidthStr;

/// Lines are not wider than this, if that can be.
const WIDTH: usize = 80;

/// Up to as many scans each has a column of its own.
const MOST_SCANS: usize = 60;

/// A row of a scenario that is to be written.
#[derive(Debug)]
pub struct RunRow {
    /// The tag.
    pub name: String,
    /// Whether it has an arrow.
    pub is_expected: bool,
    /// Whether its cells are levels.
    pub is_level: bool,
    /// Whether what is new goes on to be shown in the steps after it.
    pub goes_on: bool,
    /// For each column what is written there.
    pub cells: Vec<RunCell>,
}

/// What is written in a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RunCell {
    /// Given before its first scan, or expected after its last.
    New(String),
    /// The level that it has already.
    Still(String),
    /// Nothing.
    Nothing,
}

impl RunCell {
    fn text(&self, is_level: bool) -> &str {
        let text = match self {
            RunCell::New(text) | RunCell::Still(text) => text,
            RunCell::Nothing => return ".",
        };
        match text.as_str() {
            "~" => "~",
            "TRUE" if is_level => "-",
            _ if is_level => "_",
            text => text.strip_prefix("T#").unwrap_or(text),
        }
    }
}

/// How long columns are, in scans, and how long a scan is.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lengths<'a> {
    pub(super) columns: &'a [u64],
    pub(super) interval: i64,
}

impl Lengths<'_> {
    /// Of as many scans all columns are a multiple.
    fn step(&self) -> u64 {
        self.columns
            .iter()
            .fold(0, |step, &length| divisor(length, step))
            .max(1)
    }
}

/// A scenario of which every scan is known, with the rows' cells one for each; its steps are scans of this interval, in nanoseconds.
/// A column is a scan, or in a long run a stretch in which nothing changes.
pub fn run_text(mut rows: Vec<RunRow>, interval: i64, name: &str) -> String {
    let scans = rows.first().map_or(0, |row| row.cells.len());
    let each: Vec<u64> = vec![1; scans];
    let lengths = Lengths {
        columns: &each,
        interval,
    };
    let heading = heading(name);
    if scans <= MOST_SCANS
        && let Some(even) = even(&rows, lengths, 1)
    {
        return layout(&(heading + &even));
    }
    let changes = |scan: &usize| {
        let text = |row: &RunRow, scan: usize| row.cells[scan].text(row.is_level).to_owned();
        *scan == 0 || rows.iter().any(|row| text(row, *scan) != text(row, *scan - 1))
    };
    let begins: Vec<usize> = (0..scans).filter(changes).collect();
    let columns = columns(&begins, scans);
    for row in &mut rows {
        row.cells = begins.iter().map(|begin| row.cells[*begin].clone()).collect();
    }
    let lengths = Lengths {
        columns: &columns,
        interval,
    };
    layout(&(heading + &by_change(&rows, lengths, 1)))
}

/// How long the columns are that begin with these scans.
pub(super) fn columns(begins: &[usize], scans: usize) -> Vec<u64> {
    let ends = begins.iter().skip(1).chain([&scans]);
    begins
        .iter()
        .zip(ends)
        .map(|(begin, end)| (end - begin) as u64)
        .collect()
}

fn heading(name: &str) -> String {
    format!("scenario \"{}\"\n", name.replace('"', "'"))
}

/// The file, below its line with the program.
pub(super) fn text(rows: &[RunRow], lengths: Lengths<'_>, name: &str) -> String {
    let step = lengths.step();
    let scans = i64::try_from(step).unwrap_or(i64::MAX);
    layout(&format!(
        "step {}\ninterval {}\n\n{}",
        short_duration(scans.saturating_mul(lengths.interval)),
        short_duration(lengths.interval),
        scenario(rows, lengths, name, step)
    ))
}

/// The scenario alone, for a file whose steps have so many scans.
pub(super) fn scenario(rows: &[RunRow], lengths: Lengths<'_>, name: &str, step: u64) -> String {
    let by_change = by_change(rows, lengths, step);
    let rows = match even(rows, lengths, step) {
        Some(even) if even.len() <= by_change.len() => even,
        _ => by_change,
    };
    heading(name) + &rows
}

/// All columns as long as the step, if that fits.
fn even(rows: &[RunRow], lengths: Lengths<'_>, step: u64) -> Option<String> {
    let steps = lengths.columns.iter().sum::<u64>() / step;
    let is_whole = lengths.columns.iter().all(|length| length.is_multiple_of(step));
    if !is_whole || steps > WIDTH as u64 {
        return None;
    }
    let mut text = String::new();
    for row in rows {
        let _ = write!(text, "{}{}", row.name, if row.is_expected { " => " } else { " " });
        for (cell, length) in row.cells.iter().zip(lengths.columns) {
            for part in 0..length / step {
                text.push_str(if part > 0 && !row.goes_on {
                    "."
                } else {
                    cell.text(row.is_level)
                });
                if !row.is_level {
                    text.push(' ');
                }
            }
        }
        text.push('\n');
    }
    let widest = layout(&text).lines().map(UnicodeWidthStr::width).max();
    widest.is_none_or(|widest| widest <= WIDTH).then_some(text)
}

/// A column for each stretch in which nothing changes.
fn by_change(rows: &[RunRow], lengths: Lengths<'_>, step: u64) -> String {
    let times: Vec<String> = lengths
        .columns
        .iter()
        .map(|&length| {
            if length == step {
                return ".".to_owned();
            }
            let scans = i64::try_from(length).unwrap_or(i64::MAX);
            short_duration(scans.saturating_mul(lengths.interval))
        })
        .collect();
    let names = rows.iter().map(|row| row.name.width()).max().unwrap_or(0);
    let room = WIDTH.saturating_sub(names.max(TIME.len()) + 4);
    let mut text = String::new();
    let mut from = 0;
    while from < times.len() {
        let to = fitting(rows, &times, from, room);
        // Of what is given only what is new is needed, and above all what the scenario begins with.
        let is_needed = |row: &&RunRow| {
            from == 0
                || row.is_expected
                || row.cells[from..to]
                    .iter()
                    .any(|cell| matches!(cell, RunCell::New(_)))
        };
        let _ = writeln!(text, "{TIME} {}", times[from..to].join(" "));
        for row in rows.iter().filter(is_needed) {
            let cells: Vec<&str> = row.cells[from..to]
                .iter()
                .map(|cell| cell.text(row.is_level))
                .collect();
            let arrow = if row.is_expected { "=> " } else { "" };
            let _ = writeln!(text, "{} {arrow}{}", row.name, cells.join(" "));
        }
        from = to;
    }
    text
}

/// The first column that does not fit after those from here on; at least one does.
fn fitting(rows: &[RunRow], times: &[String], from: usize, room: usize) -> usize {
    let mut used = 0;
    for (column, time) in times.iter().enumerate().skip(from) {
        let cells = rows
            .iter()
            .map(|row| row.cells[column].text(row.is_level).width());
        used += cells.max().unwrap_or(0).max(time.width());
        if used > room && column > from {
            return column;
        }
        used += 1;
    }
    times.len()
}

/// A duration as a person would write it: `3s`, `1.43s`, `1m20s`.
fn short_duration(nanoseconds: i64) -> String {
    const SECOND: i64 = 1_000_000_000;
    let text = value_text::duration(nanoseconds);
    let (seconds, rest) = (nanoseconds / SECOND, nanoseconds % SECOND);
    if !(1..60).contains(&seconds) || rest == 0 {
        return text;
    }
    let decimals = format!("{rest:09}");
    let short = format!("{seconds}.{}s", decimals.trim_end_matches('0'));
    let reads_back = value_text::parse(&short, Scalar::Time) == Ok(Value::Int(nanoseconds));
    if reads_back && short.len() < text.len() {
        short
    } else {
        text
    }
}

/// The greatest number of which both are a multiple.
fn divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { divisor(b, a % b) }
}

//! The layout of a scenario file: the tags of a scenario below each other, their arrows, and the values of a step in one
//! column.
//!
//! ```text
//! scenario "it counts"               scenario "it counts"
//! start _-_                     =>   start     _ - _
//! total =>  0 10 10                  total  => 0 10 10
//! ```
//!
//! Only white space changes, so nothing that is written is lost. Where each step is one letter in all rows, they touch
//! as they do in a timing diagram; a blank between two steps stays where most rows have one. A line that cannot be read
//! stays as it is.

mod columns;
mod ruler;

use super::parse::{HEADINGS, parse};
use super::suite::{Direction, Row, Suite};
use super::words::{Line, lines};
use columns::{Columns, Laid};
use ladder_syntax::{TextRange, TextSize, conflicts};
use unicode_width::UnicodeWidthStr;

/// The text in its layout. To lay it out once more changes nothing.
pub fn layout(text: &str) -> String {
    // A merge has not been decided: nothing of it is known.
    if !conflicts(text).is_empty() {
        return text.to_owned();
    }
    let suite = parse(text);
    let lines: Vec<Line<'_>> = lines(text).collect();
    if lines.iter().all(is_blank) {
        return text.to_owned();
    }
    let shapes = shapes(&suite, &lines);
    let rows: Vec<Vec<Laid>> = (0..suite.scenarios.len())
        .map(|scenario| rows_of(scenario, &suite, &shapes))
        .collect();
    // Of each scenario the columns of each piece, by the step with which it begins.
    let columns: Vec<Vec<(usize, Columns)>> = rows.iter().map(|rows| pieces(rows, text)).collect();
    let columns_at = |scenario: usize, first: usize| {
        let pieces: &[(usize, Columns)] = &columns[scenario];
        let at = pieces.partition_point(|(begin, _)| *begin <= first);
        &pieces[at.saturating_sub(1)].1
    };
    let mut out = Written::new(text, &lines);
    for (at, line) in lines.iter().enumerate() {
        if is_blank(line) {
            out.blank();
            continue;
        }
        let goes_on = at > 0 && is_remark(&lines[at - 1]);
        // More steps are a piece of their own.
        let goes_on_below = matches!(shapes[at], Shape::Time(scenario, time) if suite.scenarios[scenario].times[time].first > 0);
        if !goes_on && (goes_on_below || begins_scenario(&lines[at..])) {
            out.blank();
        }
        let written = match shapes[at] {
            Shape::Heading | Shape::Scenario => with_comment(heading(line, text), line),
            Shape::Row(scenario, row) => {
                let row = Laid::from(&suite.scenarios[scenario].rows[row]);
                columns_at(scenario, row.first).line(&row, line.comment(), text)
            }
            Shape::Time(scenario, time) => {
                let row = Laid::from(&suite.scenarios[scenario].times[time]);
                columns_at(scenario, row.first).line(&row, line.comment(), text)
            }
            Shape::Remark(Some((scenario, first))) => columns_at(scenario, first).ruler(line.text.trim_end()),
            Shape::Remark(None) => line.text.trim().to_owned(),
            Shape::Stays => line.text.trim_end().to_owned(),
        };
        out.line(&written, line.end);
    }
    out.text
}

/// What a line is for the layout.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shape {
    /// `program`, `step`, `interval` or `tolerance`.
    Heading,
    /// A line that begins a scenario.
    Scenario,
    /// A row: the scenario's number, and its own.
    Row(usize, usize),
    /// A row of how long steps are: the scenario's number, and its own.
    Time(usize, usize),
    /// Nothing but a comment; between the rows of which scenario, and with which step those below it begin.
    Remark(Option<(usize, usize)>),
    /// What cannot be read, or would be read as something else with other blanks in it.
    Stays,
}

fn shapes(suite: &Suite, lines: &[Line<'_>]) -> Vec<Shape> {
    let mut next = (0, 0);
    let mut next_time = 0;
    let mut shapes = Vec::with_capacity(lines.len());
    // How many scenarios have begun.
    let mut begun: usize = 0;
    for line in lines {
        let Some(first) = line.words.first() else {
            let between = begun.checked_sub(1).and_then(|scenario| {
                let below = suite.scenarios[scenario].rows.get(next.1)?;
                Some((scenario, below.first))
            });
            shapes.push(Shape::Remark(between));
            continue;
        };
        let mut shape = Shape::Stays;
        if first.text == "scenario" {
            next = (begun, 0);
            next_time = 0;
            begun += 1;
            let is_whole = matches!(&line.words[1..], [name] if name.text.starts_with('"') && !name.unclosed);
            shape = if is_whole { Shape::Scenario } else { Shape::Stays };
        } else if begun == 0 && HEADINGS.contains(&first.text) {
            shape = Shape::Heading;
        } else if let Some(time) = suite.scenarios.get(next.0).and_then(|it| it.times.get(next_time))
            && time.range == first.range()
        {
            shape = Shape::Time(next.0, next_time);
            next_time += 1;
        } else if let Some(row) = suite.scenarios.get(next.0).and_then(|it| it.rows.get(next.1))
            && row.range == first.range()
        {
            // A row with an error in it may hold words that nothing was made of.
            if line.words.last().map(|last| last.range().end()) == end_of(row) {
                shape = Shape::Row(next.0, next.1);
            }
            next.1 += 1;
        }
        shapes.push(if reads_the_same(line) { shape } else { Shape::Stays });
    }
    shapes
}

/// Where the last thing of a row ends.
fn end_of(row: &Row) -> Option<TextSize> {
    let cell = row.cells.last().map(|(_, place)| place.end());
    row.tolerance.as_ref().map(|(_, place)| place.end()).or(cell)
}

/// Whether the words are the same with other blanks between them.
fn reads_the_same(line: &Line<'_>) -> bool {
    let plain = with_comment(
        line.words
            .iter()
            .map(|word| word.text)
            .collect::<Vec<_>>()
            .join(" "),
        line,
    );
    let read = Line::read(&plain, "", 0);
    let words = |line: &Line<'_>| {
        line.words
            .iter()
            .map(|word| word.text.to_owned())
            .collect::<Vec<_>>()
    };
    words(&read) == words(line) && read.comment() == line.comment()
}

/// The rows of a scenario that are laid out, in the order of the file.
fn rows_of(number: usize, suite: &Suite, shapes: &[Shape]) -> Vec<Laid> {
    let scenario = &suite.scenarios[number];
    let laid_out = shapes.iter().filter_map(|shape| match shape {
        Shape::Row(of, row) if *of == number => scenario.rows.get(*row).map(Laid::from),
        Shape::Time(of, time) if *of == number => scenario.times.get(*time).map(Laid::from),
        _ => None,
    });
    laid_out.collect()
}

/// The columns of a scenario's rows: those that begin with one step have columns of their own, but all tags are as wide.
fn pieces(rows: &[Laid], text: &str) -> Vec<(usize, Columns)> {
    let names = Columns::names(rows, text);
    let of = |rows: &[Laid]| {
        (
            rows.first().map_or(0, |row| row.first),
            Columns::of(rows, names, text),
        )
    };
    if rows.is_empty() {
        return vec![of(rows)];
    }
    rows.chunk_by(|above, below| above.first == below.first)
        .map(of)
        .collect()
}

/// Whether a scenario begins here, with the comments above it.
fn begins_scenario(lines: &[Line<'_>]) -> bool {
    let mut below = lines.iter().skip_while(|line| is_remark(line));
    let first = below.next().and_then(|line| line.words.first());
    first.is_some_and(|first| first.text == "scenario")
}

fn is_remark(line: &Line<'_>) -> bool {
    line.words.is_empty() && line.comment.is_some()
}

fn is_blank(line: &Line<'_>) -> bool {
    line.words.is_empty() && line.comment.is_none()
}

/// A heading with one blank after its first word; a program's name keeps its blanks.
fn heading(line: &Line<'_>, text: &str) -> String {
    let [first, rest @ ..] = line.words.as_slice() else {
        return String::new();
    };
    let rest = match rest {
        [] => return first.text.to_owned(),
        [from, .., to] if first.text == "program" => text[from.start..to.end()].to_owned(),
        words => words.iter().map(|word| word.text).collect::<Vec<_>>().join(" "),
    };
    format!("{} {rest}", first.text)
}

/// With the comment of a line after it.
fn with_comment(mut written: String, line: &Line<'_>) -> String {
    if let Some(comment) = line.comment() {
        if !written.is_empty() {
            written.push_str("  ");
        }
        written.push_str(comment);
    }
    written
}

/// The text as it grows.
struct Written<'t> {
    text: String,
    /// The end of the last line, and of lines that have none.
    end: &'t str,
    /// Whether a blank line is due before the next one.
    blank: bool,
    begun: bool,
}

impl<'t> Written<'t> {
    fn new(text: &str, lines: &[Line<'t>]) -> Written<'t> {
        let mark = if text.starts_with('\u{feff}') {
            "\u{feff}"
        } else {
            ""
        };
        let end = lines.first().map_or("", |line| line.end);
        Written {
            text: mark.to_owned(),
            end: if end.is_empty() { "\n" } else { end },
            blank: false,
            begun: false,
        }
    }

    fn blank(&mut self) {
        self.blank = self.begun;
    }

    fn line(&mut self, line: &str, end: &'t str) {
        if std::mem::take(&mut self.blank) {
            self.text.push_str(self.end);
        }
        if !end.is_empty() {
            self.end = end;
        }
        self.text.push_str(line);
        self.text.push_str(self.end);
        self.begun = true;
    }
}

/// How many columns a text takes on the screen.
fn width(text: &str) -> usize {
    text.width()
}

/// What is in a range.
fn at(text: &str, range: TextRange) -> &str {
    text.get(std::ops::Range::<usize>::from(range))
        .unwrap_or_default()
}

const fn is_expected(row: &Row) -> bool {
    matches!(row.direction, Direction::Expected)
}

#[cfg(test)]
mod tests;

//! A comparison for a terminal: what changed is drawn, in the old form and the new, what did not is a line.

use super::{Compared, notes, of_whole, summary};
use crate::comparison::{Change, Comparison};
use crate::drawing::{Drawn, DrawnLine, draw, draw_both};
use crate::verdict::Verdict;
use crate::words::{heading, reason};
use std::ops::Range;

/// A drawing has this width, so that it fits into 80 columns next to its signs.
const WIDTH: u32 = 78;

/// What stands for the name of a file that is not there.
const NO_FILE: &str = "(no such file)";

/// A line of the report, without its line end.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// What it is.
    pub kind: LineKind,
    /// What is on it, signs at its beginning included.
    pub text: String,
    /// Ranges of bytes in it that differ from the other form.
    pub marks: Vec<Range<usize>>,
}

/// What a line of the report is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LineKind {
    /// The name of a file.
    File,
    /// What happened to an entry.
    Heading,
    /// Part of the old form.
    Old,
    /// Part of the new form.
    New,
    /// Part of something that has moved.
    Moved,
    /// Signs below a line.
    Marks,
    /// Anything else.
    Plain,
}

/// The report of two files.
pub fn report(compared: &Compared<'_>) -> Vec<Line> {
    let comparison = &compared.comparison;
    let mut lines = settings(compared.old, compared.new, &[]);
    let renamed = if compared.renamed { "renamed, " } else { "" };
    lines.push(plain(
        LineKind::Plain,
        format!("    {renamed}{}", summary(comparison)),
    ));
    let notes = notes(comparison);
    if !notes.is_empty() {
        lines.push(plain(LineKind::Plain, String::new()));
        lines.extend(notes.into_iter().map(|note| plain(LineKind::Heading, note)));
    }
    changes(comparison, &mut lines);
    if let Some((told, rows)) = of_whole(comparison) {
        lines.push(plain(LineKind::Plain, String::new()));
        lines.push(plain(LineKind::Heading, told));
        lines.extend(
            rows.into_iter()
                .map(|row| plain(LineKind::Plain, format!("    {row}"))),
        );
    }
    lines
}

/// The report of two settings files, of whose lines the signs are known.
pub fn settings(old: Option<&str>, new: Option<&str>, lines: &[String]) -> Vec<Line> {
    let name = |name: Option<&str>| name.unwrap_or(NO_FILE).to_owned();
    let mut report = vec![
        plain(LineKind::File, format!("--- {}", name(old))),
        plain(LineKind::File, format!("+++ {}", name(new))),
    ];
    report.extend(lines.iter().map(|line| {
        let kind = match line.as_bytes().first() {
            Some(b'-') => LineKind::Old,
            Some(b'+') => LineKind::New,
            _ => LineKind::Plain,
        };
        plain(kind, line.trim_end().to_owned())
    }));
    report
}

/// The changes of a comparison, each with its heading; what is the same between them is folded into a line.
pub fn changes(comparison: &Comparison<'_>, lines: &mut Vec<Line>) {
    let mut same = 0;
    for change in &comparison.changes {
        if change.verdict == Verdict::Value {
            continue;
        }
        if !change.is_change() {
            same += usize::from(!change.entry().kind.holds_others());
            continue;
        }
        folded(&mut same, lines);
        lines.push(plain(LineKind::Plain, String::new()));
        lines.push(plain(LineKind::Heading, heading(comparison, change)));
        if let Some(reason) = reason(change) {
            lines.push(plain(LineKind::Plain, format!("    {reason}")));
        }
        drawn(comparison, change, lines);
    }
    folded(&mut same, lines);
}

fn folded(same: &mut usize, lines: &mut Vec<Line>) {
    match std::mem::take(same) {
        0 => {}
        same => {
            lines.push(plain(LineKind::Plain, String::new()));
            lines.push(plain(LineKind::Plain, format!("    ... {same} the same")));
        }
    }
}

fn plain(kind: LineKind, text: String) -> Line {
    Line {
        kind,
        text,
        marks: Vec::new(),
    }
}

/// Both forms of an entry.
pub fn drawn(comparison: &Comparison<'_>, change: &Change<'_>, lines: &mut Vec<Line>) {
    match (change.verdict, change.old, change.new) {
        (Verdict::Edited | Verdict::Commented, Some(old), Some(new)) => {
            let (old, new) = draw_both((comparison.old, old), (comparison.new, new), WIDTH);
            let common = common_comments(&old, &new);
            let (above, old_rest) = old.lines.split_at(common);
            signed(' ', LineKind::Plain, above, lines);
            signed('-', LineKind::Old, old_rest, lines);
            signed('+', LineKind::New, &new.lines[common..], lines);
        }
        (_, None, Some(new)) => signed('+', LineKind::New, &draw(comparison.new, new, WIDTH).lines, lines),
        (_, Some(old), None) => signed('-', LineKind::Old, &draw(comparison.old, old, WIDTH).lines, lines),
        (_, _, Some(new)) if change.moved => {
            signed(
                '>',
                LineKind::Moved,
                &draw(comparison.new, new, WIDTH).lines,
                lines,
            );
        }
        _ => {}
    }
}

/// How many lines of comments above both forms are the same.
fn common_comments(old: &Drawn, new: &Drawn) -> usize {
    let both = old.lines.iter().zip(&new.lines);
    both.take_while(|(old, new)| old == new && old.marks.is_empty() && old.text.starts_with('#'))
        .count()
}

fn signed(sign: char, kind: LineKind, drawn: &[DrawnLine], lines: &mut Vec<Line>) {
    for line in drawn {
        let text = format!("{sign} {}", line.text);
        lines.push(Line {
            kind,
            text: text.trim_end().to_owned(),
            marks: line
                .marks
                .iter()
                .map(|mark| mark.start + 2..mark.end + 2)
                .collect(),
        });
        if let Some(marks) = line.underline('^') {
            lines.push(plain(LineKind::Marks, format!("  {marks}")));
        }
    }
}

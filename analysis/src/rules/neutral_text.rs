//! `unexpected-character`, for rungs as Rockwell's software puts them on the clipboard: reported once for each stretch of them, with
//! the fix that draws them, where all of it can be read.

use crate::findings::Finding;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::Severity;
use ladder_drawings::{RungText, may_be_rung_text, read_rung_text};
use ladder_format::Options;
use ladder_syntax::{LineKind, Parse, TextRange, TextSize};

/// This many parts that cannot be read are named.
const NAMED: usize = 5;

/// Puts one finding in the place of all that is found in such rungs.
pub(crate) fn hide_all_else(parse: &Parse, all: &mut Vec<Finding>) {
    let mut found: Vec<Diagnostic> = Vec::new();
    let mut looked_to = 0;
    let errors = all.iter().filter(|found| found.severity == Severity::Error);
    for line in errors.filter_map(|found| parse.line_at(found.range.start())) {
        if line < looked_to || !may_be_rung_text(parse.lines()[line].text()) {
            continue;
        }
        let end = end_of_stretch(parse, line);
        looked_to = end;
        let start = parse.line_start(line);
        let text = parse.text_in(TextRange::new(start, parse.line_range(end - 1).end()));
        let text = text.to_string();
        if let Some(read) = read_rung_text(&text) {
            let range = TextRange::at(start, TextSize::of(text.trim_end()));
            found.push(pasted(range, &text, &read));
        }
    }
    if found.is_empty() {
        return;
    }
    all.retain(|other| {
        let at = other.range.start();
        let first = found.partition_point(|found| found.range.end() < at);
        found.get(first).is_none_or(|found| at < found.range.start())
    });
    all.extend(found.into_iter().map(Finding::from));
    all.sort_by_key(|found| found.range.start());
}

/// After the last line that is neither blank nor ladder text.
fn end_of_stretch(parse: &Parse, first: usize) -> usize {
    let lines = parse.lines();
    let goes_on = |line: usize| {
        let text = lines[line].text().trim_start();
        !text.is_empty()
            && !text.starts_with(['+', '|', '/', '\\', '#'])
            && matches!(lines[line].kind, LineKind::Rung | LineKind::Stray)
    };
    (first + 1..lines.len())
        .find(|&line| !goes_on(line))
        .unwrap_or(lines.len())
}

fn pasted(range: TextRange, text: &str, read: &RungText) -> Diagnostic {
    let found = Diagnostic::new(
        super::unexpected_character::RULE,
        range,
        "this is a rung as Rockwell's software writes it as text, not a drawing",
    );
    if !read.problems.is_empty() {
        let named: Vec<&str> = read.problems.iter().take(NAMED).map(String::as_str).collect();
        return found.help(format!("draw it with blocks: {}", named.join("; ")));
    }
    let line_end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let options = Options::default();
    let drawn = read.program.write(&options).text;
    found
        .help("the fix draws it; a timer keeps its preset, and what follows one gets the power that it gets")
        .fix(
            Applicability::Unsafe,
            "Draw it as a rung",
            range,
            drawn.trim_end().replace('\n', line_end),
        )
}

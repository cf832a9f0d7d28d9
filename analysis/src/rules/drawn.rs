//! `unexpected-character`, for a ladder diagram that was pasted as other programs and people draw it: reported once for each drawing, with the
//! fix that draws it as ladder text, where all of it can be read.

use crate::findings::Finding;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::Severity;
use ladder_drawings::{Look, Read};
use ladder_format::{Edit, Options};
use ladder_syntax::{LineIndex, LineKind, Parse, TextRange, TextSize};

const MESSAGE: &str = "this looks like a ladder diagram that is drawn with characters";

/// This many places that cannot be read are shown.
const SHOWN: usize = 10;

/// So much text is checked for drawings.
const MOST_BYTES: usize = 4 << 20;

/// Lines without a blank one, among them none of a declaration.
struct Part<'t> {
    range: TextRange,
    lines: Vec<&'t str>,
}

/// Puts one finding in the place of all that is found in a drawing.
pub(crate) fn hide_all_else(parse: &Parse, all: &mut Vec<Finding>) {
    let errors = all.iter().filter(|found| found.severity == Severity::Error);
    let mut places: Vec<TextSize> = errors.map(|found| found.range.start()).collect();
    if places.is_empty() || u32::from(parse.text_len()) as usize > MOST_BYTES {
        return;
    }
    places.sort_unstable();
    let text = parse.to_string();
    let open = parse.unclosed_comment().map(TextRange::start);
    let is_wrong = |part: &Part<'_>| {
        let first = places.partition_point(|place| *place < part.range.start());
        let has_error = places.get(first).is_some_and(|place| *place <= part.range.end());
        has_error || open.is_some_and(|open| open < part.range.start())
    };
    let mut drawings: Vec<TextRange> = Vec::new();
    // What may be the title of a drawing below.
    let mut titles: Option<TextRange> = None;
    for part in parts(parse, &text).into_iter().filter(is_wrong) {
        let above = titles.take().filter(|titles| follows(&text, *titles, part.range));
        let range = above.map_or(part.range, |titles| titles.cover(part.range));
        match ladder_drawings::look(&part.lines) {
            Look::Text => titles = Some(range),
            Look::Ladder => {}
            Look::Drawn => match drawings.last_mut() {
                Some(drawing) if follows(&text, *drawing, range) => *drawing = drawing.cover(range),
                _ => drawings.push(range),
            },
        }
    }
    if drawings.is_empty() {
        return;
    }
    all.retain(|other| {
        let place = other.range.start();
        let first = drawings.partition_point(|drawing| drawing.end() < place);
        drawings.get(first).is_none_or(|drawing| place < drawing.start())
    });
    all.extend(
        drawings
            .into_iter()
            .map(|range| Finding::from(found(&text, range))),
    );
    all.sort_by_key(|found| found.range.start());
}

/// Whether only blank lines are between two stretches.
fn follows(text: &str, above: TextRange, below: TextRange) -> bool {
    above.end() <= below.start() && text[TextRange::new(above.end(), below.start())].trim().is_empty()
}

fn found(text: &str, range: TextRange) -> Diagnostic {
    let drawing = &text[range];
    let lines: Vec<&str> = lines(drawing).into_iter().map(|line| &drawing[line]).collect();
    let read = ladder_drawings::read(&lines.join("\n"));
    let found = Diagnostic::new(super::unexpected_character::RULE, range, MESSAGE);
    if read.is_complete() {
        return found
            .help("convert it with `ladder convert --from ascii`, or draw these lines as ladder text with the fix")
            .with(fix(drawing, range, read));
    }
    let index = LineIndex::new(drawing);
    let mut found =
        found.help("convert it with `ladder convert --from ascii`: what cannot be read stays as a comment");
    for problem in read.problems.iter().take(SHOWN) {
        let at = index.offset(drawing, problem.place);
        let rest = drawing[usize::from(at)..].lines().next().unwrap_or_default();
        let word = rest.split("  ").next().unwrap_or_default();
        let word = if rest.starts_with(&problem.text) {
            &problem.text
        } else {
            word
        };
        let place = TextRange::at(range.start() + at, TextSize::of(word));
        found = found.related(place, format!("this cannot be read: {}", problem.why));
    }
    found
}

fn fix(drawing: &str, range: TextRange, read: Read) -> Fix {
    let written = read.program.write(&Options::default()).text;
    let line_end = if drawing.contains("\r\n") { "\r\n" } else { "\n" };
    let edit = Edit {
        range,
        text: written.trim_end().replace('\n', line_end),
    };
    Fix::new(
        Applicability::Unsafe,
        "Draw it with - + | \\ / and blocks",
        vec![edit],
    )
}

/// The lines of a text, without their ends.
fn lines(text: &str) -> Vec<TextRange> {
    let index = LineIndex::new(text);
    let ranges = (0..index.line_count()).map(|line| index.range(line));
    ranges
        .map(|range| {
            let line = text[range].trim_end_matches(['\r', '\n']);
            TextRange::at(range.start(), TextSize::of(line))
        })
        .collect()
}

/// The text without declarations and whole lines of comment, parted where lines are blank.
fn parts<'t>(parse: &Parse, text: &'t str) -> Vec<Part<'t>> {
    let mut parts: Vec<Part<'t>> = Vec::new();
    let mut goes_on = false;
    for range in lines(text) {
        let line = &text[range];
        let parts_it = line.trim().is_empty() || is_own(parse, range.start(), line.trim());
        if parts_it {
            goes_on = false;
            continue;
        }
        match parts.last_mut().filter(|_| goes_on) {
            Some(part) => {
                part.range = part.range.cover(range);
                part.lines.push(line);
            }
            None => parts.push(Part {
                range,
                lines: vec![line],
            }),
        }
        goes_on = true;
    }
    parts
}

/// Whether a line is ladder text whatever is around it.
fn is_own(parse: &Parse, start: TextSize, line: &str) -> bool {
    let kind = parse.line_at(start).map(|line| parse.lines()[line].kind);
    let is_comment = line.starts_with('#') && line.len() > 1 && line.ends_with('#');
    is_comment
        || matches!(
            kind,
            Some(
                LineKind::SectionHeader
                    | LineKind::Declaration
                    | LineKind::SectionEnd
                    | LineKind::BlockHeader
                    | LineKind::BlockEnd
            )
        )
}

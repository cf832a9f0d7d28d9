//! Comments as other languages write them: `// text`, `(* text *)`, `/* text */`, `; text`.
//!
//! The parser reads them as drawing or declarations, and stumbles over and over. Here they are found before that: at
//! the start of a line, and where the first error of a line is.

use ladder_syntax::{DeclarationProblem, LineKind, NodeOrToken, Parse, SyntaxErrorKind, TextRange, TextSize};
use std::ops::Range;

/// A comment of another language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct ForeignComment {
    /// What it begins with.
    pub(crate) opening: &'static str,
    /// From there to its end, or to the end of its line.
    pub(crate) range: TextRange,
    /// What it says.
    pub(crate) text: String,
    /// The logical lines that it touches.
    pub(crate) lines: Range<usize>,
    /// It is in a section, which the parser takes to end here.
    pub(crate) ends_section: bool,
}

/// All such comments of a file, in their order.
#[derive(Debug, Clone, Default)]
pub(crate) struct ForeignComments(pub(crate) Vec<ForeignComment>);

impl ForeignComments {
    /// Looks for them. `is_drawn` says whether a logical line is a rung of a sound drawing.
    pub(crate) fn find(parse: &Parse, is_drawn: impl Fn(usize) -> bool) -> ForeignComments {
        let mut found: Vec<ForeignComment> = Vec::new();
        let lines = parse.lines();
        for (number, part) in lines.parts().iter().enumerate() {
            if !part.is_faulty() && !part.begins_with_up() {
                continue;
            }
            for line in lines.first_line(number)..lines.first_line(number + 1) {
                let within = found.last().is_some_and(|last| last.lines.contains(&line));
                if !within && may_hold_one(parse, line, &is_drawn) {
                    found.extend(on_line(parse, line));
                }
            }
        }
        ForeignComments(found)
    }

    /// The one that touches a logical line.
    pub(crate) fn on_line(&self, line: usize) -> Option<&ForeignComment> {
        let next = self.0.partition_point(|comment| comment.lines.start <= line);
        let before = self.0[..next].last()?;
        before.lines.contains(&line).then_some(before)
    }

    /// Whether what is found at a place only follows from one: it lies in it, or after it on its last line.
    pub(crate) fn explain(&self, parse: &Parse, at: TextSize) -> bool {
        let line = (!self.0.is_empty()).then(|| parse.line_at(at)).flatten();
        line.and_then(|line| self.on_line(line))
            .is_some_and(|comment| comment.range.start() <= at)
    }
}

/// Cheap: most lines have no error and begin with a rail.
fn may_hold_one(parse: &Parse, number: usize, is_drawn: impl Fn(usize) -> bool) -> bool {
    let line = &parse.lines()[number];
    if !line.errors.is_empty() || line.kind == LineKind::Stray {
        return true;
    }
    if line.kind != LineKind::Rung || !line.text().trim_start().starts_with('/') {
        return false;
    }
    let tree = line.tree();
    let tokens = tree.children().filter_map(NodeOrToken::into_token);
    let mut drawn = tokens.skip_while(|token| token.text().trim().is_empty());
    if !drawn.next().is_some_and(|token| token.text().starts_with('/')) {
        return false;
    }
    // Connectors that touch each other and a wire, and close branches of a sound drawing, are no comment.
    let wire = drawn.find(|token| !token.text().starts_with('/'));
    !(wire.is_some_and(|token| token.text().starts_with('-')) && is_drawn(number))
}

fn on_line(parse: &Parse, line: usize) -> Option<ForeignComment> {
    let parsed = &parse.lines()[line];
    let text = parsed.text();
    let first = text.len() - text.trim_start().len();
    let error = parsed.errors.iter().map(|error| error.range.start()).min();
    let error = error.map(|at| usize::from(at).min(text.len()));
    let (at, opening) = opening(text, first)
        .map(|opening| (first, opening))
        .or_else(|| after(text, error?))?;
    let closing = match opening {
        "(*" => Some("*)"),
        "/*" => Some("*/"),
        _ => None,
    };
    let from = at + opening.len();
    // One that is not closed ends with its line.
    let (length, says, last) = closing
        .and_then(|closing| {
            up_to(parse, line, from, |text| {
                Some((text.find(closing)?, closing.len()))
            })
        })
        .or_else(|| up_to(parse, line, from, |text| Some((text.find(['\n', '\r'])?, 0))))
        .unwrap_or_else(|| (text.len() - from, text[from..].to_owned(), line));
    if opening == ";" && (error.is_none() || !is_note(&says, parsed.kind, &text[..at])) {
        return None;
    }
    let section_ends = SyntaxErrorKind::BadDeclaration(DeclarationProblem::SectionNotClosed);
    let start = parse.line_start(line);
    let range = TextRange::at(
        start + TextSize::new(at as u32),
        TextSize::new((opening.len() + length) as u32),
    );
    Some(ForeignComment {
        opening,
        range,
        text: says.trim_start_matches(opening).to_owned(),
        lines: line..last + 1,
        ends_section: parse
            .lines()
            .range(line..last + 1)
            .flat_map(|line| &line.errors)
            .any(|error| error.kind == section_ends),
    })
}

/// Whether what is after a `;` is not a declaration, and the `;` ends none.
fn is_note(says: &str, kind: LineKind, before: &str) -> bool {
    let ends_declaration = kind == LineKind::Declaration && (says.contains(':') || !before.trim().is_empty());
    let says = says.trim_start_matches([';', ' ', '\t']);
    says.starts_with(char::is_alphanumeric) && !ends_declaration
}

/// From a place of a line to an end, which may lie on a later one: the length, the text without the end, and the last
/// logical line. `find` gives where the end is and how long.
fn up_to(
    parse: &Parse,
    line: usize,
    from: usize,
    find: impl Fn(&str) -> Option<(usize, usize)>,
) -> Option<(usize, String, usize)> {
    let mut says = String::new();
    let mut skipped = from;
    for (next, parsed) in (line..).zip(parse.lines().from(line)).take(MOST_LINES) {
        let text = parsed.text();
        let text = &text[std::mem::take(&mut skipped)..];
        if let Some((at, length)) = find(text) {
            let whole = says.len() + at + length;
            says.push_str(&text[..at]);
            return Some((whole, says, next));
        }
        says.push_str(text);
    }
    None
}

/// So far the end of a comment is looked for: each line without one is read once more.
const MOST_LINES: usize = 200;

/// What a comment at this place begins with. Two connectors that touch may also be drawing.
fn opening(text: &str, at: usize) -> Option<&'static str> {
    let rest = &text[at..];
    if let Some(says) = rest.strip_prefix("//") {
        let is_text = |c: char| c.is_alphanumeric() || c.is_whitespace() || c == '/' || c == '!';
        return says.chars().next().is_none_or(is_text).then_some("//");
    }
    ["(*", "/*", ";"]
        .into_iter()
        .find(|opening| rest.starts_with(opening))
}

/// A comment after a rung or a declaration: where it begins, and with what. `error` is where the parser stumbled.
fn after(text: &str, error: usize) -> Option<(usize, &'static str)> {
    let ahead = text.get(error..)?;
    let before = text[..error].trim_end_matches([' ', '\t']);
    // The parser takes what a comment begins with for drawing, as far as it can.
    let at = if ["//", "/*", "(*", ";"]
        .iter()
        .any(|opening| ahead.starts_with(opening))
    {
        error
    } else if before.ends_with("//") {
        before.len() - 2
    } else if before.len() == error && before.ends_with(['/', '(']) && ahead.starts_with('*') {
        error - 1
    } else {
        return None;
    };
    let opening = opening(text, at)?;
    // The rung or the declaration is whole: a character too many in it begins no comment.
    let ahead = text[..at].trim_end_matches([' ', '\t']);
    let is_apart = ahead.len() < at && ahead.len() > 1 && ahead.ends_with(['+', '|', ';']);
    is_apart.then_some((at, opening))
}

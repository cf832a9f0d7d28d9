//! Actions in Structured Text that the text of their unit calls: what they do stands in the place of the call.

use super::structured::within;
use super::texts::may_leave;
use crate::model::{Body, Unit};
use crate::scope::local;
use ladder_notation::{LineColumn, Lines};
use ladder_notation_st::read::{Dialect, parses};
use std::collections::HashSet;

/// Actions call each other no deeper.
const DEEPEST: usize = 8;

/// No more actions are put into a text that is this long.
const LONGEST: usize = 500_000;

/// A text, with the texts of its unit's actions in the places of their calls.
pub(super) struct WithActions<'u> {
    pub(super) text: String,
    /// The actions that are in it, by their names in small letters.
    pub(super) in_place: HashSet<String>,
    /// That of the unit, and those of its actions.
    sources: Vec<Source<'u>>,
    pieces: Vec<Piece>,
}

/// A text of the file.
struct Source<'u> {
    name: &'u str,
    text: &'u str,
    place: LineColumn,
    lines: Lines,
    calls: Vec<(usize, usize, &'u str)>,
}

/// A part of the whole: where it begins, of which text it is, and where in that it begins.
struct Piece {
    start: usize,
    source: usize,
    from: usize,
}

impl<'u> WithActions<'u> {
    pub(super) fn of(
        unit: &'u Unit,
        (text, place): (&'u str, LineColumn),
        dialect: Dialect,
    ) -> WithActions<'u> {
        let is_declared = |name: &str| local(unit).any(|variable| variable.name.eq_ignore_ascii_case(name));
        let actions = unit.parts.iter().filter_map(|part| match &part.body {
            Body::Text("ST", text, place) if part.what == "action" && !is_declared(&part.name) => {
                let is_whole = !may_leave(text) && parses(text, dialect);
                is_whole.then_some((part.name.as_str(), text.as_str(), *place))
            }
            _ => None,
        });
        let actions: Vec<_> = actions.collect();
        let has_actions = !actions.is_empty();
        let sources = std::iter::once(("", text, place)).chain(actions);
        let sources = sources.map(|(name, text, place)| Source {
            name,
            text,
            place,
            lines: Lines::of(text),
            calls: if has_actions { calls(text) } else { Vec::new() },
        });
        let mut all = WithActions {
            text: String::new(),
            in_place: HashSet::new(),
            sources: sources.collect(),
            pieces: Vec::new(),
        };
        all.add(0, 0);
        all
    }

    fn add(&mut self, source: usize, depth: usize) {
        let text = self.sources[source].text;
        let mut from = 0;
        for number in 0..self.sources[source].calls.len() {
            let (start, end, name) = self.sources[source].calls[number];
            let mut actions = self.sources.iter().skip(1);
            let action = actions.position(|action| action.name.eq_ignore_ascii_case(name));
            let Some(action) = action.filter(|_| depth < DEEPEST && self.text.len() < LONGEST) else {
                continue;
            };
            self.piece(source, from, &text[from..start]);
            self.in_place.insert(name.to_lowercase());
            self.text.push('\n');
            self.add(action + 1, depth + 1);
            self.text.push('\n');
            from = end;
        }
        self.piece(source, from, &text[from..]);
    }

    fn piece(&mut self, source: usize, from: usize, text: &str) {
        let start = self.text.len();
        self.pieces.push(Piece { start, source, from });
        self.text.push_str(text);
    }

    /// Where a byte is in the file.
    pub(super) fn place(&self, at: usize) -> LineColumn {
        let number = self.pieces.partition_point(|piece| piece.start <= at);
        let Some(piece) = self.pieces.get(number.saturating_sub(1)) else {
            return LineColumn::START;
        };
        let source = &self.sources[piece.source];
        let own = (piece.from + at.saturating_sub(piece.start)).min(source.text.len());
        within(source.place, source.lines.place(source.text, own))
    }
}

/// The calls without operands in a text, each a statement with its `;`: where it begins and ends, and its name.
fn calls(text: &str) -> Vec<(usize, usize, &str)> {
    let mut calls = Vec::new();
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let (mut at, mut before) = (0, ';');
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let length = if let Some(length) = passed_over(rest) {
            length
        } else if is_word(c) {
            let length = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
            let end = (before != '.').then(|| end_of_call(&rest[length..])).flatten();
            if let Some(end) = end {
                calls.push((at, at + length + end, &rest[..length]));
            }
            before = c;
            length
        } else {
            before = if c.is_whitespace() { before } else { c };
            c.len_utf8()
        };
        at += length;
    }
    calls
}

/// How long a comment, a pragma or a string at the beginning of a text is.
fn passed_over(text: &str) -> Option<usize> {
    let comment = [("(*", "*)"), ("/*", "*/"), ("//", "\n"), ("{", "}")];
    if let Some((open, close)) = comment.iter().find(|(open, _)| text.starts_with(open)) {
        let inside = &text[open.len()..];
        let end = inside.find(close).map(|end| open.len() + end + close.len());
        return Some(end.unwrap_or(text.len()));
    }
    let quote = text.chars().next().filter(|c| matches!(c, '\'' | '"'))?;
    let mut is_escaped = false;
    let end = text[1..].find(|c| {
        let ends = c == quote && !is_escaped;
        is_escaped = c == '$' && !is_escaped;
        ends
    });
    Some(end.map_or(text.len(), |end| end + 2))
}

/// Where `();` ends, with blanks between its signs.
fn end_of_call(text: &str) -> Option<usize> {
    let mut rest = text;
    for sign in ['(', ')', ';'] {
        rest = rest.trim_start().strip_prefix(sign)?;
    }
    Some(text.len() - rest.len())
}

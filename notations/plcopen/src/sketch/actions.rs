//! Actions in Structured Text that the text of their unit calls: what they do is in the place of the call.

use super::structured::within;
use super::texts::may_leave;
use crate::model::{Body, Unit};
use crate::scope::local;
use ladder_notation::{LineColumn, Lines};
use ladder_notation_st::read::{Dialect, bare_calls, parses};
use std::collections::HashSet;
use std::ops::Range;

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
    /// Where each call without operands is, and its name.
    calls: Vec<(Range<usize>, String)>,
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
            calls: if has_actions {
                bare_calls(text, dialect)
            } else {
                Vec::new()
            },
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
            let (call, name) = self.sources[source].calls[number].clone();
            let mut actions = self.sources.iter().skip(1);
            let action = actions.position(|action| action.name.eq_ignore_ascii_case(&name));
            let Some(action) = action.filter(|_| depth < DEEPEST && self.text.len() < LONGEST) else {
                continue;
            };
            self.piece(source, from, &text[from..call.start]);
            self.in_place.insert(name.to_lowercase());
            self.text.push('\n');
            self.add(action + 1, depth + 1);
            self.text.push('\n');
            from = call.end;
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

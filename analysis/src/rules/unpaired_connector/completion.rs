//! The ways to fix a connector without a partner: what is drawn is completed; only the last one takes it away.
//!
//! Each of them decides which way power takes, and the drawing does not say for sure: none is safe.

use super::{Side, next_to, partner, symbol};
use crate::findings::diagnostic::{Applicability, Fix};
use crate::findings::excerpt::columns;
use crate::networks::neighbours::{rung_above, rung_below};
use ladder_format::Edit;
use ladder_syntax::wiring::{self, PartKind, Rung};
use ladder_syntax::{Parse, TextRange, TextSize};

/// This many columns next to a connector its partner is looked for.
pub(super) const NEAR: usize = 2;

/// This many columns from a connector a wire is looked for, where a block is in the connector's column: it is where the
/// branch was meant to leave or to come back.
const NEAR_A_BLOCK: usize = 16;

/// A rung with the columns of its parts.
pub(super) struct Row {
    line: usize,
    pub(super) rung: Rung,
    /// The first column of each part, and the one after it.
    pub(super) spans: Vec<(usize, usize)>,
}

/// A connector, or the place where one is missing.
#[derive(Clone, Copy)]
struct Spot<'r> {
    row: &'r Row,
    part: usize,
}

/// The best first.
pub(super) fn fixes(parse: &Parse, own: &Side, other: Option<&Side>, suspect: usize) -> Vec<Fix> {
    let row = Row::new(parse, own.line);
    let spot = Spot {
        row: &row,
        part: own.parts[suspect],
    };
    let column = own.columns[suspect];
    let other = other.map(|other| Row::new(parse, other.line));
    let mut fixes: Vec<Fix> = exchanged(parse, spot, own.kind, column).into_iter().collect();
    if let Some(other) = &other {
        fixes.extend(in_its_place(parse, other, &row, own.kind, column));
        let is_misdrawn = !fixes.is_empty();
        let closed = close(parse, other, own.kind, column);
        let joined = || join(parse, other, own.kind, column);
        let drawn = || draw(parse, other, own.kind, column, suspect).filter(|_| !is_misdrawn);
        fixes.extend(closed.or_else(joined).or_else(drawn));
    }
    if own.kind == PartKind::Down && other.is_none_or(|other| is_apart(&other)) {
        fixes.extend(take_away(parse, spot));
    }
    fixes
}

impl Row {
    pub(super) fn new(parse: &Parse, line: usize) -> Row {
        let rung = wiring::rung(&parse.lines()[line].tree());
        let ends = rung
            .parts
            .iter()
            .flat_map(|part| [part.range.start(), part.range.end()]);
        let flat = columns(parse, line, ends);
        let spans = flat.chunks_exact(2).map(|span| (span[0], span[1])).collect();
        Row { line, rung, spans }
    }

    /// The part of a kind nearest to a column, if one is near.
    fn near(&self, column: usize, is: impl Fn(usize) -> bool) -> Option<usize> {
        let distance = |part: usize| self.spans[part].0.abs_diff(column);
        let parts = 0..self.rung.parts.len();
        parts
            .filter(|&part| distance(part) <= NEAR && is(part))
            .min_by_key(|&part| distance(part))
    }

    fn is(&self, part: usize, kind: PartKind) -> bool {
        self.rung.parts[part].kind == kind
    }

    pub(super) fn range(&self, parse: &Parse, part: usize) -> TextRange {
        self.rung.parts[part].range + parse.line_start(self.line)
    }
}

/// Whether a line has more connectors of a kind than its neighbour has partners for them.
fn too_many(parse: &Parse, row: &Row, kind: PartKind) -> bool {
    let neighbour = match kind {
        PartKind::Down => rung_below(parse, row.line),
        _ => rung_above(parse, row.line),
    };
    let partners = neighbour.map_or(0, |line| {
        wiring::rung(&parse.lines()[line].tree())
            .connectors(partner(kind))
            .count()
    });
    row.rung.connectors(kind).count() > partners
}

/// `/` above `\`: the two are swapped. `/` above `/`, or `\` above `\`: the one that has no partner on its side is
/// meant the other way.
fn exchanged(parse: &Parse, spot: Spot<'_>, kind: PartKind, column: usize) -> Option<Fix> {
    let after = match kind {
        PartKind::Down => rung_above(parse, spot.row.line),
        _ => rung_below(parse, spot.row.line),
    };
    let after = Row::new(parse, after?);
    let alone = |kind| {
        let found = after.near(column, |part| after.is(part, kind))?;
        too_many(parse, &after, kind).then_some(found)
    };
    let own = edit(spot.row.range(parse, spot.part), symbol(partner(kind)));
    if let Some(other) = alone(partner(kind)) {
        let other = edit(after.range(parse, other), symbol(kind));
        let edits = match kind {
            PartKind::Down => vec![other, own],
            _ => vec![own, other],
        };
        return Some(guess("Swap `/` and `\\`".to_owned(), edits));
    }
    alone(kind)?;
    let title = format!("Replace `{}` with `{}`", symbol(kind), symbol(partner(kind)));
    Some(guess(title, vec![own]))
}

/// A `|`, a `+` or the wrong connector in the place of the partner.
fn in_its_place(parse: &Parse, other: &Row, own: &Row, kind: PartKind, column: usize) -> Option<Fix> {
    let last = other.rung.parts.len() - 1;
    let is_rail = |part: usize| {
        let touches = |part: usize| other.rung.parts.get(part).is_some_and(|part| part.touches);
        (part == 0 && other.spans[part].0 == 0 && !touches(1)) || (part == last && !touches(part))
    };
    let ends_a_wire = |part: usize| {
        let ahead = other.spans.get(part + 1);
        let before = part.checked_sub(1).map(|before| other.spans[before]);
        ahead.is_some_and(|ahead| ahead.0 <= other.spans[part].1 + NEAR)
            || before.is_some_and(|before| before.1 + NEAR >= other.spans[part].0)
    };
    let found = other.near(column, |part| match other.rung.parts[part].kind {
        PartKind::Bar | PartKind::StrayBar => !is_rail(part) && ends_a_wire(part),
        PartKind::StrayRail => true,
        // Not the rails where the rungs begin and end.
        PartKind::LeftRail => other.spans[part].0 > 0,
        PartKind::RightRail => own.spans.last().is_some_and(|end| end.0 != other.spans[part].0),
        found => found == kind && too_many(parse, other, kind),
    })?;
    let written = match other.rung.parts[found].kind {
        PartKind::Bar | PartKind::StrayBar => "|",
        PartKind::Down | PartKind::Up => symbol(other.rung.parts[found].kind),
        _ => "+",
    };
    let meant = symbol(partner(kind));
    let title = format!("Replace `{written}` with `{meant}`");
    Some(guess(title, vec![edit(other.range(parse, found), meant)]))
}

/// The columns in which a line lacks connectors, in their order, each with the connector that is missing.
pub(crate) fn missing(parse: &Parse, line: usize) -> Vec<(usize, &'static str)> {
    let neighbours = [
        (rung_above(parse, line), PartKind::Down),
        (rung_below(parse, line), PartKind::Up),
    ];
    let mut missing = Vec::new();
    for (neighbour, kind) in neighbours {
        let Some(row) = neighbour.map(|line| Row::new(parse, line)) else {
            continue;
        };
        if too_many(parse, &row, kind) {
            let places = row.rung.connectors(kind).map(|part| row.spans[part].0);
            missing.extend(places.map(|column| (column, symbol(partner(kind)))));
        }
    }
    missing.sort_unstable();
    missing
}

/// The connector that is missing nearest to a column, if one is near.
pub(crate) fn nearest(missing: &[(usize, &'static str)], column: usize) -> Option<&'static str> {
    let from = missing.partition_point(|(at, _)| at + NEAR < column);
    let near = missing[from..].iter().take_while(|(at, _)| *at <= column + NEAR);
    near.min_by_key(|(at, _)| at.abs_diff(column))
        .map(|(_, connector)| *connector)
}

/// An end of wire on the other line: near the connector's column, or the only one there.
fn close(parse: &Parse, other: &Row, kind: PartKind, column: usize) -> Option<Fix> {
    let mut ends: Vec<(usize, Edit)> = Vec::new();
    let meant = symbol(partner(kind));
    for segment in &other.rung.segments {
        let (first, last) = (segment.parts.start, segment.parts.end - 1);
        let is_open = |part: usize| {
            matches!(
                other.rung.parts[part].kind,
                PartKind::Wire | PartKind::Block | PartKind::Comment
            )
        };
        let is_wire = |part: usize| other.is(part, PartKind::Wire);
        if is_open(first) {
            let (start, end) = other.spans[first];
            let range = other.range(parse, first);
            // The connector takes the place of the dash in its column, if wire is left after it.
            let replaced = (column + 1).saturating_sub(start);
            let edit = if is_wire(first) && replaced <= NEAR + 1 && column + 1 < end {
                let length = TextSize::new(replaced as u32);
                edit(TextRange::at(range.start(), length), meant)
            } else {
                let wire = if is_wire(first) { "" } else { "-" };
                edit(TextRange::empty(range.start()), &format!("{meant}{wire}"))
            };
            ends.push((start.abs_diff(column), edit));
        }
        if is_open(last) {
            let (start, end) = other.spans[last];
            let range = other.range(parse, last);
            let replaced = end.saturating_sub(column);
            let edit = if is_wire(last) && replaced <= NEAR + 1 && column > start {
                let length = TextSize::new(replaced as u32);
                edit(TextRange::new(range.end() - length, range.end()), meant)
            } else {
                let wire = if is_wire(last) { "" } else { "-" };
                edit(TextRange::empty(range.end()), &format!("{wire}{meant}"))
            };
            ends.push((end.abs_diff(column), edit));
        }
    }
    let only = ends.len() == 1;
    let (distance, edit) = ends.into_iter().min_by_key(|(distance, _)| *distance)?;
    let title = format!("Close the branch with `{meant}`");
    (only || distance <= NEAR).then(|| guess(title, vec![edit]))
}

/// A wire of the other line that passes the connector.
fn join(parse: &Parse, other: &Row, kind: PartKind, column: usize) -> Option<Fix> {
    let passes = |part: &usize| {
        let (start, end) = other.spans[*part];
        other.is(*part, PartKind::Wire) && (start..end).contains(&column)
    };
    let wire = (0..other.spans.len()).find(passes)?;
    let within = TextSize::new((column - other.spans[wire].0) as u32);
    let at = TextRange::at(other.range(parse, wire).start() + within, TextSize::new(1));
    let meant = symbol(partner(kind));
    let title = format!("Join with `{meant}` {} it", next_to(kind));
    Some(guess(title, vec![edit(at, meant)]))
}

/// No wire of the other line passes the connector: the nearest one from which the two are still a pair, if one is near.
fn draw(parse: &Parse, other: &Row, kind: PartKind, column: usize, suspect: usize) -> Option<Fix> {
    // Below, a rung that comes from the left rail is one of its own.
    if kind == PartKind::Down
        && other
            .rung
            .parts
            .iter()
            .any(|part| part.kind == PartKind::LeftRail)
    {
        return None;
    }
    let distance = |part: usize| {
        let (start, end) = other.spans[part];
        start.saturating_sub(column) + (column + 1).saturating_sub(end)
    };
    let pairs = |part: usize| {
        let left = other.rung.connectors(partner(kind));
        left.take_while(|connector| *connector < part).count() <= suspect
    };
    let wires = (0..other.spans.len()).filter(|&part| other.is(part, PartKind::Wire) && pairs(part));
    let wire = wires.min_by_key(|&part| distance(part))?;
    if distance(wire) > NEAR_A_BLOCK {
        return None;
    }
    let range = other.range(parse, wire);
    let at = if other.spans[wire].0 > column {
        range.start()
    } else {
        range.end()
    };
    let meant = symbol(partner(kind));
    let drawn = if at == range.start() {
        format!("--{meant}")
    } else {
        format!("{meant}--")
    };
    let title = format!("Draw `{meant}` {} it", next_to(kind));
    Some(guess(title, vec![edit(TextRange::empty(at), &drawn)]))
}

/// Whether a line below is drawn without the connector that would join it: its power comes from the left rail.
fn is_apart(below: &Row) -> bool {
    below.rung.has_left_rail() && below.rung.connectors(PartKind::Up).next().is_none()
}

/// The last way out, where nothing is below that a `\` could lead to. A `/` with nothing above it may be a closed contact of
/// another notation: there is none.
fn take_away(parse: &Parse, spot: Spot<'_>) -> Option<Fix> {
    let parts = &spot.row.rung.parts;
    let touches_after = parts.get(spot.part + 1).is_some_and(|next| next.touches);
    let edits = || vec![edit(spot.row.range(parse, spot.part), "-")];
    (parts[spot.part].touches && touches_after).then(|| guess("Replace `\\` with wire".to_owned(), edits()))
}

fn guess(title: String, edits: Vec<Edit>) -> Fix {
    Fix::new(Applicability::Unsafe, title, edits)
}

fn edit(range: TextRange, text: &str) -> Edit {
    let text = text.to_owned();
    Edit { range, text }
}

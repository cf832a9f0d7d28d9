//! Contacts, coils and boxes as characters.

use super::canvas::{Arm, Canvas, Weight};
use super::network::Flow;
use super::{Gate, Ink, Shown};
use crate::measure::columns;
use crate::symbol::{Label, Mark, Symbol};

/// The lines that something takes over and under its wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Lines {
    pub(super) over: usize,
    pub(super) under: usize,
}

/// Where a symbol is: its columns, and the line of its wire.
#[derive(Debug, Clone, Copy)]
pub(super) struct SymbolAt {
    pub(super) row: usize,
    pub(super) left: usize,
    pub(super) right: usize,
}

/// How a symbol is while a program runs.
pub(super) struct Standing<'s> {
    pub(super) arriving: Flow,
    pub(super) own: Flow,
    /// What it does, if it is a contact.
    pub(super) gate: Option<Gate>,
    /// The value of an operand by its number.
    pub(super) value: &'s dyn Fn(usize) -> Option<Shown>,
}

/// A tag, and the room for its value.
fn label_lines(label: &Label) -> usize {
    usize::from(!label.text.is_empty()) + usize::from(label.room)
}

/// How many lines a symbol takes.
pub(super) fn lines(symbol: &Symbol) -> Lines {
    match symbol {
        Symbol::Contact { over, under, .. } => Lines {
            over: label_lines(over),
            under: label_lines(under),
        },
        Symbol::Coil { over, .. } => Lines {
            over: label_lines(over),
            under: 0,
        },
        Symbol::Box { over, rows, .. } => Lines {
            over: 1 + label_lines(over),
            under: 1 + rows
                .iter()
                .map(|(_, label)| label_lines(label).max(1))
                .sum::<usize>(),
        },
        Symbol::Jump(_) | Symbol::Flow(_) | Symbol::Target(_) => Lines::default(),
    }
}

/// Draws a symbol with its wires up to the ends of its room.
pub(super) fn draw(canvas: &mut Canvas, symbol: &Symbol, place: SymbolAt, standing: &Standing<'_>) {
    // One that is open and has power before it blocks that.
    let holds_up = standing.gate == Some(Gate::Open) && standing.arriving == Flow::Live;
    let standing = &Standing {
        gate: if holds_up {
            Some(Gate::Blocks)
        } else {
            standing.gate
        },
        ..*standing
    };
    let SymbolAt { row, left, right } = place;
    match symbol {
        Symbol::Contact { mark, over, under } => {
            let (start, end) = between(canvas, mark, ["┤", "├"], place, standing);
            // The bars join what comes and goes.
            bar(canvas, row, start, Arm::Left, standing.arriving, standing);
            bar(canvas, row, end - 1, Arm::Right, standing.own, standing);
            labelled(canvas, over, place, Side::Over, 1, standing);
            labelled(canvas, under, place, Side::Under, 1, standing);
        }
        Symbol::Coil { mark, over } => {
            between(canvas, mark, ["(", ")"], place, standing);
            labelled(canvas, over, place, Side::Over, 1, standing);
        }
        Symbol::Box { over, .. } => {
            boxed(canvas, symbol, place, standing);
            labelled(canvas, over, place, Side::Over, 2, standing);
        }
        Symbol::Jump(name) => {
            let ink = standing.arriving.ink();
            canvas.text(row, left, ">>", ink);
            canvas.text(row, left + 3, name, Ink::Name);
        }
        Symbol::Flow(word) => {
            canvas.text(row, left, "<", standing.arriving.ink());
            canvas.text(row, left + 2, word, Ink::Name);
            canvas.text(row, right - 1, ">", standing.own.ink());
        }
        Symbol::Target(name) => {
            canvas.text(row, left, "[", Ink::Line);
            canvas.text(row, left + 1, name, Ink::Name);
            canvas.text(row, right - 1, "]", Ink::Line);
        }
    }
}

/// The bar of a contact, with the wire that it is on.
fn bar(canvas: &mut Canvas, row: usize, column: usize, wire: Arm, flow: Flow, standing: &Standing<'_>) {
    let ink = glyph_ink(standing);
    canvas.text(row, column, " ", ink);
    for (arm, weight) in [
        (Arm::Up, Weight::Light),
        (Arm::Down, Weight::Light),
        (wire, flow.weight()),
    ] {
        canvas.arm(row, column, arm, weight, ink);
    }
}

/// What a contact or coil is drawn in.
fn glyph_ink(standing: &Standing<'_>) -> Ink {
    match (standing.gate, standing.own) {
        (Some(Gate::Blocks), _) => Ink::Blocks,
        (_, Flow::Unknown) => Ink::Line,
        (_, Flow::Live) => Ink::On,
        (Some(Gate::Closed), Flow::Dead) => Ink::Closed,
        (_, Flow::Dead) => Ink::Off,
    }
}

/// What is between two bars or brackets, and these. Returns where they begin and end.
fn between(
    canvas: &mut Canvas,
    mark: &Mark,
    ends: [&str; 2],
    SymbolAt { row, left, right }: SymbolAt,
    standing: &Standing<'_>,
) -> (usize, usize) {
    let room = mark.width() as usize + 1;
    let start = left + (right - left).saturating_sub(room + 2) / 2;
    let end = start + room + 2;
    canvas.across(
        row,
        left,
        start,
        standing.arriving.weight(),
        standing.arriving.ink(),
    );
    canvas.across(row, end, right, standing.own.weight(), standing.own.ink());
    let ink = glyph_ink(standing);
    // What lets power through is closed to the eye, too.
    let is_closed = match standing.gate {
        Some(gate) => gate == Gate::Closed,
        None => standing.own == Flow::Live,
    };
    let fill = match (is_closed, standing.own) {
        (true, Flow::Live) => "━",
        (true, _) => "─",
        (false, _) => " ",
    };
    let inside = match mark {
        Mark::Nothing => fill.repeat(room),
        Mark::Stroke => format!("{fill}/{fill}"),
        Mark::Word(word) => {
            let rest = room.saturating_sub(columns(word) as usize);
            format!("{}{word}{}", fill.repeat(rest - rest / 2), fill.repeat(rest / 2))
        }
    };
    canvas.text(row, start, ends[0], ink);
    canvas.text(row, start + 1, &inside, ink);
    canvas.text(row, end - 1, ends[1], ink);
    (start, end)
}

#[derive(Clone, Copy)]
enum Side {
    Over,
    Under,
}

/// A tag this many lines next to the wire, and its value beyond it.
fn labelled(
    canvas: &mut Canvas,
    label: &Label,
    SymbolAt { row, left, right }: SymbolAt,
    side: Side,
    distance: usize,
    standing: &Standing<'_>,
) {
    if label.text.is_empty() {
        return;
    }
    let next_to = |lines: usize| match side {
        Side::Over => row - lines,
        Side::Under => row + lines,
    };
    let value = (standing.value)(label.operand);
    let is_forced = value.as_ref().is_some_and(|value| value.forced);
    let centred = |text: &str| left + (right - left).saturating_sub(columns(text) as usize) / 2;
    // A contact shows the value of its tag by itself, but not that it is forced.
    let (text, ink) = if is_forced && !label.room {
        (format!("{}!", label.text), Ink::Forced)
    } else {
        (label.text.clone(), Ink::Tag)
    };
    canvas.text(next_to(distance), centred(&text), &text, ink);
    if let Some(value) = value.filter(|_| label.room) {
        let text = valued(&value, right - left);
        let ink = if value.forced { Ink::Forced } else { Ink::Value };
        canvas.text(next_to(distance + 1), centred(&text), &text, ink);
    }
}

/// A value in this many columns, with `!` if it is forced.
fn valued(value: &Shown, room: usize) -> String {
    let sign = if value.forced { "!" } else { "" };
    let room = room.saturating_sub(sign.len());
    if columns(&value.text) as usize <= room {
        return format!("{}{sign}", value.text);
    }
    let mut kept = String::new();
    for letter in value.text.chars() {
        if columns(&kept) as usize + 2 > room {
            break;
        }
        kept.push(letter);
    }
    format!("{kept}…{sign}")
}

/// A box with its name in its upper edge.
fn boxed(
    canvas: &mut Canvas,
    symbol: &Symbol,
    SymbolAt { row, left, right }: SymbolAt,
    standing: &Standing<'_>,
) {
    let Symbol::Box {
        name,
        pins,
        rows,
        names,
        ..
    } = symbol
    else {
        return;
    };
    let (top, bottom) = (row - 1, row + lines(symbol).under);
    let last = right - 1;
    for edge in [top, bottom] {
        canvas.across(edge, left + 1, last, Weight::Light, Ink::Line);
        canvas.arm(edge, left, Arm::Right, Weight::Light, Ink::Line);
        canvas.arm(edge, last, Arm::Left, Weight::Light, Ink::Line);
    }
    for side in [left, last] {
        canvas.down(side, top, bottom, Weight::Light, Ink::Line);
    }
    let inner = right - left - 2;
    let wide = columns(name) as usize;
    let name = if wide + 2 <= inner {
        format!(" {name} ")
    } else {
        name.clone()
    };
    let at = left + 1 + inner.saturating_sub(columns(&name) as usize) / 2;
    canvas.text(top, at, &name, Ink::Name);
    if let Some((into, out)) = pins {
        canvas.arm(row, left, Arm::Left, standing.arriving.weight(), Ink::Line);
        canvas.arm(row, last, Arm::Right, standing.own.weight(), Ink::Line);
        canvas.text(row, left + 1, into, Ink::Pin);
        canvas.text(row, last - out.len(), out, Ink::Pin);
    }
    let mut at = row + 1;
    for (name, label) in rows {
        canvas.text(at, left + 1, name, Ink::Pin);
        let column = left + 1 + *names as usize + usize::from(*names > 0);
        let value = (standing.value)(label.operand);
        canvas.text(at, column, &label.text, Ink::Tag);
        if let Some(value) = value.filter(|_| label.room) {
            let ink = if value.forced { Ink::Forced } else { Ink::Value };
            canvas.text(at + 1, column, &valued(&value, last - column), ink);
        }
        at += label_lines(label).max(1);
    }
}

//! The symbols of blocks: contacts, coils, boxes.

use super::draw::Power;
use super::paper::Paper;
use super::shapes::{Anchor, At, PathStep};
use super::style::{HALF, LINE, Look, UNIT};
use super::symbol::{Label, Mark, NAME, ROWS, Symbol, VALUE, width};

/// Where a symbol is: its ends on the wire.
#[derive(Clone, Copy)]
pub(super) struct WireEnds {
    pub(super) left: i32,
    pub(super) right: i32,
    pub(super) y: i32,
}

impl WireEnds {
    const fn middle(self) -> i32 {
        i32::midpoint(self.left, self.right)
    }
}

/// Draws a block: power `arriving` at its left, and `own` leaving it.
pub(super) fn draw(paper: &mut Paper, symbol: &Symbol, place: WireEnds, arriving: &Power, own: &Power) {
    let WireEnds { left, right, y } = place;
    let middle = place.middle();
    match symbol {
        Symbol::Contact { mark, over, under } => {
            let half = mark.width() as i32 * UNIT / 2;
            paper.gate([
                PathStep::Move((middle - half, y - HALF)),
                PathStep::Line((middle + half, y - HALF)),
                PathStep::Line((middle + half, y + HALF)),
                PathStep::Line((middle - half, y + HALF)),
                PathStep::Close,
            ]);
            lead(paper, arriving, (left, y), (middle - half, y));
            lead(paper, own, (middle + half, y), (right, y));
            for bar in [middle - half, middle + half] {
                paper.line(Look::Line, (bar, y - HALF), (bar, y + HALF));
            }
            draw_mark(paper, mark, middle, y);
            draw_label(paper, over, middle, y - HALF - 5, Side::Over);
            draw_label(paper, under, middle, y + HALF + LINE - 4, Side::Under);
        }
        Symbol::Coil { mark, over } => {
            let half = mark.width() as i32 * UNIT / 2;
            let (upper, lower) = (y - HALF, y + HALF);
            paper.gate([
                PathStep::Move((middle - half, upper)),
                PathStep::Bow((middle - half - 6, y), (middle - half, lower)),
                PathStep::Line((middle + half, lower)),
                PathStep::Bow((middle + half + 6, y), (middle + half, upper)),
                PathStep::Close,
            ]);
            lead(paper, arriving, (left, y), (middle - half - 3, y));
            lead(paper, own, (middle + half + 3, y), (right, y));
            for (end, bow) in [(middle - half, -6), (middle + half, 6)] {
                let bowed = end + bow;
                let bow = PathStep::Bow((bowed, y), (end, lower));
                paper.path(Look::Line, [PathStep::Move((end, upper)), bow]);
            }
            draw_mark(paper, mark, middle, y);
            draw_label(paper, over, middle, y - HALF - 5, Side::Over);
        }
        Symbol::Box {
            over,
            name,
            pins,
            rows,
            names,
        } => {
            let height = symbol.room().under + NAME;
            paper.rect(Look::Box, (left, y - NAME), right - left, height);
            draw_label(paper, over, middle, y - NAME - 5, Side::Over);
            let base = y - NAME + LINE - 3;
            paper.text(Look::Name, (middle, base), Anchor::Middle, width(name), name);
            if let Some((into, out)) = pins {
                paper.text(Look::Pin, (left + 4, y + 4), Anchor::Start, width(into), into);
                paper.text(Look::Pin, (right - 4, y + 4), Anchor::End, width(out), out);
            }
            let names = *names as i32 * UNIT;
            let mut bottom = y + ROWS;
            for (name, label) in rows {
                bottom += label.height().max(LINE);
                let base = bottom - 4;
                paper.text(
                    Look::Pin,
                    (left + UNIT / 2, base),
                    Anchor::Start,
                    width(name),
                    name,
                );
                let at = if names == 0 {
                    left + UNIT
                } else {
                    left + names + UNIT + UNIT / 2
                };
                paper.operand(Some(label.operand));
                paper.text(
                    Look::Text,
                    (at, base),
                    Anchor::Start,
                    width(&label.text),
                    &label.text,
                );
                if label.room {
                    paper.value((at, base - VALUE + 1), Anchor::Start, right - UNIT / 2 - at);
                }
                paper.operand(None);
                if let Some(value) = &label.value {
                    let at = (at + width(&label.text) + UNIT, base);
                    paper.text(Look::Value, at, Anchor::Start, width(value), value);
                }
            }
        }
        Symbol::Jump(name) => {
            for step in [0, UNIT] {
                let at = left + step;
                let (upper, lower) = (y - 6, y + 6);
                let tip = at + 7;
                let steps = [
                    PathStep::Move((at, upper)),
                    PathStep::Line((tip, y)),
                    PathStep::Line((at, lower)),
                ];
                paper.powered_by(&arriving.of);
                paper.path(arriving.flow.line(), steps);
            }
            lead(paper, arriving, (left, y), (left + 7, y));
            let at = (left + 2 * UNIT + 4, y + 4);
            paper.text(Look::Name, at, Anchor::Start, width(name), name);
        }
        Symbol::Flow(word) => {
            let (upper, lower) = (y - HALF - 2, y + HALF + 2);
            let (inner_left, inner_right) = (left + UNIT, right - UNIT);
            let steps = [
                PathStep::Move((left, y)),
                PathStep::Line((inner_left, upper)),
                PathStep::Line((inner_right, upper)),
                PathStep::Line((right, y)),
                PathStep::Line((inner_right, lower)),
                PathStep::Line((inner_left, lower)),
                PathStep::Close,
            ];
            paper.path(Look::Box, steps);
            paper.text(Look::Name, (middle, y + 4), Anchor::Middle, width(word), word);
        }
        Symbol::Target(name) => {
            paper.rect(Look::Box, (left, y - HALF - 2), right - left, 2 * HALF + 4);
            paper.text(Look::Name, (middle, y + 4), Anchor::Middle, width(name), name);
        }
    }
}

/// The wire from a symbol to the end of its room.
fn lead(paper: &mut Paper, power: &Power, from: At, to: At) {
    paper.powered_by(&power.of);
    paper.line(power.flow.line(), from, to);
    paper.powered_by(&[]);
}

fn draw_mark(paper: &mut Paper, mark: &Mark, middle: i32, y: i32) {
    match mark {
        Mark::Nothing => {}
        Mark::Stroke => paper.line(Look::Line, (middle - 8, y + HALF), (middle + 8, y - HALF)),
        Mark::Word(word) => paper.text(Look::Name, (middle, y + 4), Anchor::Middle, width(word), word),
    }
}

/// On which side of its symbol a label is; its value is further out.
#[derive(Clone, Copy)]
enum Side {
    Over,
    Under,
}

/// A tag, with its value after it, or room for it.
fn draw_label(paper: &mut Paper, label: &Label, middle: i32, base: i32, side: Side) {
    paper.operand(Some(label.operand));
    write_label(paper, label, middle, base);
    if label.room {
        let base = match side {
            Side::Over => base - VALUE,
            Side::Under => base + VALUE,
        };
        paper.value((middle, base), Anchor::Middle, width(&label.text).max(9 * UNIT));
    }
    paper.operand(None);
}

fn write_label(paper: &mut Paper, label: &Label, middle: i32, base: i32) {
    let Some(value) = &label.value else {
        paper.text(
            Look::Text,
            (middle, base),
            Anchor::Middle,
            width(&label.text),
            &label.text,
        );
        return;
    };
    let whole = width(&label.text) + UNIT + width(value);
    let left = middle - whole / 2;
    paper.text(
        Look::Text,
        (left, base),
        Anchor::Start,
        width(&label.text),
        &label.text,
    );
    let at = (left + width(&label.text) + UNIT, base);
    paper.text(Look::Value, at, Anchor::Start, width(value), value);
}

//! A network on paper.

use super::paper::{Anchor, Paper};
use super::place::{Drawn, Figure, x};
use super::style::{HALF, LINE, MARGIN, UNIT};
use super::symbol::{Label, Mark, NAME, ROWS, Symbol, row_name_width, width};
use ladder_analysis::network::NetworkFacts;
use ladder_format::Layout;
use ladder_syntax::{Parse, TextRange};
use std::collections::HashMap;

/// Pixels between two rungs.
const BETWEEN: i32 = 6;
/// The middle of a rail or connector in its column.
const MIDDLE: i32 = UNIT / 2;

/// A network with its columns, and where it is drawn.
pub(super) struct Drawing<'d> {
    pub(super) parse: &'d Parse,
    pub(super) network: &'d NetworkFacts,
    pub(super) figure: &'d Figure,
    pub(super) layout: &'d Layout,
    pub(super) power: Option<&'d HashMap<TextRange, bool>>,
}

/// What a part's lines look like.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Flow {
    /// Nothing is said about power.
    Unknown,
    Dead,
    Live,
}

impl Flow {
    const fn line(self) -> &'static str {
        match self {
            Flow::Unknown => "line",
            Flow::Dead => "dead",
            Flow::Live => "live",
        }
    }

    const fn dot(self) -> &'static str {
        match self {
            Flow::Unknown => "dot",
            Flow::Dead => "dot-dead",
            Flow::Live => "dot-live",
        }
    }
}

impl Drawing<'_> {
    /// Draws it below `top`; gives its lower end.
    pub(super) fn draw(&self, paper: &mut Paper, top: i32) -> i32 {
        let mut wires = Vec::with_capacity(self.figure.rooms.len());
        let mut y = top;
        for room in &self.figure.rooms {
            wires.push(y + room.over);
            y += room.over + room.under + BETWEEN;
        }
        let bottom = y - BETWEEN;
        self.verticals(paper, &wires);
        for rung in 0..wires.len() {
            self.rung(paper, rung, &wires);
        }
        self.rails(paper, top, bottom);
        bottom
    }

    fn flow(&self, rung: usize, part: usize) -> Flow {
        let Some(power) = self.power else {
            return Flow::Unknown;
        };
        match power.get(&self.network.part_range(self.parse, rung, part)) {
            Some(true) => Flow::Live,
            _ => Flow::Dead,
        }
    }

    fn rails(&self, paper: &mut Paper, top: i32, bottom: i32) {
        let rungs = &self.network.wiring.rungs;
        if rungs.iter().any(ladder_syntax::wiring::Rung::has_left_rail) {
            let left = MARGIN + MIDDLE;
            paper.line("rail", (left, top), (left, bottom));
        }
        if let Some(column) = self.layout.right_rail() {
            let right = MARGIN + column as i32 * UNIT + MIDDLE;
            paper.line("rail", (right, top), (right, bottom));
        }
    }

    /// The lines between paired connectors.
    fn verticals(&self, paper: &mut Paper, wires: &[i32]) {
        for point in &self.network.wiring.points {
            let Some(element) = self.element(point.upper, point.down) else {
                continue;
            };
            let at = x(self.layout, element) + MIDDLE;
            let class = self.flow(point.upper, point.down).line();
            paper.line(class, (at, wires[point.upper]), (at, wires[point.upper + 1]));
        }
    }

    /// The element of a part.
    fn element(&self, rung: usize, part: usize) -> Option<usize> {
        let elements = self.layout.sketch().rungs().get(rung)?.clone();
        let (start, end) = (elements.start as usize, elements.end as usize);
        let items = &self.figure.items[start..end];
        items
            .binary_search_by_key(&part, |item| item.part)
            .ok()
            .map(|at| start + at)
    }

    /// Where the wire comes to an element, and where it leaves it.
    fn ends(&self, element: usize) -> (i32, i32) {
        let left = x(self.layout, element);
        match self.figure.items[element].drawn {
            Drawn::Rail | Drawn::Connector => (left + MIDDLE, left + MIDDLE),
            _ => (
                left,
                left + self.layout.sketch().elements()[element].width as i32 * UNIT,
            ),
        }
    }

    fn rung(&self, paper: &mut Paper, rung: usize, wires: &[i32]) {
        let y = wires[rung];
        let above = &self.figure.above[rung];
        for (line, comment) in above.iter().enumerate() {
            let base = y - self.figure.rooms[rung].over + (line as i32 + 1) * LINE - 4;
            let at = (MARGIN + 3 * UNIT, base);
            paper.text("comment", at, Anchor::Start, width(comment), comment);
        }
        let elements = self.layout.sketch().rungs()[rung].clone();
        let elements = elements.start as usize..elements.end as usize;
        let mut arriving = Flow::Unknown;
        for element in elements.clone() {
            let item = &self.figure.items[element];
            let kind = self.layout.sketch().elements()[element];
            let (left, right) = self.ends(element);
            let own = self.flow(rung, item.part);
            if kind.joined && element > elements.start {
                let flow = item.wire.map_or(arriving, |wire| self.flow(rung, wire));
                let from = self.ends(element - 1).1;
                paper.line(flow.line(), (from, y), (left, y));
                arriving = flow;
            } else {
                arriving = match own {
                    Flow::Unknown => Flow::Unknown,
                    _ => Flow::Dead,
                };
            }
            match &item.drawn {
                Drawn::Rail => {}
                Drawn::Connector => {
                    let goes_on = elements.contains(&(element + 1))
                        && self.layout.sketch().elements()[element + 1].joined;
                    if kind.joined && goes_on {
                        paper.dot(own.dot(), (left, y));
                    }
                }
                Drawn::Stub => paper.line(own.line(), (left, y), (right, y)),
                Drawn::Comment(text) => {
                    if kind.joined {
                        paper.line(own.line(), (left, y), (right, y));
                    }
                    let at = (i32::midpoint(left, right), y - 6);
                    paper.text("comment", at, Anchor::Middle, width(text), text);
                }
                Drawn::Symbol(symbol) => {
                    let place = Place { left, right, y };
                    draw_symbol(paper, symbol, place, arriving, own);
                }
            }
            arriving = own;
        }
        self.behind(paper, rung, y, elements.end);
    }

    /// The comment behind a rung.
    fn behind(&self, paper: &mut Paper, rung: usize, y: i32, end: usize) {
        let comment = &self.figure.behind[rung];
        let right = match self.layout.right_rail() {
            Some(column) => MARGIN + (column as i32 + 1) * UNIT,
            None => end.checked_sub(1).map_or(MARGIN, |last| self.ends(last).1),
        };
        let at = (right + 2 * UNIT, y + 4);
        paper.text("comment", at, Anchor::Start, width(comment), comment);
    }
}

/// Where a symbol stands: its ends on the wire.
#[derive(Clone, Copy)]
struct Place {
    left: i32,
    right: i32,
    y: i32,
}

impl Place {
    const fn middle(self) -> i32 {
        i32::midpoint(self.left, self.right)
    }
}

/// Draws a block: power `arriving` at its left, and `own` leaving it.
fn draw_symbol(paper: &mut Paper, symbol: &Symbol, place: Place, arriving: Flow, own: Flow) {
    let Place { left, right, y } = place;
    let middle = place.middle();
    match symbol {
        Symbol::Contact { mark, over, under } => {
            let half = mark.width() as i32 * UNIT / 2;
            paper.line(arriving.line(), (left, y), (middle - half, y));
            paper.line(own.line(), (middle + half, y), (right, y));
            for bar in [middle - half, middle + half] {
                paper.line("line", (bar, y - HALF), (bar, y + HALF));
            }
            draw_mark(paper, mark, middle, y);
            draw_label(paper, over, middle, y - HALF - 5);
            draw_label(paper, under, middle, y + HALF + LINE - 4);
        }
        Symbol::Coil { mark, over } => {
            let half = mark.width() as i32 * UNIT / 2;
            paper.line(arriving.line(), (left, y), (middle - half - 3, y));
            paper.line(own.line(), (middle + half + 3, y), (right, y));
            for (end, bow) in [(middle - half, -6), (middle + half, 6)] {
                let (upper, lower) = (y - HALF, y + HALF);
                let bowed = end + bow;
                paper.path("line", &format!("M {end} {upper} Q {bowed} {y} {end} {lower}"));
            }
            draw_mark(paper, mark, middle, y);
            draw_label(paper, over, middle, y - HALF - 5);
        }
        Symbol::Box {
            over,
            name,
            pins,
            rows,
        } => {
            let height = symbol.room().under + NAME;
            paper.rect("box", (left, y - NAME), right - left, height);
            draw_label(paper, over, middle, y - NAME - 5);
            let base = y - NAME + LINE - 3;
            paper.text("name", (middle, base), Anchor::Middle, width(name), name);
            if let Some((into, out)) = pins {
                paper.text("pin", (left + 4, y + 4), Anchor::Start, width(into), into);
                paper.text("pin", (right - 4, y + 4), Anchor::End, width(out), out);
            }
            let names = row_name_width(rows) as i32 * UNIT;
            for (row, (name, label)) in rows.iter().enumerate() {
                let base = y + ROWS + (row as i32 + 1) * LINE - 4;
                paper.text("pin", (left + UNIT / 2, base), Anchor::Start, width(name), name);
                let at = if names == 0 {
                    left + UNIT
                } else {
                    left + names + UNIT + UNIT / 2
                };
                paper.text("", (at, base), Anchor::Start, width(&label.text), &label.text);
                if let Some(value) = &label.value {
                    let at = (at + width(&label.text) + UNIT, base);
                    paper.text("value", at, Anchor::Start, width(value), value);
                }
            }
        }
        Symbol::Jump(name) => {
            for step in [0, UNIT] {
                let at = left + step;
                let (upper, lower) = (y - 6, y + 6);
                let tip = at + 7;
                paper.path(
                    arriving.line(),
                    &format!("M {at} {upper} L {tip} {y} L {at} {lower}"),
                );
            }
            paper.line(arriving.line(), (left, y), (left + 7, y));
            let at = (left + 2 * UNIT + 4, y + 4);
            paper.text("name", at, Anchor::Start, width(name), name);
        }
        Symbol::Flow(word) => {
            let (upper, lower) = (y - HALF - 2, y + HALF + 2);
            let (inner_left, inner_right) = (left + UNIT, right - UNIT);
            paper.path(
                "box",
                &format!(
                    "M {left} {y} L {inner_left} {upper} H {inner_right} L {right} {y} L {inner_right} {lower} H {inner_left} Z"
                ),
            );
            paper.text("name", (middle, y + 4), Anchor::Middle, width(word), word);
        }
        Symbol::Target(name) => {
            paper.rect("box", (left, y - HALF - 2), right - left, 2 * HALF + 4);
            paper.text("name", (middle, y + 4), Anchor::Middle, width(name), name);
        }
    }
}

fn draw_mark(paper: &mut Paper, mark: &Mark, middle: i32, y: i32) {
    match mark {
        Mark::Nothing => {}
        Mark::Stroke => paper.line("line", (middle - 8, y + HALF), (middle + 8, y - HALF)),
        Mark::Word(word) => paper.text("name", (middle, y + 4), Anchor::Middle, width(word), word),
    }
}

/// A tag, with its value behind it.
fn draw_label(paper: &mut Paper, label: &Label, middle: i32, base: i32) {
    let Some(value) = &label.value else {
        paper.text(
            "",
            (middle, base),
            Anchor::Middle,
            width(&label.text),
            &label.text,
        );
        return;
    };
    let whole = width(&label.text) + UNIT + width(value);
    let left = middle - whole / 2;
    paper.text("", (left, base), Anchor::Start, width(&label.text), &label.text);
    let at = (left + width(&label.text) + UNIT, base);
    paper.text("value", at, Anchor::Start, width(value), value);
}

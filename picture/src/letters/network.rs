//! A network as characters.

use super::canvas::{Arm, Canvas, Weight};
use super::symbol::{self, Lines, Standing, SymbolAt};
use super::{Area, Ink, Join, Live, Things, Wire};
use crate::columns::Layout;
use crate::figure::{Drawn, Figure};
use crate::grid::{Kind, Slot};
use crate::measure::columns;
use crate::nodes::point_of;
use ladder_analysis::networks::NetworkAt;
use ladder_syntax::{Parse, TextRange, TextSize};

/// Where a comment above a rung begins.
const COMMENT: usize = 3;

/// Cells of a drawing: each takes some tens of bytes.
const MOST_CELLS: usize = 4_000_000;

/// A network with its columns, and how it is.
pub(super) struct Drawing<'d> {
    pub(super) parse: &'d Parse,
    pub(super) network: NetworkAt<'d>,
    pub(super) figure: &'d Figure,
    pub(super) layout: &'d Layout,
    /// The column of the right rail, where the network ends at one.
    pub(super) rail: Option<u32>,
    pub(super) live: Option<&'d Live>,
}

/// What is where in a drawing.
pub(super) struct Plan {
    /// For each line the place that it shows.
    pub(super) places: Vec<TextSize>,
    /// The lines with the wires of the rungs.
    pub(super) wires: Vec<usize>,
    /// What is on them.
    pub(super) things: Things,
}

/// What is known of the power in a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    /// Nothing is known about power.
    Unknown,
    Dead,
    Live,
}

impl Flow {
    pub(super) fn weight(self) -> Weight {
        match self {
            Flow::Live => Weight::Heavy,
            Flow::Unknown | Flow::Dead => Weight::Light,
        }
    }

    pub(super) fn ink(self) -> Ink {
        match self {
            Flow::Unknown => Ink::Line,
            Flow::Dead => Ink::Off,
            Flow::Live => Ink::On,
        }
    }
}

impl Drawing<'_> {
    /// Draws it; returns what is where.
    ///
    /// # Errors
    /// It is too large, in words.
    pub(super) fn draw(&self, canvas: &mut Canvas) -> Result<Plan, String> {
        let mut wires = Vec::new();
        let mut places = Vec::new();
        for rung in 0..self.figure.rungs.len() {
            let lines = self.lines(rung);
            wires.push(places.len() + lines.over);
            let place = self.parse.line_range(self.network.line(rung)).start();
            places.resize(places.len() + lines.over + 1 + lines.under, place);
        }
        let (lines, columns) = (places.len(), self.columns());
        if lines.saturating_mul(columns) > MOST_CELLS {
            return Err(format!(
                "a network of {lines} lines and {columns} columns is too large to be drawn with characters"
            ));
        }
        self.rails(canvas, lines);
        let mut things = Things::default();
        self.verticals(canvas, &wires, &mut things.joins);
        for (rung, &row) in wires.iter().enumerate() {
            self.rung(canvas, rung, row, &mut things);
        }
        Ok(Plan {
            places,
            wires,
            things,
        })
    }

    /// How wide it is, but for comments after its rungs.
    fn columns(&self) -> usize {
        let things = self.layout.grid.things.iter().zip(&self.layout.columns);
        let ends = things.map(|(thing, column)| column + thing.columns);
        ends.chain(self.rail).max().unwrap_or(0) as usize
    }

    /// The lines of a rung over and under its wire.
    fn lines(&self, rung: usize) -> Lines {
        let own = self.figure.rungs[rung].iter().map(|item| match &item.drawn {
            Drawn::Symbol { symbol, .. } => symbol::lines(symbol),
            Drawn::Comment(_) => Lines { over: 1, under: 0 },
            _ => Lines::default(),
        });
        let most = own.fold(Lines::default(), |most, own| Lines {
            over: most.over.max(own.over),
            under: most.under.max(own.under),
        });
        Lines {
            over: most.over + self.figure.above[rung].len(),
            ..most
        }
    }

    fn range(&self, rung: usize, part: usize) -> TextRange {
        self.network.part_range(self.parse, rung, part)
    }

    fn flow(&self, rung: usize, part: usize) -> Flow {
        match self.live.map(|live| live.power.get(&self.range(rung, part))) {
            None => Flow::Unknown,
            Some(Some(true)) => Flow::Live,
            Some(_) => Flow::Dead,
        }
    }

    /// The power of a thing on several rungs: that of its points.
    fn flow_of(&self, thing: usize) -> Flow {
        let slots = self.layout.grid.things[thing].slots.iter();
        let parts = slots.flat_map(|&(rung, slot)| {
            let items = self.layout.grid.rungs[rung][slot].items.clone();
            items.map(move |item| (rung, self.figure.rungs[rung][item].part))
        });
        let flows = parts.map(|(rung, part)| self.flow(rung, part));
        flows.fold(Flow::Unknown, |found, flow| match (found, flow) {
            (Flow::Live, _) | (_, Flow::Live) => Flow::Live,
            (_, flow) => flow,
        })
    }

    fn rails(&self, canvas: &mut Canvas, lines: usize) {
        let mut things = self.layout.grid.things.iter();
        let left = things.any(|thing| thing.kind == Kind::LeftRail).then_some(0);
        for column in left.into_iter().chain(self.rail) {
            for row in 0..lines {
                for arm in [Arm::Up, Arm::Down] {
                    canvas.arm(row, column as usize, arm, Weight::Light, Ink::Rail);
                }
            }
        }
    }

    /// The lines from rung to rung.
    fn verticals(&self, canvas: &mut Canvas, wires: &[usize], joins: &mut Vec<Join>) {
        for (rung, slots) in self.layout.grid.rungs.iter().enumerate() {
            for slot in slots {
                if let (Some(up), Some(&to)) = (self.connector_below(rung, slot), wires.get(rung + 1)) {
                    let flow = self.flow_of(slot.thing);
                    let (column, _) = self.ends(slot);
                    canvas.down(column, wires[rung], to, flow.weight(), flow.ink());
                    joins.push(Join {
                        place: self.range(rung + 1, up).start(),
                        lines: wires[rung]..to + 1,
                        column,
                    });
                }
            }
        }
    }

    /// A column from which on this many are free of the lines that come down to a rung.
    fn free_of_lines(&self, rung: usize, wide: usize) -> usize {
        let Some(above) = rung.checked_sub(1) else {
            return COMMENT;
        };
        let slots = self.layout.grid.rungs[above].iter();
        let mut at = COMMENT;
        for slot in slots.filter(|slot| self.connector_below(above, slot).is_some()) {
            let (column, after) = self.ends(slot);
            if column < at + wide && after >= at {
                at = after + 1;
            }
        }
        at
    }

    /// The connector of the rung below that a line leads down to.
    fn connector_below(&self, rung: usize, slot: &Slot) -> Option<usize> {
        let points = self.figure.rungs[rung][slot.items.clone()]
            .iter()
            .filter_map(point_of);
        let mut pairs = points.map(|point| &self.network.wiring.points[point]);
        Some(pairs.find(|pair| pair.upper == rung)?.up)
    }

    /// The columns of something, the first and the one after the last.
    fn ends(&self, slot: &Slot) -> (usize, usize) {
        let thing = &self.layout.grid.things[slot.thing];
        let left = self.layout.columns[slot.thing] as usize;
        match thing.kind {
            Kind::LeftRail | Kind::RightRail | Kind::Node => (left, left + 1),
            _ => (left, left + thing.columns as usize),
        }
    }

    fn rung(&self, canvas: &mut Canvas, rung: usize, row: usize, things: &mut Things) {
        let lines = self.lines(rung);
        for (line, comment) in self.figure.above[rung].iter().enumerate() {
            let at = self.free_of_lines(rung, columns(comment) as usize);
            canvas.text(row - lines.over + line, at, comment, Ink::Comment);
        }
        let slots = &self.layout.grid.rungs[rung];
        let mut arriving = Flow::Unknown;
        let mut before: Option<(usize, Kind)> = None;
        for slot in slots {
            let item = &self.figure.rungs[rung][slot.items.start];
            let kind = self.layout.grid.things[slot.thing].kind;
            let (left, right) = self.ends(slot);
            let own = match item.drawn {
                Drawn::Connector(_) => self.flow_of(slot.thing),
                _ => self.flow(rung, item.part),
            };
            match before.filter(|_| slot.joined) {
                Some((from, kind_before)) => {
                    if let Some(wire) = item.wire {
                        arriving = self.flow(rung, wire);
                    }
                    let (weight, ink) = (arriving.weight(), arriving.ink());
                    canvas.across(row, from, left, weight, ink);
                    things.wires.push(Wire {
                        place: self.range(rung, item.wire.unwrap_or(item.part)).start(),
                        line: row,
                        columns: from..left,
                    });
                    if is_thin(kind_before) {
                        canvas.arm(row, from - 1, Arm::Right, weight, ink);
                    }
                    if is_thin(kind) {
                        canvas.arm(row, left, Arm::Left, weight, ink);
                    }
                }
                None => {
                    arriving = match own {
                        Flow::Unknown => Flow::Unknown,
                        _ => Flow::Dead,
                    };
                }
            }
            self.slot(
                canvas,
                rung,
                slot,
                SymbolAt { row, left, right },
                (arriving, own),
                things,
            );
            arriving = own;
            before = Some((right, kind));
        }
        let comment = &self.figure.after[rung];
        if !comment.is_empty() {
            let after = self.rail.map(|rail| rail as usize + 1);
            let after = after.or(before.map(|(right, _)| right)).unwrap_or(0);
            canvas.text(row, after + 2, comment, Ink::Comment);
        }
    }

    fn slot(
        &self,
        canvas: &mut Canvas,
        rung: usize,
        slot: &Slot,
        place: SymbolAt,
        (arriving, own): (Flow, Flow),
        things: &mut Things,
    ) {
        let SymbolAt { row, left, right } = place;
        let item = &self.figure.rungs[rung][slot.items.start];
        match &item.drawn {
            Drawn::LeftRail | Drawn::RightRail | Drawn::Connector(_) => {}
            Drawn::Stub => {
                canvas.across(row, left, right, own.weight(), own.ink());
                things.wires.push(Wire {
                    place: self.range(rung, item.part).start(),
                    line: row,
                    columns: left..right,
                });
            }
            Drawn::Comment(text) => {
                canvas.across(row, left, right, own.weight(), own.ink());
                let at = left + (right - left).saturating_sub(columns(text) as usize) / 2;
                canvas.text(row - 1, at, text, Ink::Comment);
                things.areas.push(Area {
                    range: self.range(rung, item.part),
                    lines: row - 1..row + 1,
                    columns: left..right,
                });
            }
            Drawn::Symbol { symbol, .. } => {
                let range = self.range(rung, item.part);
                let mut blocks = self.network.blocks();
                let block = blocks.find(|block| (block.facts.rung, block.facts.part) == (rung, item.part));
                let value = |operand: usize| {
                    let block = block?;
                    let operand = block.facts.operands.get(operand)?;
                    let range = block.absolute(operand.value.range);
                    self.live?.values.get(&range).cloned()
                };
                let standing = Standing {
                    arriving,
                    own,
                    gate: self.live.and_then(|live| live.contacts.get(&range).copied()),
                    value: &value,
                };
                symbol::draw(canvas, symbol, place, &standing);
                let lines = symbol::lines(symbol);
                things.areas.push(Area {
                    range,
                    lines: row - lines.over..row + lines.under + 1,
                    columns: left..right,
                });
            }
        }
    }
}

/// A rail or line from rung to rung: one column, which wires are joined to.
fn is_thin(kind: Kind) -> bool {
    matches!(kind, Kind::LeftRail | Kind::RightRail | Kind::Node)
}

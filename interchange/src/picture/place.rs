//! Where each part of a network stands: the formatter's layout, with the widths of symbols.

use super::comment;
use super::style::{LINE, UNIT};
use super::symbol::{Room, Symbol, Words};
use ladder_analysis::network::{BoundBlock, NetworkFacts};
use ladder_format::{ElementKind, Layout, Sketch, display_width};
use ladder_instructions::Role;
use ladder_syntax::wiring::{PartKind, Rung};
use std::collections::HashMap;

/// A network as it will be drawn, before it has columns.
#[derive(Debug)]
pub(super) struct Figure {
    pub(super) sketch: Sketch,
    /// For each element of the sketch what it is.
    pub(super) items: Vec<Item>,
    /// Comments that stand above each rung.
    pub(super) above: Vec<Vec<String>>,
    /// Comments behind each rung.
    pub(super) behind: Vec<String>,
    /// The room of each rung over and under its wire.
    pub(super) rooms: Vec<Room>,
}

/// An element of a rung.
#[derive(Debug)]
pub(super) struct Item {
    /// The part of its rung.
    pub(super) part: usize,
    /// The wire that leads to it from the element before, where one is drawn.
    pub(super) wire: Option<usize>,
    pub(super) drawn: Drawn,
}

/// What is drawn for an element.
#[derive(Debug)]
pub(super) enum Drawn {
    Rail,
    Connector,
    Stub,
    Symbol(Symbol),
    Comment(String),
}

/// What a network consists of.
pub(super) fn figure(network: &NetworkFacts, words: &Words<'_>) -> Figure {
    let mut figure = Figure {
        sketch: Sketch::new(),
        items: Vec::new(),
        above: Vec::new(),
        behind: Vec::new(),
        rooms: Vec::new(),
    };
    let blocks = network.blocks.iter();
    let blocks = blocks
        .map(|block| ((block.facts.rung, block.facts.part), block))
        .collect();
    for (number, rung) in network.wiring.rungs.iter().enumerate() {
        let before = match number.checked_sub(1) {
            Some(before) => network.line(before) + 1,
            None => network.line(number),
        };
        let between = before..network.line(number);
        figure
            .above
            .push(between.flat_map(|line| words.comments_of(line)).collect());
        figure.sketch.begin_rung();
        figure.rung(network, number, rung, words, &blocks);
    }
    figure
}

/// The blocks of a network by rung and part.
type Blocks<'n> = HashMap<(usize, usize), &'n BoundBlock>;

impl Figure {
    fn rung(
        &mut self,
        network: &NetworkFacts,
        number: usize,
        rung: &Rung,
        words: &Words<'_>,
        blocks: &Blocks<'_>,
    ) {
        let mut room = Room {
            columns: 0,
            over: 6,
            under: 6,
        };
        let mut behind = Vec::new();
        let mut segment = None;
        let mut wire = None;
        let first = rung.parts.iter().position(|part| part.segment.is_some());
        let last = rung.parts.iter().rposition(|part| part.segment.is_some());
        for (index, part) in rung.parts.iter().enumerate() {
            let joined = part.segment.is_some() && part.segment == segment;
            let of_part = |drawn| (drawn, joined);
            let (drawn, joined) = match part.kind {
                PartKind::Bar | PartKind::StrayBar | PartKind::Junk => continue,
                PartKind::LeftRail | PartKind::RightRail => of_part(Drawn::Rail),
                PartKind::StrayRail => of_part(Drawn::Stub),
                PartKind::Down | PartKind::Up => of_part(Drawn::Connector),
                PartKind::Wire => {
                    let ends = part.segment.and_then(|n| rung.segments.get(n as usize));
                    let is_between = ends.is_some_and(|s| s.parts.start < index && index + 1 < s.parts.end);
                    if is_between {
                        wire = Some(index);
                        continue;
                    }
                    of_part(Drawn::Stub)
                }
                PartKind::Comment => {
                    let text = words.text_of(network.part_range(&words.context.parse, number, index));
                    let text = comment::on_one_line(text);
                    if part.segment.is_none() && Some(index) > last {
                        behind.push(text);
                        continue;
                    }
                    if part.segment.is_none() && Some(index) < first {
                        self.above[number].push(text);
                        continue;
                    }
                    of_part(Drawn::Comment(text))
                }
                PartKind::Block => {
                    let Some(block) = blocks.get(&(number, index)) else {
                        continue;
                    };
                    of_part(Drawn::Symbol(words.symbol(block)))
                }
            };
            let (kind, own) = match &drawn {
                Drawn::Rail if part.kind == PartKind::LeftRail => (ElementKind::LeftRail, Room::thin(1)),
                Drawn::Rail => (ElementKind::RightRail, Room::thin(1)),
                Drawn::Connector if part.kind == PartKind::Down => (ElementKind::Down, Room::thin(1)),
                Drawn::Connector => (ElementKind::Up, Room::thin(1)),
                Drawn::Stub => (ElementKind::Stub, Room::thin(2)),
                Drawn::Comment(text) => (
                    ElementKind::Comment,
                    Room {
                        columns: display_width(text) + 2,
                        over: LINE + 4,
                        under: 6,
                    },
                ),
                Drawn::Symbol(symbol) => (role(blocks.get(&(number, index)).copied()), symbol.room()),
            };
            room.over = room.over.max(own.over);
            room.under = room.under.max(own.under);
            self.sketch.push(kind, joined, own.columns);
            self.items.push(Item {
                part: index,
                wire: wire.take(),
                drawn,
            });
            segment = part.segment;
        }
        room.over += self.above[number].len() as i32 * LINE;
        self.behind.push(behind.join("  "));
        self.rooms.push(room);
    }
}

fn role(block: Option<&BoundBlock>) -> ElementKind {
    match block.and_then(BoundBlock::instruction) {
        Some(row) if row.role == Role::Condition => ElementKind::Condition,
        _ => ElementKind::Acting,
    }
}

impl Room {
    /// Something that takes no room beside the wire.
    const fn thin(columns: u32) -> Room {
        Room {
            columns,
            over: 0,
            under: 0,
        }
    }
}

/// The left edge of a column, in pixels.
pub(super) fn x(layout: &Layout, element: usize) -> i32 {
    super::style::MARGIN + layout.columns()[element] as i32 * UNIT
}

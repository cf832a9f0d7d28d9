//! What a network consists of: the elements of its rungs with the room that each takes, before they have columns.

use super::comment;
use super::measure::{columns, shortened};
use super::style::LINE;
use super::symbol::{Room, Symbol, Words};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_instructions::Role;
use ladder_syntax::wiring::{PartKind, Rung};
use std::collections::HashMap;

/// A network as it will be drawn.
#[derive(Debug)]
pub(super) struct Figure {
    /// The elements of each rung from left to right.
    pub(super) rungs: Vec<Vec<Item>>,
    /// Comments that are above each rung.
    pub(super) above: Vec<Vec<String>>,
    /// Comments after each rung.
    pub(super) after: Vec<String>,
    /// The room of each rung over and under its wire.
    pub(super) rooms: Vec<Room>,
}

/// An element of a rung.
#[derive(Debug)]
pub(super) struct Item {
    /// The part of its rung.
    pub(super) part: usize,
    /// Whether a wire leads to it from the element before.
    pub(super) joined: bool,
    /// That wire, where it is drawn in the text.
    pub(super) wire: Option<usize>,
    /// The columns that it takes.
    pub(super) columns: u32,
    pub(super) drawn: Drawn,
}

/// What is drawn for an element.
#[derive(Debug)]
pub(super) enum Drawn {
    LeftRail,
    RightRail,
    /// A connector of this pair of the wiring.
    Connector(usize),
    /// A wire that ends at nothing.
    Stub,
    Symbol {
        symbol: Symbol,
        /// It does something, rather than decide about power.
        acts: bool,
    },
    Comment(String),
}

/// The blocks of a network by rung and part.
type Blocks<'n> = HashMap<(usize, usize), BlockAt<'n>>;

/// The figure of a network.
pub(super) fn figure(network: NetworkAt<'_>, words: &Words<'_>) -> Figure {
    let mut figure = Figure {
        rungs: Vec::new(),
        above: Vec::new(),
        after: Vec::new(),
        rooms: Vec::new(),
    };
    let blocks = network.blocks();
    let blocks = blocks
        .map(|block| ((block.facts.rung, block.facts.part), block))
        .collect();
    let mut connectors = HashMap::new();
    for (point, pair) in network.wiring.points.iter().enumerate() {
        connectors.insert((pair.upper, pair.down), point);
        connectors.insert((pair.upper + 1, pair.up), point);
    }
    for (number, rung) in network.wiring.rungs.iter().enumerate() {
        let before = match number.checked_sub(1) {
            Some(before) => network.line(before) + 1,
            None => network.line(number),
        };
        let between = before..network.line(number);
        figure.above.push(
            between
                .flat_map(|line| words.comments_of(line))
                .map(shortened)
                .collect(),
        );
        figure.rung(network, number, rung, words, &blocks, &connectors);
    }
    figure
}

impl Figure {
    fn rung(
        &mut self,
        network: NetworkAt<'_>,
        number: usize,
        rung: &Rung,
        words: &Words<'_>,
        blocks: &Blocks<'_>,
        connectors: &HashMap<(usize, usize), usize>,
    ) {
        let mut items = Vec::new();
        let mut room = Room {
            columns: 0,
            over: 6,
            under: 6,
        };
        let mut after = Vec::new();
        let mut segment = None;
        let mut wire = None;
        let first = rung.parts.iter().position(|part| part.segment.is_some());
        let last = rung.parts.iter().rposition(|part| part.segment.is_some());
        for (index, part) in rung.parts.iter().enumerate() {
            let drawn = match part.kind {
                PartKind::Bar | PartKind::StrayBar | PartKind::Junk => continue,
                PartKind::LeftRail => Drawn::LeftRail,
                PartKind::RightRail => Drawn::RightRail,
                PartKind::StrayRail => Drawn::Stub,
                PartKind::Down | PartKind::Up => match connectors.get(&(number, index)) {
                    Some(&point) => Drawn::Connector(point),
                    None => Drawn::Stub,
                },
                PartKind::Wire => {
                    let ends = part.segment.and_then(|n| rung.segments.get(n as usize));
                    let is_between = ends.is_some_and(|s| s.parts.start < index && index + 1 < s.parts.end);
                    if is_between {
                        wire = Some(index);
                        continue;
                    }
                    Drawn::Stub
                }
                PartKind::Comment => {
                    let text = words.text_of(network.part_range(&words.context.parse, number, index));
                    let text = shortened(comment::on_one_line(&text));
                    if part.segment.is_none() && Some(index) > last {
                        after.push(text);
                        continue;
                    }
                    if part.segment.is_none() && Some(index) < first {
                        self.above[number].push(text);
                        continue;
                    }
                    Drawn::Comment(text)
                }
                PartKind::Block => {
                    let Some(block) = blocks.get(&(number, index)) else {
                        continue;
                    };
                    Drawn::Symbol {
                        symbol: words.symbol(*block, network.scope),
                        acts: acts(*block),
                    }
                }
            };
            let own = drawn.room();
            room.over = room.over.max(own.over);
            room.under = room.under.max(own.under);
            items.push(Item {
                part: index,
                joined: part.segment.is_some() && part.segment == segment,
                wire: wire.take(),
                columns: own.columns,
                drawn,
            });
            segment = part.segment;
        }
        room.over += self.above[number].len() as i32 * LINE;
        self.rungs.push(items);
        self.after.push(after.join("  "));
        self.rooms.push(room);
    }
}

impl Drawn {
    fn room(&self) -> Room {
        // What takes no room next to the wire.
        let thin = |columns| Room {
            columns,
            over: 0,
            under: 0,
        };
        match self {
            Drawn::LeftRail | Drawn::RightRail | Drawn::Connector(_) => thin(1),
            Drawn::Stub => thin(2),
            Drawn::Comment(text) => Room {
                columns: columns(text) + 2,
                over: LINE + 4,
                under: 6,
            },
            Drawn::Symbol { symbol, .. } => symbol.room(),
        }
    }
}

fn acts(block: BlockAt<'_>) -> bool {
    block.instruction().is_none_or(|row| row.role != Role::Condition)
}

//! The drawing on rungs: parts, segments, connector pairs (LANGUAGE §2).
//!
//! Reads the green nodes of the lines directly, without a tree cursor: this runs for every network at every
//! check, format and simulation.

use crate::kind::SyntaxKind;
use crate::line::LineKind;
use crate::line_tree::Trees;
use crate::parse::Parse;
use crate::structure::Network;
use rowan::{GreenNode, GreenNodeData, NodeOrToken, TextRange, TextSize};
use std::ops::Range;

/// What one part of a rung is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum PartKind {
    /// A run of dashes.
    Wire,
    /// The `+` that is first on its line: power comes from the left rail.
    LeftRail,
    /// The `+` that is last on its line.
    RightRail,
    /// A `+` anywhere else. An error; it acts as wire.
    StrayRail,
    /// A `|`. Breaks a wire.
    Bar,
    /// A `|` that touches the drawing on both sides. An error; it breaks the wire.
    StrayBar,
    /// `\`
    Down,
    /// `/`
    Up,
    /// A block.
    Block,
    /// A comment. It is wire when it joins what touches it on both sides.
    Comment,
    /// Characters that mean nothing. An error; taken as wire, so that it does not bring others.
    Junk,
}

impl PartKind {
    /// Whether a comment next to it can join it: wires, connectors and blocks.
    const fn joins(self) -> bool {
        !matches!(self, PartKind::Bar | PartKind::StrayBar | PartKind::Comment)
    }
}

/// One thing on a rung. White space between parts is not a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RungPart {
    /// What it is.
    pub kind: PartKind,
    /// Where, counted from the start of its line.
    pub range: TextRange,
    /// Which child of its line's node it is; the first, where it is several.
    pub child: u32,
    /// Whether it touches the part before it.
    pub touches: bool,
    /// The segment it belongs to. None for bars, and for comments and stray characters that join nothing.
    pub segment: Option<u32>,
}

/// A stretch of parts that touch: what is drawn is what is connected.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Segment {
    /// Its parts, as indices into [`Rung::parts`].
    pub parts: Range<usize>,
    /// It begins with the `+` at the left rail.
    pub powered: bool,
}

/// The drawing on one rung.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Rung {
    /// The parts from left to right.
    pub parts: Vec<RungPart>,
    /// The segments from left to right.
    pub segments: Vec<Segment>,
}

impl Rung {
    /// The indices of the `\` (or `/`) parts, from left to right.
    pub fn connectors(&self, kind: PartKind) -> impl Iterator<Item = usize> + '_ {
        self.parts
            .iter()
            .enumerate()
            .filter(move |(_, part)| part.kind == kind)
            .map(|(index, _)| index)
    }

    /// Whether a line of its network begins at the left rail here.
    pub fn has_left_rail(&self) -> bool {
        self.parts.iter().any(|part| part.kind == PartKind::LeftRail)
    }

    /// Whether it ends at the right rail.
    pub fn has_right_rail(&self) -> bool {
        self.parts.iter().any(|part| part.kind == PartKind::RightRail)
    }
}

/// A contact drawn with bars, as in many books: `--| |--`, `--||--`, and `--|/|--` for a closed one. It means nothing in the
/// language; without it the drawing would be another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BarContact {
    /// Its parts, from the first bar to the last, as indices into [`Rung::parts`].
    pub parts: Range<usize>,
    /// There is a stroke between the bars.
    pub is_closed: bool,
}

/// How many blanks there are between the bars of a contact, at most.
const WIDEST_CONTACT: u32 = 3;

/// The contacts drawn with bars on a rung.
pub fn bar_contacts(parts: &[RungPart]) -> impl Iterator<Item = BarContact> + '_ {
    let is_bar = |n: usize| matches!(parts[n].kind, PartKind::Bar | PartKind::StrayBar);
    let mut end = 0;
    (1..parts.len().saturating_sub(2)).filter_map(move |first| {
        if first < end || !is_bar(first) || !parts[first].touches || !parts[first - 1].kind.joins() {
            return None;
        }
        let is_closed = matches!(parts[first + 1].kind, PartKind::Up | PartKind::Down);
        let last = first + 1 + usize::from(is_closed);
        let after = parts.get(last + 1)?;
        let gap = parts[last].range.start() - parts[first].range.end();
        if !is_bar(last) || !after.touches || !after.kind.joins() || u32::from(gap) > WIDEST_CONTACT {
            return None;
        }
        end = last + 1;
        let parts = first..end;
        Some(BarContact { parts, is_closed })
    })
}

/// A pair of connectors: one electrical point. Rungs count within their network.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Point {
    /// The rung of the `\`; the `/` is on the next.
    pub upper: usize,
    /// The part of the `\` on its rung.
    pub down: usize,
    /// The part of the `/` on the next rung.
    pub up: usize,
    /// Its number among the pairs between the two rungs, from 0.
    pub ordinal: usize,
}

/// The wiring of one network.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Wiring {
    /// For each rung how many lines below the network's first line it is. So the wiring is that of the lines
    /// alone, wherever in a file they are.
    pub line_offsets: Vec<usize>,
    /// The rungs from top to bottom.
    pub rungs: Vec<Rung>,
    /// The pairs, by rung and then from left to right.
    pub points: Vec<Point>,
    /// Connectors without a partner: rung and part.
    pub unpaired: Vec<(usize, usize)>,
}

/// The wiring of a network.
pub fn wiring(parse: &Parse, network: &Network) -> Wiring {
    let mut trees = Trees::default();
    let rungs = network.rungs(parse.lines());
    let rungs: Vec<GreenNode> = rungs.map(|line| trees.of(&parse.lines()[line])).collect();
    wiring_of(parse, network, &rungs)
}

/// The wiring of a network, of whose rungs the trees are known.
pub fn wiring_of(parse: &Parse, network: &Network, rungs: &[GreenNode]) -> Wiring {
    // Nearly all lines of a network are rungs.
    let mut wiring = Wiring {
        line_offsets: Vec::with_capacity(network.lines.len()),
        rungs: rungs.iter().map(|node| rung(node)).collect(),
        ..Wiring::default()
    };
    let lines = parse.lines().range(network.lines.clone()).enumerate();
    let rungs = lines.filter(|(_, line)| line.kind == LineKind::Rung);
    wiring.line_offsets.extend(rungs.map(|(offset, _)| offset));
    pair(&mut wiring);
    wiring
}

/// Pairs the k-th `\` of each rung with the k-th `/` of the next.
fn pair(wiring: &mut Wiring) {
    for upper in 0..wiring.rungs.len() {
        let downs: Vec<usize> = wiring.rungs[upper].connectors(PartKind::Down).collect();
        let ups: Vec<usize> = match wiring.rungs.get(upper + 1) {
            Some(below) => below.connectors(PartKind::Up).collect(),
            None => Vec::new(),
        };
        for (ordinal, (&down, &up)) in downs.iter().zip(&ups).enumerate() {
            wiring.points.push(Point {
                upper,
                down,
                up,
                ordinal,
            });
        }
        wiring
            .unpaired
            .extend(downs.iter().skip(ups.len()).map(|&down| (upper, down)));
        wiring
            .unpaired
            .extend(ups.iter().skip(downs.len()).map(|&up| (upper + 1, up)));
    }
    if let Some(first) = wiring.rungs.first() {
        let above: Vec<usize> = first.connectors(PartKind::Up).collect();
        wiring.unpaired.extend(above.into_iter().map(|up| (0, up)));
    }
    wiring.unpaired.sort_unstable();
}

/// The parts and segments of one rung, from its line's node.
pub fn rung(line: &GreenNodeData) -> Rung {
    let children = line.children();
    let mut rung = Rung {
        // White space alone takes none of it.
        parts: Vec::with_capacity(children.len()),
        segments: Vec::with_capacity(1),
    };
    let children = children.map(|child| match child {
        NodeOrToken::Node(node) => (node.kind(), node.text_len()),
        NodeOrToken::Token(token) => (token.kind(), token.text_len()),
    });
    let numbered = children.zip(0..).map(|((kind, len), number)| Child {
        kind: SyntaxKind::from_raw(kind),
        len,
        number,
    });
    read_rung(numbered, &mut rung);
    rung
}

/// A node or token directly on a line.
#[derive(Debug, Clone, Copy)]
pub struct Child {
    /// What it is.
    pub kind: SyntaxKind,
    /// How long its text is.
    pub len: TextSize,
    /// Its number, for [`RungPart::child`].
    pub number: u32,
}

/// Reads the parts and segments of a rung from its line's children. What the rung held before goes, its memory stays: a
/// walk over a file needs no other.
pub fn read_rung(children: impl Iterator<Item = Child>, rung: &mut Rung) {
    rung.parts.clear();
    rung.segments.clear();
    parts(children, &mut rung.parts);
    classify_rails(&mut rung.parts);
    classify_bars(&mut rung.parts);
    segments(&mut rung.parts, &mut rung.segments);
}

fn parts(children: impl Iterator<Item = Child>, parts: &mut Vec<RungPart>) {
    let mut at = TextSize::new(0);
    let mut touches = false;
    for child in children {
        let range = TextRange::at(at, child.len);
        at += child.len;
        let kind = match child.kind {
            SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE | SyntaxKind::BOM => {
                touches = false;
                continue;
            }
            SyntaxKind::WIRE => PartKind::Wire,
            // Which `+` it is becomes clear when all parts are there.
            SyntaxKind::RAIL_CONNECTOR => PartKind::StrayRail,
            SyntaxKind::RAIL => PartKind::Bar,
            SyntaxKind::DOWN => PartKind::Down,
            SyntaxKind::UP => PartKind::Up,
            SyntaxKind::COMMENT => PartKind::Comment,
            kind if kind.is_block() => PartKind::Block,
            _ => PartKind::Junk,
        };
        if kind == PartKind::Junk
            && touches
            && let Some(last) = parts.last_mut().filter(|last| last.kind == PartKind::Junk)
        {
            last.range = last.range.cover(range);
            continue;
        }
        parts.push(RungPart {
            kind,
            range,
            child: child.number,
            touches,
            segment: None,
        });
        touches = true;
    }
}

/// The first `+` of a line is the left rail's if nothing but comments and `|` are before it, the last one
/// the right rail's likewise. Characters that mean nothing are one error and make no second.
fn classify_rails(parts: &mut [RungPart]) {
    let aside = |part: &RungPart| matches!(part.kind, PartKind::Comment | PartKind::Bar | PartKind::Junk);
    let first = parts.iter().position(|part| !aside(part));
    let last = parts.iter().rposition(|part| !aside(part));
    if let Some(first) = first.filter(|&n| parts[n].kind == PartKind::StrayRail) {
        parts[first].kind = PartKind::LeftRail;
    }
    if let Some(last) = last.filter(|&n| parts[n].kind == PartKind::StrayRail) {
        parts[last].kind = PartKind::RightRail;
    }
}

fn classify_bars(parts: &mut [RungPart]) {
    for index in 1..parts.len().saturating_sub(1) {
        let touched = parts[index].touches && parts[index + 1].touches;
        if parts[index].kind == PartKind::Bar
            && touched
            && parts[index - 1].kind.joins()
            && parts[index + 1].kind.joins()
        {
            parts[index].kind = PartKind::StrayBar;
        }
    }
}

fn segments(parts: &mut [RungPart], segments: &mut Vec<Segment>) {
    let mut start = 0;
    while start < parts.len() {
        let is_bar = |part: &RungPart| matches!(part.kind, PartKind::Bar | PartKind::StrayBar);
        if is_bar(&parts[start]) {
            start += 1;
            continue;
        }
        let mut end = start + 1;
        while end < parts.len() && parts[end].touches && !is_bar(&parts[end]) {
            end += 1;
        }
        // Comments at either end of a touching run have nothing to join on one side.
        let run = &parts[start..end];
        let inner = run
            .iter()
            .position(|part| part.kind != PartKind::Comment)
            .map(|first| {
                let last = run
                    .iter()
                    .rposition(|part| part.kind != PartKind::Comment)
                    .unwrap_or(first);
                start + first..start + last + 1
            });
        // Characters that mean nothing and touch nothing are no wire either.
        let drawn = |range: &Range<usize>| {
            let means = |part: &RungPart| !matches!(part.kind, PartKind::Junk | PartKind::Comment);
            parts[range.clone()].iter().any(means)
        };
        if let Some(inner) = inner.filter(drawn) {
            for part in &mut parts[inner.clone()] {
                part.segment = Some(segments.len() as u32);
            }
            let powered = parts[inner.clone()]
                .iter()
                .find(|part| part.kind != PartKind::Junk)
                .is_some_and(|part| part.kind == PartKind::LeftRail);
            segments.push(Segment {
                parts: inner,
                powered,
            });
        }
        start = end;
    }
}

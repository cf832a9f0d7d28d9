//! Parts of a drawing for a page that shows a running program: each comment and network by itself, and in it the places
//! in the text of all that can be live. The page that shows it knows nothing of ladder logic.
//!
//! ```text
//! <svg class="drawing">
//!   <line data-power="0:1" data-point="0:1"/>    a wire: it is live if one of these parts has power, and something can be put in
//!   <line data-joins="0:13,1:3" data-tight="0:14"/>  a line from rung to rung, and points on it that have no wire here
//!   <text class="comment" data-at="0:3" data-end="0:15">  a comment in a wire
//!   <g class="element contact" data-at="0:3" data-end="0:15" data-name="Open contact">
//!     <rect class="hit"/>                        where a user points at it
//!     <path class="gate"/>                       the gap, filled when power can pass
//!     <text data-operand="0:8">start</text>      the name of an operand
//!     <text class="value" data-operand="0:8"/>   where its value belongs
//!   </g>
//! </svg>
//! ```

use super::Options;
use super::page::{self, PageItem};
use super::paper::Paper;
use super::shapes::{BlockKind, Element, Form, Picture, Role, Shape};
use super::style::{Look, MARGIN, UNIT};
use super::svg::write;
use super::symbol::Words;
use super::wrap::paragraph;
use ladder_analysis::context::Context;
use ladder_analysis::networks::BlockAt;
use ladder_instructions::Group;
use ladder_syntax::wiring::PartKind;
use ladder_syntax::xml::Escaped;
use ladder_syntax::{Item, Structure, TextRange, TextSize};
use std::collections::HashMap;
use std::fmt::Write;

/// Blank above and below a piece.
const EDGE: i32 = 4;

/// A comment, heading or network, drawn by itself.
#[derive(Debug)]
pub struct Piece {
    /// Where it is in the text, line ends included.
    pub range: TextRange,
    /// The drawing, from its own upper left corner.
    picture: Picture,
}

/// What a piece is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Comments on lines of their own.
    Comment,
    /// The first or last line of a user-defined block.
    Heading,
    /// A network.
    Network,
    /// A network with an error in its drawing, shown as text, and whatever is after a comment that is never closed.
    Broken,
}

/// Draws what has something in a stretch of a text, with the right rail in this column where a network is no wider.
pub fn pieces(context: &Context, stretch: TextRange, rail: u32) -> Vec<Piece> {
    let options = Options {
        live: true,
        ..Options::default()
    };
    let words = Words::of(context, &options);
    let structure = context.parse.structure();
    let is_comment = |item: &Item| page::is_comment(context, *item);
    let items = items_in(context, structure, stretch, &is_comment);
    // Comments on lines that follow each other are one text.
    let groups = items.chunk_by(|above, below| is_comment(above) && is_comment(below));
    let pieces = groups.filter_map(|group| {
        let (first, last) = (*group.first()?, *group.last()?);
        let range = lines_of(context, structure, first).cover(lines_of(context, structure, last));
        let mut item = page::items(group, &words).pop()?;
        match &mut item {
            PageItem::Section(..) => return None,
            PageItem::Comment(lines) => *lines = paragraph(lines, rail),
            _ => {}
        }
        let mut paper = Paper::new(true);
        let bottom = item.draw(&mut paper, EDGE, rail, context, &options);
        let mut picture = paper.finish(bottom, MARGIN, 0);
        picture.height = bottom + EDGE;
        Some(Piece { range, picture })
    });
    pieces.collect()
}

/// The items of a file that have something in a stretch of it, and all of the comments of which it has some.
pub(super) fn items_in<'s>(
    context: &Context,
    structure: &'s Structure,
    stretch: TextRange,
    is_comment: &dyn Fn(&Item) -> bool,
) -> &'s [Item] {
    let items = &structure.items;
    let lines = |item: &Item| lines_of(context, structure, *item);
    let mut first = items.partition_point(|item| lines(item).end() <= stretch.start());
    let mut end = items.partition_point(|item| lines(item).start() < stretch.end());
    end = end.max(first);
    while first > 0 && first < items.len() && is_comment(&items[first]) && is_comment(&items[first - 1]) {
        first -= 1;
    }
    while end > first && end < items.len() && is_comment(&items[end - 1]) && is_comment(&items[end]) {
        end += 1;
    }
    &items[first..end]
}

/// The lines of an item, line ends included.
pub(super) fn lines_of(context: &Context, structure: &Structure, item: Item) -> TextRange {
    let parse = &context.parse;
    let line = match item {
        Item::Network(index) => return context.networks.at(index).range,
        Item::Section(index) => {
            let lines = &structure.sections[index].lines;
            let last = lines.end.max(lines.start + 1) - 1;
            return parse.line_range(lines.start).cover(parse.line_range(last));
        }
        Item::BlockHeader(index) => structure.blocks[index].lines.start,
        Item::BlockEnd(line) | Item::Decoration(line) | Item::Stray(line) => line,
    };
    parse.line_range(line)
}

impl Piece {
    /// What it is.
    pub fn kind(&self, context: &Context) -> Kind {
        // What is after a comment that is never closed is not what it seems to be.
        let unclosed = context.parse.unclosed_comment();
        if unclosed.is_some_and(|place| place.start() < self.range.end()) {
            return Kind::Broken;
        }
        match self.picture.blocks.first().map(|block| &block.kind) {
            Some(&BlockKind::Network { index, .. }) if context.networks.at(index).broken => Kind::Broken,
            Some(BlockKind::Network { .. }) => Kind::Network,
            Some(BlockKind::Heading) => Kind::Heading,
            _ => Kind::Comment,
        }
    }

    /// Its width and height, in pixels.
    pub fn size(&self) -> (i32, i32) {
        (self.picture.width, self.picture.height)
    }

    /// Which network it is.
    pub fn network(&self) -> Option<usize> {
        match self.picture.blocks.first()?.kind {
            BlockKind::Network { index, .. } => Some(index),
            _ => None,
        }
    }

    /// The drawing. `place` says how the page calls a place in the text; `points` are the places of the network where something
    /// can be put in, sorted.
    pub fn svg(&self, context: &Context, points: &[TextSize], place: &dyn Fn(TextSize) -> String) -> String {
        let Picture { width, height, .. } = self.picture;
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"drawing\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\">\n"
        );
        let elements = Elements::of(&self.picture, context);
        let mut open = None;
        for shape in &self.picture.shapes {
            let element = shape
                .element
                .filter(|element| shape.role == Role::Symbol && elements.symbols.contains_key(element));
            if element != open {
                if open.is_some() {
                    out.push_str("</g>\n");
                }
                if let Some(element) = element {
                    elements.open(element, place, &mut out);
                }
                open = element;
            }
            write(shape, &elements.attributes(shape, points, place), &mut out);
        }
        if open.is_some() {
            out.push_str("</g>\n");
        }
        out.push_str("</svg>");
        out
    }
}

/// The blocks of a piece's network, by the elements that show them.
struct Elements<'c> {
    context: &'c Context,
    symbols: HashMap<Element, Symbol<'c>>,
}

/// A block, and where it is drawn.
struct Symbol<'c> {
    block: BlockAt<'c>,
    columns: (i32, i32),
    rows: (i32, i32),
}

impl<'c> Elements<'c> {
    fn of(picture: &Picture, context: &'c Context) -> Elements<'c> {
        let mut symbols = HashMap::new();
        if let Some(first) = picture.placed.first() {
            let network = context.networks.at(first.element.network);
            let blocks = network.blocks();
            let blocks: HashMap<_, _> = blocks
                .map(|block| ((block.facts.rung, block.facts.part), block))
                .collect();
            for placed in &picture.placed {
                let element = placed.element;
                if let Some(&block) = blocks.get(&(element.rung, element.part)) {
                    let (columns, rows) = (placed.columns, placed.rows);
                    symbols.insert(element, Symbol { block, columns, rows });
                }
            }
        }
        Elements { context, symbols }
    }

    /// Begins the group of a symbol.
    fn open(&self, element: Element, place: &dyn Fn(TextSize) -> String, out: &mut String) {
        let Symbol { block, columns, rows } = &self.symbols[&element];
        let range = self.range(element);
        let (kind, name) = match block.instruction() {
            Some(row) if row.group == Group::Condition => ("contact", row.title),
            Some(row) if row.coil.is_some() => ("coil", row.title),
            Some(row) => ("block", row.title),
            None => ("block", block.facts.head.text()),
        };
        let (width, height) = (columns.1 - columns.0, rows.1 - rows.0);
        // Writing to a String does not fail.
        let _ = write!(
            out,
            "<g class=\"element {kind}\" data-at=\"{}\" data-end=\"{}\" data-name=\"{}\">\n\
             <rect class=\"hit\" x=\"{}\" y=\"{}\" width=\"{width}\" height=\"{height}\" rx=\"3\"/>\n",
            place(range.start()),
            place(range.end()),
            Escaped(name),
            columns.0,
            rows.0,
        );
    }

    fn range(&self, element: Element) -> TextRange {
        let network = self.context.networks.at(element.network);
        network.part_range(&self.context.parse, element.rung, element.part)
    }

    /// What makes a shape live: whose power it shows, and which operand it names.
    fn attributes(&self, shape: &Shape, points: &[TextSize], place: &dyn Fn(TextSize) -> String) -> String {
        let mut attributes = String::new();
        if !shape.power.is_empty() {
            let mut parts: Vec<String> = Vec::with_capacity(shape.power.len());
            for &part in &shape.power {
                let part = place(self.range(part).start());
                if !parts.contains(&part) {
                    parts.push(part);
                }
            }
            let _ = write!(attributes, " data-power=\"{}\"", parts.join(" "));
        }
        let operand = shape.element.zip(shape.operand).and_then(|(element, operand)| {
            let block = self.symbols.get(&element)?.block;
            Some(block.absolute(block.facts.operands.get(operand)?.value.range))
        });
        if let Some(range) = operand {
            let _ = write!(attributes, " data-operand=\"{}\"", place(range.start()));
        }
        if let (Look::Value, Form::Text { width, .. }) = (shape.look, &shape.form) {
            let _ = write!(attributes, " data-room=\"{}\"", width / UNIT);
        }
        if let Some(element) = shape.element {
            self.drawn(shape, element, points, place, &mut attributes);
        }
        attributes
    }

    /// What a person who draws does with a shape: where something is put in, and what a line joins.
    fn drawn(
        &self,
        shape: &Shape,
        element: Element,
        points: &[TextSize],
        place: &dyn Fn(TextSize) -> String,
        attributes: &mut String,
    ) {
        let range = || self.range(element);
        let is_point = |at: &TextSize| points.binary_search(at).is_ok();
        let _ = match (shape.role, shape.look) {
            (Role::Wire, _) if is_point(&range().start()) && !self.is_comment(element) => {
                write!(attributes, " data-point=\"{}\"", place(range().start()))
            }
            (Role::Symbol, Look::Comment) => {
                let [at, end] = [range().start(), range().end()].map(place);
                write!(attributes, " data-at=\"{at}\" data-end=\"{end}\"")
            }
            (Role::Node, _) => {
                let joins = self.joins(shape, element.rung);
                let joins = joins.iter().map(|[upper, lower]| {
                    let [upper, lower] = [upper, lower].map(|part| place(self.range(*part).start()));
                    format!("{upper},{lower}")
                });
                let joins: Vec<String> = joins.collect();
                let tight = self.tight(shape, element.rung).into_iter().filter(is_point);
                let tight: Vec<String> = tight.map(place).collect();
                let _ = write!(attributes, " data-joins=\"{}\"", joins.join(" "));
                if tight.is_empty() {
                    return;
                }
                write!(attributes, " data-tight=\"{}\"", tight.join(" "))
            }
            _ => Ok(()),
        };
    }

    fn is_comment(&self, element: Element) -> bool {
        let network = self.context.networks.at(element.network);
        network.wiring.rungs[element.rung].parts[element.part].kind == PartKind::Comment
    }

    /// The pairs of connectors that the part of a line below a rung is, from left to right.
    fn joins(&self, shape: &Shape, rung: usize) -> Vec<[Element; 2]> {
        let points = |upper: &Element| {
            let network = self.context.networks.at(upper.network);
            let mut points = network.wiring.points.iter();
            let point = points.find(|point| (point.upper, point.down) == (upper.rung, upper.part))?;
            let lower = Element {
                rung: point.upper + 1,
                part: point.up,
                ..*upper
            };
            Some([*upper, lower])
        };
        let mut joins: Vec<_> = shape
            .power
            .iter()
            .filter(|part| part.rung == rung)
            .filter_map(points)
            .collect();
        joins.sort_unstable();
        joins
    }

    /// Where wires between the connectors of a line begin: on the rung above, and on that below if the line ends there.
    fn tight(&self, shape: &Shape, rung: usize) -> Vec<TextSize> {
        let ends = self.joins(shape, rung + 1).is_empty();
        let mut parts: Vec<Element> = shape.power.clone();
        parts.retain(|part| part.rung == rung || (ends && part.rung == rung + 1));
        parts.sort_unstable();
        let next_to = |pair: &&[Element]| {
            let network = self.context.networks.at(pair[0].network);
            let drawn = &network.wiring.rungs[pair[0].rung].parts;
            pair[0].rung == pair[1].rung && drawn[pair[0].part].segment == drawn[pair[1].part].segment
        };
        let wires = parts.windows(2).filter(next_to);
        wires.map(|pair| self.range(pair[0]).end()).collect()
    }
}

//! The diagram drawn with characters, for a terminal and for editors that show nothing else: each comment and network by
//! itself, at rest or as it is while a program runs.
//!
//! ```text
//!       start       stop              run
//! ├──┬──┤   ├──┬──┤ / ├──────────────(   )──┤
//! │  │   run   │                            │
//! │  └──┤   ├──┘                            │
//! ```
//!
//! What is where is decided as for a picture: one unit of a column is a letter there, too. Power is shown by the weight
//! of the lines, what a contact does by what is between its bars, and all of it by marks besides, which may be colours.

mod canvas;
mod network;
mod style;
mod symbol;

pub use style::{Style, text};

use super::Options;
use super::live::{items_in, lines_of};
use super::page::{self, PageItem};
use super::symbol::Words;
use super::wrap::paragraph;
use canvas::Canvas;
use ladder_analysis::context::Context;
use ladder_syntax::{Item, TextRange, TextSize};
use std::collections::HashMap;
use std::ops::Range;

/// How the parts of a running program are, by their places in the text.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Live {
    /// Whether power leaves a wire, block or connector.
    pub power: HashMap<TextRange, bool>,
    /// What contacts do.
    pub contacts: HashMap<TextRange, Gate>,
    /// The values of operands.
    pub values: HashMap<TextRange, Shown>,
}

/// What a contact does with power.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gate {
    /// It lets power through, whether any comes or not.
    Closed,
    /// It would not, and none comes.
    Open,
    /// It holds up the power that comes.
    Blocks,
}

/// The value of an operand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shown {
    /// In words.
    pub text: String,
    /// It is held there.
    pub forced: bool,
}

/// What a stretch of a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ink {
    /// Lines of a program at rest, and boxes.
    Line,
    /// What has power.
    On,
    /// What has none.
    Off,
    /// A contact that lets power through, but none comes.
    Closed,
    /// A contact that holds up the power that comes.
    Blocks,
    /// A rail.
    Rail,
    /// A tag or another operand.
    Tag,
    /// The name of an instruction, a heading.
    Name,
    /// The name of an operand.
    Pin,
    /// A value.
    Value,
    /// A forced value, and the tag that has it.
    Forced,
    /// A comment.
    Comment,
    /// A network with an error in its drawing, as it is written.
    Text,
}

/// A stretch of a line, in characters.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mark {
    /// Where.
    pub characters: Range<usize>,
    /// What it is.
    pub ink: Ink,
}

/// A line of a drawing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line {
    /// Without blanks at its end.
    pub text: String,
    /// What its parts are.
    pub marks: Vec<Mark>,
    /// The line of the text that it shows: where that begins.
    pub place: TextSize,
    /// The wire of a rung is on it.
    pub is_wire: bool,
}

/// A block or a comment in a wire that is drawn, and where.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Area {
    /// It in the text.
    pub range: TextRange,
    /// Its lines in the piece.
    pub lines: Range<usize>,
    /// Its columns.
    pub columns: Range<usize>,
}

/// A wire between two things of a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wire {
    /// Where it begins in the text.
    pub place: TextSize,
    /// Its line in the piece.
    pub line: usize,
    /// Its columns.
    pub columns: Range<usize>,
}

/// A line from the wire of a rung to that of the rung below.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Join {
    /// Its lower connector in the text.
    pub place: TextSize,
    /// The lines of the piece from the upper wire up to the lower one.
    pub lines: Range<usize>,
    /// Its column.
    pub column: usize,
}

/// A comment, heading or network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Piece {
    /// Where it is in the text, line ends included.
    pub range: TextRange,
    /// What is drawn.
    pub lines: Vec<Line>,
    /// What is in it.
    pub things: Things,
}

/// What a cursor in a network can be on.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Things {
    /// Its blocks, and the comments in its wires.
    pub areas: Vec<Area>,
    /// Its wires.
    pub wires: Vec<Wire>,
    /// The lines from rung to rung.
    pub joins: Vec<Join>,
}

/// Draws what has something in a stretch of a text, with the right rail in this column where a network is no wider.
/// `live` is how its parts are, if it runs.
pub fn pieces(context: &Context, stretch: TextRange, rail: u32, live: Option<&Live>) -> Vec<Piece> {
    let options = Options {
        live: live.is_some(),
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
        let item = page::items(group, &words).pop()?;
        let (lines, things) = draw(item, range, rail, context, live)?;
        Some(Piece { range, lines, things })
    });
    pieces.collect()
}

fn draw(
    item: PageItem,
    range: TextRange,
    rail: u32,
    context: &Context,
    live: Option<&Live>,
) -> Option<(Vec<Line>, Things)> {
    let lines = match item {
        PageItem::Comment(lines) => texts(&paragraph(&lines, rail), Ink::Comment, range),
        PageItem::Heading(heading) => texts(&[heading], Ink::Name, range),
        PageItem::Text(_, lines) => texts(&lines, Ink::Text, range),
        PageItem::Section(..) => return None,
        PageItem::Network(index, mut drawn) => {
            let (figure, layout) = &mut *drawn;
            let rail = layout.least_rail.map(|least| least.max(rail));
            if let Some(rail) = rail {
                layout.move_right(rail);
            }
            let drawing = network::Drawing {
                parse: &context.parse,
                network: context.networks.at(index),
                figure,
                layout,
                rail,
                live,
            };
            let mut canvas = Canvas::default();
            match drawing.draw(&mut canvas) {
                Ok(plan) => return Some((canvas.finish(&plan.places, &plan.wires), plan.things)),
                Err(too_large) => texts(&[too_large], Ink::Text, range),
            }
        }
    };
    Some((lines, Things::default()))
}

/// Lines of text, each as it is.
fn texts(lines: &[String], ink: Ink, range: TextRange) -> Vec<Line> {
    let lines = lines.iter().map(|line| {
        let text = line.trim_end();
        let characters = 0..text.chars().count();
        let marks = (!characters.is_empty()).then_some(Mark { characters, ink });
        Line {
            text: text.to_owned(),
            marks: marks.into_iter().collect(),
            place: range.start(),
            is_wire: false,
        }
    });
    lines.collect()
}

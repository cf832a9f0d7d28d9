//! The diagram of an open program drawn with characters: only what a client shows, and, while the program runs, as it is.
//! `docs/protocol.md` shows the messages.

use ladder_documents::{Lines, Position, Range, Revision};
use ladder_picture::letters::{self, Gate, Ink, Live, Piece, Shown};
use ladder_simulator::chart;
use ladder_syntax::{TextRange, TextSize};
use serde::{Deserialize, Serialize};

use crate::drawing::Drawing as Elements;
use crate::engine::Engine;
use crate::messages::Contact;
use crate::request::Failure;

/// More lines than this are no screen.
const MOST_LINES: u32 = 1000;
/// Where the right rail may be, in columns from the left one.
const RAILS: std::ops::RangeInclusive<u32> = 20..=400;
/// Where it is unless the client says so.
const RAIL: u32 = 76;

/// The argument of `ladder.diagramText`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DiagramText {
    /// The program, which must be open.
    pub uri: String,
    /// The simulation of it that is shown; the program is drawn at rest without one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub session: Option<String>,
    /// The lines of its text that are shown.
    pub lines: Lines,
    /// Where the right rail is to be, in columns from the left one; a wider network has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rail: Option<u32>,
}

/// The answer to `ladder.diagramText`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnText {
    /// The version of the text that all places belong to.
    pub version: i32,
    /// What is drawn, line by line.
    pub drawn: Vec<DrawnLine>,
    /// The blocks in it, and the comments in its wires.
    pub blocks: Vec<DrawnBlock>,
    /// The wires in it.
    pub wires: Vec<DrawnWire>,
    /// The lines from rung to rung in it.
    pub joins: Vec<DrawnJoin>,
}

/// A line of a diagram.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnLine {
    /// The line of the program that it shows.
    pub line: u32,
    /// The wire of a rung is on it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub wire: bool,
    /// The characters.
    pub text: String,
    /// What stretches of them are: from which character on, up to which, and what.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub marks: Vec<(usize, usize, InkName)>,
}

/// A block that is drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnBlock {
    /// The block in the text.
    pub range: Range,
    /// The first of the lines that it is drawn in, and the one after the last.
    pub lines: (usize, usize),
    /// Its first column, and the one after the last.
    pub columns: (usize, usize),
    /// In a simulation the tags that its operands name, the most telling one first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tags: Vec<String>,
}

/// A wire that is drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnWire {
    /// Where it begins in the text: something can be put in there.
    pub at: Position,
    /// The line that it is drawn in.
    pub line: usize,
    /// Its first column, and the one after the last.
    pub columns: (usize, usize),
}

/// A line from a wire to the one below it that is drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct DrawnJoin {
    /// Its lower connector in the text.
    pub at: Position,
    /// The line of the upper wire, and the one after that of the lower wire.
    pub lines: (usize, usize),
    /// The column that it is drawn in.
    pub column: usize,
}

/// What a stretch of a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum InkName {
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

impl InkName {
    fn of(ink: Ink) -> InkName {
        match ink {
            Ink::Line => InkName::Line,
            Ink::On => InkName::On,
            Ink::Off => InkName::Off,
            Ink::Closed => InkName::Closed,
            Ink::Blocks => InkName::Blocks,
            Ink::Rail => InkName::Rail,
            Ink::Tag => InkName::Tag,
            Ink::Name => InkName::Name,
            Ink::Pin => InkName::Pin,
            Ink::Value => InkName::Value,
            Ink::Forced => InkName::Forced,
            Ink::Comment => InkName::Comment,
            Ink::Text => InkName::Text,
        }
    }
}

/// The lines that are asked for, as far as there are that many.
fn lines_asked(asked: &DiagramText, last_line: u32) -> Lines {
    let first = asked.lines.first.min(last_line);
    let most = first.saturating_add(MOST_LINES - 1);
    Lines {
        first,
        last: asked.lines.last.clamp(first, most).min(last_line),
    }
}

/// Where the right rail is to be.
fn rail(asked: &DiagramText) -> u32 {
    asked.rail.unwrap_or(RAIL).clamp(*RAILS.start(), *RAILS.end())
}

/// Draws what is asked for, at rest; none if the text is too large. For a blocking thread.
pub fn draw(revision: &Revision, asked: &DiagramText) -> Option<DrawnText> {
    let Lines { first, last } = lines_asked(asked, revision.last_line());
    let start = revision.line_start(first);
    let stretch = TextRange::new(start, revision.line_start(last + 1).max(start));
    let mut drawing = Drawing::new(revision.version);
    for piece in pieces(revision, stretch, rail(asked), None)? {
        let place = |place: TextSize| revision.range(TextRange::empty(place)).start;
        let block = |range: TextRange| Some((revision.range(range), Vec::new()));
        drawing.add(piece, place, block);
    }
    Some(drawing.done)
}

/// The pieces of a stretch of a text; none if that is too large.
fn pieces(revision: &Revision, stretch: TextRange, rail: u32, live: Option<&Live>) -> Option<Vec<Piece>> {
    let context = revision.context()?;
    Some(letters::pieces(context, stretch, rail, live))
}

/// A diagram that is put together from pieces.
struct Drawing {
    done: DrawnText,
}

impl Drawing {
    fn new(version: i32) -> Drawing {
        Drawing {
            done: DrawnText {
                version,
                drawn: Vec::new(),
                blocks: Vec::new(),
                wires: Vec::new(),
                joins: Vec::new(),
            },
        }
    }

    /// Adds a piece below what is there. `place` is where a place is in the text that is shown; `block` where a block is, and
    /// its tags, if it is still there.
    fn add(
        &mut self,
        piece: Piece,
        place: impl Fn(TextSize) -> Position,
        block: impl Fn(TextRange) -> Option<(Range, Vec<String>)>,
    ) {
        if let (Some(_), Some(next)) = (self.done.drawn.last(), piece.lines.first()) {
            self.done.drawn.push(DrawnLine {
                line: place(next.place).line,
                wire: false,
                text: String::new(),
                marks: Vec::new(),
            });
        }
        let top = self.done.drawn.len();
        for drawn in piece.lines {
            let marks = drawn.marks.into_iter();
            let marks = marks.map(|mark| (mark.characters.start, mark.characters.end, InkName::of(mark.ink)));
            self.done.drawn.push(DrawnLine {
                line: place(drawn.place).line,
                wire: drawn.is_wire,
                marks: marks.collect(),
                text: drawn.text,
            });
        }
        for area in piece.things.areas {
            if let Some((range, tags)) = block(area.range) {
                self.done.blocks.push(DrawnBlock {
                    range,
                    lines: (top + area.lines.start, top + area.lines.end),
                    columns: (area.columns.start, area.columns.end),
                    tags,
                });
            }
        }
        let wires = piece.things.wires.into_iter().map(|wire| DrawnWire {
            at: place(wire.place),
            line: top + wire.line,
            columns: (wire.columns.start, wire.columns.end),
        });
        self.done.wires.extend(wires);
        let joins = piece.things.joins.into_iter().map(|join| DrawnJoin {
            at: place(join.place),
            lines: (top + join.lines.start, top + join.lines.end),
            column: join.column,
        });
        self.done.joins.extend(joins);
    }
}

impl Engine {
    /// Draws what is asked for, as it is now.
    pub(crate) fn diagram_text(&self, asked: &DiagramText) -> Result<DrawnText, Failure> {
        let simulation = self.session.simulation();
        let elements = self.drawing.get_or_init(|| Elements::of(simulation));
        let revision = self.line_map.running();
        let shown = self.line_map.shown();
        let Lines { first, last } = lines_asked(asked, shown.last_line());
        let mut drawing = Drawing::new(shown.version);
        let mut after = TextSize::from(0);
        for stretch in self.line_map.stretches(first, last) {
            // A network that is cut through is drawn as a whole, and once.
            let start = stretch.start().max(after);
            if start >= stretch.end() {
                continue;
            }
            let stretch = TextRange::new(start, stretch.end());
            let whole = elements.whole_networks(stretch);
            let live = self.live_in(elements, whole);
            let pieces = pieces(revision, stretch, rail(asked), Some(&live));
            let pieces = pieces.ok_or_else(|| Failure::Failed("the file is too large to be drawn".into()))?;
            let operands = elements.operands_in(whole, revision, simulation);
            for piece in pieces {
                after = after.max(piece.range.end());
                let place = |place: TextSize| self.line_map.range_or_near(TextRange::empty(place)).start;
                let block = |range: TextRange| {
                    let named = operands.iter().filter(|operand| operand.block == range);
                    let tags =
                        named.flat_map(|operand| operand.points.iter().map(|point| point.name.clone()));
                    Some((self.line_map.range(range)?, tags.collect()))
                };
                drawing.add(piece, place, block);
            }
        }
        Ok(drawing.done)
    }

    /// How the parts of the drawing in a stretch are.
    fn live_in(&self, elements: &Elements, stretch: TextRange) -> Live {
        let simulation = self.session.simulation();
        let revision = self.line_map.running();
        let mut live = Live::default();
        for element in elements.elements_in(stretch, revision, simulation) {
            if self
                .controller
                .as_ref()
                .is_some_and(|it| it.is_unknown(element.number))
            {
                // Drawn as if nothing ran.
                continue;
            }
            let on = simulation.is_live(element.number);
            live.power.insert(element.range, on);
            if let Some(contact) = element.contact {
                let gate = match contact.state(on, simulation) {
                    Contact::Closed => Gate::Closed,
                    Contact::Open => Gate::Open,
                    Contact::Blocks => Gate::Blocks,
                };
                live.contacts.insert(element.range, gate);
            }
        }
        for operand in elements.operands_in(stretch, revision, simulation) {
            let Some(point) = operand.points.first() else {
                continue;
            };
            let shown = Shown {
                text: operand.index().unwrap_or_default()
                    + &chart::reading(&simulation.value(point), point.ty),
                forced: operand.points.iter().any(|point| simulation.is_forced(point)),
            };
            // Of the tags that an operand names the first stands for it.
            live.values.entry(operand.range).or_insert(shown);
        }
        live
    }
}

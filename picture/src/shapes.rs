//! What a picture consists of: shapes at their places, and which part of the program each of them shows. Every kind
//! of document is written from this.

use super::style::Look;
use std::ops::Range;

/// A place, in pixels from the upper left corner.
pub type At = (i32, i32);

/// A drawn file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Picture {
    /// Its width, in pixels.
    pub width: i32,
    /// Its height.
    pub height: i32,
    /// What is drawn, in this order.
    pub shapes: Vec<Shape>,
    /// The networks, comments and headings from top to bottom.
    pub blocks: Vec<Block>,
    /// The elements of the networks and where they are: what a user points at.
    pub placed: Vec<Placed>,
}

/// A network, or what is between networks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// What it is.
    pub kind: BlockKind,
    /// Its shapes.
    pub shapes: Range<usize>,
    /// Where it begins and ends, from top to bottom.
    pub rows: Range<i32>,
    /// The right end of what it draws.
    pub right: i32,
}

/// What a block of a picture is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum BlockKind {
    /// Comments, line by line.
    Comment(Vec<String>),
    /// The first or last line of a user-defined block.
    Heading,
    /// The place of a section of declarations. Nothing is drawn for it.
    Declarations {
        /// Its index in the file's structure.
        section: usize,
        /// The comment before it is right above it, and so about it.
        noted: bool,
    },
    /// A network by its index, and the line of the file where it begins, from 1. One with an error in its drawing
    /// is shown as text.
    Network {
        /// As in [`Context::networks`](ladder_analysis::context::Context).
        index: usize,
        /// From 1.
        line: usize,
    },
}

/// A part of a network: an index into the parts of a rung of its wiring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Element {
    /// As in [`Context::networks`](ladder_analysis::context::Context).
    pub network: usize,
    /// The rung in it.
    pub rung: usize,
    /// The part of the rung.
    pub part: usize,
}

/// An element and where it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Placed {
    /// Which.
    pub element: Element,
    /// Where its wire comes in, and where it leaves.
    pub columns: (i32, i32),
    /// The height of its wire.
    pub wire: i32,
    /// How far it reaches, from top to bottom.
    pub rows: (i32, i32),
}

/// Something drawn.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shape {
    /// What it looks like.
    pub look: Look,
    /// What it is in the program.
    pub role: Role,
    /// The part of the program that it shows: of a wire between two rungs its `\`.
    pub element: Option<Element>,
    /// In a live drawing the parts whose power it shows: one of them with power is enough.
    pub power: Vec<Element>,
    /// In a live drawing the operand of the element that it names, or whose value belongs here.
    pub operand: Option<usize>,
    /// Its lines or letters.
    pub form: Form,
}

/// What a shape is in the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// A wire, from left to right.
    Wire,
    /// A wire from one rung down to the next.
    Node,
    /// A rail.
    Rail,
    /// A symbol, a comment, a value: anything else.
    Symbol,
}

/// The lines or letters of a shape.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Form {
    /// From one place to another.
    Line(At, At),
    /// Several lines in one go.
    Path(Vec<PathStep>),
    /// A rectangle with slightly rounded corners.
    Rect {
        /// Its upper left corner.
        at: At,
        /// Its width.
        width: i32,
        /// Its height.
        height: i32,
    },
    /// A small disc.
    Dot(At),
    /// A text on one line.
    Text {
        /// A place on its base line.
        at: At,
        /// Where the text is, seen from there.
        anchor: Anchor,
        /// The room that it takes.
        width: i32,
        /// What it says.
        text: String,
    },
}

/// A step of a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PathStep {
    /// Begins here.
    Move(At),
    /// A line to here.
    Line(At),
    /// A bow towards the first place, to the second.
    Bow(At, At),
    /// Back to where it began.
    Close,
}

/// Where a text is, seen from its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// To the right.
    Start,
    /// Around it.
    Middle,
    /// To the left.
    End,
}

/// The rectangle around something: left, top, right, bottom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// Its left end.
    pub left: i32,
    /// Its upper end.
    pub top: i32,
    /// Its right end.
    pub right: i32,
    /// Its lower end.
    pub bottom: i32,
}

impl Shape {
    /// How far it reaches, without the width of its lines.
    pub fn extent(&self) -> Extent {
        let around = |points: &mut dyn Iterator<Item = At>| {
            let mut extent = Extent {
                left: i32::MAX,
                top: i32::MAX,
                right: i32::MIN,
                bottom: i32::MIN,
            };
            for (x, y) in points {
                extent.left = extent.left.min(x);
                extent.right = extent.right.max(x);
                extent.top = extent.top.min(y);
                extent.bottom = extent.bottom.max(y);
            }
            extent
        };
        match &self.form {
            Form::Line(from, to) => around(&mut [*from, *to].into_iter()),
            Form::Path(steps) => around(&mut steps.iter().flat_map(|step| match *step {
                PathStep::Move(at) | PathStep::Line(at) => vec![at],
                PathStep::Bow(by, at) => vec![by, at],
                PathStep::Close => Vec::new(),
            })),
            Form::Rect { at, width, height } => around(&mut [*at, (at.0 + width, at.1 + height)].into_iter()),
            Form::Dot((x, y)) => {
                let dot = super::style::DOT;
                around(&mut [(x - dot, y - dot), (x + dot, y + dot)].into_iter())
            }
            Form::Text {
                at, anchor, width, ..
            } => {
                let left = match anchor {
                    Anchor::Start => at.0,
                    Anchor::Middle => at.0 - width / 2,
                    Anchor::End => at.0 - width,
                };
                around(&mut [(left, at.1 - 12), (left + width, at.1 + 4)].into_iter())
            }
        }
    }
}

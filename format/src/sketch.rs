//! A network as a drawing without columns: what is on its rungs, in which order, and how it is joined.
//!
//! The formatter makes a sketch of every network that it reads; code that makes new networks (an importer, a
//! refactoring) makes one of what it wants drawn. Columns are worked out from the sketch alone.

use std::ops::Range;

/// What an element of a rung is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ElementKind {
    /// The `+` at the left rail.
    LeftRail,
    /// The `+` at the right rail.
    RightRail,
    /// A `|` at the left end of a rung that its wire reaches to. It brings no power.
    LeftBar,
    /// A `|` at the right end of a rung that its wire reaches to.
    RightBar,
    /// A `|` between two wires, or a `+` in the middle of a rung: errors that formatting keeps.
    Stray,
    /// `\`
    Down,
    /// `/`
    Up,
    /// A block that decides about power: a contact, a comparison, a label.
    Condition,
    /// A block that does something: a coil, a timer, an addition.
    Acting,
    /// A comment: a piece of wire if it is joined, else only text between two segments.
    Comment,
    /// Two dashes where a wire ends at nothing: directly next to the element that the wire comes from or leads to.
    Stub,
}

/// One element of a rung.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Element {
    /// What it is.
    pub kind: ElementKind,
    /// Whether wire joins it to the element before it on its rung; if not, blanks are between them.
    pub joined: bool,
    /// Its display width in columns.
    pub width: u32,
    /// The other connector of its pair, or [`NONE`].
    pub(crate) partner: u32,
}

/// No element.
pub(crate) const NONE: u32 = u32::MAX;

/// The rungs of a network. (The formatter keeps the networks of a part of a file in one, one after the other.)
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Sketch {
    pub(crate) elements: Vec<Element>,
    pub(crate) rungs: Vec<Range<u32>>,
}

impl Sketch {
    /// A sketch without rungs.
    pub fn new() -> Sketch {
        Sketch::default()
    }

    /// Begins the next rung, below those that are there. The k-th [`ElementKind::Down`] of a rung pairs with
    /// the k-th [`ElementKind::Up`] of the next.
    pub fn begin_rung(&mut self) {
        let at = self.elements.len() as u32;
        self.rungs.push(at..at);
    }

    /// Puts an element after the others of the last rung.
    pub fn push(&mut self, kind: ElementKind, joined: bool, width: u32) {
        if self.rungs.is_empty() {
            self.begin_rung();
        }
        let is_first = self.rungs.last().is_some_and(Range::is_empty);
        self.elements.push(Element {
            kind,
            joined: joined && !is_first,
            width,
            partner: NONE,
        });
        if let Some(rung) = self.rungs.last_mut() {
            rung.end = self.elements.len() as u32;
        }
    }

    /// The elements of all rungs, from the first rung to the last.
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The rungs, as ranges of [`Sketch::elements`].
    pub fn rungs(&self) -> &[Range<u32>] {
        &self.rungs
    }

    pub(crate) fn rung(&self, rung: usize) -> &[Element] {
        let range = &self.rungs[rung];
        &self.elements[range.start as usize..range.end as usize]
    }

    /// Finds the partners of the connectors on some rungs that follow each other.
    pub(crate) fn pair(&mut self, rungs: Range<usize>) {
        for upper in rungs.start..rungs.end.saturating_sub(1) {
            let (above, below) = (self.rungs[upper].clone(), self.rungs[upper + 1].clone());
            let mut up = below.start;
            for down in above {
                if self.elements[down as usize].kind != ElementKind::Down {
                    continue;
                }
                while up < below.end && self.elements[up as usize].kind != ElementKind::Up {
                    up += 1;
                }
                if up == below.end {
                    break;
                }
                self.elements[down as usize].partner = up;
                self.elements[up as usize].partner = down;
                up += 1;
            }
        }
    }

    /// Forgets everything from a place on.
    pub(crate) fn truncate(&mut self, rungs: usize) {
        let elements = self.rungs.get(rungs).map(|rung| rung.start as usize);
        self.rungs.truncate(rungs);
        if let Some(elements) = elements {
            self.elements.truncate(elements);
        }
    }
}

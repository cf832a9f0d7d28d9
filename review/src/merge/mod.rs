//! Three programs as one: what each of two sides changed of their common base.
//!
//! Entries are merged, not lines. What one side alone changed is as that side has it; what both changed in one entry is a
//! conflict, for which both forms are there between comments, of which ours is read:
//!
//! ```text
//! # <<<<<<< ours #
//! +--[ ]( a )--( )( y )--+
//! # ======= #
//! +--[ ]( b )--( )( y )--+
//! # >>>>>>> theirs #
//! ```
//!
//! What was put together is read again, and is only the result if each entry is in it that should be.

mod conflict;
mod order;
mod renames;
mod writer;

pub use conflict::{Clash, Conflict};

use crate::comparison::verdict;
use crate::outline::{Entry, Kind, Outline};
use crate::verdict::Verdict;
use order::{Slot, slots};
use std::fmt;
use writer::Writer;

/// The three programs.
#[derive(Debug, Clone, Copy)]
pub struct Sides<'o> {
    /// What both began with.
    pub base: &'o Outline,
    /// One side.
    pub ours: &'o Outline,
    /// The other.
    pub theirs: &'o Outline,
}

/// What came of a merge.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Merged {
    /// The text. It is not laid out yet.
    pub text: String,
    /// What both sides changed, from top to bottom.
    pub conflicts: Vec<Conflict>,
    /// New names that one side gave and the other side's part could not take: why.
    pub refused: Vec<String>,
}

/// Why three programs were not merged. Nothing is known then of what the result should be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotMerged {
    /// In one of the texts something is not closed, so that it is not known what is inside of it.
    Unclear {
        /// Which: `base`, `ours`, `theirs`.
        side: &'static str,
        /// What is not closed.
        what: &'static str,
        /// The line where it begins, from 1.
        line: usize,
    },
    /// In one of the texts a conflict of an earlier merge is left.
    Undecided {
        /// Which: `ours`, `theirs`.
        side: &'static str,
        /// The line where it begins, from 1.
        line: usize,
    },
    /// Errors in the texts make something else of the entries when they are next to each other.
    Mixed,
}

impl fmt::Display for NotMerged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotMerged::Unclear { side, what, line } => write!(
                f,
                "{what} in line {line} of {side} is not closed, so it is not known what belongs to it; close it first"
            ),
            NotMerged::Undecided { side, line } => write!(
                f,
                "a merge left a conflict in line {line} of {side}; decide which form holds first"
            ),
            NotMerged::Mixed => f.write_str(
                "errors in the texts join networks of one side to those of the other; fix the connectors first",
            ),
        }
    }
}

impl std::error::Error for NotMerged {}

/// Merges what two sides made of a program.
///
/// # Errors
/// A text is not clear enough to be taken apart into entries.
pub fn merge(sides: Sides<'_>) -> Result<Merged, NotMerged> {
    for (side, outline) in [
        ("base", sides.base),
        ("ours", sides.ours),
        ("theirs", sides.theirs),
    ] {
        check(side, outline)?;
    }
    let carried = renames::carried(sides);
    let sides = Sides {
        base: &carried.base,
        ours: &carried.ours,
        theirs: &carried.theirs,
    };
    let mut merge = Merge {
        sides,
        writer: Writer::new(sides),
    };
    merge.level(&sides.base.entries, &sides.ours.entries, &sides.theirs.entries);
    let merged = merge.writer.finish()?;
    Ok(Merged {
        refused: carried.refused,
        ..merged
    })
}

/// Whether all that is opened in a text is closed, and all that is in question decided.
fn check(side: &'static str, outline: &Outline) -> Result<(), NotMerged> {
    let context = &outline.context;
    let unclear = |what, at| {
        Err(NotMerged::Unclear {
            side,
            what,
            line: context.line_number(at),
        })
    };
    if let Some(place) = context.parse.unclosed_comment() {
        return unclear("the comment", place.start());
    }
    // Of a base with conflicts, which git makes of several bases, ours is what the sides are compared with.
    if let Some(conflict) = context.parse.conflicts().first().filter(|_| side != "base") {
        let line = context.line_number(conflict.signs[0].1.start());
        return Err(NotMerged::Undecided { side, line });
    }
    let frame = context.parse.frame();
    let start = |line| context.parse.line_start(line);
    if let Some(section) = frame.sections.iter().find(|section| !section.closed) {
        return unclear("the section", start(section.lines.start));
    }
    match frame.blocks.iter().find(|block| !block.closed) {
        Some(block) => unclear("the block", start(block.lines.start)),
        None => Ok(()),
    }
}

struct Merge<'o> {
    sides: Sides<'o>,
    writer: Writer<'o>,
}

impl<'o> Merge<'o> {
    fn level(&mut self, base: &'o [Entry], ours: &'o [Entry], theirs: &'o [Entry]) {
        for slot in slots(base, ours, theirs) {
            self.slot(slot);
        }
    }

    fn slot(&mut self, slot: Slot<'o>) {
        let Sides { ours, theirs, .. } = self.sides;
        match (slot.base, slot.ours, slot.theirs) {
            (_, None, None) => {}
            (None, Some(entry), None) => self.whole(ours, entry),
            (None, None, Some(entry)) => self.whole(theirs, entry),
            (None, Some(our), Some(their)) => match verdict(ours, our, theirs, their) {
                Verdict::Edited => self.clash(Clash::BothAdded, Some(our), Some(their)),
                _ if our.kind.holds_others() => self.container(None, Some(our), Some(their)),
                Verdict::Commented => self.clash(Clash::BothAdded, Some(our), Some(their)),
                _ => self.whole(ours, our),
            },
            (Some(was), Some(entry), None) => self.removed(was, Clash::TheirsRemoved, (ours, entry)),
            (Some(was), None, Some(entry)) => self.removed(was, Clash::OursRemoved, (theirs, entry)),
            (Some(was), Some(our), Some(their)) => {
                if was.kind.holds_others() {
                    self.container(Some(was), Some(our), Some(their));
                } else {
                    match self.choice(was, our, their) {
                        Some((outline, entry)) => self.whole(outline, entry),
                        None => self.clash(Clash::BothEdited, Some(our), Some(their)),
                    }
                }
            }
        }
    }

    /// An entry that one side removed. What the other did to it is kept.
    fn removed(&mut self, was: &'o Entry, clash: Clash, (outline, entry): (&'o Outline, &'o Entry)) {
        let base = self.sides.base;
        if is_unchanged(base, was, outline, entry) {
            return;
        }
        let (our, their) = match clash {
            Clash::OursRemoved => (None, Some(entry)),
            _ => (Some(entry), None),
        };
        // Of a section what the other side declared in it is kept, by itself.
        if was.kind == Kind::Section && !says_more(verdict(base, was, outline, entry)) {
            self.container(Some(was), our, their);
        } else {
            self.clash(clash, our, their);
        }
    }

    /// Which form of an entry, or of the first line of one, holds. None: both sides changed it.
    fn choice(&self, was: &Entry, our: &'o Entry, their: &'o Entry) -> Option<(&'o Outline, &'o Entry)> {
        let Sides { base, ours, theirs } = self.sides;
        let (we, they) = (verdict(base, was, ours, our), verdict(base, was, theirs, their));
        if !says_more(they) && (they == Verdict::Same || we != Verdict::Same) {
            return Some((ours, our));
        }
        if !says_more(we) {
            return Some((theirs, their));
        }
        // Both made the same of it.
        let agree = verdict(ours, our, theirs, their);
        (!says_more(agree)).then_some((ours, our))
    }

    /// An entry with all that it holds, as one side has it.
    fn whole(&mut self, outline: &'o Outline, entry: &'o Entry) {
        self.writer.entry(outline, entry);
        for inner in &entry.inside {
            self.whole(outline, inner);
        }
        self.writer.end(outline, entry);
    }

    fn clash(&mut self, clash: Clash, ours: Option<&'o Entry>, theirs: Option<&'o Entry>) {
        self.writer.conflict(clash, ours, theirs);
    }

    /// An entry that holds others.
    fn container(&mut self, was: Option<&'o Entry>, our: Option<&'o Entry>, their: Option<&'o Entry>) {
        let Sides { ours, theirs, .. } = self.sides;
        let inside = |entry: Option<&'o Entry>| entry.map_or(&[][..], |entry| &entry.inside);
        let chosen = match (was, our, their) {
            (Some(was), Some(our), Some(their)) => self.choice(was, our, their),
            (None, Some(our), Some(their)) => (our.comments == their.comments).then_some((ours, our)),
            (_, Some(our), None) => Some((ours, our)),
            (_, None, Some(their)) => Some((theirs, their)),
            (_, None, None) => return,
        };
        let header = match (chosen, our, their) {
            (Some((outline, header)), _, _) => (outline, header),
            // Only their comments differ: those of the other side are written above.
            (None, Some(our), Some(their)) if our.told == their.told => {
                self.writer.comments(their);
                (ours, our)
            }
            (None, our, their) => return self.clash(Clash::BothEdited, our, their),
        };
        self.writer.entry(header.0, header.1);
        self.level(inside(was), inside(our), inside(their));
        self.writer.end(header.0, header.1);
    }
}

/// Whether a form says something that the other does not.
fn says_more(verdict: Verdict) -> bool {
    !matches!(verdict, Verdict::Same | Verdict::Redrawn)
}

/// Whether an entry, and all that it holds, is what it was.
fn is_unchanged(before: &Outline, old: &Entry, after: &Outline, new: &Entry) -> bool {
    if says_more(verdict(before, old, after, new)) || old.inside.len() != new.inside.len() {
        return false;
    }
    let mut inside = old.inside.iter().zip(&new.inside);
    inside.all(|(old, new)| is_unchanged(before, old, after, new))
}

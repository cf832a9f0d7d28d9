//! Why a tag holds what it holds: which block wrote it, in which scan, with which contacts closed, back to what was
//! given from outside; and for what is off, the contacts that block it.
//!
//! Nothing is recorded for this while scans run but which tags have changed at all. The scan in question is restored from
//! the history and run again, until the last write of the tag has been seen.

mod held;
mod inquiry;
mod known;
mod moment;
mod place;
mod question;
mod reasons;
mod target;
#[cfg(test)]
mod tests;
mod text;
mod trace;
mod writers;

use crate::tags::Point;
pub(super) use inquiry::Inquiry;
use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
pub use moment::{Judged, Judgement, Moment};
pub use text::Wording;
pub(super) use writers::Writers;

/// Why a point holds its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Why {
    /// The point.
    pub point: Point,
    /// What it holds.
    pub value: Value,
    /// Since when.
    pub since: Since,
    /// Through what: what happened then.
    pub cause: Cause,
    /// For what is off since an earlier scan: what keeps it off now, if a block still writes it in every scan.
    pub now: Option<Box<Write>>,
}

/// Since when a point holds its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Since {
    /// It has held no other since the start.
    Start,
    /// Since before the kept scans.
    Longer,
    /// Since this scan.
    Scan {
        /// Its number, from 0.
        scan: u64,
        /// Its clock, in nanoseconds.
        time: i64,
    },
}

/// What made a point hold its value.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// Nothing has written it: it has its initial value.
    Initial,
    /// It was given from outside.
    Given,
    /// It is forced.
    Forced,
    /// The simulation itself keeps it: a system tag.
    System,
    /// What wrote it is not known any more: the scan is not kept.
    Unknown,
    /// A block of the program wrote it.
    Block(Box<Write>),
}

/// A block that wrote a tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Write {
    /// The scan in which it did, from 0.
    pub scan: u64,
    /// The block.
    pub block: Location,
    /// The block that called the function in which it is, where several do.
    pub called: Option<Location>,
    /// Whether power reached it.
    pub power: bool,
    /// With power: one list, of the blocks that passed it on, from left to right. Without: each list is one way in
    /// which power would reach the block, by letting it pass all blocks of the list; no list has more than it needs.
    pub reasons: Vec<Vec<Reason>>,
    /// What the indices were of what it wrote: they tell the turns of a loop apart.
    pub indices: Vec<(Point, Value)>,
    /// What it made its result of, where it writes more than its power.
    pub read: Vec<(Point, Value)>,
    /// Why that was so, as far as it was followed.
    pub because: Vec<Why>,
}

/// A block that passes power on, or does not.
#[derive(Debug, Clone, PartialEq)]
pub struct Reason {
    /// The block; for a rail the network.
    pub block: Location,
    /// It is the left rail, which an `<MCR>` has switched off.
    pub is_rail: bool,
    /// What it read, with the values of that moment.
    pub values: Vec<(Point, Value)>,
    /// Why these were so, as far as that was followed.
    pub because: Vec<Why>,
}

//! Unread parts in flat code (LANGUAGE §5.9): nothing of them runs. What each may read and write is here for the prover.

use crate::layout::Home;
use crate::memory::Bit;
use ladder_analysis::program::{Location, TagId};
use std::sync::Arc;

/// An unread part at its place, or one that runs at any time.
#[derive(Debug, Clone)]
pub struct UnreadPlace {
    /// As sentences name it.
    pub name: String,
    /// Where it is, if it has a place.
    pub location: Option<Location>,
    /// What of its text makes it the same as another one.
    pub text: String,
    /// The power that enters it and the power that leaves it, if it has a place.
    pub power: Option<[Bit; 2]>,
    /// What it is given by value.
    pub given: Vec<Home>,
    /// What of its own it may write: the tags of its body, what its outputs are given for, and what states remember besides tags.
    pub own: Vec<Tracked>,
    /// The tags around it that it may write.
    pub writes: Arc<[Tracked]>,
    /// The tags that it may read.
    pub reads: Arc<[Tracked]>,
}

/// Something in memory with a name, by which it is found in another program.
#[derive(Debug, Clone)]
pub struct Tracked {
    /// Its name, at the same place in another program the same.
    pub name: String,
    /// The tag of the program; none of what is not a tag.
    pub tag: Option<TagId>,
    /// Where it is.
    pub home: Home,
}

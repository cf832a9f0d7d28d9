//! What changed between two ladder programs, and merges of such changes.
//!
//! ```text
//! Context --reader---> entries: networks, declarations, types, blocks, settings, each with its comments
//!         --canonical--> what an entry says, without its layout and its comments
//! two outlines --matching--> which entry of the one is which of the other
//!              --comparison--> changes: the same, moved, drawn differently, edited, new, gone
//!                              --drawing--> both rungs, with marks at what changed
//!                                           --report--> for a terminal, a pull request
//! three outlines --merge--> one text, with a conflict where both sides edited the same entry
//! ```
//!
//! Nothing here reads a file. A change is one of what is written; what an edited network does is asked of the prover, in
//! [`meaning`].

mod by_networks;
mod canonical;
pub mod comparison;
pub mod drawing;
mod independence;
mod matching;
pub mod meaning;
pub mod merge;
pub mod outline;
mod reader;
pub mod rename;
pub mod report;
pub mod used;
mod values;
pub mod verdict;
pub mod whole;
pub mod words;

pub use comparison::{Change, Comparison, compare, compare_renamed};
pub use ladder_prover::{Limits, Meaning};
pub use merge::{Merged, NotMerged, Sides, merge};
pub use outline::Outline;
pub use verdict::Verdict;

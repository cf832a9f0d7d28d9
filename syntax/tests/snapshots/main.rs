//! What the parser makes of texts, as snapshots: one file for each concern.

mod accessors;
mod comments;
mod conflicts;
mod declarations;
mod lexing;
mod recovery;
mod show;
mod structure;
mod tree;
mod types;
mod wiring;

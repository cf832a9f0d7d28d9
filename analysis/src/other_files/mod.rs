//! What a file shows to the others of its workspace, what it sees of theirs, and programs of several files.

pub(crate) mod exports;
pub(crate) mod link;
pub(crate) mod others;
pub(crate) mod outward;

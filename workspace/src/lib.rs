//! Ladder files on disk: search, limits, atomic writes.

//! Comparisons and merges of programs.

mod compare;
mod harness;
mod hostile;

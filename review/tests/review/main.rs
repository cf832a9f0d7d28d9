//! Comparisons and merges of programs.

mod broken;
mod compare;
mod harness;
mod hostile;
mod merge;
mod merge_properties;
mod pages;
mod renames;
mod unread;
mod whole;

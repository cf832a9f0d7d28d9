//! What each rule finds, says and mends; one table a case.

mod blocks;
mod check;
mod connectors;
mod follow_ups;
mod mutated;
mod names;
mod pages;
mod pathological;
mod program;
mod several_files;
mod text;
mod wiring;

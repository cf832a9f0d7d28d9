//! What each rule finds, says and fixes; one table a case.

mod blocks;
mod check;
mod connectors;
mod flow;
mod follow_ups;
mod mutated;
mod names;
mod other_drawings;
mod pages;
mod parts;
mod pathological;
mod power;
mod program;
mod several_files;
mod several_files_blocks;
mod several_files_globals;
mod switched_off;
mod tags;
mod text;
mod types;
mod values;
mod wiring;

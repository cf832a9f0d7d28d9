//! The book against the code, and what crosses crates.

mod book_links;
mod book_programs;
mod book_refactorings;
mod click_programs;
mod click_traces;
mod crates;
mod every_feature;
mod fuzz_words;
mod incremental;
mod instruction_reference;
mod iot_traces;
mod ldmicro_fork;
mod ldmicro_traces;
mod notations_back;
mod pictures_wiring;
mod power;
mod refactorings;
mod rename;
mod rooms;
mod rule_index;
mod safe_fixes;
mod scenarios;
mod settings_reference;
mod texts;
mod timing_diagrams;

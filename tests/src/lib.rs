//! Tests that cross the crates.
//!
//! This library is what several of them share: where the project's files are, how the book is read, and the
//! pages of the book that are made from the table of instructions.
//!
//! ```text
//! docs/src/SUMMARY.md --book--> pages: headings, links, programs    checked by tests/project/book_*.rs
//! TABLE --instruction_pages--> docs/src/language/instructions/*.md  compared by tests/project/instruction_reference.rs
//! ladder_analysis::rules::ALL --rule_index--> docs/src/rules/index.md               compared by tests/project/rule_index.rs
//! SECTIONS --settings_reference--> settings.md, the schema, package.json  compared by tests/project/settings_reference.rs
//! client: the language server as a process, for the benches
//! typed_programs: what an edit costs, counted by tests/project/work_of_an_edit.rs and measured by benches/language_server
//! src/**/*.rs --imports--> circles of files that import each other  checked by tests/project/rooms.rs
//! console blocks --console--> what they really show                compared by cli/tests/project/book_sessions.rs
//! ```

pub mod book;
pub mod client;
pub mod console;
pub mod imports;
pub mod instruction_pages;
pub mod instruction_runs;
pub mod markdown;
pub mod project;
pub mod rule_index;
pub mod settings_reference;
pub mod structured_text;
pub mod typed_programs;

pub use ladder_invariants::{features, generator, reference, trace};

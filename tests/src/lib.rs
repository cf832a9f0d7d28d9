//! Tests that cross the crates.
//!
//! This library is what several of them share: where the project's files are, how the book is read, and the
//! pages of the book that are made from the table of instructions.
//!
//! ```text
//! docs/src/SUMMARY.md --book--> pages: headings, links, programs    checked by tests/book_*.rs
//! TABLE --instruction_pages--> docs/src/language/instructions/*.md  compared by tests/instruction_reference.rs
//! Rule::ALL --rule_index--> docs/src/rules/index.md               compared by tests/rule_index.rs
//! SECTIONS --settings_reference--> settings.md, the schema, package.json  compared by tests/settings_reference.rs
//! console blocks --console--> what they really show                compared by tests/book_sessions.rs
//! ```

pub mod book;
pub mod console;
pub mod generator;
pub mod instruction_pages;
pub mod instruction_runs;
pub mod markdown;
pub mod project;
pub mod reference;
pub mod rule_index;
pub mod settings_reference;
pub mod trace;

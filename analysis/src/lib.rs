//! Names, types, the program model and the diagnostics of ladder text.
//!
//! ```text
//! Parse --network--> per network: wiring, blocks bound to the instruction table, order of evaluation
//!       --declare--> the tags of each scope   --uses, infer--> undeclared tags and their types
//!       --resolve--> Program: names resolved, operands typed, elements in the order of evaluation
//!       --rules----> Diagnostics, with fixes as text edits; those about power ask the boolean function of a network
//! ```
//!
//! | room | what is known there |
//! | --- | --- |
//! | `values` | types, literals, values |
//! | `networks` | each network by itself: wiring, blocks, order; and where it is |
//! | `names` | the tags of each scope, their places and types |
//! | `resolve` | what operands mean; the program model |
//! | `boolean` | when power comes through a network |
//! | `findings` | what a finding is, and what comments say about it |
//! | `rules` | what is wrong, one file for each rule |
//! | `checking` | who asks the rules, and keeps what they find, by owner, from one text to the next |
//! | `other_files` | what files show to each other, and programs of several files |
//!
//! A file shows the others of its workspace its [`Exports`], which follow from its text alone; [`Others`] is what it sees of
//! theirs, the blocks of the [`library`] among them, and [`link()`] puts the program together that uses functions and blocks of several files.
//!
//! [`analyze()`] does all of it for one file that is alone, [`analyze_in()`] for one among others. [`Context`](context::Context) is what rules and the editor's features
//! read; [`Program`](program::Program) is what runs. A file with errors has no program.

mod analyze;
pub mod asked;
mod boolean;
mod checking;
pub mod context;
mod cplc_draft;
mod cross_reference;
pub mod findings;
pub mod library;
pub mod names;
pub mod networks;
pub mod other_files;
mod profile;
pub mod program;
mod resolve;
pub mod rules;
mod still_wanted;
pub mod values;

pub use analyze::{
    Analysis, analyze, analyze_after, analyze_context, analyze_in, analyze_while, analyze_with,
};
pub use boolean::formula::{Formulas, formulas};
pub use checking::keep_nearest;
pub use cplc_draft::is_cplc_draft;
pub use cross_reference::{TagEntry, TagKind, TagPlace, cross_reference};
pub use findings::Finding;
pub use findings::article::with_article;
pub use findings::diagnostic::{Applicability, Diagnostic, Fix, Related};
pub use findings::rule::{Rule, RuleGroup, Severity};
pub use findings::rule_settings::{Level, RuleSettings};
pub use names::infer::member as state_member;
pub use networks::access_kind::AccessKind;
pub use other_files::exporting::exports;
pub use other_files::exports::{ExportedBlock, ExportedFunction, Exports, Global};
pub use other_files::import::Import;
pub use other_files::link::{Linked, NotWhole, link, link_files};
pub use other_files::others::{Exported, Others};
pub use resolve::in_class;
pub use still_wanted::BETWEEN;

//! Names, types, the program model and the diagnostics of ladder text.
//!
//! ```text
//! Parse --network--> per network: wiring, blocks bound to the instruction table, order of evaluation
//!       --declare--> the tags of each scope   --uses, infer--> undeclared tags and their types
//!       --resolve--> Program: names resolved, operands typed, elements in the order of evaluation
//!       --rules----> Diagnostics, with fixes as text edits; those about power ask the boolean function of a network
//! ```
//!
//! Each room knows only those above it:
//!
//! | room | what is known there |
//! | --- | --- |
//! | `findings` | what a rule and a finding are |
//! | `values` | types, literals, values |
//! | `program` | the program model |
//! | `written` | operands, types and headers of blocks as they are written |
//! | `other_files` | what files show to each other |
//! | `networks` | each network by itself: wiring, blocks, order; and where it is |
//! | `names` | the tags of each scope, their places and types: the [`Context`](context::Context) |
//! | `exporting` | from a file to what it shows to the others |
//! | `boolean` | when power comes through a network |
//! | `resolve` | what operands mean; from the context to the program model |
//! | `rules` | what is wrong, one file for each rule |
//! | `checking` | the rules are asked, what they find in networks is kept in a memo, and what is shown is chosen |
//!
//! A file shows the others of its workspace its [`Exports`], which follow from its text alone; [`Others`] is what it sees of
//! theirs, the blocks of the [`library`] among them, and [`link()`] puts the program together that uses functions and blocks of several files.
//!
//! [`analyze()`] does all of it for one file, [`context()`] all but asking the rules. The context is what rules and the editor's features
//! read; [`Program`](program::Program) is what runs. A file with errors has no program.

mod analyze;
pub mod asked;
mod boolean;
mod cancel;
mod checking;
mod cplc_draft;
mod cross_reference;
mod exporting;
pub mod findings;
pub mod library;
mod link;
pub mod names;
pub mod networks;
pub mod other_files;
mod plants;
mod profile;
pub mod program;
mod resolve;
pub mod rules;
pub mod values;
pub mod written;

pub use analyze::{Analysis, AnalyzeOptions, analyze, context};
pub use boolean::formula::{Formulas, formulas};
pub use cancel::{BETWEEN, Cancel, CancelOnDrop};
pub use checking::keep_nearest;
pub use cplc_draft::is_cplc_draft;
pub use cross_reference::{TagEntry, TagKind, TagPlace, cross_reference};
pub use exporting::exports;
pub use findings::Finding;
pub use findings::article::with_article;
pub use findings::diagnostic::{Applicability, Diagnostic, Fix, Related};
pub use findings::rule::{Rule, RuleGroup, Severity};
pub use findings::rule_settings::{Level, RuleSettings};
pub use link::{Linked, NotWhole, library_analysis, link, link_files, link_tasks, link_with_plants};
pub use names::context;
pub use names::infer::member as state_member;
pub use networks::access_kind::AccessKind;
pub use other_files::exports::{ExportedBlock, ExportedFunction, Exports, Global};
pub use other_files::others::{Exported, Others};
pub use plants::{Blames, Connect, PlantError, PlantFile};
pub use resolve::in_class;
pub use written::import::Import;

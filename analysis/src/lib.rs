//! Names, types, the program model and the diagnostics of ladder text.
//!
//! ```text
//! Parse --network--> per network: wiring, blocks bound to the instruction table, order of evaluation
//!       --declare--> the tags of each scope   --uses, infer--> undeclared tags and their types
//!       --resolve--> Program: names resolved, operands typed, elements in the order of evaluation
//!       --rules----> Diagnostics, with fixes as text edits; those about power ask the boolean function of a network
//! ```
//!
//! A file shows the others of its workspace its [`Exports`], which follow from its text alone; [`Others`] is what it sees of
//! theirs, and [`link()`] puts the program together that uses functions and blocks of several files.
//!
//! [`analyze()`] does all of it for one file that stands alone, [`analyze_in()`] for one among others. [`Context`](context::Context) is what rules and the editor's features
//! read; [`Program`](program::Program) is what runs. A file with errors has no program.

mod analyze;
mod article;
mod asked;
mod boolean;
mod chunked;
pub mod constant;
pub mod context;
mod control_flow;
mod cplc_draft;
pub mod declaration_fix;
mod declare;
pub mod diagnostic;
mod edited;
mod excerpt;
mod exports;
pub mod facts;
mod findings;
pub mod fix;
mod foreign_comment;
mod infer;
#[cfg(test)]
mod infer_tests;
mod kept;
mod known_blocks;
mod link;
mod lint;
pub mod literal;
pub mod network;
pub mod networks;
mod operand_value;
pub mod order;
#[cfg(test)]
mod order_tests;
mod others;
mod outward;
mod profile;
pub mod program;
mod resolve;
pub mod rule;
pub mod rule_settings;
mod rules;
pub mod scope;
mod shared;
mod stamp;
pub mod system_tag;
pub mod tags;
pub mod types;
pub mod user_block;
mod uses;
pub mod value;
mod verdict;

pub use analyze::{Analysis, analyze, analyze_after, analyze_context, analyze_in, analyze_with};
pub use article::with_article;
pub use boolean::formula::{Formulas, formulas};
pub use cplc_draft::is_cplc_draft;
pub use diagnostic::{Applicability, Diagnostic, Fix, Related};
pub use exports::{ExportedBlock, ExportedFunction, Exports, Global, exports};
pub use findings::{Finding, Work};
pub use infer::member as state_member;
pub use link::{NotWhole, link};
pub use others::{Exported, Import, Others};
pub use resolve::{in_class, is_function as is_expression_function};
pub use rule::{Rule, RuleGroup, Severity};
pub use rule_settings::{Level, RuleSettings};
pub use rules::cplc_draft::is_told as says_cplc_draft;

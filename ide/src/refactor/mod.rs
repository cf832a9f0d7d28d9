//! Code actions: fixes of findings, and changes of a drawing that a person would draw by hand.
//!
//! ```text
//! analysis, range --Place--> what is selected --one file each--> Action: title, kind, raw edits
//!                                                                  --aligned--> edits that leave the drawing straight
//! ```
//!
//! An action's edits are raw: small, or a network's text with its columns anyhow. [`Action::aligned`] has the formatter
//! draw what they touch, which reads the whole file; it is done for the one action that is wanted. Every action keeps what
//! the program does, or says in its title that it does not.

mod allow;
mod declare_tags;
pub(crate) mod declared;
mod extract_block;
mod extract_function;
mod extract_structure;
mod fixes;
pub(crate) mod flow;
mod inline_block;
mod inline_function;
mod inline_structure;
pub(crate) mod insert_branch;
mod latch;
mod named_state;
pub(crate) mod names;
pub(crate) mod place;
mod remove_branch;
mod scenarios;
pub(crate) mod split_network;
mod suggestions;
pub(crate) mod toggle;
mod wrap_branch;

pub use fixes::{fix_all, quick_fixes};

use crate::neighbour::Workspace;
use crate::rename::Renamed;
use ladder_analysis::findings::fix;
use ladder_analysis::{Analysis, Applicability, Fix};
use ladder_format::{Edit, Options};
use ladder_syntax::TextRange;
use place::Selected;
use scenarios::InScenarios;
use std::sync::Arc;

/// What an action is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ActionKind {
    /// It fixes one finding.
    QuickFix,
    /// It fixes all that can be fixed safely.
    FixAll,
    /// It makes a function or block of a part.
    Extract,
    /// It puts what a function or block does in the place of its call.
    Inline,
    /// It draws a part in another way.
    Rewrite,
}

/// What an action does to the text.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Work {
    /// Edits, sorted and disjoint.
    Edits(Vec<Edit>),
    /// The safe fixes of all findings. They are gathered when they are wanted: a file may have many.
    SafeFixes,
    /// Declarations of all undeclared tags of a scope, likewise.
    Declarations(usize),
}

/// Something that can be done with a part of a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Action {
    /// What it does, for a menu.
    pub title: String,
    /// What it is for.
    pub kind: ActionKind,
    work: Work,
    scenarios: InScenarios,
    /// Why it cannot be done here, though it looks as if it could.
    pub disabled: Option<String>,
    /// The finding that it fixes, as an index into the analysis' diagnostics.
    pub finding: Option<usize>,
    /// A name that it makes up, for which a person will want another one.
    pub made_up: Option<String>,
    /// It is the best of those that fix the finding, and safe.
    pub preferred: bool,
}

impl Action {
    pub(crate) fn new(kind: ActionKind, title: impl Into<String>, mut edits: Vec<Edit>) -> Action {
        // What is put in at a place comes before what replaces the text after it.
        edits.sort_by_key(|edit| (edit.range.start(), edit.range.end()));
        Action {
            work: Work::Edits(edits),
            ..Action::later(kind, title, Work::SafeFixes)
        }
    }

    /// The edits of one whose edits are known, before the drawing is put straight.
    pub(crate) fn own_edits(&self) -> &[Edit] {
        match &self.work {
            Work::Edits(edits) => edits,
            Work::SafeFixes | Work::Declarations(_) => &[],
        }
    }

    fn later(kind: ActionKind, title: impl Into<String>, work: Work) -> Action {
        Action {
            title: title.into(),
            kind,
            work,
            scenarios: InScenarios::Nothing,
            disabled: None,
            finding: None,
            made_up: None,
            preferred: false,
        }
    }

    /// The same action, which changes what scenarios name.
    fn in_scenarios(self, scenarios: InScenarios) -> Action {
        Action { scenarios, ..self }
    }

    /// The same action, which makes up a name.
    fn making_up(self, name: String) -> Action {
        Action {
            made_up: Some(name),
            ..self
        }
    }

    pub(crate) fn disabled(kind: ActionKind, title: impl Into<String>, why: impl Into<String>) -> Action {
        Action {
            disabled: Some(why.into()),
            ..Action::new(kind, title, Vec::new())
        }
    }

    /// The edits, sorted and disjoint, before the drawing is put straight.
    pub fn edits(&self, analysis: &Analysis) -> Vec<Edit> {
        match &self.work {
            Work::Edits(edits) => edits.clone(),
            Work::SafeFixes => fixes::safe_fixes(analysis.diagnostics()),
            Work::Declarations(scope) => declare_tags::edits(&analysis.context, *scope),
        }
    }

    /// The edits of the text that was analysed, with the drawing around them put straight: sorted, none touching another,
    /// none where nothing changes.
    pub fn aligned(&self, analysis: &Analysis, text: &str, options: &Options) -> Vec<Edit> {
        let fix = Fix::new(Applicability::Safe, "", self.edits(analysis));
        fix::aligned(text, &fix, options)
    }

    /// The same edits, and those of all files of scenarios, where the action changes what they name.
    pub fn everywhere(
        &self,
        analysis: &Analysis,
        text: &str,
        options: &Options,
        workspace: &dyn Workspace,
    ) -> Vec<Renamed> {
        let context = &analysis.context;
        let own = Renamed {
            file: Arc::clone(&context.name),
            edits: self.aligned(analysis, text, options),
        };
        let mut files = vec![own];
        files.extend(self.scenarios.edits(context, workspace));
        files
    }
}

/// The refactorings that are offered for a selection, or a cursor where it is empty.
pub fn refactorings(analysis: &Analysis, range: TextRange) -> Vec<Action> {
    let mut actions = Vec::new();
    let place = Selected::find(analysis, range);
    for offer in [
        toggle::offer,
        insert_branch::offer,
        wrap_branch::offer,
        remove_branch::offer,
        split_network::offer,
        latch::offer_seal_in,
        latch::offer_set_and_reset,
        declare_tags::offer,
        extract_function::offer,
        extract_block::offer,
        extract_structure::offer,
        inline_function::offer,
        inline_block::offer,
        inline_structure::offer,
        named_state::offer,
    ] {
        offer(&place, &mut actions);
    }
    actions
}

#[cfg(test)]
mod tests;

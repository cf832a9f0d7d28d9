//! Looking for what is wrong in a file, and keeping what is found from one text to the next.
//!
//! ```text
//! Context --ledger--> findings by owner: a network, a tag, the file; each looked for where something changed
//!         --shown---> those that are shown, with their severities, in the order of their places: a list of Finding
//! ```

mod addresses;
mod allowed;
mod at_tags;
mod dependencies;
mod latches;
mod ledger;
mod of_bodies;
mod of_program;
mod part_notes;
mod read_above;
mod shelf;
mod shown;
mod undeclared;
mod unused_allows;

pub(crate) use ledger::Ledger;
pub use ledger::Work;
pub(crate) use shown::Shown;
pub use shown::keep_nearest;

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::findings::Finding;
use crate::mistakes;
use crate::rule_settings::RuleSettings;
use crate::still_wanted::StillWanted;

/// What is found in a text.
#[derive(Debug)]
pub(crate) struct Found {
    pub(crate) shown: Shown,
    /// Errors that settings or comments hide, or count as less, beside those that [`Shown`] keeps.
    pub(crate) hidden_errors: Vec<Diagnostic>,
    /// What was looked at for it.
    pub(crate) work: Work,
    /// To be handed on to the next text.
    pub(crate) ledger: Ledger,
}

/// Looks for what is wrong in a file. `before` is what was found in an earlier text of it. None if that is not wanted any
/// longer.
pub(crate) fn find(
    before: Option<Ledger>,
    context: &Context,
    settings: &RuleSettings,
    wanted: &StillWanted<'_>,
) -> Option<Found> {
    let (mut ledger, of_file) = Ledger::look(before, context, settings, wanted)?;
    let (mut shown, hidden_errors, looked_at) = shown::shown(context, &mut ledger, of_file, settings);
    if let Some(block) = ledger.unresolved(context)
        && hidden_errors.is_empty()
        && !shown.hides_errors()
        && !shown.has_errors()
    {
        shown.add(Finding::from(mistakes::bad_operand::meaningless(block)));
    }
    let work = ledger.work();
    Some(Found {
        shown,
        hidden_errors,
        work: Work {
            findings: looked_at.findings,
            comments: work.comments + looked_at.comments,
            ..work
        },
        ledger,
    })
}

//! Looking for what is wrong in a file.
//!
//! ```text
//! Context --networks--> what the rules about networks find; of a network that is as it was that is in the memo
//!         --tags------> what the rules about tags find
//!         --rules-----> what the rules about the file and the program find
//!         --shown-----> those that are shown, with their severities, in the order of their places
//! ```

mod comments;
mod memo;
mod networks;
mod shown;
mod stamp;
mod tags;

pub(crate) use memo::Memo;
pub use shown::keep_nearest;

use crate::cancel::Cancel;
use crate::findings::Finding;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Known, Severity};
use crate::findings::rule_settings::RuleSettings;
use crate::names::context::Context;
use crate::networks::NetworkAt;
use crate::networks::control_flow::ControlFlow;
use crate::rules::survey::Survey;
use crate::rules::{self, Checks};
use comments::Allows;
use networks::InNetworks;

/// What is found in a text.
#[derive(Debug)]
pub(crate) struct Found {
    /// In the order of the places.
    pub(crate) shown: Vec<Finding>,
    /// Errors that settings or comments hide, or count as less.
    pub(crate) hidden_errors: Vec<Diagnostic>,
    /// For the next text.
    pub(crate) memo: Memo,
}

/// Looks for what is wrong in a file. `memo` is from an earlier text of it: what comes out is the same with any other. None if
/// that is cancelled.
pub(crate) fn find(
    memo: &Memo,
    context: &Context,
    settings: &RuleSettings,
    cancel: &Cancel,
) -> Option<Found> {
    let networks = context.networks.iter();
    let any = networks.fold(ControlFlow::default(), |any, network| {
        any.with(network.control_flow)
    });
    let checks = Checks::new(settings);
    let mut in_networks = InNetworks::check(memo, &checks, context, settings, cancel)?;
    let mut names = Vec::new();
    rules::of_names(context, &mut names);
    let mut of_tags = tags::check(&checks, context, any, cancel)?;
    let mut of_comments = Vec::new();
    let mut allows = Allows::of(context, &mut of_comments);
    of_tags.retain(|found| !found.rule.runs_if_allowed() || !allows.hide(found.rule, found.range.start()));
    let mut file = Vec::new();
    checks.file(context, &mut file);

    let has_error = |found: &Diagnostic| found.severity == Severity::Error;
    let elsewhere = names
        .iter()
        .chain(&of_tags)
        .chain(&file)
        .filter(|found| has_error(found));
    let mut unsound = in_networks.faulty.clone();
    let mut is_sound = true;
    for found in elsewhere {
        is_sound = false;
        if let Some(network) = network_at(context, found) {
            unsound[network.index] = true;
        }
    }
    let is_unclear = |network: NetworkAt<'_>| network.broken || !network.known;
    let known = Known {
        whole: is_sound
            && !in_networks.faulty.contains(&true)
            && !context.networks.iter().any(is_unclear)
            && !has_syntax_errors(context),
        names: !of_tags
            .iter()
            .any(|found| found.rule == rules::undeclared_tag::RULE),
    };
    let survey = Survey {
        whole: known.whole,
        any,
        context,
        unsound: &unsound,
    };
    in_networks.check_power(context, &survey, cancel)?;
    let mut program = Vec::new();
    checks.program(&survey, &mut program);

    // Of two findings of one rule at one place the first counts: what is found while types are inferred comes before what
    // follows from it.
    let findings = |found: Vec<Diagnostic>| found.into_iter().map(Finding::from);
    let (types, tags): (Vec<_>, Vec<_>) = of_tags
        .into_iter()
        .partition(|found| found.rule == rules::type_mismatch::RULE);
    let mut all: Vec<Finding> = findings(names).chain(findings(types)).collect();
    all.append(&mut in_networks.found);
    all.extend(findings(file).chain(findings(tags)).chain(findings(program)));
    all.retain(|found| found.rule.when().holds(known));
    let (mut shown, hidden_errors) = shown::shown(context, all, known, settings, (allows, of_comments));
    let has_errors = shown.iter().any(|found| found.severity == Severity::Error);
    if let Some(block) = in_networks.unresolved
        && hidden_errors.is_empty()
        && !has_errors
    {
        shown.push(Finding::from(rules::bad_operand::meaningless(block)));
    }
    Some(Found {
        shown,
        hidden_errors,
        memo: in_networks.memo,
    })
}

/// The network in which a finding begins.
fn network_at<'c>(context: &'c Context, found: &Diagnostic) -> Option<NetworkAt<'c>> {
    let at = found.range.start();
    let after = context
        .networks
        .partition_point(|network| network.range.start() <= at);
    let network = context.networks.at(after.checked_sub(1)?);
    (at < network.range.end()).then_some(network)
}

fn has_syntax_errors(context: &Context) -> bool {
    let lines = context.parse.lines();
    lines
        .of_parts_that(ladder_syntax::Part::is_faulty)
        .any(|(_, line)| !line.errors.is_empty())
}

//! What is found in networks one by one.

use super::memo::{FoundInNetwork, Group, Memo};
use crate::cancel::Cancel;
use crate::checking::stamp;
use crate::findings::Finding;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Severity;
use crate::findings::rule_settings::RuleSettings;
use crate::names::context::Context;
use crate::networks::NetworkAt;
use crate::resolve;
use crate::rules::survey::Survey;
use crate::rules::{self, Checks, MOST_FINDINGS};
use ladder_syntax::TextRange;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// What is found in the networks of a file.
pub(super) struct InNetworks<'m> {
    before: &'m Memo,
    rules: &'m Checks,
    pub(super) memo: Memo,
    pub(super) found: Vec<Finding>,
    /// For each network whether an error is found in it.
    pub(super) faulty: Vec<bool>,
    /// The first block that could not be resolved whole.
    pub(super) unresolved: Option<TextRange>,
    /// For each network the number that stands for its tags and for all else of the file that the rules see of it; none where
    /// nothing is kept.
    keys: Vec<Option<u64>>,
}

impl<'m> InNetworks<'m> {
    /// Asks the rules about drawings, blocks and types. None if that is cancelled.
    pub(super) fn check(
        before: &'m Memo,
        rules: &'m Checks,
        context: &Context,
        settings: &RuleSettings,
        cancel: &Cancel,
    ) -> Option<InNetworks<'m>> {
        let count = context.networks.len();
        let of_settings = of_settings(context, settings);
        let mut all = InNetworks {
            before,
            rules,
            memo: Memo::with_capacity(count),
            found: Vec::new(),
            faulty: vec![false; count],
            unresolved: None,
            keys: Vec::with_capacity(count),
        };
        for network in &context.networks {
            cancel.one_more()?;
            let key = key(context, network, of_settings);
            all.keys.push(key);
            let mut unresolved = None;
            let known = all.found.len();
            all.ask(context, network, Group::Form, key, |rules, out| {
                unresolved = resolve::check(context, network.index, out);
                rules.form(context, network, settings, out);
                unresolved.is_none()
            });
            let mut found = all.found[known..].iter();
            all.faulty[network.index] = found.any(|found| found.severity == Severity::Error);
            all.unresolved = all.unresolved.or(unresolved);
            if all.found.len() >= MOST_FINDINGS {
                all.say_enough();
                break;
            }
        }
        Some(all)
    }

    /// Asks the rules about the power in networks. None if that is cancelled.
    pub(super) fn check_power(
        &mut self,
        context: &Context,
        survey: &Survey<'_>,
        cancel: &Cancel,
    ) -> Option<()> {
        for index in 0..self.keys.len() {
            cancel.one_more()?;
            let network = context.networks.at(index);
            if !survey.is_sound(network) {
                continue;
            }
            let key =
                self.keys[index].map(|key| key.wrapping_mul(2) | u64::from(survey.rail_varies(network)));
            self.ask(context, network, Group::Power, key, |rules, out| {
                rules.power(survey, network, out);
                true
            });
        }
        Some(())
    }

    /// Recalls what a group of rules finds in a network, or looks for it. `look` answers whether that may be kept.
    fn ask(
        &mut self,
        context: &Context,
        network: NetworkAt<'_>,
        group: Group,
        key: Option<u64>,
        look: impl FnOnce(&Checks, &mut Vec<Diagnostic>) -> bool,
    ) {
        let facts = context.networks.facts(network.index);
        let start = network.range.start();
        if let Some(key) = key
            && let Some(known) = self.before.recall(facts, group, key)
        {
            self.found
                .extend(known.iter().map(|found| Finding::new(found, start)));
            self.memo.keep(facts, group, key, Arc::clone(known));
            return;
        }
        let mut out = Vec::new();
        let may_keep = look(self.rules, &mut out);
        // What names places elsewhere is true for this text only.
        let Some(key) = key.filter(|_| may_keep && out.iter().all(|found| found.lies_in(network.range)))
        else {
            self.found.extend(out.into_iter().map(Finding::from));
            return;
        };
        let counted = out.into_iter().map(|mut found| {
            found.move_by(-i64::from(u32::from(start)));
            Arc::new(found.finished())
        });
        let counted: FoundInNetwork = counted.collect();
        self.found
            .extend(counted.iter().map(|found| Finding::new(found, start)));
        self.memo.keep(facts, group, key, counted);
    }

    fn say_enough(&mut self) {
        if let Some(last) = self.found.last_mut() {
            let mut found = last.diagnostic();
            rules::say_enough(&mut found);
            *last = Finding::from(found);
        }
    }
}

/// Stands for all that the rules see of a network besides its own lines. None if other networks or files have a say.
fn key(context: &Context, network: NetworkAt<'_>, of_settings: u64) -> Option<u64> {
    if network.broken || !network.names_tags_only {
        return None;
    }
    let mut hasher = FxHasher::default();
    (stamp::of_network(context, network), of_settings).hash(&mut hasher);
    Some(hasher.finish())
}

/// Stands for the settings that decide about what is found in networks.
fn of_settings(context: &Context, settings: &RuleSettings) -> u64 {
    let mut hasher = FxHasher::default();
    let switched_on = rules::ALL
        .iter()
        .filter(|rule| !rule.on_by_default() && settings.is_on(**rule));
    switched_on.for_each(|rule| rule.name().hash(&mut hasher));
    (settings.scan_interval, context.cycle).hash(&mut hasher);
    hasher.finish()
}

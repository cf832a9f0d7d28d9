//! What is found in networks one by one: the types of their operands, their form, their blocks, and what power does in them.

use super::Ledger;
use crate::context::Context;
use crate::control_flow::ControlFlow;
use crate::findings::Anchored;
use crate::networks::NetworkAt;
use crate::reading::TOGETHER;
use crate::rule::{Rule, Severity};
use crate::rules::{self, MOST_FINDINGS, survey};
use crate::still_wanted::StillWanted;
use crate::verdict::{InNetwork, Pass};
use crate::{resolve, stamp};
use rustc_hash::FxHashSet;
use std::sync::Arc;

impl Ledger {
    /// Looks at what is in networks, at all of it while a network is at hand. What power does in one that is without an error
    /// as far as can be seen is looked at, too: an error that shows later is rare.
    pub(super) fn in_networks(
        &mut self,
        context: &Context,
        networks: &[usize],
        wanted: &StillWanted<'_>,
    ) -> Option<()> {
        for together in networks.chunks(TOGETHER) {
            if self.is_full_at(together[0]) {
                break;
            }
            for &index in together {
                wanted.one_more()?;
                self.types(context, index);
            }
            let with_id = |&index: &usize| (context.networks.at(index), context.networks.id(index));
            let together = together.iter().map(with_id);
            let mut looked_at = 0;
            for (network, id) in together.clone() {
                if self.is_full_at(network.index) {
                    break;
                }
                looked_at += 1;
                let form = rules::of_network(context, network);
                if has_error(&form) {
                    self.faulty.insert(id);
                }
                self.set(id, Pass::Form, form);
            }
            let together = together.take(looked_at);
            for (network, id) in together.clone() {
                let stamp = self.networks[id as usize].stamp;
                let blocks = survey::of_network(context, network, stamp, &self.settings);
                self.set(id, Pass::Blocks, blocks);
            }
            for (network, id) in together {
                if self.faulty.contains(&id) {
                    self.unsound.insert(id);
                }
                self.power(context, network, self.networks[id as usize].stamp);
            }
        }
        Some(())
    }

    /// Whether so much is found already that nothing is looked for from this network on.
    fn is_full_at(&mut self, index: usize) -> bool {
        if self.count >= MOST_FINDINGS {
            self.full_from.get_or_insert(index);
        }
        self.full_from.is_some()
    }

    /// Looks at the types of a network's operands.
    fn types(&mut self, context: &Context, index: usize) {
        let network = context.networks.at(index);
        let id = context.networks.id(index);
        let stamp = stamp::of_network(context, network);
        self.networks[id as usize].stamp = stamp;
        note(&mut self.unclear, id, network.broken || !network.known);
        note(&mut self.volatile, id, network.broken);
        let (types, unresolved) = resolve::check_network(context, network, stamp);
        match unresolved {
            Some(block) => self.unresolved.insert(id, block - network.range.start()),
            None => self.unresolved.remove(&id),
        };
        let is_member = |found: &Arc<Anchored>| found.rule() == Rule::UnknownMember;
        note(&mut self.unknown_members, id, types.iter().any(is_member));
        note(&mut self.faulty, id, has_error(&types));
        self.set(id, Pass::Types, types);
    }

    /// Looks at what power does in a network.
    fn power(&mut self, context: &Context, network: NetworkAt<'_>, stamp: u64) {
        let id = context.networks.id(network.index);
        let survey = self.survey(context, false);
        let wiring = rules::wiring_walk::check(context, &survey, network, stamp);
        let power = rules::power_rules::check(context, &survey, network, stamp, &wiring);
        self.set(id, Pass::Wiring, wiring);
        self.set(id, Pass::Power, power);
    }

    /// Looks once more at what power does in the networks of which it is new whether there is an error; in all of them if it
    /// is new whether a rail may be dead.
    pub(super) fn power_again(
        &mut self,
        context: &Context,
        toggled: Vec<usize>,
        wanted: &StillWanted<'_>,
    ) -> Option<()> {
        let rail_varies = self.any.has(ControlFlow::MCR);
        let is_new = self.rail_varies.replace(rail_varies) == Some(!rail_varies);
        let mut again = toggled;
        if is_new {
            again = (0..context.networks.len()).collect();
        }
        self.work.networks += again.len();
        let end = self.full_from.unwrap_or(usize::MAX);
        for index in again.into_iter().filter(|&index| index < end) {
            wanted.one_more()?;
            let network = context.networks.at(index);
            let stamp = self.networks[context.networks.id(index) as usize].stamp;
            self.power(context, network, stamp);
        }
        Some(())
    }
}

fn has_error(found: &InNetwork) -> bool {
    found.iter().any(|found| found.severity() == Severity::Error)
}

fn note(numbers: &mut FxHashSet<u32>, id: u32, is_it: bool) {
    if is_it {
        numbers.insert(id);
    } else {
        numbers.remove(&id);
    }
}

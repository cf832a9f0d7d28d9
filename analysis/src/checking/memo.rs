//! What the rules about networks found in an earlier text, by what they were shown of each network.
//!
//! A memo: without it all comes out the same, later. Its key is the network's own facts, which are read again whenever one of its
//! lines changes, and a number that stands for all else that the rules see of it.

use crate::findings::diagnostic::Diagnostic;
use crate::networks::network::NetworkFacts;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What is found in a network, with places that count from its start.
pub(crate) type FoundInNetwork = Arc<[Arc<Diagnostic>]>;

/// What was found in the networks of a text.
#[derive(Debug, Clone, Default)]
pub(crate) struct Memo(FxHashMap<usize, Kept>);

#[derive(Debug, Clone)]
struct Kept {
    /// As long as they are kept no others have their address.
    facts: Arc<NetworkFacts>,
    form: Option<(u64, FoundInNetwork)>,
    power: Option<(u64, FoundInNetwork)>,
}

/// Which rules about a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    /// Those about its drawing, its blocks and the types of their operands.
    Form,
    /// Those about its power, which is asked for where all else is in order.
    Power,
}

impl Memo {
    /// Room for so many networks.
    pub(super) fn with_capacity(networks: usize) -> Memo {
        Memo(FxHashMap::with_capacity_and_hasher(
            networks,
            rustc_hash::FxBuildHasher,
        ))
    }

    /// What a group of rules found when it was shown the same of a network.
    pub(super) fn recall(
        &self,
        facts: &Arc<NetworkFacts>,
        group: Group,
        key: u64,
    ) -> Option<&FoundInNetwork> {
        let kept = self.0.get(&address(facts))?;
        let found = match group {
            Group::Form => &kept.form,
            Group::Power => &kept.power,
        };
        found
            .as_ref()
            .filter(|(known, _)| *known == key)
            .map(|(_, found)| found)
    }

    /// Keeps what a group of rules found in a network.
    pub(super) fn keep(&mut self, facts: &Arc<NetworkFacts>, group: Group, key: u64, found: FoundInNetwork) {
        let kept = self.0.entry(address(facts)).or_insert_with(|| Kept {
            facts: Arc::clone(facts),
            form: None,
            power: None,
        });
        debug_assert!(Arc::ptr_eq(&kept.facts, facts));
        match group {
            Group::Form => kept.form = Some((key, found)),
            Group::Power => kept.power = Some((key, found)),
        }
    }
}

fn address(facts: &Arc<NetworkFacts>) -> usize {
    Arc::as_ptr(facts).addr()
}

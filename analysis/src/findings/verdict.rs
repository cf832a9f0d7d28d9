//! What was found in a network, kept with it from one text to the next.
//!
//! A pass over networks asks here first. Its key says what else than the network's own lines decides about its
//! findings: the types of its tags, whether its rail may be dead. With another key the network is looked at again. Nothing
//! here is ever needed, it only saves looking.

use crate::diagnostic::Diagnostic;
use crate::findings::Anchored;
use crate::networks::NetworkAt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The passes whose findings are kept.
/// In the order in which their findings count.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Pass {
    /// The types of the operands.
    Types,
    /// The drawing and the form of the blocks.
    Form,
    /// Blocks one by one.
    Blocks,
    /// What is behind what on a wire.
    Wiring,
    /// When its wires have power.
    Power,
}

const PASSES: usize = Pass::Power as usize + 1;

/// Findings in a network.
pub(crate) type InNetwork = Vec<Arc<Anchored>>;

/// What passes have found in a network. In most networks that is nothing, and takes one word.
#[derive(Debug, Clone, Default)]
pub(crate) struct ByPass(Option<Arc<Found>>);

/// In the order of the passes.
#[derive(Debug)]
struct Found(Box<[(Pass, Arc<Anchored>)]>);

impl ByPass {
    fn list(&self) -> &[(Pass, Arc<Anchored>)] {
        self.0.as_ref().map_or(&[], |found| &found.0)
    }

    /// All of it.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        self.list().iter().map(|(_, found)| found)
    }

    /// How much that is.
    pub(crate) fn len(&self) -> usize {
        self.list().len()
    }

    /// What one pass has found.
    fn of(&self, pass: Pass) -> impl Iterator<Item = &Arc<Anchored>> {
        let all = self.list().iter();
        all.filter_map(move |(by, found)| (*by == pass).then_some(found))
    }

    /// Exchanges what one pass has found.
    pub(crate) fn set(&mut self, pass: Pass, found: &[Arc<Anchored>]) {
        if found.is_empty() && self.of(pass).next().is_none() {
            return;
        }
        let mut all = self.list().to_vec();
        let first = all.partition_point(|(by, _)| *by < pass);
        let end = all.partition_point(|(by, _)| *by <= pass);
        all.splice(first..end, found.iter().map(|found| (pass, Arc::clone(found))));
        self.0 = (!all.is_empty()).then(|| Arc::new(Found(all.into())));
    }

    /// Shares the list with another that holds the same findings.
    fn share(&mut self, other: &ByPass) {
        let (own, others) = (self.list(), other.list());
        let mut both = own.iter().zip(others);
        let is_same =
            |((by, found), (other_by, other)): (&_, &_)| by == other_by && Arc::ptr_eq(found, other);
        if own.len() == others.len() && both.all(is_same) {
            self.0.clone_from(&other.0);
        }
    }
}

/// What each pass found when it looked last.
#[derive(Debug, Default)]
pub(crate) struct Verdict {
    /// With which key each pass looked. 0: it has not.
    keys: [AtomicU64; PASSES],
    found: Mutex<ByPass>,
}

impl Verdict {
    /// What a pass has found with this key, if it has looked with it. The key is never 0.
    fn recall(&self, pass: Pass, key: u64) -> Option<InNetwork> {
        let kept = &self.keys[pass as usize];
        if kept.load(Ordering::Acquire) != key {
            return None;
        }
        let found = self.found();
        // Another text's analysis may have looked meanwhile.
        if kept.load(Ordering::Acquire) != key {
            return None;
        }
        Some(found.of(pass).cloned().collect())
    }

    /// Keeps what a pass has found with a key, unless it names places outside of the network.
    fn keep(&self, pass: Pass, key: u64, found: &[Arc<Anchored>]) {
        if found.iter().any(|found| found.is_volatile()) {
            return;
        }
        self.found().set(pass, found);
        self.keys[pass as usize].store(key, Ordering::Release);
    }

    /// Keeps one list for both, where another holds the same findings.
    pub(crate) fn share(&self, other: &ByPass) {
        self.found().share(other);
    }

    /// What is kept stays whole: it is changed in one step.
    fn found(&self) -> MutexGuard<'_, ByPass> {
        self.found.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for Verdict {
    fn clone(&self) -> Verdict {
        let found = self.found();
        Verdict {
            keys: std::array::from_fn(|pass| AtomicU64::new(self.keys[pass].load(Ordering::Acquire))),
            found: Mutex::new(found.clone()),
        }
    }
}

/// What a pass finds in a network: what is kept if it has looked with this key before, else what `look` finds now.
/// Without a key nothing is kept, nor if `look` answers no.
pub(crate) fn once(
    pass: Pass,
    key: Option<u64>,
    network: NetworkAt<'_>,
    look: impl FnOnce(&mut Vec<Diagnostic>) -> bool,
) -> InNetwork {
    let key = key.map(|key| key | 1);
    if let Some(found) = key.and_then(|key| network.verdict.recall(pass, key)) {
        return found;
    }
    let mut found = Vec::new();
    let may_keep = look(&mut found);
    // To collect them would keep the room that they had as findings.
    let mut anchored = InNetwork::with_capacity(found.len());
    for found in found {
        anchored.push(Arc::new(Anchored::at_network(found, network)));
    }
    if let Some(key) = key.filter(|_| may_keep) {
        network.verdict.keep(pass, key, &anchored);
    }
    anchored
}

#[cfg(test)]
mod tests {
    use super::{ByPass, Pass};
    use crate::diagnostic::Diagnostic;
    use crate::findings::Anchored;
    use crate::rule::Rule;
    use ladder_syntax::TextRange;
    use std::sync::Arc;

    #[test]
    fn what_a_pass_has_found_is_exchanged_in_its_place() {
        let found = |message: &str| {
            let found = Diagnostic::new(Rule::NoOutput, TextRange::default(), message);
            Arc::new(Anchored::in_file(found))
        };
        let of = |kept: &ByPass, pass| kept.of(pass).cloned().collect::<Vec<_>>();
        let mut kept = ByPass::default();
        kept.set(Pass::Power, &[]);
        assert!(kept.0.is_none(), "nothing takes no room");
        let (first, second, third) = (found("first"), found("second"), found("third"));
        kept.set(Pass::Power, &[Arc::clone(&third)]);
        kept.set(Pass::Types, &[Arc::clone(&first)]);
        kept.set(Pass::Wiring, &[Arc::clone(&second), Arc::clone(&second)]);
        let all: Vec<_> = kept.iter().cloned().collect();
        assert_eq!(all, [&first, &second, &second, &third].map(Arc::clone));
        kept.set(Pass::Wiring, &[Arc::clone(&first)]);
        assert_eq!(of(&kept, Pass::Wiring), [Arc::clone(&first)]);
        assert_eq!(of(&kept, Pass::Blocks), []);
        for pass in [Pass::Types, Pass::Wiring, Pass::Power] {
            kept.set(pass, &[]);
        }
        assert!(kept.0.is_none(), "nothing takes no room");
    }
}

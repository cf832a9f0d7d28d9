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
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

const PASSES: usize = Pass::ALL.len();

impl Pass {
    /// In the order in which their findings count.
    pub(crate) const ALL: [Pass; 5] = [Pass::Types, Pass::Form, Pass::Blocks, Pass::Wiring, Pass::Power];
}

/// Findings in a network.
pub(crate) type InNetwork = Vec<Arc<Anchored>>;

/// What each pass found when it looked last.
#[derive(Debug, Default)]
pub(crate) struct Verdict {
    /// With which key each pass looked. 0: it has not.
    keys: [AtomicU64; PASSES],
    /// None: no pass has found anything.
    found: Mutex<Option<Box<[InNetwork; PASSES]>>>,
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
        Some(
            found
                .as_ref()
                .map_or_else(Vec::new, |found| found[pass as usize].clone()),
        )
    }

    /// Keeps what a pass has found with a key, unless it names places outside of the network.
    fn keep(&self, pass: Pass, key: u64, found: &[Arc<Anchored>]) {
        if found.iter().any(|found| found.is_volatile()) {
            return;
        }
        let mut kept = self.found();
        if !found.is_empty() {
            kept.get_or_insert_default()[pass as usize] = found.to_vec();
        } else if let Some(kept) = kept.as_mut() {
            kept[pass as usize] = Vec::new();
        }
        self.keys[pass as usize].store(key, Ordering::Release);
    }

    /// What is kept stays whole: it is changed in one step.
    fn found(&self) -> MutexGuard<'_, Option<Box<[InNetwork; PASSES]>>> {
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
    let found: InNetwork = found
        .into_iter()
        .map(|found| Arc::new(Anchored::at_network(found, network)))
        .collect();
    if let Some(key) = key.filter(|_| may_keep) {
        network.verdict.keep(pass, key, &found);
    }
    found
}

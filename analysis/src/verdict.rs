//! What was found in a network, kept with it from one text to the next.
//!
//! A pass over networks asks here first. Its key says what else than the network's own lines decides about its
//! findings: the types of its tags, whether its rail may be dead. With another key the network is looked at again. Nothing
//! here is ever needed, it only saves looking.

use crate::diagnostic::Diagnostic;
use crate::networks::NetworkAt;
use ladder_syntax::TextRange;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The passes whose findings are kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pass {
    /// The drawing and the form of the blocks.
    Form,
    /// The types of the operands.
    Types,
    /// Blocks one by one.
    Blocks,
    /// What stands behind what on a wire.
    Wiring,
    /// When its wires have power.
    Power,
}

const PASSES: usize = 5;

/// What each pass found when it looked last.
#[derive(Debug, Default)]
pub(crate) struct Verdict {
    /// With which key each pass looked. 0: it has not.
    keys: [AtomicU64; PASSES],
    /// Most networks have no findings, and no lock is taken for them.
    some: AtomicBool,
    found: Mutex<Option<Box<Found>>>,
}

/// Ranges count from the start of the network.
#[derive(Debug, Default, Clone)]
struct Found([Vec<Diagnostic>; PASSES]);

impl Verdict {
    /// If a pass has looked with this key, adds what it found to `out`, and is done. The key is never 0.
    pub(crate) fn recall(&self, pass: Pass, key: u64, network: TextRange, out: &mut Vec<Diagnostic>) -> bool {
        let kept = &self.keys[pass as usize];
        if kept.load(Ordering::Acquire) != key {
            return false;
        }
        if self.some.load(Ordering::Acquire) {
            let found = self.found();
            // Another text's analysis may have looked meanwhile.
            if kept.load(Ordering::Acquire) != key {
                return false;
            }
            let start = i64::from(u32::from(network.start()));
            let found = found.as_ref().map_or(&[][..], |found| &found.0[pass as usize]);
            out.extend(found.iter().map(|found| found.moved(start)));
        }
        true
    }

    /// Keeps what a pass has found with a key, unless it speaks of places outside of the network.
    pub(crate) fn keep(&self, pass: Pass, key: u64, network: TextRange, found: &[Diagnostic]) {
        if !found.iter().all(|found| found.lies_in(network)) {
            return;
        }
        let mut kept = self.found();
        if !found.is_empty() {
            let start = i64::from(u32::from(network.start()));
            let of_pass = &mut kept.get_or_insert_default().0[pass as usize];
            *of_pass = found.iter().map(|found| found.moved(-start)).collect();
            self.some.store(true, Ordering::Release);
        } else if let Some(kept) = kept.as_mut() {
            kept.0[pass as usize] = Vec::new();
        }
        self.keys[pass as usize].store(key, Ordering::Release);
    }

    /// What is kept stays whole: it is changed in one step.
    fn found(&self) -> MutexGuard<'_, Option<Box<Found>>> {
        self.found.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Clone for Verdict {
    fn clone(&self) -> Verdict {
        let found = self.found();
        Verdict {
            keys: std::array::from_fn(|pass| AtomicU64::new(self.keys[pass].load(Ordering::Acquire))),
            some: AtomicBool::new(found.is_some()),
            found: Mutex::new(found.clone()),
        }
    }
}

/// Adds what a pass finds in a network to `out`: what is kept if it has looked with this key before, else what `look`
/// finds now.
pub(crate) fn once(
    pass: Pass,
    key: u64,
    network: NetworkAt<'_>,
    out: &mut Vec<Diagnostic>,
    look: impl FnOnce(&mut Vec<Diagnostic>),
) {
    let key = key | 1;
    if network.verdict.recall(pass, key, network.range, out) {
        return;
    }
    let before = out.len();
    look(out);
    network.verdict.keep(pass, key, network.range, &out[before..]);
}

//! What was found of a network, kept with it from one text to the next.
//!
//! What a verdict says is never needed, it only saves looking: without one, or with an old one, a network is looked at
//! again.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// What nothing was found in.
#[derive(Debug, Default)]
pub(crate) struct Verdict {
    types: AtomicU64,
    well_formed: AtomicBool,
    well_wired: AtomicBool,
}

impl Verdict {
    /// Whether its operands were found to be without mistakes while its tags had these types.
    pub(crate) fn is_well_typed(&self, types: u64) -> bool {
        self.types.load(Ordering::Relaxed) == types
    }

    /// They are. `types` is a number that stands for the types of the tags, never 0.
    pub(crate) fn well_typed(&self, types: u64) {
        self.types.store(types, Ordering::Relaxed);
    }

    /// Whether the rules about networks by themselves found nothing.
    pub(crate) fn is_well_formed(&self) -> bool {
        self.well_formed.load(Ordering::Relaxed)
    }

    /// They did not.
    pub(crate) fn well_formed(&self) {
        self.well_formed.store(true, Ordering::Relaxed);
    }

    /// Whether the rules about what stands behind what on its wires found nothing.
    pub(crate) fn is_well_wired(&self) -> bool {
        self.well_wired.load(Ordering::Relaxed)
    }

    /// They did not.
    pub(crate) fn well_wired(&self) {
        self.well_wired.store(true, Ordering::Relaxed);
    }
}

impl Clone for Verdict {
    fn clone(&self) -> Verdict {
        Verdict {
            types: AtomicU64::new(self.types.load(Ordering::Relaxed)),
            well_formed: AtomicBool::new(self.is_well_formed()),
            well_wired: AtomicBool::new(self.is_well_wired()),
        }
    }
}

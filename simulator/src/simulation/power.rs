//! The power of what is drawn.

use super::{Simulation, Status};
use crate::code::ElementPlace;
use crate::fuse::Power;
use crate::memory::Bit;
use ladder_analysis::program::{ElementKind, Location};

/// Where a power is read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PowerSource {
    /// A byte of the bank of bits.
    Bit(usize),
    /// The row that a record took.
    Row(usize),
}

impl Simulation {
    /// Every part of the drawing that carries power, and whether it had power in the last scan, or has in the one
    /// that is open. What that scan did not reach, or not yet, has none.
    pub fn power(&self) -> impl Iterator<Item = (ElementKind, Location, bool)> + '_ {
        let elements = self.compiled.elements.iter();
        elements.map(|element| (element.kind, element.location, self.shows_power(element)))
    }

    /// Whether one part of the drawing has power, by its place in [`Self::power`]: for a screen that shows a few
    /// lines of a long program.
    pub fn is_live(&self, element: usize) -> bool {
        let elements = &self.compiled.elements;
        elements
            .get(element)
            .is_some_and(|element| self.shows_power(element))
    }

    fn shows_power(&self, element: &ElementPlace) -> bool {
        self.is_reached(element) && self.has_power(element.power)
    }

    /// Every part of the drawing that carries power.
    pub(crate) fn elements(&self) -> &[ElementPlace] {
        &self.compiled.elements
    }

    /// The power of a part of the drawing in the last scan; none if that scan did not reach it.
    pub(crate) fn element_power(&self, element: &ElementPlace) -> Option<bool> {
        self.is_reached(element).then(|| self.has_power(element.power))
    }

    /// Where that power is read from after a scan that halted on its way, or one with forces.
    pub(crate) fn plain_power_source(element: &ElementPlace) -> PowerSource {
        PowerSource::Bit(element.power.0 as usize)
    }

    /// Where it is read from after a scan that ran straight through, while nothing is forced.
    pub(crate) fn power_source(&self, element: &ElementPlace) -> PowerSource {
        match self.compiled.fused.power(element.power) {
            Power::Slot(slot) => PowerSource::Bit(slot.0 as usize),
            Power::Row { record, .. } => PowerSource::Row(record as usize),
        }
    }

    /// The two banks that powers are read from: bits, and the rows that records took.
    pub(crate) fn power_banks(&self) -> (&[u8], &[u8]) {
        (&self.machine.memory.bits, &self.machine.rows)
    }

    /// Whether some scans may not reach a network.
    pub(crate) fn is_skippable(&self, network: usize) -> bool {
        self.compiled.skippable[network]
    }

    /// Whether the last scan, which is not open, reached a network.
    pub(crate) fn has_reached(&self, network: usize) -> bool {
        let machine = &self.machine;
        machine.scan > 0 && (!self.compiled.skippable[network] || machine.reached[network] == machine.scan)
    }

    fn is_reached(&self, element: &ElementPlace) -> bool {
        let network = element.network as usize;
        let machine = &self.machine;
        // One that a fault stopped is where it was stopped.
        let open = self.open || self.status == Status::Faulted;
        if open {
            let stretch = &self.compiled.stretches[network];
            let scan = machine.open_scan();
            if let Some(pc) = scan.within(stretch.start, stretch.end) {
                return element.at <= pc;
            }
            if !self.compiled.skippable[network] {
                return element.at <= scan.main();
            }
        }
        // It is not counted yet.
        let scan = machine.scan + i64::from(open);
        scan > 0
            && (!self.compiled.skippable[network]
                || (machine.reached[network] == scan && element.step <= machine.left_at[network]))
    }

    pub(crate) fn has_power(&self, slot: Bit) -> bool {
        let place = if self.ran_plain {
            Power::Slot(slot)
        } else {
            self.compiled.fused.power(slot)
        };
        match place {
            Power::Slot(slot) => self.machine.memory.bit(slot),
            Power::Row { record, truth } => truth >> (self.machine.rows[record as usize] & 7) & 1 != 0,
        }
    }
}

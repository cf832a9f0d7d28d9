//! Which parts are worth a look after a scan: those whose power may be another than after the scan before.
//!
//! All powers are read from two banks of bytes. Most scans change little of them, so the banks are compared with
//! what they were, stretch by stretch, and only the parts that read a stretch that has changed are checked.

use super::Runs;
use crate::code::ElementPlace;
use crate::memory::Bit;
use crate::simulation::{PowerSource, Simulation};

/// This many bytes are compared at once.
const STRETCH: usize = 64;

/// What the last scan left, and who reads it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Watch {
    bits: Bank,
    rows: Bank,
    /// Parts of networks that a scan may miss.
    always: Vec<u32>,
    /// All parts, until the first scan has been observed.
    all: Vec<u32>,
}

#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Bank {
    before: Vec<u8>,
    /// For each stretch the parts that read it.
    readers: Vec<Vec<u32>>,
}

impl Watch {
    /// A watch over parts: each by its number, with the places whose power it reads.
    pub(super) fn of<'e>(
        simulation: &Simulation,
        runs: Runs,
        parts: impl Iterator<Item = (u32, [Option<&'e ElementPlace>; 2])>,
    ) -> Watch {
        let (bits, rows) = simulation.power_banks();
        let mut watch = Watch {
            bits: Bank::of(bits),
            rows: Bank::of(rows),
            ..Watch::default()
        };
        for (part, places) in parts {
            watch.all.push(part);
            for place in places.into_iter().flatten() {
                if simulation.is_skippable(place.network as usize) {
                    watch.always.push(part);
                    break;
                }
                let source = match runs {
                    Runs::Through => simulation.power_source(place),
                    Runs::ByTurns => Simulation::plain_power_source(place),
                };
                match source {
                    // The rail's, which never changes.
                    PowerSource::Bit(at) if at == Bit::HIGH.0 as usize || at == Bit::LOW.0 as usize => {}
                    PowerSource::Bit(at) => watch.bits.read_by(at, part),
                    PowerSource::Row(at) => watch.rows.read_by(at, part),
                }
            }
        }
        watch
    }

    /// Calls `look` for the parts that may run several times in a scan, within one.
    pub(super) fn within_scan(&mut self, mut look: impl FnMut(u32) -> bool) {
        self.always.retain(|&part| !look(part));
    }

    /// Calls `look` for each part that is worth it; one that needs no further look says so.
    pub(super) fn changed(&mut self, simulation: &Simulation, mut look: impl FnMut(u32) -> bool) {
        let (bits, rows) = simulation.power_banks();
        for part in std::mem::take(&mut self.all) {
            look(part);
        }
        self.always.retain(|&part| !look(part));
        self.bits.changed(bits, &mut look);
        self.rows.changed(rows, &mut look);
    }
}

impl Bank {
    fn of(bytes: &[u8]) -> Bank {
        Bank {
            before: bytes.to_vec(),
            readers: vec![Vec::new(); bytes.len().div_ceil(STRETCH)],
        }
    }

    fn read_by(&mut self, at: usize, part: u32) {
        self.readers[at / STRETCH].push(part);
    }

    fn changed(&mut self, now: &[u8], look: &mut impl FnMut(u32) -> bool) {
        let stretches = now.chunks(STRETCH).zip(self.before.chunks_mut(STRETCH));
        for ((now, before), readers) in stretches.zip(&mut self.readers) {
            if now != before {
                before.copy_from_slice(now);
                readers.retain(|&part| !look(part));
            }
        }
    }
}

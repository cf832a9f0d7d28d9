//! What is kept of a scan, and how much of the past.

use crate::machine::Faulted;
use crate::simulation::{Force, Simulation, Status};
use std::collections::BTreeMap;

/// How much of the past is kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HistoryLimits {
    /// At most this many scans; none with 0.
    pub scans: usize,
    /// At most this many bytes.
    pub bytes: usize,
}

impl Default for HistoryLimits {
    /// 10,000 scans (100 seconds at 10 ms) in at most 64 MiB.
    fn default() -> Self {
        HistoryLimits {
            scans: 10_000,
            bytes: 64 << 20,
        }
    }
}

impl HistoryLimits {
    /// This many scans, in at most as many bytes as by default.
    pub fn of_scans(scans: usize) -> HistoryLimits {
        HistoryLimits {
            scans,
            ..HistoryLimits::default()
        }
    }
}

pub(in crate::session) type Forces = BTreeMap<String, Force>;

/// The clock of a moment, and the state of the program.
#[derive(Debug, Clone, Copy)]
pub(in crate::session) struct Moment {
    pub(in crate::session) now: i64,
    pub(in crate::session) scan: i64,
    faulted: Faulted,
    status: Status,
    ran_plain: bool,
}

impl Moment {
    pub(in crate::session) fn of(simulation: &Simulation) -> Moment {
        Moment {
            now: simulation.machine.now,
            scan: simulation.machine.scan,
            faulted: simulation.machine.faulted,
            status: simulation.status,
            ran_plain: simulation.ran_plain,
        }
    }

    pub(in crate::session) fn restore(self, simulation: &mut Simulation) {
        simulation.machine.now = self.now;
        simulation.machine.scan = self.scan;
        simulation.machine.faulted = self.faulted;
        simulation.status = self.status;
        simulation.ran_plain = self.ran_plain;
    }
}

/// What was given from outside, beyond what the banks show: the forces before and after. None if they stayed.
pub(in crate::session) type ForceChange = Option<Box<(Forces, Forces)>>;

/// One scan.
#[derive(Debug)]
pub(in crate::session) struct Entry {
    /// Bytes of what was given before it.
    pub(in crate::session) given: u32,
    /// Bytes of what it did.
    pub(super) ran: u32,
    /// Bytes that it sent through the serial port.
    pub(super) sent: u32,
    pub(in crate::session) forces: ForceChange,
    pub(super) after: Moment,
}

impl Entry {
    pub(in crate::session) fn bytes(&self) -> usize {
        self.given as usize + self.ran as usize
    }
}

/// What was given for a scan that has not ended.
#[derive(Debug, Default)]
pub(in crate::session) struct Given {
    pub(in crate::session) bytes: Vec<u8>,
    pub(in crate::session) forces: ForceChange,
}

impl Given {
    pub(in crate::session) fn is_nothing(&self) -> bool {
        self.bytes.is_empty() && self.forces.is_none()
    }
}

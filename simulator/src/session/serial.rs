//! What was sent through the serial port, as far back as the kept scans need it.

use crate::memory::SERIAL_ROOM;
use std::collections::VecDeque;

/// Sent bytes: those before the oldest kept scan, those of the kept ones up to here, and those ahead.
#[derive(Debug, Default)]
pub(super) struct SerialLog {
    bytes: VecDeque<u8>,
    /// How many lie before the oldest kept scan.
    old: usize,
    /// How many lie before here.
    here: usize,
}

impl SerialLog {
    /// Takes what a scan has sent; how many bytes it was. It is the newest scan.
    pub(super) fn take(&mut self, sent: &mut VecDeque<u8>) -> u32 {
        let count = sent.len();
        if count > 0 {
            self.bytes.extend(sent.drain(..));
            self.here = self.bytes.len();
        }
        count as u32
    }

    /// A log that begins after what this one shows.
    pub(super) fn following(&self) -> SerialLog {
        let bytes: VecDeque<u8> = self.shown().collect();
        SerialLog {
            old: bytes.len(),
            here: bytes.len(),
            bytes,
        }
    }

    pub(super) fn back(&mut self, count: u32) {
        self.here -= count as usize;
    }

    pub(super) fn forward(&mut self, count: u32) {
        self.here += count as usize;
    }

    pub(super) fn forget_ahead(&mut self) {
        self.bytes.truncate(self.here);
    }

    /// The oldest kept scan, which sent this many bytes, is kept no longer.
    pub(super) fn forget_oldest(&mut self, count: u32) {
        self.old += count as usize;
        let gone = self.old.saturating_sub(SERIAL_ROOM);
        if gone > 0 {
            self.bytes.drain(..gone);
            self.old -= gone;
            self.here -= gone;
        }
    }

    /// What was sent up to here: the newest bytes.
    pub(super) fn shown(&self) -> impl Iterator<Item = u8> + '_ {
        self.bytes
            .range(self.here.saturating_sub(SERIAL_ROOM)..self.here)
            .copied()
    }

    /// How many bytes are kept.
    pub(super) fn size(&self) -> usize {
        self.bytes.len()
    }
}

//! The arrays in which a Click controller reports of itself ([`Controller::Banks`](ladder_instructions::Controller)).

use super::Compiler;
use crate::controller::{Relay, Relays, STOP};
use crate::layout::Home;
use crate::memory::Bit;
use crate::routine::Routine;
use ladder_instructions::Controller;

impl Compiler<'_> {
    /// Finds the arrays SC and SD of the main program's file, and writes them at the start of every scan.
    pub(super) fn controller(&mut self) {
        let program = self.program;
        let Some(first) = program.networks.get(program.main.start) else {
            return;
        };
        if program.semantics(first.location).controller != Controller::Banks {
            return;
        }
        let file = first.location.file;
        let home = |name: &str| {
            let tags = program.tags.iter().zip(&self.homes);
            let mut own = tags.filter(|(tag, _)| tag.block.is_none() && tag.location.file == file);
            own.find(|(tag, _)| tag.name.eq_ignore_ascii_case(name))
                .map(|(_, home)| *home)
        };
        let bits = match home("SC") {
            Some(Home::Bits { at, first, len }) => array(at.0, first, len),
            _ => None,
        };
        let words = match home("SD") {
            Some(Home::Words { at, first, len, .. }) => array(at.0, first, len),
            _ => None,
        };
        if bits.is_none() && words.is_none() {
            return;
        }
        let numbered = |number: u32| {
            let [at, first, len] = bits?;
            let index = number.checked_sub(first)?;
            (index < len).then_some(Bit(at + index))
        };
        let relay = |relay: Relay| numbered(relay.number());
        self.code.relays = Relays {
            zero: relay(Relay::Zero),
            range: relay(Relay::Range),
            address: relay(Relay::Address),
            math: relay(Relay::Math),
            stop: numbered(STOP),
        };
        let interval = self.constant(self.interval);
        let mut operands = [bits.unwrap_or_default(), words.unwrap_or_default()].concat();
        operands.push(interval.0);
        self.routine(Routine::Controller, &operands);
    }
}

/// An array as the routine takes it.
fn array(at: u32, first: i64, len: u32) -> Option<[u32; 3]> {
    Some([at, u32::try_from(first).ok()?, len])
}

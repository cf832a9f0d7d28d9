//! The controller's supply of power (LANGUAGE §9, `SYS.POWER`): what is lost when it fails, and how the program begins again.

use super::Simulation;
use crate::layout::Home;
use crate::memory::{Bit, Memory, Word};
use crate::retain::copy;
use ladder_analysis::program::{Connection, TagId};

impl Simulation {
    /// Whether the controller had power in the last scan.
    pub fn had_power(&self) -> bool {
        self.machine.memory.bit(Bit::HAD_POWER)
    }

    /// The plant whose `SYS.FAULT` shows the fault of the last scan, if only plants had one.
    pub fn faulted_plant(&self) -> Option<&str> {
        let faulted = self.machine.faulted;
        let plant = self
            .program
            .plants
            .first()
            .filter(|_| faulted.plants && !faulted.program);
        plant.map(|plant| plant.name.as_str())
    }

    /// Before a scan: what happens if power went away or came back since the last one.
    pub(super) fn supply(&mut self) {
        let memory = &mut self.machine.memory;
        let (had, has) = (memory.bit(Bit::HAD_POWER), memory.bit(Bit::POWER));
        memory.set_bit(Bit::HAD_POWER, has);
        match (had, has) {
            (true, false) => self.lose_power(),
            (false, true) => self.get_power(),
            _ => {}
        }
    }

    /// All but what is retentive, what goes in, what is forced, and what is the plants' is as before the first scan.
    fn lose_power(&mut self) {
        let compiled = &self.compiled;
        let memory = &mut self.machine.memory;
        let kept = std::mem::replace(memory, compiled.initial.clone());
        (memory.held, memory.received, memory.sent) =
            (kept.held.clone(), kept.received.clone(), kept.sent.clone());
        memory.bits[..Bit::RESERVED].copy_from_slice(&kept.bits[..Bit::RESERVED]);
        memory.words[..Word::RESERVED].copy_from_slice(&kept.words[..Word::RESERVED]);
        memory.words[Word::UNPOWERED_AT.0 as usize] = self.machine.now;
        let tags = self.program.tags.iter().zip(&compiled.homes);
        let stays = tags.filter(|(tag, _)| tag.is_input || self.program.plant_of(&tag.name).is_some());
        let retained = compiled.retained.iter().map(|retained| retained.home);
        for home in stays.map(|(_, home)| *home).chain(retained) {
            copy(home, memory, &kept);
        }
        for laid in compiled.plants.iter().flat_map(|plants| &plants.laid) {
            memory.bits[laid.bits.clone()].copy_from_slice(&kept.bits[laid.bits.clone()]);
            memory.words[laid.words.clone()].copy_from_slice(&kept.words[laid.words.clone()]);
            memory.texts[laid.texts.clone()].clone_from_slice(&kept.texts[laid.texts.clone()]);
        }
        for &Connection { from, to } in self.program.plants.iter().flat_map(|plant| &plant.inputs) {
            let home = |tag: TagId| compiled.homes[tag.0 as usize];
            copy_to(home(to), memory, home(from), &compiled.initial);
        }
        let forced: Vec<_> = self.forces.values().map(|force| force.point.clone()).collect();
        for point in forced {
            self.write(&point, &point.read(&kept));
        }
        self.machine.faulted.program = false;
    }

    /// The program starts warm. The clocks of what is retentive did not run meanwhile.
    fn get_power(&mut self) {
        let machine = &mut self.machine;
        let off_for = machine.now - machine.memory.word(Word::UNPOWERED_AT);
        machine.memory.words[Word::POWERED_IN.0 as usize] = machine.scan;
        machine.memory.words[Word::POWERED_AT.0 as usize] = machine.now;
        for retained in &self.compiled.retained {
            retained.shift_clock(&mut machine.memory, off_for);
        }
        machine.faulted.program = false;
    }
}

/// Copies what lives in one place of a memory to another place of the same kind.
fn copy_to(home: Home, memory: &mut Memory, from_home: Home, from: &Memory) {
    match (home, from_home) {
        (Home::Bits { at, len, .. }, Home::Bits { at: start, .. }) => {
            let (at, start, len) = (at.0 as usize, start.0 as usize, len as usize);
            memory.bits[at..at + len].copy_from_slice(&from.bits[start..start + len]);
        }
        (Home::Words { at, len, .. }, Home::Words { at: start, .. }) => {
            let (at, start, len) = (at.0 as usize, start.0 as usize, len as usize);
            memory.words[at..at + len].copy_from_slice(&from.words[start..start + len]);
        }
        (Home::Texts { at, len, .. }, Home::Texts { at: start, .. }) => {
            let (at, start, len) = (at.0 as usize, start.0 as usize, len as usize);
            memory.texts[at..at + len].clone_from_slice(&from.texts[start..start + len]);
        }
        _ => {}
    }
}

//! The system tags of a scan (LANGUAGE §4): clocks, counts, and whether the scan before had a fault.

use crate::encode::{Memory, World};
use crate::graph::Lit;
use crate::number::{Number, common};
use ladder_analysis::program::Clock;
use ladder_simulator::compiled::{Bit, Word};

/// A number that is remembered, of this many bits.
fn counter(world: &mut World, bits: usize, initial: i64) -> (Number, Vec<usize>) {
    let (leaves, numbers) = (0..bits)
        .map(|bit| world.remember(initial >> bit & 1 != 0))
        .unzip();
    (Number::unsigned(leaves), numbers)
}

fn becomes(world: &mut World, numbers: &[usize], next: &Number) {
    for (n, number) in numbers.iter().enumerate() {
        world.states[*number].next = next.bit(n);
    }
}

/// The states that say whether the scan before had a fault: in the program, and in plants if there are any.
pub(crate) struct HadFault {
    pub(crate) program: usize,
    pub(crate) plants: Option<usize>,
}

/// Sets the system tags. Those of plants, so far after those of the program, are the same but for their faults: no proof is about
/// a failure of the controller's power.
pub(crate) fn set(
    world: &mut World,
    memory: &mut Memory<'_>,
    interval: i64,
    of_plants: Option<(u32, u32)>,
) -> HadFault {
    let mut set_bit = |slot: Bit, value: Lit| {
        memory.set_bit(slot, value);
        if let Some((bits, _)) = of_plants {
            memory.set_bit(slot.offset(bits), value);
        }
    };
    let (first, number) = world.remember(true);
    world.states[number].next = Lit::FALSE;
    set_bit(Bit::FIRST_SCAN, first);
    let (fault, program) = world.remember(false);
    set_bit(Bit::FAULT, fault);
    for clock in Clock::ALL {
        let high = clock_bit(world, clock.period(), interval);
        set_bit(Bit::CLOCKS.offset(clock as u32), high);
    }
    // SYS.SCAN is a DINT and wraps.
    let (leaves, numbers): (Vec<Lit>, Vec<usize>) = (0..32).map(|_| world.remember(false)).unzip();
    let scan = Number::of_bits(leaves);
    let next = world.graph.add(&scan, &Number::constant(1));
    becomes(world, &numbers, &next);
    let time = clock(world, interval);
    let scan_time = Number::constant(interval);
    let scan_time = world.graph.choose_number(first, &Number::constant(0), &scan_time);
    for (slot, value) in [
        (Word::SCAN, scan),
        (Word::TIME, time),
        (Word::SCAN_TIME, scan_time),
    ] {
        if let Some((_, words)) = of_plants {
            memory.set_word(slot.offset(words), value.clone());
        }
        memory.set_word(slot, value);
    }
    let plants = of_plants.map(|(bits, _)| {
        let (fault, number) = world.remember(false);
        memory.set_bit(Bit::FAULT.offset(bits), fault);
        number
    });
    HadFault { program, plants }
}

/// The time since the start. It is counted in scans: so it is easily seen as milliseconds, too.
fn clock(world: &mut World, interval: i64) -> Number {
    let most = i64::MAX / interval.max(1) + 1;
    let bits = (64 - most.leading_zeros()) as usize;
    let (scans, numbers) = counter(world, bits, 0);
    let next = world.graph.add(&scans, &Number::constant(1));
    let next = world.graph.min(&next, &Number::constant(most));
    becomes(world, &numbers, &next);
    let time = world.graph.mul(&scans, &Number::constant(interval), 128);
    world.clock = Some(scans);
    world.graph.min(&time, &Number::constant(i64::MAX))
}

/// A clock: low in the first half of its period. It counts in steps of what period and interval have in common.
fn clock_bit(world: &mut World, period: i64, interval: i64) -> Lit {
    let unit = common(period, interval);
    let (steps, step) = (period / unit, (interval / unit) % (period / unit));
    let half = (period / 2 + unit - 1) / unit;
    let bits = (64 - steps.leading_zeros()) as usize;
    let (now, numbers) = counter(world, bits, 0);
    let graph = &mut world.graph;
    let more = graph.add(&now, &Number::constant(step));
    let less = graph.sub(&more, &Number::constant(steps));
    let is_within = graph.less(&more, &Number::constant(steps));
    let next = graph.choose_number(is_within, &more, &less);
    let high = !graph.less(&now, &Number::constant(half));
    becomes(world, &numbers, &next);
    high
}

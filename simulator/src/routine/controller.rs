//! What a Click controller reports of itself in the arrays SC and SD.

use super::Operands;
use crate::controller::Relay;
use crate::memory::{Bit, Memory, Word};
use crate::timers::Clock;
use ladder_analysis::program::Clock as Wave;

const MILLISECOND: i64 = 1_000_000;

/// At the start of a scan: the relays and numbers that have counterparts here, as far as the arrays reach.
pub(super) fn tell<const FORCED: bool>(memory: &mut Memory, with: &mut Operands, clock: Clock) {
    let mut place = || {
        let (at, first, count) = (with.number(), with.number(), with.number());
        move |number: u32| {
            let index = number.checked_sub(first)?;
            (index < count).then_some(at + index)
        }
    };
    let (relay, number) = (place(), place());
    let interval = with.value(memory);
    let mut put = |number: u32, value: bool| {
        if let Some(slot) = relay(number) {
            memory.put_bit::<FORCED>(Bit(slot), value);
        }
    };
    // Scans count from 1 here.
    put(1, true);
    put(2, clock.scan == 1);
    put(3, clock.scan % 2 == 0);
    for (number, wave) in (4..).zip(Wave::ALL) {
        let period = wave.period();
        put(number, clock.now.rem_euclid(period) >= period / 2);
    }
    // The switch is at RUN.
    put(10, true);
    put(11, true);
    for relay in [Relay::Zero, Relay::Range, Relay::Address, Relay::Math] {
        put(relay.number(), false);
    }
    let milliseconds = i64::from((interval / MILLISECOND) as i16);
    for (at, value) in [
        (9, i64::from(clock.scan as i16)),
        (10, milliseconds),
        (11, milliseconds),
        (12, milliseconds),
    ] {
        if let Some(slot) = number(at) {
            memory.put_word::<FORCED>(Word(slot), value);
        }
    }
}

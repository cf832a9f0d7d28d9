//! The timers (LANGUAGE §5.3).
//!
//! A timer's members are tags like any other and may be forced, so what a timer is doing is kept apart from
//! them: PHASE, and SINCE, the instant from which the time is counted. The times of the on-delay, off-delay and
//! pulse timer are differences to that instant, so a timer that was not reached for a while is right when it is
//! next evaluated.

use crate::layout::timer::{ET, IN, PHASE, PT, Q, R, SINCE, STAMP};
use crate::memory::{Bit, Memory, Word};
use ladder_instructions::StateType;

/// Where a timer's state begins.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Timer {
    pub(crate) bits: Bit,
    pub(crate) words: Word,
}

/// The simulation's clock in nanoseconds, and the scan, counted from 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Clock {
    pub(crate) now: i64,
    pub(crate) scan: i64,
}

// Phases of TON, TOF and TP.
const IDLE: u8 = 0;
const RUNNING: u8 = 1;
const DONE: u8 = 2;
/// A TOF whose EN is high: its fall starts the time.
const ARMED: u8 = 3;
/// Added to the phase of a TP: EN was high at its last evaluation.
const WAS_HIGH: u8 = 4;

// Phase of RTO and RTOF: a set of these.
/// The last evaluation was one that time is added from.
const COUNTING: u8 = 1;
/// An RTOF whose EN was high once since it was cleared.
const FELL: u8 = 2;
/// An RTOF whose time has not run out.
const ON: u8 = 4;

impl Timer {
    /// Copies the inputs into the members. Gives EN as the timer sees it (low while R is high), R, and PT.
    #[inline]
    fn inputs<const FORCED: bool>(self, memory: &mut Memory, en: bool, pt: i64) -> (bool, bool, i64) {
        let reset = memory.bit(self.bits.offset(R));
        memory.put_bit::<FORCED>(self.bits.offset(IN), en && !reset);
        memory.put_word::<FORCED>(self.words.offset(PT), pt);
        if FORCED {
            let input = memory.bit(self.bits.offset(IN));
            return (input, reset, memory.word(self.words.offset(PT)));
        }
        (en && !reset, reset, pt)
    }

    #[inline]
    fn outputs<const FORCED: bool>(self, memory: &mut Memory, q: bool, et: i64) -> bool {
        memory.put_word::<FORCED>(self.words.offset(ET), et);
        memory.put_bit::<FORCED>(self.bits.offset(Q), q);
        if FORCED {
            memory.bit(self.bits.offset(Q))
        } else {
            q
        }
    }

    #[inline]
    fn phase(self, memory: &Memory) -> u8 {
        memory.bits[self.bits.offset(PHASE).0 as usize]
    }

    #[inline]
    fn set_phase(self, memory: &mut Memory, phase: u8) {
        memory.bits[self.bits.offset(PHASE).0 as usize] = phase;
    }

    #[inline]
    fn begin(self, memory: &mut Memory, clock: Clock) {
        memory.words[self.words.offset(SINCE).0 as usize] = clock.now;
    }

    #[inline]
    fn elapsed(self, memory: &Memory, clock: Clock) -> i64 {
        clock.now.saturating_sub(memory.word(self.words.offset(SINCE)))
    }

    /// On-delay.
    #[inline]
    pub(crate) fn ton<const FORCED: bool>(
        self,
        memory: &mut Memory,
        en: bool,
        pt: i64,
        clock: Clock,
    ) -> bool {
        let (input, _, pt) = self.inputs::<FORCED>(memory, en, pt);
        if !input {
            self.set_phase(memory, IDLE);
            return self.outputs::<FORCED>(memory, false, 0);
        }
        let mut phase = self.phase(memory);
        if phase == IDLE {
            self.begin(memory, clock);
            phase = RUNNING;
        }
        let elapsed = self.elapsed(memory, clock);
        if elapsed >= pt {
            phase = DONE;
        }
        self.set_phase(memory, phase);
        // A longer PT does not take back a Q that is high.
        self.outputs::<FORCED>(memory, phase == DONE, elapsed.min(pt.max(0)))
    }

    /// Off-delay.
    #[inline]
    pub(crate) fn tof<const FORCED: bool>(
        self,
        memory: &mut Memory,
        en: bool,
        pt: i64,
        clock: Clock,
    ) -> bool {
        let (input, reset, pt) = self.inputs::<FORCED>(memory, en, pt);
        if reset {
            self.set_phase(memory, IDLE);
            return self.outputs::<FORCED>(memory, false, 0);
        }
        if input {
            self.set_phase(memory, ARMED);
            return self.outputs::<FORCED>(memory, true, 0);
        }
        let mut phase = self.phase(memory);
        if phase == ARMED {
            self.begin(memory, clock);
            phase = RUNNING;
        }
        let et = if phase == RUNNING {
            let elapsed = self.elapsed(memory, clock);
            if elapsed >= pt {
                phase = DONE;
            }
            elapsed
        } else {
            memory.word(self.words.offset(ET))
        };
        self.set_phase(memory, phase);
        self.outputs::<FORCED>(memory, phase == RUNNING, et.min(pt.max(0)))
    }

    /// Pulse.
    pub(crate) fn tp<const FORCED: bool>(self, memory: &mut Memory, en: bool, pt: i64, clock: Clock) -> bool {
        let (input, reset, pt) = self.inputs::<FORCED>(memory, en, pt);
        // While R is high EN counts as low, but what is then high at its end is no rise.
        let high = if FORCED && !reset { input } else { en };
        let before = self.phase(memory);
        let stamp = &mut memory.words[self.words.offset(STAMP).0 as usize];
        let again = std::mem::replace(stamp, clock.scan) == clock.scan;
        let rise = high && before & WAS_HIGH == 0 && !again;
        let (mut q, mut et) = (false, 0);
        let mut phase = before & !WAS_HIGH;
        match phase {
            _ if reset => phase = IDLE,
            IDLE if rise && pt > 0 => {
                self.begin(memory, clock);
                (phase, q) = (RUNNING, true);
            }
            IDLE => {}
            RUNNING if self.elapsed(memory, clock) < pt => (q, et) = (true, self.elapsed(memory, clock)),
            // Over, and ET stays at PT until EN is low: at once, if it is low already.
            _ if !high => phase = IDLE,
            RUNNING => (phase, et) = (DONE, pt.max(0)),
            _ => et = memory.word(self.words.offset(ET)).min(pt.max(0)),
        }
        self.set_phase(memory, phase | if high { WAS_HIGH } else { 0 });
        self.outputs::<FORCED>(memory, q, et)
    }

    /// Retentive on-delay.
    pub(crate) fn rto<const FORCED: bool>(
        self,
        memory: &mut Memory,
        en: bool,
        pt: i64,
        clock: Clock,
    ) -> bool {
        let (input, reset, pt) = self.inputs::<FORCED>(memory, en, pt);
        if reset {
            self.set_phase(memory, 0);
            return self.outputs::<FORCED>(memory, false, 0);
        }
        let mut et = memory.word(self.words.offset(ET));
        if input && self.phase(memory) & COUNTING != 0 {
            et = et.saturating_add(self.elapsed(memory, clock));
        }
        et = et.min(pt.max(0));
        self.begin(memory, clock);
        self.set_phase(memory, if input { COUNTING } else { 0 });
        let q = if pt > 0 { et >= pt } else { input };
        self.outputs::<FORCED>(memory, q, et)
    }

    /// Retentive off-delay.
    pub(crate) fn rtof<const FORCED: bool>(
        self,
        memory: &mut Memory,
        en: bool,
        pt: i64,
        clock: Clock,
    ) -> bool {
        let (input, reset, pt) = self.inputs::<FORCED>(memory, en, pt);
        if reset {
            self.set_phase(memory, 0);
            return self.outputs::<FORCED>(memory, false, 0);
        }
        let limit = pt.max(0);
        let mut et = memory.word(self.words.offset(ET));
        let mut phase = self.phase(memory);
        if input {
            phase = FELL | ON;
        } else if phase & FELL != 0 {
            if phase & COUNTING != 0 {
                et = et.saturating_add(self.elapsed(memory, clock));
            }
            phase |= COUNTING;
            if et >= limit {
                phase &= !ON;
            }
        }
        self.begin(memory, clock);
        self.set_phase(memory, phase);
        self.outputs::<FORCED>(memory, phase & ON != 0, et.min(limit))
    }

    /// `(RES)`: like an R that ends with it. A pulse timer remembers EN: what is high then is no rise.
    pub(crate) fn clear<const FORCED: bool>(self, memory: &mut Memory, state: StateType) {
        let kept = if state == StateType::Tp {
            self.phase(memory) & WAS_HIGH
        } else {
            0
        };
        self.set_phase(memory, kept);
        self.outputs::<FORCED>(memory, false, 0);
    }
}

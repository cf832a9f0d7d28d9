//! The timers (LANGUAGE §5.3).
//!
//! A timer's members are tags like any other and may be forced, so what a timer is doing is kept apart from
//! them: PHASE, and SINCE, the instant from which the time is counted. The times of the on-delay, off-delay and
//! pulse timer are differences to that instant, so a timer that was not reached for a while is right when it is
//! next evaluated.

use crate::layout::timer::{BITS, ET, IN, PHASE, PT, Q, R, SINCE, WORDS};
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

/// A timer's state with what of it is forced. Seen as two arrays, so that one check of the bounds is enough.
struct View<'m, const FORCED: bool> {
    bits: &'m mut [u8; BITS as usize],
    words: &'m mut [i64; WORDS as usize],
    /// Empty without forces.
    held_bits: &'m [u8],
    held_words: &'m [i64],
}

impl<const FORCED: bool> View<'_, FORCED> {
    #[inline]
    fn put_bit(&mut self, member: u32, value: bool) -> bool {
        let at = member as usize;
        if !FORCED || self.held_bits.get(at) == Some(&0) {
            self.bits[at] = u8::from(value);
        }
        if FORCED { self.bits[at] != 0 } else { value }
    }

    #[inline]
    fn put_word(&mut self, member: u32, value: i64) -> i64 {
        let at = member as usize;
        if !FORCED || self.held_words.get(at) == Some(&0) {
            self.words[at] = value;
        }
        if FORCED { self.words[at] } else { value }
    }

    /// Copies the inputs into the members. Returns EN as the timer sees it (low while R is high), R, and PT.
    #[inline]
    fn inputs(&mut self, en: bool, pt: i64) -> (bool, bool, i64) {
        let reset = self.bits[R as usize] != 0;
        (self.put_bit(IN, en && !reset), reset, self.put_word(PT, pt))
    }

    #[inline]
    fn outputs(&mut self, q: bool, et: i64) -> bool {
        self.put_word(ET, et);
        self.put_bit(Q, q)
    }

    #[inline]
    fn phase(&self) -> u8 {
        self.bits[PHASE as usize]
    }

    #[inline]
    fn set_phase(&mut self, phase: u8) {
        self.bits[PHASE as usize] = phase;
    }

    #[inline]
    fn et(&self) -> i64 {
        self.words[ET as usize]
    }

    #[inline]
    fn begin(&mut self, clock: Clock) {
        self.words[SINCE as usize] = clock.now;
    }

    #[inline]
    fn elapsed(&self, clock: Clock) -> i64 {
        clock.now.saturating_sub(self.words[SINCE as usize])
    }
}

impl Timer {
    #[inline]
    fn view<const FORCED: bool>(self, memory: &mut Memory) -> View<'_, FORCED> {
        let (bits, words) = (self.bits.0 as usize, self.words.0 as usize);
        let held = &memory.held;
        View {
            bits: memory.bits[bits..]
                .first_chunk_mut()
                .expect("a timer's bits are laid out together"),
            words: memory.words[words..]
                .first_chunk_mut()
                .expect("a timer's words are laid out together"),
            held_bits: if FORCED { &held.bits[bits..] } else { &[] },
            held_words: if FORCED { &held.words[words..] } else { &[] },
        }
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
        let mut timer = self.view::<FORCED>(memory);
        let (input, _, pt) = timer.inputs(en, pt);
        if !input {
            timer.set_phase(IDLE);
            return timer.outputs(false, 0);
        }
        let mut phase = timer.phase();
        if phase == IDLE {
            timer.begin(clock);
            phase = RUNNING;
        }
        let elapsed = timer.elapsed(clock);
        if elapsed >= pt {
            phase = DONE;
        }
        timer.set_phase(phase);
        // A longer PT does not take back a Q that is high.
        timer.outputs(phase == DONE, elapsed.min(pt.max(0)))
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
        let mut timer = self.view::<FORCED>(memory);
        let (input, reset, pt) = timer.inputs(en, pt);
        if reset {
            timer.set_phase(IDLE);
            return timer.outputs(false, 0);
        }
        if input {
            timer.set_phase(ARMED);
            return timer.outputs(true, 0);
        }
        let mut phase = timer.phase();
        if phase == ARMED {
            timer.begin(clock);
            phase = RUNNING;
        }
        let et = if phase == RUNNING {
            let elapsed = timer.elapsed(clock);
            if elapsed >= pt {
                phase = DONE;
            }
            elapsed
        } else {
            timer.et()
        };
        timer.set_phase(phase);
        timer.outputs(phase == RUNNING, et.min(pt.max(0)))
    }

    /// Pulse.
    pub(crate) fn tp<const FORCED: bool>(self, memory: &mut Memory, en: bool, pt: i64, clock: Clock) -> bool {
        let mut timer = self.view::<FORCED>(memory);
        let (input, reset, pt) = timer.inputs(en, pt);
        // While R is high EN counts as low, but what is then high at its end is not a rise.
        let high = if FORCED && !reset { input } else { en };
        let before = timer.phase();
        let rise = high && before & WAS_HIGH == 0;
        let (mut q, mut et) = (false, 0);
        let mut phase = before & !WAS_HIGH;
        match phase {
            _ if reset => phase = IDLE,
            IDLE if rise && pt > 0 => {
                timer.begin(clock);
                (phase, q) = (RUNNING, true);
            }
            IDLE => {}
            RUNNING if timer.elapsed(clock) < pt => (q, et) = (true, timer.elapsed(clock)),
            // Over, and ET stays at PT until EN is low: at once, if it is low already.
            _ if !high => phase = IDLE,
            RUNNING => (phase, et) = (DONE, pt.max(0)),
            _ => et = timer.et().min(pt.max(0)),
        }
        timer.set_phase(phase | if high { WAS_HIGH } else { 0 });
        timer.outputs(q, et)
    }

    /// Retentive on-delay.
    pub(crate) fn rto<const FORCED: bool>(
        self,
        memory: &mut Memory,
        en: bool,
        pt: i64,
        clock: Clock,
    ) -> bool {
        let mut timer = self.view::<FORCED>(memory);
        let (input, reset, pt) = timer.inputs(en, pt);
        if reset {
            timer.set_phase(0);
            return timer.outputs(false, 0);
        }
        let mut et = timer.et();
        if input && timer.phase() & COUNTING != 0 {
            et = et.saturating_add(timer.elapsed(clock));
        }
        et = et.min(pt.max(0));
        timer.begin(clock);
        timer.set_phase(if input { COUNTING } else { 0 });
        let q = if pt > 0 { et >= pt } else { input };
        timer.outputs(q, et)
    }

    /// Retentive off-delay.
    pub(crate) fn rtof<const FORCED: bool>(
        self,
        memory: &mut Memory,
        en: bool,
        pt: i64,
        clock: Clock,
    ) -> bool {
        let mut timer = self.view::<FORCED>(memory);
        let (input, reset, pt) = timer.inputs(en, pt);
        if reset {
            timer.set_phase(0);
            return timer.outputs(false, 0);
        }
        let limit = pt.max(0);
        let mut et = timer.et();
        let mut phase = timer.phase();
        if input {
            phase = FELL | ON;
        } else if phase & FELL != 0 {
            if phase & COUNTING != 0 {
                et = et.saturating_add(timer.elapsed(clock));
            }
            phase |= COUNTING;
            if et >= limit {
                phase &= !ON;
            }
        }
        timer.begin(clock);
        timer.set_phase(phase);
        timer.outputs(phase & ON != 0, et.min(limit))
    }

    /// Its members were written from outside: what it is doing is made to fit them, so that it goes on from there.
    pub(crate) fn follow_members(self, memory: &mut Memory, state: StateType, now: i64) {
        let timer = self.view::<false>(memory);
        let (q, et) = (timer.bits[Q as usize] != 0, timer.et());
        let is_high = timer.bits[IN as usize] != 0;
        timer.words[SINCE as usize] = now.saturating_sub(et);
        timer.bits[PHASE as usize] = match state {
            StateType::Ton if q => DONE,
            StateType::Ton if et > 0 => RUNNING,
            StateType::Tof if is_high => ARMED,
            StateType::Tof if q => RUNNING,
            StateType::Tof => DONE,
            // Of one moment no rise is known.
            StateType::Tp if q => RUNNING | WAS_HIGH,
            StateType::Tp if et > 0 => DONE | WAS_HIGH,
            StateType::Tp => IDLE | WAS_HIGH,
            StateType::Rtof => FELL | if q { ON } else { 0 },
            _ => IDLE,
        };
    }

    /// `(RES)`: like an R that ends with it. A pulse timer remembers EN: what is high then is not a rise.
    pub(crate) fn clear<const FORCED: bool>(self, memory: &mut Memory, state: StateType) {
        let mut timer = self.view::<FORCED>(memory);
        let kept = if state == StateType::Tp {
            timer.phase() & WAS_HIGH
        } else {
            0
        };
        timer.set_phase(kept);
        timer.outputs(false, 0);
    }
}

//! The counters and bistables (LANGUAGE §5.3).

use crate::layout::counter::{CD, CHANGED, CU, CV, DOWN_BEFORE, LD, PV, Q, QD, R, UP_BEFORE};
use crate::memory::{Bit, Memory, Word};
use ladder_instructions::StateType;

/// Where a counter's state begins.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Counter {
    pub(crate) bits: Bit,
    pub(crate) words: Word,
}

/// What an evaluation is to do.
struct Inputs {
    up: bool,
    down: bool,
    reset: bool,
    load: bool,
    pv: i64,
}

impl Counter {
    /// Copies EN and PV into the members, looks for edges, and reads the rest. Edges are seen also while R or LD
    /// is high.
    fn inputs<const FORCED: bool>(self, memory: &mut Memory, en: bool, pv: i64) -> Inputs {
        memory.put_bit::<FORCED>(self.bits.offset(CU), en);
        memory.put_word::<FORCED>(self.words.offset(PV), pv);
        let mut rise = |input: u32, before: u32| {
            let high = memory.bit(self.bits.offset(input));
            let was = memory.bit(self.bits.offset(before));
            memory.set_bit(self.bits.offset(before), high);
            high && !was
        };
        Inputs {
            up: rise(CU, UP_BEFORE),
            down: rise(CD, DOWN_BEFORE),
            reset: memory.bit(self.bits.offset(R)),
            load: memory.bit(self.bits.offset(LD)),
            pv: memory.word(self.words.offset(PV)),
        }
    }

    fn count(self, memory: &Memory) -> i64 {
        memory.word(self.words.offset(CV))
    }

    /// Writes CV; what it was shows whether it changed.
    fn set_count<const FORCED: bool>(self, memory: &mut Memory, count: i64) {
        let before = self.count(memory);
        memory.put_word::<FORCED>(self.words.offset(CV), count);
        let changed = self.count(memory) != before;
        memory.put_bit::<FORCED>(self.bits.offset(CHANGED), changed);
    }

    fn set_output<const FORCED: bool>(self, memory: &mut Memory, member: u32, high: bool) -> bool {
        memory.put_bit::<FORCED>(self.bits.offset(member), high);
        memory.bit(self.bits.offset(member))
    }

    pub(crate) fn ctu<const FORCED: bool>(self, memory: &mut Memory, en: bool, pv: i64) -> bool {
        let inputs = self.inputs::<FORCED>(memory, en, pv);
        let count = match self.count(memory) {
            _ if inputs.reset => 0,
            count if inputs.up => up(count),
            count => count,
        };
        self.set_count::<FORCED>(memory, count);
        let reached = self.count(memory) >= inputs.pv;
        self.set_output::<FORCED>(memory, Q, reached)
    }

    pub(crate) fn ctd<const FORCED: bool>(self, memory: &mut Memory, en: bool, pv: i64) -> bool {
        let inputs = self.inputs::<FORCED>(memory, en, pv);
        let count = match self.count(memory) {
            _ if inputs.reset => 0,
            _ if inputs.load => inputs.pv,
            count if inputs.up => down(count),
            count => count,
        };
        self.set_count::<FORCED>(memory, count);
        let empty = self.count(memory) <= 0;
        self.set_output::<FORCED>(memory, Q, empty)
    }

    pub(crate) fn ctud<const FORCED: bool>(self, memory: &mut Memory, en: bool, pv: i64) -> bool {
        let inputs = self.inputs::<FORCED>(memory, en, pv);
        let count = match (self.count(memory), inputs.up, inputs.down) {
            _ if inputs.reset => 0,
            _ if inputs.load => inputs.pv,
            (count, true, false) => up(count),
            (count, false, true) => down(count),
            (count, _, _) => count,
        };
        self.set_count::<FORCED>(memory, count);
        let count = self.count(memory);
        self.set_output::<FORCED>(memory, QD, count <= 0);
        self.set_output::<FORCED>(memory, Q, count >= inputs.pv)
    }

    /// Counts in a circle: PV is followed by 0.
    pub(crate) fn ctc<const FORCED: bool>(self, memory: &mut Memory, en: bool, pv: i64) -> bool {
        let inputs = self.inputs::<FORCED>(memory, en, pv);
        let count = match self.count(memory) {
            _ if inputs.reset => 0,
            count if inputs.up && count >= inputs.pv => 0,
            count if inputs.up => up(count),
            count => count,
        };
        self.set_count::<FORCED>(memory, count);
        let full = self.count(memory) == inputs.pv;
        self.set_output::<FORCED>(memory, Q, full)
    }

    /// `(RES)`: CV 0, and Q follows at once.
    pub(crate) fn clear<const FORCED: bool>(self, memory: &mut Memory, state: StateType) {
        self.set_count::<FORCED>(memory, 0);
        let (count, pv) = (self.count(memory), memory.word(self.words.offset(PV)));
        let q = match state {
            StateType::Ctd => count <= 0,
            StateType::Ctc => count == pv,
            _ => count >= pv,
        };
        self.set_output::<FORCED>(memory, Q, q);
        if state == StateType::Ctud {
            self.set_output::<FORCED>(memory, QD, count <= 0);
        }
    }
}

/// Counters stop at the limits of DINT.
fn up(count: i64) -> i64 {
    (count + 1).min(i64::from(i32::MAX))
}

fn down(count: i64) -> i64 {
    (count - 1).max(i64::from(i32::MIN))
}

/// `[SR]`: the set dominates.
pub(crate) fn sr<const FORCED: bool>(memory: &mut Memory, q1: Bit, set: bool, reset: bool) -> bool {
    let value = set || (memory.bit(q1) && !reset);
    memory.put_bit::<FORCED>(q1, value);
    memory.bit(q1)
}

/// `[RS]`: the reset dominates.
pub(crate) fn rs<const FORCED: bool>(memory: &mut Memory, q1: Bit, set: bool, reset: bool) -> bool {
    let value = !reset && (set || memory.bit(q1));
    memory.put_bit::<FORCED>(q1, value);
    memory.bit(q1)
}

//! The counters (LANGUAGE §5.3), and what clears timers, counters and bistables.

use super::Scan;
use crate::graph::Lit;
use crate::number::Number;
use ladder_instructions::StateType;
use ladder_simulator::compiled::{Bit, Word, counter};

/// A counter that is evaluated.
struct Counter {
    up: Lit,
    down: Lit,
    reset: Lit,
    load: Lit,
    pv: Number,
    count: Number,
}

impl Scan<'_, '_> {
    /// Copies EN and PV into the members, looks for edges, and reads the rest.
    fn counter(&mut self, en: Bit, bits: Bit, pv: Word, words: Word) -> Counter {
        let (en, pv) = (self.bit(en), self.word(pv));
        self.write_bit(bits.offset(counter::CU), en);
        self.write_word(words.offset(counter::PV), pv.clone());
        let mut rise = |high: Lit, before: u32| {
            let was = self.bit(bits.offset(before));
            self.write_bit(bits.offset(before), high);
            self.world.graph.and(high, !was)
        };
        let up = rise(en, counter::UP_BEFORE);
        let cd = self.bit(bits.offset(counter::CD));
        let mut rise = |high: Lit, before: u32| {
            let was = self.bit(bits.offset(before));
            self.write_bit(bits.offset(before), high);
            self.world.graph.and(high, !was)
        };
        let down = rise(cd, counter::DOWN_BEFORE);
        let count = self.word(words.offset(counter::CV));
        self.world.counts.push((words.0, count.bit(0), pv.known()));
        Counter {
            up,
            down,
            reset: self.bit(bits.offset(counter::R)),
            load: self.bit(bits.offset(counter::LD)),
            pv,
            count,
        }
    }

    /// One more, held at the end of DINT.
    fn one_up(&mut self, count: &Number) -> Number {
        let more = self.world.graph.add(count, &Number::constant(1));
        self.world
            .graph
            .min(&more, &Number::constant(i64::from(i32::MAX)))
    }

    fn one_down(&mut self, count: &Number) -> Number {
        let less = self.world.graph.sub(count, &Number::constant(1));
        self.world
            .graph
            .max(&less, &Number::constant(i64::from(i32::MIN)))
    }

    fn set_count(&mut self, bits: Bit, words: Word, count: &Number, before: &Number) {
        self.write_word(words.offset(counter::CV), count.clone());
        let same = self.world.graph.equal(count, before);
        self.write_bit(bits.offset(counter::CHANGED), !same);
    }

    fn output(&mut self, out: Bit, member: Bit, high: Lit) {
        self.write_bit(member, high);
        self.write_bit(out, high);
    }

    pub(super) fn ctu(&mut self, [out, en, bits]: [Bit; 3], [pv, words]: [Word; 2]) {
        let it = self.counter(en, bits, pv, words);
        let more = self.one_up(&it.count);
        let graph = &mut self.world.graph;
        let count = graph.choose_number(it.up, &more, &it.count);
        let count = graph.choose_number(it.reset, &Number::constant(0), &count);
        let reached = !graph.less(&count, &it.pv);
        self.set_count(bits, words, &count, &it.count);
        self.output(out, bits.offset(counter::Q), reached);
    }

    pub(super) fn ctd(&mut self, [out, en, bits]: [Bit; 3], [pv, words]: [Word; 2]) {
        let it = self.counter(en, bits, pv, words);
        let less = self.one_down(&it.count);
        let zero = Number::constant(0);
        let graph = &mut self.world.graph;
        let count = graph.choose_number(it.up, &less, &it.count);
        let count = graph.choose_number(it.load, &it.pv, &count);
        let count = graph.choose_number(it.reset, &zero, &count);
        let empty = !graph.less(&zero, &count);
        self.set_count(bits, words, &count, &it.count);
        self.output(out, bits.offset(counter::Q), empty);
    }

    pub(super) fn ctud(&mut self, [out, en, bits]: [Bit; 3], [pv, words]: [Word; 2]) {
        let it = self.counter(en, bits, pv, words);
        let (more, less) = (self.one_up(&it.count), self.one_down(&it.count));
        let zero = Number::constant(0);
        let graph = &mut self.world.graph;
        let (up, down) = (graph.and(it.up, !it.down), graph.and(it.down, !it.up));
        let count = graph.choose_number(up, &more, &it.count);
        let count = graph.choose_number(down, &less, &count);
        let count = graph.choose_number(it.load, &it.pv, &count);
        let count = graph.choose_number(it.reset, &zero, &count);
        let empty = !graph.less(&zero, &count);
        let reached = !graph.less(&count, &it.pv);
        self.set_count(bits, words, &count, &it.count);
        self.write_bit(bits.offset(counter::QD), empty);
        self.output(out, bits.offset(counter::Q), reached);
    }

    /// PV is followed by 0.
    pub(super) fn ctc(&mut self, [out, en, bits]: [Bit; 3], [pv, words]: [Word; 2]) {
        let it = self.counter(en, bits, pv, words);
        let more = self.one_up(&it.count);
        let zero = Number::constant(0);
        let graph = &mut self.world.graph;
        let is_full = !graph.less(&it.count, &it.pv);
        let next = graph.choose_number(is_full, &zero, &more);
        let count = graph.choose_number(it.up, &next, &it.count);
        let count = graph.choose_number(it.reset, &zero, &count);
        let full = graph.equal(&count, &it.pv);
        self.set_count(bits, words, &count, &it.count);
        self.output(out, bits.offset(counter::Q), full);
    }

    /// `(RES)`, and `(R)` on such a tag.
    pub(super) fn clear(&mut self, en: Bit, state: StateType, bits: Bit, words: Word) {
        let en = self.bit(en);
        if state.is_timer() {
            return self.clear_timer(en, state == StateType::Tp, bits, words);
        }
        if !state.is_counter() {
            return self.write_bit_if(en, bits, Lit::FALSE);
        }
        let (zero, before) = (Number::constant(0), self.word(words.offset(counter::CV)));
        let pv = self.word(words.offset(counter::PV));
        let graph = &mut self.world.graph;
        let same = graph.equal(&before, &zero);
        let q = match state {
            StateType::Ctd => Lit::TRUE,
            StateType::Ctc => graph.equal(&zero, &pv),
            _ => !graph.less(&zero, &pv),
        };
        self.write_word_if(en, words.offset(counter::CV), &zero);
        self.write_bit_if(en, bits.offset(counter::CHANGED), !same);
        self.write_bit_if(en, bits.offset(counter::Q), q);
        if state == StateType::Ctud {
            self.write_bit_if(en, bits.offset(counter::QD), Lit::TRUE);
        }
    }
}

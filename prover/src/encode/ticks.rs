//! Timers that count a time base and counters that latch, as iot-ladder-editor has them.

use super::timers::{ANY_AGE, scans_of};
use super::{Scan, Times};
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Routine, Width, Word, counter as c, timer as t};

const WIDTH: Width = Width::I32;

/// The clock counts whole milliseconds.
const MILLISECOND: i64 = 1_000_000;

impl Scan<'_, '_> {
    /// The clock of that system: a program's first scan is at the end of its first interval.
    fn tick_clock(&mut self) -> Number {
        let now = self.word(Word::TIME);
        let graph = &mut self.world.graph;
        let now = graph.add(&now, &Number::constant(self.interval));
        let now = graph.min(&now, &Number::constant(i64::MAX));
        let whole = graph.div(&now, &Number::constant(MILLISECOND)).0;
        graph.mul(&whole, &Number::constant(MILLISECOND), 64).as_word()
    }

    /// Whether as much time has passed as the base says, and how the next step begins where a condition holds. It is told by
    /// the scans since then, where the clock moves evenly; a copy of a timer has no such age.
    fn base_is_over(&mut self, bits: Bit, words: Word, base: &Number) -> Lit {
        if self.times == Times::Open {
            let any = self.world.graph.leaf();
            self.world.times.push(any);
            return any;
        }
        let since = words.offset(t::SINCE);
        if self.is_even(since) {
            let scans = base.known().map(|base| scans_of(base, self.interval));
            let most = scans.unwrap_or(ANY_AGE).clamp(1, ANY_AGE);
            let age = self.memory.age(self.world, bits, most);
            let graph = &mut self.world.graph;
            return match scans {
                Some(scans) => !graph.less(&age, &Number::constant(scans as i64)),
                None => {
                    let passed = graph.mul(&age, &Number::constant(self.interval), 128);
                    !graph.less(&passed, base)
                }
            };
        }
        let (now, since) = (self.tick_clock(), self.word(since));
        let graph = &mut self.world.graph;
        let passed = graph.sub(&now, &since);
        let passed = graph.min(&passed, &Number::constant(i64::MAX));
        !graph.less(&passed, base)
    }

    fn is_even(&self, since: Word) -> bool {
        self.alone.is_some() || self.interval % MILLISECOND == 0 && !self.memory.changes(since)
    }

    /// The next step begins now, where a condition holds.
    fn begin_step(&mut self, when: Lit, bits: Bit, words: Word) {
        if self.times == Times::Open {
            return;
        }
        let since = words.offset(t::SINCE);
        if self.is_even(since) {
            let age = self.memory.known_age(bits);
            let age = age.unwrap_or_else(|| self.memory.age(self.world, bits, ANY_AGE));
            let when = self.world.graph.and(self.act, when);
            let age = self.world.graph.choose_number(when, &Number::constant(0), &age);
            return self.memory.set_age(bits, age);
        }
        let now = self.tick_clock();
        self.write_word_if(when, since, &now);
    }

    pub(super) fn tick_timer(&mut self, routine: Routine, pool: &[u32]) {
        let [out, en, preset, bits, words, base, ..] = *pool else {
            return;
        };
        let (bits, words) = (Bit(bits), Word(words));
        let (en, preset) = (self.bit(Bit(en)), self.word(Word(preset)));
        self.write_bit(bits.offset(t::IN), en);
        self.write_word(words.offset(t::PT), preset.clone());
        let (was_done, count) = (self.bit(bits.offset(t::Q)), self.word(words.offset(t::ET)));
        let base = self.word(Word(base));
        let scans = base.known().zip(preset.known());
        let scans = scans.map(|(base, preset)| scans_of(base.saturating_mul(preset), self.interval));
        self.world.presets.insert(bits.0, scans);
        let over = self.base_is_over(bits, words, &base);
        let graph = &mut self.world.graph;
        let steps = graph.all([en, !was_done, over]);
        let more = graph.add(&count, &Number::constant(1)).wrapped(WIDTH);
        let count = graph.choose_number(steps, &more, &count);
        let count = graph.choose_number(en, &count, &Number::constant(0));
        let reached = !graph.less(&count, &preset);
        let reached = graph.and(steps, reached);
        let done = graph.or(was_done, reached);
        let done = graph.and(en, done);
        let begins = graph.or(!en, steps);
        self.begin_step(begins, bits, words);
        self.write_word(words.offset(t::ET), count);
        self.write_bit(bits.offset(t::Q), done);
        let power = match routine {
            Routine::TickTon => done,
            _ => self.world.graph.and(en, !done),
        };
        self.write_bit(Bit(out), power);
    }

    pub(super) fn reset_tick_timer(&mut self, pool: &[u32]) {
        let [en, bits, words, start, ..] = *pool else {
            return;
        };
        let (en, bits, words) = (self.bit(Bit(en)), Bit(bits), Word(words));
        let start = self.word(Word(start));
        self.write_bit_if(en, bits.offset(t::Q), Lit::FALSE);
        self.write_bit_if(en, bits.offset(t::IN), Lit::FALSE);
        self.write_word_if(en, words.offset(t::ET), &start);
        self.begin_step(en, bits, words);
    }

    pub(super) fn latching_counter(&mut self, routine: Routine, pool: &[u32]) {
        let [out, en, preset, bits, words, ..] = *pool else {
            return;
        };
        let (bits, words) = (Bit(bits), Word(words));
        let (en, preset) = (self.bit(Bit(en)), self.word(Word(preset)));
        self.write_bit(bits.offset(c::CU), en);
        self.write_word(words.offset(c::PV), preset.clone());
        let (was_done, counted) = (self.bit(bits.offset(c::Q)), self.bit(bits.offset(c::CHANGED)));
        let count = self.word(words.offset(c::CV));
        self.world.counts.push((words.0, count.bit(0), preset.known()));
        let is_up = routine == Routine::LatchingCtu;
        let graph = &mut self.world.graph;
        let counts = graph.and(en, !counted);
        let step = Number::constant(if is_up { 1 } else { -1 });
        let next = graph.add(&count, &step).wrapped(WIDTH);
        let count = graph.choose_number(counts, &next, &count);
        let (low, high) = if is_up {
            (&count, &preset)
        } else {
            (&preset, &count)
        };
        let beyond = graph.less(low, high);
        let reached = graph.and(counts, !beyond);
        let done = graph.or(was_done, reached);
        let power = graph.and(en, done);
        self.write_word(words.offset(c::CV), count);
        self.write_bit(bits.offset(c::CHANGED), en);
        self.write_bit(bits.offset(c::Q), done);
        self.write_bit(Bit(out), power);
    }

    pub(super) fn reset_latching_counter(&mut self, pool: &[u32]) {
        let [en, bits, words, start, ..] = *pool else {
            return;
        };
        let (en, bits, words) = (self.bit(Bit(en)), Bit(bits), Word(words));
        let start = self.word(Word(start));
        self.write_bit_if(en, bits.offset(c::Q), Lit::FALSE);
        self.write_bit_if(en, bits.offset(c::CHANGED), Lit::FALSE);
        self.write_word_if(en, words.offset(c::CV), &start);
    }
}

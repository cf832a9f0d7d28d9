//! The timers (LANGUAGE §5.3), as the simulator has them. Where it holds the instant at which a timer began, here is its age:
//! how many scans ago that was.

use super::{Scan, Times};
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Word, timer};

/// An age that no preset of a tag is larger than: 292 years in milliseconds take no more.
pub(super) const ANY_AGE: u64 = 1 << 44;

/// A timer that is evaluated: what it is given, and what it compares.
struct Timer {
    bits: Bit,
    words: Word,
    input: Lit,
    reset: Lit,
    pt: Number,
    phase: Vec<Lit>,
    age: Number,
    /// The largest age that counts.
    most: u64,
}

impl Scan<'_, '_> {
    /// Copies the inputs into the members.
    fn timer(&mut self, [en, bits]: [Bit; 2], [pt, words]: [Word; 2]) -> Timer {
        let (en, reset) = (self.bit(en), self.bit(bits.offset(timer::R)));
        let input = self.world.graph.and(en, !reset);
        self.write_bit(bits.offset(timer::IN), input);
        let pt = self.word(pt);
        self.write_word(words.offset(timer::PT), pt.clone());
        let scans = pt.known().map(|pt| scans_of(pt, self.interval));
        let entry = self.world.presets.entry(bits.0).or_insert(Some(1));
        *entry = entry.zip(scans).map(|(most, scans)| most.max(scans));
        let most = entry.unwrap_or(ANY_AGE).clamp(1, ANY_AGE);
        let age = match self.times {
            Times::Exact => self.memory.age(self.world, bits, most),
            Times::Open => Number::constant(1),
        };
        Timer {
            bits,
            words,
            input,
            reset,
            pt,
            phase: self.memory.phase(self.world, bits),
            age,
            most,
        }
    }

    /// It begins now, where this holds.
    fn begin(&mut self, timer: &mut Timer, where_: Lit) {
        timer.age = self
            .world
            .graph
            .choose_number(where_, &Number::constant(0), &timer.age);
    }

    /// Whether as much time has passed as its preset says. Where times are open it may have, but for a timer that begins now
    /// and has a preset.
    fn has_run_out(&mut self, timer: &Timer, begins: Lit) -> Lit {
        if self.times == Times::Open {
            let any = self.world.graph.leaf();
            self.world.times.push(any);
            return match timer.pt.known() {
                Some(..=0) => Lit::TRUE,
                Some(_) => self.world.graph.and(any, !begins),
                None => any,
            };
        }
        match timer.pt.known() {
            Some(pt) => {
                let scans = Number::constant(scans_of(pt, self.interval) as i64);
                !self.world.graph.less(&timer.age, &scans)
            }
            None => {
                let elapsed = self.elapsed(timer);
                !self.world.graph.less(&elapsed, &timer.pt)
            }
        }
    }

    /// The time since it began, in nanoseconds.
    fn elapsed(&mut self, timer: &Timer) -> Number {
        if self.times == Times::Open {
            return self.any_time();
        }
        let interval = Number::constant(self.interval);
        let time = self.world.graph.mul(&timer.age, &interval, 128);
        self.world.graph.min(&time, &Number::constant(i64::MAX))
    }

    fn any_time(&mut self) -> Number {
        let bits: Vec<Lit> = (0..63).map(|_| self.world.graph.leaf()).collect();
        self.world.times.extend(&bits);
        Number::unsigned(bits)
    }

    /// The preset, and 0 for one below it.
    fn limit(&mut self, timer: &Timer) -> Number {
        self.world.graph.max(&timer.pt, &Number::constant(0))
    }

    /// The ET of the last evaluation.
    fn last_elapsed(&mut self, timer: &Timer) -> Number {
        let most = match self.world.presets.get(&timer.bits.0) {
            // The ages of all presets that it has, in nanoseconds.
            Some(Some(scans)) => (*scans as i64).saturating_mul(self.interval),
            _ => i64::MAX,
        };
        self.memory
            .elapsed(self.world, timer.words.offset(timer::ET), most)
    }

    fn finish_timer(&mut self, out: Bit, timer: Timer, phase: Vec<Lit>, q: Lit, et: Number) {
        // What is written of the ET has the room that is remembered of it.
        self.last_elapsed(&timer);
        if self.times == Times::Exact {
            let old = self.memory.age(self.world, timer.bits, timer.most);
            let age = self.world.graph.choose_number(self.act, &timer.age, &old);
            self.memory.set_age(timer.bits, age);
        }
        let phase = phase.into_iter().zip(&timer.phase);
        let phase = phase.map(|(new, old)| self.world.graph.choose(self.act, new, *old));
        let phase = phase.collect();
        self.memory.set_phase(timer.bits, phase);
        self.write_word(timer.words.offset(timer::ET), et);
        self.write_bit(timer.bits.offset(timer::Q), q);
        self.write_bit(out, q);
    }

    /// Phases: 0 idle, 1 running, 2 done.
    pub(super) fn ton(&mut self, [out, en, bits]: [Bit; 3], words: [Word; 2], _at: u32) {
        let mut timer = self.timer([en, bits], words);
        let (running, done) = (timer.phase[0], timer.phase[1]);
        let graph = &mut self.world.graph;
        let is_idle = graph.and(!running, !done);
        let begins = graph.and(timer.input, is_idle);
        self.begin(&mut timer, begins);
        let over = self.has_run_out(&timer, begins);
        let (elapsed, limit) = (self.elapsed(&timer), self.limit(&timer));
        let graph = &mut self.world.graph;
        let over = graph.or(over, done);
        let q = graph.and(timer.input, over);
        let running = graph.and(timer.input, !over);
        let time = graph.min(&elapsed, &limit);
        let et = graph.choose_number(timer.input, &time, &Number::constant(0));
        self.finish_timer(out, timer, vec![running, q, Lit::FALSE], q, et);
    }

    /// Phases: 0 idle, 1 running, 2 done, 3 armed.
    pub(super) fn tof(&mut self, [out, en, bits]: [Bit; 3], words: [Word; 2], _at: u32) {
        let mut timer = self.timer([en, bits], words);
        let (one, two) = (timer.phase[0], timer.phase[1]);
        let graph = &mut self.world.graph;
        let armed = graph.and(one, two);
        let was_running = graph.and(one, !two);
        let low = graph.and(!timer.input, !timer.reset);
        let begins = graph.and(armed, low);
        self.begin(&mut timer, begins);
        let over = self.has_run_out(&timer, begins);
        let (elapsed, limit, last) = (
            self.elapsed(&timer),
            self.limit(&timer),
            self.last_elapsed(&timer),
        );
        let graph = &mut self.world.graph;
        let runs = graph.or(armed, was_running);
        let running = graph.and(runs, !over);
        let time = graph.choose_number(runs, &elapsed, &last);
        let time = graph.min(&time, &limit);
        let et = graph.choose_number(low, &time, &Number::constant(0));
        // Low: running 1, done 2 or idle 0 as before; input: 3; reset: 0.
        let ends = graph.and(runs, over);
        let was_done = graph.and(!one, two);
        let is_done = graph.or(ends, was_done);
        let low_one = graph.and(low, running);
        let low_two = graph.and(low, is_done);
        let new_one = graph.or(timer.input, low_one);
        let new_two = graph.or(timer.input, low_two);
        let q = new_one;
        self.finish_timer(out, timer, vec![new_one, new_two, Lit::FALSE], q, et);
    }

    /// Phases: 0 idle, 1 running, 2 done; the third bit that EN was high.
    pub(super) fn tp(&mut self, [out, en, bits]: [Bit; 3], words: [Word; 2], _at: u32) {
        let high = self.bit(en);
        let mut timer = self.timer([en, bits], words);
        let (one, two, was_high) = (timer.phase[0], timer.phase[1], timer.phase[2]);
        let limit = self.limit(&timer);
        let graph = &mut self.world.graph;
        let rises = graph.and(high, !was_high);
        let is_idle = graph.and(!one, !two);
        let is_running = graph.and(one, !two);
        let has_preset = graph.less(&Number::constant(0), &timer.pt);
        let starts = graph.all([is_idle, rises, has_preset, !timer.reset]);
        let over = self.has_run_out(&timer, Lit::FALSE);
        let (elapsed, last) = (self.elapsed(&timer), self.last_elapsed(&timer));
        self.begin(&mut timer, starts);
        let graph = &mut self.world.graph;
        let not_reset = !timer.reset;
        let goes_on = graph.all([is_running, !over, not_reset]);
        let ends = graph.all([is_running, over, high, not_reset]);
        let is_neither = graph.and(!is_idle, !is_running);
        let stays_done = graph.all([is_neither, high, not_reset]);
        let q = graph.or(starts, goes_on);
        let done = graph.or(ends, stays_done);
        let mut et = graph.choose_number(goes_on, &elapsed, &Number::constant(0));
        et = graph.choose_number(ends, &limit, &et);
        let last = graph.min(&last, &limit);
        et = graph.choose_number(stays_done, &last, &et);
        // A phase of 3 does not come to be: it is taken for done.
        self.finish_timer(out, timer, vec![q, done, high], q, et);
    }

    /// The first bit of the phase: the last evaluation was one that time is added from.
    pub(super) fn rto(&mut self, [out, en, bits]: [Bit; 3], words: [Word; 2], at: u32) {
        let mut timer = self.timer([en, bits], words);
        let counting = timer.phase[0];
        let (elapsed, limit, last) = (
            self.elapsed(&timer),
            self.limit(&timer),
            self.last_elapsed(&timer),
        );
        let graph = &mut self.world.graph;
        let adds = graph.and(timer.input, counting);
        let more = graph.add(&last, &elapsed);
        let et = graph.choose_number(adds, &more, &last);
        let et = graph.min(&et, &limit);
        let has_preset = graph.less(&Number::constant(0), &timer.pt);
        let over = self.retentive_over(&timer, &et, at);
        let graph = &mut self.world.graph;
        let q = graph.choose(has_preset, over, timer.input);
        let q = graph.and(q, !timer.reset);
        let et = graph.choose_number(timer.reset, &Number::constant(0), &et);
        let input = timer.input;
        let not_reset = !timer.reset;
        self.begin(&mut timer, not_reset);
        self.finish_timer(out, timer, vec![input, Lit::FALSE, Lit::FALSE], q, et);
    }

    /// The bits of the phase: counting, EN was high once, the time has not run out.
    pub(super) fn rtof(&mut self, [out, en, bits]: [Bit; 3], words: [Word; 2], at: u32) {
        let mut timer = self.timer([en, bits], words);
        let (counting, fell, on) = (timer.phase[0], timer.phase[1], timer.phase[2]);
        let (elapsed, limit, last) = (
            self.elapsed(&timer),
            self.limit(&timer),
            self.last_elapsed(&timer),
        );
        let graph = &mut self.world.graph;
        let counts = graph.all([!timer.input, fell, counting]);
        let more = graph.add(&last, &elapsed);
        let et = graph.choose_number(counts, &more, &last);
        let over = self.retentive_over(&timer, &et, at);
        let graph = &mut self.world.graph;
        let et = graph.min(&et, &limit);
        let et = graph.choose_number(timer.reset, &Number::constant(0), &et);
        let ends = graph.all([!timer.input, fell, over]);
        let stays_on = graph.and(on, !ends);
        let new_on = graph.or(timer.input, stays_on);
        let new_fell = graph.or(timer.input, fell);
        // As it was where EN is low and never was high.
        let kept = graph.or(fell, counting);
        let new_counting = graph.and(!timer.input, kept);
        let not_reset = !timer.reset;
        let phase = [new_counting, new_fell, new_on].map(|bit| self.world.graph.and(bit, not_reset));
        self.begin(&mut timer, not_reset);
        let q = phase[2];
        self.finish_timer(out, timer, phase.to_vec(), q, et);
    }

    fn retentive_over(&mut self, timer: &Timer, et: &Number, _at: u32) -> Lit {
        if self.times == Times::Open {
            return self.has_run_out(timer, Lit::FALSE);
        }
        let limit = self.limit(timer);
        !self.world.graph.less(et, &limit)
    }

    /// `(RES)` on a timer where EN is high. A pulse timer remembers EN.
    pub(super) fn clear_timer(&mut self, en: Lit, is_pulse: bool, bits: Bit, words: Word) {
        let phase = self.memory.phase(self.world, bits);
        let clears = self.world.graph.and(self.act, en);
        let cleared = phase.iter().enumerate().map(|(n, bit)| {
            if n == 2 && is_pulse {
                *bit
            } else {
                self.world.graph.and(*bit, !clears)
            }
        });
        let cleared = cleared.collect();
        self.memory.set_phase(bits, cleared);
        self.write_word_if(en, words.offset(timer::ET), &Number::constant(0));
        self.write_bit_if(en, bits.offset(timer::Q), Lit::FALSE);
    }
}

/// How many scans a preset takes: none where it is not above 0.
pub(super) fn scans_of(pt: i64, interval: i64) -> u64 {
    let interval = interval.max(1);
    (pt.max(0) / interval + i64::from(pt.max(0) % interval != 0)).unsigned_abs()
}

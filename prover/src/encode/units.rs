//! Timers that count time in a unit, and counters whose output compares, as Click controllers have them.

use super::timers::{ANY_AGE, scans_of};
use super::{Scan, Times};
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Routine, Word, counter as c, timer as t};

/// What a timer can count to.
const MOST_UNITS: i64 = i16::MAX as i64;

impl Scan<'_, '_> {
    /// Phase: bit 0 that time passed in the last evaluation, bit 1 that EN of an off-delay was high once. What is less than a
    /// unit is kept in steps of what unit and interval have in common. False: it is not followed.
    pub(super) fn unit_timer(&mut self, routine: Routine, pool: &[u32]) -> bool {
        let [out, en, preset, bits, words, unit, interval, rest, ..] = *pool else {
            return true;
        };
        let (bits, words, rest) = (Bit(bits), Word(words), Word(rest));
        let (Some(unit), Some(interval)) = (self.word(Word(unit)).known(), self.word(Word(interval)).known())
        else {
            return false;
        };
        let (unit, interval) = (unit.max(1), interval.max(1));
        let common = crate::number::common(unit, interval);
        let (unit, step) = (unit / common, interval / common);

        let reset = self.bit(bits.offset(t::R));
        let (en, preset) = (self.bit(Bit(en)), self.word(Word(preset)));
        let en = self.world.graph.and(en, !reset);
        self.write_bit(bits.offset(t::IN), en);
        self.write_word(words.offset(t::PT), preset.clone());
        let nanoseconds = unit.saturating_mul(common);
        let scans = preset
            .known()
            .map(|preset| scans_of(preset.saturating_mul(nanoseconds), interval));
        self.world.presets.insert(bits.0, scans);
        let phase = self.memory.phase(self.world, bits);
        let was_counting = phase[0];
        let is_off = matches!(routine, Routine::UnitTof | Routine::UnitRtof);
        let graph = &mut self.world.graph;
        let either = graph.or(en, phase[1]);
        let armed = graph.all([Lit::constant(is_off), !reset, either]);
        let counts = if is_off {
            graph.and(armed, !en)
        } else {
            graph.and(!reset, en)
        };
        let clears = match routine {
            Routine::UnitTon => graph.or(reset, !en),
            Routine::UnitTof => graph.or(reset, en),
            _ => reset,
        };
        let count = self.word(words.offset(t::ET));
        let zero = Number::constant(0);
        let rest_now = match unit {
            1 => zero.clone(),
            _ => self.memory.up_to(self.world, rest, unit - 1),
        };
        let (units, over) = self.units_passed(bits, &rest_now, was_counting, (unit, step, interval));
        let graph = &mut self.world.graph;
        let next = graph.add(&count, &units);
        let next = graph.min(&next, &Number::constant(MOST_UNITS));
        let counting = graph.and(counts, !clears);
        let mut keep = |next: &Number, old: &Number| {
            let value = graph.choose_number(counting, next, old);
            graph.choose_number(clears, &zero, &value)
        };
        let (count, over) = (keep(&next, &count), keep(&over, &rest_now));
        self.write_word(words.offset(t::ET), count.clone());
        self.write_word(rest, over);
        let phase = [counts, armed, phase[2]].into_iter().zip(&phase);
        let phase = phase.map(|(new, old)| self.world.graph.choose(self.act, new, *old));
        let phase = phase.collect();
        self.memory.set_phase(bits, phase);
        if let Some(age) = self.memory.known_age(bits) {
            let age = self.world.graph.choose_number(self.act, &zero, &age);
            self.memory.set_age(bits, age);
        }
        let graph = &mut self.world.graph;
        let reached = !graph.less(&count, &preset);
        let q = match routine {
            Routine::UnitTon => graph.and(en, reached),
            Routine::UnitRto => reached,
            _ => {
                let runs = graph.and(armed, !reached);
                graph.or(en, runs)
            }
        };
        let q = graph.and(q, !reset);
        self.write_bit(bits.offset(t::Q), q);
        self.write_bit(Bit(out), q);
        true
    }

    /// How many units are over, and what is left of the last one. The first evaluation is for a whole scan.
    fn units_passed(
        &mut self,
        timer: Bit,
        rest: &Number,
        was_counting: Lit,
        (unit, step, interval): (i64, i64, i64),
    ) -> (Number, Number) {
        if self.times == Times::Open {
            let bits: Vec<Lit> = (0..15).map(|_| self.world.graph.leaf()).collect();
            self.world.times.extend(&bits);
            return (Number::unsigned(bits), rest.clone());
        }
        // More than it can count to makes no difference.
        let longest = MOST_UNITS
            .saturating_add(1)
            .saturating_mul(unit)
            .saturating_mul(interval / step);
        let most = scans_of(longest, interval).clamp(1, ANY_AGE);
        let age = self.memory.age(self.world, timer, most);
        let graph = &mut self.world.graph;
        let passed = graph.mul(&age, &Number::constant(step), 64);
        let passed = graph.choose_number(was_counting, &passed, &Number::constant(step));
        let time = graph.add(rest, &passed);
        match unit {
            1 => (time, Number::constant(0)),
            _ => graph.div(&time, &Number::constant(unit)),
        }
    }

    pub(super) fn comparing_counter(&mut self, routine: Routine, pool: &[u32]) {
        let [out, en, preset, bits, words, ..] = *pool else {
            return;
        };
        let (bits, words) = (Bit(bits), Word(words));
        let (en, preset) = (self.bit(Bit(en)), self.word(Word(preset)));
        self.write_bit(bits.offset(c::CU), en);
        self.write_word(words.offset(c::PV), preset.clone());
        let down = self.bit(bits.offset(c::CD));
        let mut rises = [Lit::FALSE; 2];
        for (rise, (high, before)) in rises.iter_mut().zip([(en, c::UP_BEFORE), (down, c::DOWN_BEFORE)]) {
            let was = self.bit(bits.offset(before));
            self.write_bit(bits.offset(before), high);
            *rise = self.world.graph.and(high, !was);
        }
        let [first, second] = rises.map(Number::of_bit);
        let (reset, load) = (self.bit(bits.offset(c::R)), self.bit(bits.offset(c::LD)));
        let before = self.word(words.offset(c::CV));
        self.world.counts.push((words.0, before.bit(0), preset.known()));
        let zero = Number::constant(0);
        let graph = &mut self.world.graph;
        let step = match routine {
            Routine::ComparingCtu => first,
            Routine::ComparingCtd => graph.sub(&zero, &first),
            _ => graph.sub(&first, &second),
        };
        let count = graph.add(&before, &step);
        let count = graph.min(&count, &Number::constant(i32::MAX.into()));
        let count = graph.max(&count, &Number::constant(i32::MIN.into()));
        let count = graph.choose_number(load, &preset, &count);
        let count = graph.choose_number(reset, &zero, &count);
        let same = graph.equal(&count, &before);
        let empty = !graph.less(&zero, &count);
        let reached = match routine {
            Routine::ComparingCtd => !graph.less(&preset, &count),
            _ => !graph.less(&count, &preset),
        };
        let q = graph.and(reached, !reset);
        self.write_word(words.offset(c::CV), count);
        self.write_bit(bits.offset(c::CHANGED), !same);
        if routine == Routine::ComparingCtud {
            self.write_bit(bits.offset(c::QD), empty);
        }
        self.write_bit(bits.offset(c::Q), q);
        self.write_bit(Bit(out), q);
    }
}

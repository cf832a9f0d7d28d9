//! Timers that count scans and counters of 16 bits, as LDmicro has them.

use super::Scan;
use crate::graph::Lit;
use crate::number::Number;
use ladder_simulator::compiled::{Bit, Routine, Width, Word, counter as c, timer as t};

impl Scan<'_, '_> {
    pub(super) fn scan_timer(&mut self, routine: Routine, pool: &[u32]) {
        let [out, en, preset, bits, words, started, ..] = *pool else {
            return;
        };
        let (bits, words) = (Bit(bits), Word(words));
        let (en, preset) = (self.bit(Bit(en)), self.word(Word(preset)));
        self.write_bit(bits.offset(t::IN), en);
        self.write_word(words.offset(t::PT), preset.clone());
        let first = !self.bit(Bit(started));
        self.write_bit(Bit(started), Lit::TRUE);
        let count = self.word(words.offset(t::ET));
        let zero = Number::constant(0);
        let graph = &mut self.world.graph;
        let count = match routine {
            // It begins as if it had run out.
            Routine::ScanTof => graph.choose_number(first, &preset, &count),
            _ => count,
        };
        let more = graph.add(&count, &Number::constant(1)).wrapped(Width::I16);
        let is_less = graph.less(&count, &preset);
        let (q, count) = match routine {
            Routine::ScanTon => {
                let counted = graph.choose_number(is_less, &more, &count);
                (graph.and(en, !is_less), graph.choose_number(en, &counted, &zero))
            }
            Routine::ScanTof => {
                let counted = graph.choose_number(is_less, &more, &count);
                (graph.or(en, is_less), graph.choose_number(en, &zero, &counted))
            }
            _ => {
                let counts = graph.and(en, is_less);
                (!is_less, graph.choose_number(counts, &more, &count))
            }
        };
        self.write_word(words.offset(t::ET), count);
        self.write_bit(bits.offset(t::Q), q);
        self.write_bit(Bit(out), q);
    }

    pub(super) fn wrapping_counter(&mut self, routine: Routine, pool: &[u32]) {
        let [out, en, most, bits, words, before, ..] = *pool else {
            return;
        };
        let (bits, words) = (Bit(bits), Word(words));
        let (en, most, was_high) = (self.bit(Bit(en)), self.word(Word(most)), self.bit(Bit(before)));
        let rose = self.world.graph.and(en, !was_high);
        self.write_bit(Bit(before), en);
        self.write_bit(bits.offset(c::CU), en);
        self.write_word(words.offset(c::PV), most.clone());
        let was = self.word(words.offset(c::CV));
        self.world.counts.push((words.0, was.bit(0), most.known()));
        let graph = &mut self.world.graph;
        let step = Number::constant(if routine == Routine::WrappingCtd { -1 } else { 1 });
        let mut next = graph.add(&was, &step).wrapped(Width::I16);
        if routine == Routine::WrappingCtc {
            let is_over = graph.less(&most, &next);
            next = graph.choose_number(is_over, &Number::constant(0), &next);
        }
        let count = graph.choose_number(rose, &next, &was);
        let q = match routine {
            // Its power is EN.
            Routine::WrappingCtc => en,
            _ => !graph.less(&count, &most),
        };
        let same = graph.equal(&count, &was);
        self.write_word(words.offset(c::CV), count);
        self.write_bit(bits.offset(c::CHANGED), !same);
        self.write_bit(bits.offset(c::Q), q);
        self.write_bit(Bit(out), q);
    }
}

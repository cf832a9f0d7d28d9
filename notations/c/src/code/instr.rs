//! One instruction as statements of C.

use super::{Emitter, b, operator, w, width};
use crate::pieces::PIECES;
use ladder_analysis::values::compound::EnumId;
use ladder_simulator::compiled::{Bit, Instr, Routine, TYPES, Test, Word};

impl Emitter<'_> {
    /// A comparison of something with itself, of which compilers warn. No tag holds what is not equal to itself.
    fn same(&mut self, test: Test, out: Bit, en: Bit) {
        let holds = [Test::EQ, Test::GE, Test::LE].contains(&test);
        self.bit(out, if holds { b(en) } else { "0".into() });
    }

    #[allow(clippy::too_many_lines, reason = "one line for each instruction")]
    pub(super) fn instr(&mut self, at: u32, instr: Instr) {
        match instr {
            Instr::Contact { out, en, tag } => self.bit(out, format!("{} & {}", b(en), b(tag))),
            Instr::NegatedContact { out, en, tag } => {
                self.bit(out, format!("(uint8_t)({} & ({} ^ 1))", b(en), b(tag)));
            }
            Instr::Join { out, upper, lower } => self.bit(out, format!("{} | {}", b(upper), b(lower))),
            Instr::Invert { out, en } => self.bit(out, format!("{} ^ 1", b(en))),
            Instr::Follow { out, en } => self.bit(out, b(en)),
            Instr::Rail { out } => {
                let rail = if self.zones { "frame.rail" } else { "1" };
                self.bit(out, rail);
            }
            Instr::Rising { out, en, tag, before } => {
                let piece = self.uses("rising");
                self.bit(out, format!("{piece}({}, {}, &b[{}])", b(en), b(tag), before.0));
            }
            Instr::Falling { out, en, tag, before } => {
                let piece = self.uses("falling");
                self.bit(out, format!("{piece}({}, {}, &b[{}])", b(en), b(tag), before.0));
            }
            Instr::Compare {
                test,
                out,
                en,
                a,
                b: other,
            }
            | Instr::CompareReal {
                test,
                out,
                en,
                a,
                b: other,
            } if a == other => {
                self.same(test, out, en);
            }
            Instr::CompareBit {
                test,
                out,
                en,
                a,
                b: other,
            } if a == other => self.same(test, out, en),
            Instr::Compare {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.bit(
                    out,
                    format!("{} & ({} {} {})", b(en), w(a), operator(test), w(other)),
                );
            }
            Instr::CompareUnsigned {
                test,
                a_unsigned,
                b_unsigned,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("order");
                let order = format!("order({}, {a_unsigned}, {}, {b_unsigned})", w(a), w(other));
                self.bit(out, format!("{} & ({order} {} 0)", b(en), operator(test)));
            }
            Instr::CompareReal {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("to_real");
                let (a, other) = (format!("to_real({})", w(a)), format!("to_real({})", w(other)));
                self.bit(out, format!("{} & ({a} {} {other})", b(en), operator(test)));
            }
            Instr::CompareBit {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.bit(
                    out,
                    format!("{} & ({} {} {})", b(en), b(a), operator(test), b(other)),
                );
            }
            Instr::CompareText {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("text_order");
                let order = format!("text_order(self, {}, {})", a.0, other.0);
                self.bit(out, format!("{} & ({order} {} 0)", b(en), operator(test)));
            }
            Instr::Coil { en, tag } => self.bit(tag, b(en)),
            Instr::NegatedCoil { en, tag } => self.bit(tag, format!("{} ^ 1", b(en))),
            Instr::Set { en, tag } => self.line(format!("if ({}) b[{}] = 1;", b(en), tag.0)),
            Instr::Reset { en, tag } => self.line(format!("if ({}) b[{}] = 0;", b(en), tag.0)),
            Instr::Powered { out, en, end } => {
                self.bit(out, b(en));
                self.line(format!("if (!b[{}]) goto L{end};", out.0));
            }
            Instr::MoveBit { to, from } => self.bit(to, b(from)),
            Instr::AndBit { to, a, b: other } => self.bit(to, format!("{} & {}", b(a), b(other))),
            Instr::OrBit { to, a, b: other } => self.bit(to, format!("{} | {}", b(a), b(other))),
            Instr::XorBit { to, a, b: other } => self.bit(to, format!("{} ^ {}", b(a), b(other))),
            Instr::NotBit { to, a } => self.bit(to, format!("{} ^ 1", b(a))),
            Instr::LoadBitOf { to, word, bit } => {
                self.bit(to, format!("(uint8_t)((uint64_t){} >> {bit} & 1)", w(word)));
            }
            Instr::StoreBitOf {
                word,
                bit,
                width: wide,
                from,
            } => {
                self.uses("wrap");
                let mask = format!("(UINT64_C(1) << {bit})");
                let cleared = format!("((uint64_t){} & ~{mask})", w(word));
                let value = format!("(int64_t)({cleared} | (uint64_t){} << {bit})", b(from));
                self.line(format!("{} = wrap({}, {value});", w(word), width(wide)));
            }
            Instr::Move { to, from } => self.line(format!("{} = {};", w(to), w(from))),
            Instr::MoveWhen { out, en, to, from } => {
                self.bit(out, b(en));
                self.line(format!("if (b[{}]) {} = {};", out.0, w(to), w(from)));
            }
            Instr::Integer {
                op,
                width: wide,
                to,
                a,
                b: other,
            } => self.integer(at, None, op, wide, [to, a, other]),
            Instr::IntegerWhen {
                op,
                width: wide,
                out,
                en,
                to,
                a,
                b: other,
            } => {
                self.bit(out, b(en));
                self.integer(at, Some(out), op, wide, [to, a, other]);
            }
            Instr::Real {
                op,
                single,
                to,
                a,
                b: other,
            } => self.real(at, None, op, single, [to, a, other]),
            Instr::RealWhen {
                op,
                single,
                out,
                en,
                to,
                a,
                b: other,
            } => {
                self.bit(out, b(en));
                self.real(at, Some(out), op, single, [to, a, other]);
            }
            Instr::RealFunction {
                function,
                single,
                to,
                a,
            } => self.function(at, function, single, to, a),
            Instr::Convert { conversion, to, from } => self.convert(at, conversion, to, from),
            Instr::BitToWord { to, from } => self.line(format!("{} = {};", w(to), b(from))),
            Instr::MoveText { to, from } => self.text(to.0.to_string(), from.0.to_string()),
            Instr::Index { to, index, array } => {
                let place = self.code.arrays[array as usize];
                self.uses("index_of");
                let call = format!(
                    "index_of(&{}, {}, {}, {}, {})",
                    w(to),
                    w(index),
                    place.base,
                    crate::data::number(place.first),
                    crate::data::number(place.last)
                );
                self.faulting(at, &call);
            }
            Instr::LoadBit { to, at: slot } => self.bit(to, format!("b[{}]", w(slot))),
            Instr::StoreBit { at: slot, from } => self.line(format!("b[{}] = {};", w(slot), b(from))),
            Instr::LoadWord { to, at: slot } => self.line(format!("{} = w[{}];", w(to), w(slot))),
            Instr::StoreWord { at: slot, from } => self.line(format!("w[{}] = {};", w(slot), w(from))),
            Instr::LoadText { to, at: slot } => self.text(to.0.to_string(), format!("(uint32_t){}", w(slot))),
            Instr::StoreText { at: slot, from } => {
                self.text(format!("(uint32_t){}", w(slot)), from.0.to_string());
            }
            Instr::Ton {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("ton", [out, en, bits], pt, words),
            Instr::Tof {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("tof", [out, en, bits], pt, words),
            Instr::Tp {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("tp", [out, en, bits], pt, words),
            Instr::Rto {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("rto", [out, en, bits], pt, words),
            Instr::Rtof {
                out,
                en,
                pt,
                bits,
                words,
            } => self.timer("rtof", [out, en, bits], pt, words),
            Instr::Ctu {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctu", [out, en, bits], pv, words),
            Instr::Ctd {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctd", [out, en, bits], pv, words),
            Instr::Ctud {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctud", [out, en, bits], pv, words),
            Instr::Ctc {
                out,
                en,
                pv,
                bits,
                words,
            } => self.counter("ctc", [out, en, bits], pv, words),
            Instr::Sr { out, en, reset, bits } => {
                self.bit(
                    bits,
                    format!("(uint8_t)({} | (b[{}] & ({} ^ 1)))", b(en), bits.0, b(reset)),
                );
                self.bit(out, b(bits));
            }
            Instr::Rs { out, en, reset, bits } => {
                self.bit(
                    bits,
                    format!("(uint8_t)(({} ^ 1) & ({} | b[{}]))", b(reset), b(en), bits.0),
                );
                self.bit(out, b(bits));
            }
            Instr::Clear {
                en,
                state,
                bits,
                words,
            } => self.clear(en, state, &bits.0.to_string(), &words.0.to_string()),
            Instr::ClearAt {
                en,
                state,
                bits,
                words,
            } => self.clear(en, state, &w(bits), &w(words)),
            Instr::StateAt {
                op,
                out,
                en,
                operand,
                bits,
                words,
            } => self.chosen_state(op, out, en, operand, bits, words),
            Instr::Routine { routine, operands } => self.routine(at, routine, operands),
            _ => self.flow(at, instr),
        }
    }

    fn text(&mut self, to: String, from: String) {
        self.uses("move_text");
        self.line(format!("move_text(self, {to}, {from});"));
    }

    fn routine(&mut self, at: u32, routine: Routine, operands: u32) {
        let pool = &self.code.operands[operands as usize..];
        if routine == Routine::Enumerate {
            let values = usize::try_from(pool[1])
                .ok()
                .and_then(|number| EnumId::from_number(number.checked_sub(TYPES.len())? as u32));
            let (to, from) = (w(Word(pool[0])), w(Word(pool[2])));
            if let Some(id) = values {
                let tests: Vec<String> = (id.get().values.iter().map(|(_, value)| *value))
                    .map(|value| format!("{from} == {}", crate::data::number(value.into())))
                    .collect();
                let call = format!("({} ? ({to} = {from}, 0) : FAULT_RANGE)", tests.join(" || "));
                self.faulting(at, &call);
            } else {
                self.line(format!("{to} = {from};"));
            }
            return;
        }
        let name = format!("{routine:?}");
        let known = PIECES.named(&name).filter(|_| !Self::needs_more(routine, pool));
        let Some(piece) = known else {
            self.body.missing.push((at, Self::in_words(routine)));
            return;
        };
        self.uses(piece);
        self.faulting(at, &format!("{piece}(self, operands + {operands})"));
    }

    /// Whether a routine works on what only some types have, and C has no text for.
    fn needs_more(routine: Routine, pool: &[u32]) -> bool {
        let has_no_text = |ty: &u32| TYPES.get(*ty as usize).is_none_or(|ty| ty.is_date());
        match routine {
            Routine::Format => has_no_text(&pool[2]),
            Routine::Parse => has_no_text(&pool[1]),
            _ => false,
        }
    }

    /// What a routine needs that C libraries do not have.
    fn in_words(routine: Routine) -> &'static str {
        match routine {
            Routine::Format | Routine::Parse => "dates as texts",
            Routine::SendScanTime
            | Routine::ReceiveNewest
            | Routine::SendWhenFree
            | Routine::SendTextSlowly => "the serial port of the controller whose profile the program names",
            _ => "the timers, counters and registers of the controller whose profile the program names",
        }
    }
}

//! One instruction as statements of C.

use super::term::{Rank, Term};
use super::{Emitter, operator, width};
use crate::pieces::PIECES;
use ladder_analysis::values::compound::EnumId;
use ladder_simulator::compiled::{Bit, Instr, Routine, TYPES, Test, Word};

impl Emitter<'_> {
    /// A comparison of something with itself, of which compilers warn. No tag holds what is not equal to itself.
    fn same(&mut self, test: Test, out: Bit, en: Bit) {
        let holds = [Test::EQ, Test::GE, Test::LE].contains(&test);
        let term = if holds { self.term(en) } else { Term::atom("0") };
        self.power(out, term);
    }

    #[allow(clippy::too_many_lines, reason = "one line for each instruction")]
    pub(super) fn instr(&mut self, at: u32, instr: Instr) {
        match instr {
            Instr::Rail { out } | Instr::Follow { out, .. } if self.always.contains(&out) => {}
            Instr::Contact { out, en, tag } => self.power(out, self.term(en).and(self.term(tag))),
            Instr::NegatedContact { out, en, tag } => {
                self.power(out, self.term(en).and(!self.term(tag)));
            }
            Instr::Join { out, upper, lower } => self.power(out, self.term(upper).or(self.term(lower))),
            Instr::Invert { out, en } => self.power(out, !self.term(en)),
            Instr::Follow { out, en } => self.power(out, self.term(en)),
            Instr::Rail { out } => {
                let rail = if self.zones { "frame.rail" } else { "1" };
                self.power(out, Term::atom(rail));
            }
            Instr::Rising { out, en, tag, before } => {
                let piece = self.uses("rising");
                let call = format!("{piece}({}, {}, &b[{}])", self.whole(en), self.b(tag), before.0);
                self.remembered(out, call);
            }
            Instr::Falling { out, en, tag, before } => {
                let piece = self.uses("falling");
                let call = format!("{piece}({}, {}, &b[{}])", self.whole(en), self.b(tag), before.0);
                self.remembered(out, call);
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
                let holds = format!("{} {} {}", self.number(a), operator(test), self.number(other));
                self.power(out, self.term(en).and(Term::comparison(holds)));
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
                let order = format!(
                    "order({}, {a_unsigned}, {}, {b_unsigned})",
                    self.w(a),
                    self.w(other)
                );
                let holds = Term::comparison(format!("{order} {} 0", operator(test)));
                self.power(out, self.term(en).and(holds));
            }
            Instr::CompareReal {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                self.uses("to_real");
                let (a, other) = (
                    format!("to_real({})", self.w(a)),
                    format!("to_real({})", self.w(other)),
                );
                let holds = Term::comparison(format!("{a} {} {other}", operator(test)));
                self.power(out, self.term(en).and(holds));
            }
            Instr::CompareBit {
                test,
                out,
                en,
                a,
                b: other,
            } => {
                let holds = format!("{} {} {}", self.b(a), operator(test), self.b(other));
                self.power(out, self.term(en).and(Term::comparison(holds)));
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
                let holds = Term::comparison(format!("{order} {} 0", operator(test)));
                self.power(out, self.term(en).and(holds));
            }
            Instr::Coil { en, tag } => self.bit(tag, self.whole(en)),
            Instr::NegatedCoil { en, tag } => self.bit(tag, (!self.term(en)).within(Rank::Or)),
            Instr::Set { en, tag } => self.line(format!("if ({}) {} = 1;", self.whole(en), self.slot(tag))),
            Instr::Reset { en, tag } => self.line(format!("if ({}) {} = 0;", self.whole(en), self.slot(tag))),
            Instr::Powered { out, .. } if self.always.contains(&out) => {}
            Instr::MoveWhen { out, to, from, .. } if self.always.contains(&out) => {
                self.line(format!("{} = {};", self.w(to), self.w(from)));
            }
            Instr::MoveWhen { out, en, to, from } if self.unread.contains(&out) => {
                self.line(format!(
                    "if ({}) {} = {};",
                    self.whole(en),
                    self.w(to),
                    self.w(from)
                ));
            }
            Instr::Powered { out, en, end } => {
                self.bit(out, self.whole(en));
                self.line(format!("if (!{}) goto L{end};", self.slot(out)));
            }
            Instr::MoveBit { to, from } => self.power(to, self.term(from)),
            Instr::AndBit { to, a, b } => self.power(to, self.term(a).and(self.term(b))),
            Instr::OrBit { to, a, b } => self.power(to, self.term(a).or(self.term(b))),
            Instr::XorBit { to, a, b } => {
                let differ = format!("{} != {}", self.b(a), self.b(b));
                self.power(to, Term::comparison(differ));
            }
            Instr::NotBit { to, a } => self.power(to, !self.term(a)),
            Instr::LoadBitOf { to, word, bit } => {
                let shifted = format!("(uint8_t)((uint64_t){} >> {bit} & 1)", self.w(word));
                self.power(to, Term::atom(shifted));
            }
            Instr::StoreBitOf {
                word,
                bit,
                width: wide,
                from,
            } => {
                self.uses("wrap");
                let mask = format!("(UINT64_C(1) << {bit})");
                let cleared = format!("((uint64_t){} & ~{mask})", self.w(word));
                let value = format!("(int64_t)({cleared} | (uint64_t){} << {bit})", self.b(from));
                self.line(format!("{} = wrap({}, {value});", self.w(word), width(wide)));
            }
            Instr::Move { to, from } => self.line(format!("{} = {};", self.w(to), self.w(from))),
            Instr::MoveWhen { out, en, to, from } => {
                self.bit(out, self.whole(en));
                self.line(format!(
                    "if ({}) {} = {};",
                    self.slot(out),
                    self.w(to),
                    self.w(from)
                ));
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
                self.bit(out, self.whole(en));
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
                self.bit(out, self.whole(en));
                self.real(at, Some(out), op, single, [to, a, other]);
            }
            Instr::RealFunction {
                function,
                single,
                to,
                a,
            } => self.function(at, function, single, to, a),
            Instr::Convert { conversion, to, from } => self.convert(at, conversion, to, from),
            Instr::BitToWord { to, from } => self.line(format!("{} = {};", self.w(to), self.whole(from))),
            Instr::MoveText { to, from } => self.text(to.0.to_string(), from.0.to_string()),
            Instr::Index { to, index, array } => {
                let place = self.code.arrays[array as usize];
                self.uses("index_of");
                let call = format!(
                    "index_of(&{}, {}, {}, {}, {})",
                    self.w(to),
                    self.w(index),
                    place.base,
                    crate::data::number(place.first),
                    crate::data::number(place.last)
                );
                self.faulting(at, &call);
            }
            Instr::LoadBit { to, at: slot } => {
                self.power(to, Term::atom(format!("b[{}]", self.w(slot))));
            }
            Instr::StoreBit { at: slot, from } => {
                self.line(format!("b[{}] = {};", self.w(slot), self.whole(from)));
            }
            Instr::LoadWord { to, at: slot } => self.line(format!("{} = w[{}];", self.w(to), self.w(slot))),
            Instr::StoreWord { at: slot, from } => {
                self.line(format!("w[{}] = {};", self.w(slot), self.w(from)));
            }
            Instr::LoadText { to, at: slot } => {
                self.text(to.0.to_string(), format!("(uint32_t){}", self.w(slot)));
            }
            Instr::StoreText { at: slot, from } => {
                self.text(format!("(uint32_t){}", self.w(slot)), from.0.to_string());
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
                    format!(
                        "(uint8_t)({} | (b[{}] & ({} ^ 1)))",
                        self.b(en),
                        bits.0,
                        self.b(reset)
                    ),
                );
                self.bit(out, self.b(bits));
            }
            Instr::Rs { out, en, reset, bits } => {
                self.bit(
                    bits,
                    format!(
                        "(uint8_t)(({} ^ 1) & ({} | b[{}]))",
                        self.b(reset),
                        self.b(en),
                        bits.0
                    ),
                );
                self.bit(out, self.b(bits));
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
            } => self.clear(en, state, &self.w(bits), &self.w(words)),
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
            let (to, from) = (self.w(Word(pool[0])), self.w(Word(pool[2])));
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

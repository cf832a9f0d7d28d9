//! Timers, counters, bistables.

use super::Emitter;
use ladder_instructions::{Op, StateType};
use ladder_simulator::compiled::{Bit, Word};

impl Emitter<'_> {
    pub(super) fn timer(&mut self, piece: &'static str, [out, en, bits]: [Bit; 3], pt: Word, words: Word) {
        let state = (format!("b + {}", bits.0), format!("w + {}", words.0));
        self.state(piece, out, en, &self.number(pt), &state);
    }

    pub(super) fn counter(&mut self, piece: &'static str, [out, en, bits]: [Bit; 3], pv: Word, words: Word) {
        let state = (format!("b + {}", bits.0), format!("w + {}", words.0));
        self.state(piece, out, en, &self.number(pv), &state);
    }

    /// A timer or counter whose state begins at these places.
    pub(super) fn state(
        &mut self,
        piece: &'static str,
        out: Bit,
        en: Bit,
        preset: &str,
        (bits, words): &(String, String),
    ) {
        self.uses(piece);
        let of_time = if piece.starts_with('c') { "" } else { "self, " };
        let call = format!("{piece}({of_time}{bits}, {words}, {}, {preset})", self.whole(en));
        self.remembered(out, call);
    }

    /// The state of an instruction that an index has chosen.
    pub(super) fn chosen_state(&mut self, op: Op, out: Bit, en: Bit, operand: u32, bits: Word, words: Word) {
        let piece = match op {
            Op::Ton => "ton",
            Op::Tof => "tof",
            Op::Tp => "tp",
            Op::Rto => "rto",
            Op::Rtof => "rtof",
            Op::Ctu => "ctu",
            Op::Ctd => "ctd",
            Op::Ctud => "ctud",
            Op::Ctc => "ctc",
            _ => {
                let (set, reset, q) = (self.b(en), self.b(Bit(operand)), format!("b[{}]", self.w(bits)));
                let value = if op == Op::Sr {
                    format!("{set} | ({q} & ({reset} ^ 1))")
                } else {
                    format!("({reset} ^ 1) & ({set} | {q})")
                };
                self.line(format!("{q} = (uint8_t)({value});"));
                self.bit(out, q);
                return;
            }
        };
        let state = (format!("b + {}", self.w(bits)), format!("w + {}", self.w(words)));
        self.state(piece, out, en, &self.w(Word(operand)), &state);
    }

    pub(super) fn clear(&mut self, en: Bit, state: StateType, bits: &str, words: &str) {
        use StateType as S;
        let action = if state.is_timer() {
            self.uses("clear_timer");
            format!("clear_timer(b + {bits}, w + {words}, {})", state == S::Tp)
        } else if state.is_counter() {
            self.uses("clear_counter");
            let kind = match state {
                S::Ctd => 1,
                S::Ctud => 2,
                S::Ctc => 3,
                _ => 0,
            };
            format!("clear_counter(b + {bits}, w + {words}, {kind})")
        } else {
            format!("b[{bits}] = 0")
        };
        self.line(format!("if ({}) {action};", self.whole(en)));
    }
}

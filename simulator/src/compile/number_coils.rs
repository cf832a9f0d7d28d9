//! Coils on numbers, where a BOOL is a number that is not 0 ([`Truth::NotZero`](ladder_instructions::Truth)).

use super::arguments::Arguments;
use super::place::Slot;
use super::{Compiler, Result};
use crate::code::Instr;
use crate::memory::Bit;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::{Coil, Edge};

/// Whether what a coil writes is a number.
pub(super) fn is_number_coil(arguments: Arguments) -> bool {
    arguments.place(0).is_ok_and(|(_, ty)| ty.is_number())
}

impl Compiler<'_> {
    /// Writes 1 for high and 0 for low.
    pub(super) fn coil_on_number(&mut self, coil: Coil, arguments: Arguments, en: Bit) -> Result<Bit> {
        let (place, ty) = arguments.place(0)?;
        let constant = match coil {
            Coil::Sets => Some(1),
            Coil::Resets => Some(0),
            Coil::Follows | Coil::Negated | Coil::OnEdge(_) => None,
        };
        if let Some(number) = constant {
            let (out, start) = self.begin_powered(en);
            let spot = self.spot(place)?;
            let value = Slot::Word(self.constant(number));
            let value = self.pass(value, Scalar::Dint, ty);
            self.store(spot, value);
            self.end_powered(start);
            return Ok(out);
        }
        let high = match coil {
            Coil::Negated => {
                let to = self.layout.bit();
                self.emit(Instr::NotBit { to, a: en });
                to
            }
            Coil::OnEdge(edge) => {
                let memory = self.edge_memory(Some(place))?;
                self.edge_with(memory, Bit::HIGH, en, edge == Edge::Rising)
            }
            Coil::Follows | Coil::Sets | Coil::Resets => en,
        };
        let spot = self.spot(place)?;
        let word = self.layout.word();
        self.emit(Instr::BitToWord { to: word, from: high });
        let value = self.pass(Slot::Word(word), Scalar::Dint, ty);
        self.store(spot, value);
        Ok(en)
    }
}

//! One-shots, timers, counters.

use super::{Result, Translator};
use crate::mnemonic::Role;
use crate::types::Ty;
use ladder_format::Circuit;
use ladder_format::program::Element;

impl Translator<'_> {
    /// A block that keeps its state in its operands.
    pub(super) fn state_block(&mut self, name: &str, operands: &[&str]) -> Result<Circuit<Element>> {
        let is_counter = matches!(name, "CTU" | "CTD");
        let mut texts = Vec::new();
        for text in operands {
            let place = self.target(text, if is_counter { Role::Counter } else { Role::Bit })?;
            let fits = match place.ty {
                Ty::Structure(index) => is_counter && self.tags.types.all[index].original == "COUNTER",
                _ => !is_counter && place.elem() == Some(crate::types::Elem::Bool),
            };
            if !fits {
                let what = if is_counter { "COUNTER" } else { "bit" };
                return Err(format!("`{text}` is no {what}"));
            }
            texts.push(place.text);
        }
        let block = self.blocks.plain(name);
        Ok(self.block(format!("[{block}]( {} )", texts.join(", "))))
    }

    pub(super) fn timer(&mut self, name: &str, operands: &[&str]) -> Result<Circuit<Element>> {
        let place = self.target(operands[0], Role::Timer)?;
        if !matches!(place.ty, Ty::Structure(index) if self.tags.types.all[index].original == "TIMER") {
            return Err(format!("`{}` is no TIMER", operands[0]));
        }
        let block = self.blocks.plain(name);
        if self.is_slc() {
            self.note_first("here ACC of a timer may pass PRE, where a controller stops it");
        }
        let unit = match operands {
            [_, base, _, _] => match self.expr(base)? {
                crate::operand::Expr::Int(1) => ", T#1s",
                crate::operand::Expr::Real(1.0) => ", T#1s",
                crate::operand::Expr::Real(0.01) => ", T#10ms",
                crate::operand::Expr::Real(0.001) => "",
                _ => return Err(format!("`{base}` is no time base: there are 1.0, 0.01 and 0.001")),
            },
            _ => "",
        };
        Ok(self.block(format!("[{block}]( {}{unit} )", place.text)))
    }

    pub(super) fn reset(&mut self, text: &str) -> Result<Circuit<Element>> {
        let place = self.target(text, Role::State)?;
        let name = match place.ty {
            Ty::Structure(index) => match self.tags.types.all[index].original.as_str() {
                "TIMER" => "TimerRES",
                "COUNTER" => "CounterRES",
                "CONTROL" => "ControlRES",
                _ => return Err(format!("`{text}` is no TIMER, COUNTER or CONTROL")),
            },
            _ => return Err(format!("`{text}` is no TIMER, COUNTER or CONTROL")),
        };
        let block = self.blocks.plain(name);
        Ok(self.block(format!("[{block}]( {} )", place.text)))
    }
}

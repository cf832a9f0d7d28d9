//! One-shots, timers, counters.

use super::{Result, Translator};
use crate::mnemonic::Role;
use crate::operand::Expr;
use crate::types::{Elem, Ty};
use ladder_format::Circuit;
use ladder_format::program::{Element, Expression};

/// The type of the tag of such an instruction, and the members that it works on.
pub(crate) const fn tagged(name: &str) -> (&'static str, &'static [&'static str]) {
    match name.as_bytes() {
        b"SCL" => (
            "SCALE",
            &[
                "In", "InRawMax", "InRawMin", "InEUMax", "InEUMin", "Limiting", "Out", "MaxAlarm", "MinAlarm",
            ],
        ),
        _ => (
            "FBD_TIMER",
            &["TimerEnable", "PRE", "Reset", "ACC", "EN", "TT", "DN"],
        ),
    }
}

impl Translator<'_> {
    /// A block that keeps its state in its operands.
    pub(super) fn state_block(&mut self, name: &str, operands: &[&str]) -> Result<Circuit<Element>> {
        let is_counter = matches!(name, "CTU" | "CTD");
        let mut own = Vec::new();
        for text in operands {
            let place = self.target(text, if is_counter { Role::Counter } else { Role::Bit })?;
            let fits = if is_counter {
                self.tags.types.original(&place.ty) == "COUNTER"
            } else {
                place.elem() == Some(Elem::Bool)
            };
            if !fits {
                let what = if is_counter { "COUNTER" } else { "bit" };
                return Err(format!("`{text}` is no {what}"));
            }
            own.push(place.path);
        }
        let block = self.blocks.plain(name);
        self.user(&block, own)
    }

    pub(super) fn timer(&mut self, name: &str, operands: &[&str]) -> Result<Circuit<Element>> {
        let place = self.target(operands[0], Role::Timer)?;
        if self.tags.types.original(&place.ty) != "TIMER" {
            return Err(format!("`{}` is no TIMER", operands[0]));
        }
        let block = self.blocks.plain(name);
        if self.is_slc() {
            self.note_first("here ACC of a timer may pass PRE, where a controller stops it");
        }
        let unit = match operands {
            [_, base, _, _] => match self.expr(base)? {
                Expr::Int(1) | Expr::Real(1.0) => Some("T#1s"),
                Expr::Real(0.01) => Some("T#10ms"),
                Expr::Real(0.001) => None,
                _ => return Err(format!("`{base}` is no time base: there are 1.0, 0.01 and 0.001")),
            },
            _ => None,
        };
        let mut own = vec![Expression::from(place.path)];
        if let Some(unit) = unit {
            own.push(Expression::literal(unit)?);
        }
        self.user(&block, own)
    }

    /// An instruction whose inputs and outputs are members of its tag.
    pub(super) fn tagged(&mut self, name: &str, text: &str) -> Result<Circuit<Element>> {
        let place = self.target(text, Role::Word)?;
        let (ty, members) = tagged(name);
        let own = match place.ty {
            Ty::Structure(index) if self.tags.types.original(&place.ty).eq_ignore_ascii_case(ty) => index,
            _ => return Err(format!("`{text}` is no {ty}")),
        };
        let missing = members
            .iter()
            .find(|member| self.tags.types.member(own, member).is_none());
        if let Some(member) = missing {
            return Err(format!("`{text}` has no `{member}`"));
        }
        let block = self.blocks.plain(name);
        self.user(&block, [place.path])
    }

    pub(super) fn reset(&mut self, text: &str) -> Result<Circuit<Element>> {
        let place = self.target(text, Role::State)?;
        let name = match self.tags.types.original(&place.ty) {
            "TIMER" => "TimerRES",
            "COUNTER" => "CounterRES",
            "CONTROL" => "ControlRES",
            _ => return Err(format!("`{text}` is no TIMER, COUNTER or CONTROL")),
        };
        let block = self.blocks.plain(name);
        self.user(&block, [place.path])
    }
}

//! Contacts and coils, and those on bits whose number is computed: `w.[i]`.

use super::{Result, Translator};
use crate::blocks::OTE_BIT;
use crate::mnemonic::Role;
use crate::operand::{Expr, Step};
use crate::scope::Place;
use crate::types::Elem;
use crate::unit::operand;
use ladder_format::Circuit;
use ladder_format::program::{Element, Expression, Operator};
use ladder_instructions::Op;

impl Translator<'_> {
    pub(super) fn bit(&mut self, text: &str) -> Result<Place> {
        let place = self.place(text, Role::Bit)?;
        match place.elem() {
            Some(Elem::Bool) => Ok(place),
            _ => Err(format!("`{text}` is no bit")),
        }
    }

    pub(super) fn contact(&mut self, own: Op, text: &str) -> Result<Circuit<Element>> {
        if let Some((word, index)) = self.computed_bit(text)? {
            let shifted = Expression::from(word.path).with(Operator::Shr, index);
            let is_on = shifted.with(Operator::And, 1).with(Operator::NotEqual, 0);
            return self.computed(own, is_on, "bit", text);
        }
        let place = self.bit(text)?;
        self.op(own, [place.path])
    }

    /// The word and the number of a bit that is computed, `w.[i]`.
    fn computed_bit(&mut self, text: &str) -> Result<Option<(Place, Expression)>> {
        let Expr::Path(mut word) = operand(self.project.family, text)? else {
            return Ok(None);
        };
        let Some(Step::ComputedBit(index)) = word.steps.pop() else {
            return Ok(None);
        };
        let word = self.tags.place(self.scope, &word, Role::Value)?;
        if !word.elem().is_some_and(Elem::is_integer) {
            return Err(format!("`{}` has no bits", word.path));
        }
        let index = self.tags.formula(self.scope, &index)?;
        Ok(Some((word, index)))
    }

    /// A coil on a bit that is computed. One that also clears is a block, which runs without power too.
    fn coil_on_computed(&mut self, own: Op, word: &Place, index: Expression) -> Result<Circuit<Element>> {
        let path = &word.path;
        if word.parameter.is_some() || word.is_system() {
            return Err(format!("`{path}` cannot be written here"));
        }
        let bit = |index: Expression| Expression::from(1).with(Operator::Shl, index);
        let whole = Expression::from(path);
        match (own, &index) {
            (Op::SetCoil, _) => self.put(Op::Calc, path, whole.with(Operator::Or, bit(index))),
            (Op::ResetCoil, _) => self.put(Op::Calc, path, whole.with(Operator::And, bit(index).negated())),
            (_, Expression::Path(_) | Expression::Literal(_)) => {
                let elem = word.elem().unwrap_or(Elem::Dint);
                let block = self.blocks.on_word(OTE_BIT, elem);
                self.user(&block, [whole, index])
            }
            _ => Err(format!("the number of a bit of `{path}` is a formula")),
        }
    }

    pub(super) fn coil(&mut self, own: Op, text: &str) -> Result<Circuit<Element>> {
        if let Some((word, index)) = self.computed_bit(text)? {
            return self.coil_on_computed(own, &word, index);
        }
        let place = self.target(text, Role::Bit)?;
        match place.elem() {
            Some(Elem::Bool) => self.op(own, [place.path]),
            _ => Err(format!("`{text}` is no bit")),
        }
    }
}

//! Contacts and coils, and those on bits whose number is computed: `w.[i]`.

use super::{Result, Translator};
use crate::blocks::{ONS_BIT, OTE_BIT};
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
        if let Some(is_on) = self.is_computed_bit_on(text)? {
            return self.computed(own, is_on, "bit", text);
        }
        let place = self.bit(text)?;
        self.op(own, [place.path])
    }

    /// Whether a bit whose number is computed is on, as a formula. None: it is not such a bit.
    pub(super) fn is_computed_bit_on(&mut self, text: &str) -> Result<Option<Expression>> {
        let computed = self.computed_bit(text)?;
        Ok(computed.map(|(word, index)| {
            let shifted = Expression::from(word.path).with(Operator::Shr, index);
            shifted.with(Operator::And, 1).with(Operator::NotEqual, 0)
        }))
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
        if word.is_output || word.is_system() {
            return Err(format!("`{path}` cannot be written here"));
        }
        let bit = |index: Expression| Expression::from(1).with(Operator::Shl, index);
        let whole = Expression::from(path);
        match (own, &index) {
            (Op::SetCoil, _) => self.put(Op::Calc, path, whole.with(Operator::Or, bit(index))),
            (Op::ResetCoil, _) => self.put(Op::Calc, path, whole.with(Operator::And, bit(index).negated())),
            _ => self.on_computed(OTE_BIT, word, index),
        }
    }

    /// A block that works on a bit whose number is computed.
    fn on_computed(&mut self, name: &str, word: &Place, index: Expression) -> Result<Circuit<Element>> {
        let path = &word.path;
        if !matches!(index, Expression::Path(_) | Expression::Literal(_)) {
            return Err(format!("the number of a bit of `{path}` is a formula"));
        }
        let block = self.blocks.on_word(name, word.elem().unwrap_or(Elem::Dint));
        self.user(&block, [Expression::from(path), index])
    }

    /// `ONS`
    pub(super) fn one_shot(&mut self, storage: &str) -> Result<Circuit<Element>> {
        match self.computed_bit(storage)? {
            Some((word, _)) if word.is_output || word.is_system() => {
                Err(format!("`{}` cannot be written here", word.path))
            }
            Some((word, index)) => self.on_computed(ONS_BIT, &word, index),
            None => self.state_block("ONS", &[storage]),
        }
    }

    /// `OSR`: with a bit whose number is computed it is an `ONS` and a coil beside the rung.
    pub(super) fn one_shot_rising(&mut self, storage: &str, out: &str) -> Result<Circuit<Element>> {
        if self.computed_bit(storage)?.is_none() && self.computed_bit(out)?.is_none() {
            return self.state_block("OSR", &[storage, out]);
        }
        let pulse = vec![self.one_shot(storage)?, self.coil(Op::Coil, out)?];
        let passes = Circuit::Series(Vec::new());
        Ok(Circuit::Parallel(vec![Circuit::Series(pulse), passes]))
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

//! Instructions that go through elements or call a routine several times: the rung says how often, and a loop after it does it.

use super::{Result, Translator};
use crate::mnemonic::Role;
use crate::operand::Expr;
use crate::types::Elem;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Expression, Operand, Operator, Path};
use ladder_instructions::Op;

impl Translator<'_> {
    /// The mode of a file instruction as the blocks have it: 0 for all, -1 for one, else how many in a scan.
    fn mode(&mut self, text: &str) -> Result<i64> {
        match (text.to_ascii_uppercase().as_str(), self.expr(text)) {
            ("ALL", _) => Ok(0),
            ("INC", _) => Ok(-1),
            (_, Ok(Expr::Int(number))) if number > 0 => Ok(number),
            _ => Err(format!("`{text}` is no mode: ALL, INC or a number")),
        }
    }

    /// The block on the rung, and the tag that says how often.
    fn turns(&mut self, name: &str, operands: &[&str]) -> Result<(Circuit<Element>, Path, Path)> {
        let mode = self.mode(operands[3])?;
        let control = self.control(operands[0])?;
        let what = format!("how many elements {name} goes through");
        let turns = self.helper("turns", Elem::Dint, &what);
        let block = self.blocks.plain(name);
        let own = [Expression::from(&control), mode.into(), (&turns).into()];
        Ok((self.user(&block, own)?, control, turns))
    }

    /// On to the next element.
    fn next(&self, control: &Path) -> Result<Circuit<Element>> {
        let place = Expression::from(control.clone().member("POS"));
        self.op(Op::Add, [place.clone(), place, 1.into()])
    }

    /// What is after the loop.
    fn done(&self, control: &Path) -> Result<Circuit<Element>> {
        let member = |name: &str| control.clone().member(name);
        Ok(Circuit::Series(vec![
            self.block(Block::contact(member("EN"))),
            self.op(Op::Ge, [member("POS"), member("LEN")])?,
            self.op(Op::SetCoil, [member("DN")])?,
        ]))
    }

    /// `FAL`
    pub(super) fn file_arithmetic(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let formula = self.expr(operands[5])?;
        let each = self.compute(operands[4], &formula)?;
        let (call, control, turns) = self.turns("FAL", operands)?;
        let after = [
            self.op(Op::For, [turns])?,
            Circuit::Series(vec![each, self.next(&control)?]),
            self.op(Op::Next, Operand::NONE)?,
            self.done(&control)?,
        ];
        self.after.extend(after);
        self.note("its elements are computed right after the rung");
        Ok(call)
    }

    /// `FSC`
    pub(super) fn file_search(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let found = self.compare_formula(operands[4])?;
        let (call, control, turns) = self.turns("FSC", operands)?;
        let member = |name: &str| control.clone().member(name);
        let searches = self.block(Block::negated_contact(member("IN")));
        let found = vec![
            searches.clone(),
            found,
            self.op(Op::SetCoil, [member("FD")])?,
            self.op(Op::SetCoil, [member("IN")])?,
        ];
        let after = [
            self.op(Op::For, [turns])?,
            Circuit::Series(found),
            Circuit::Series(vec![searches, self.next(&control)?]),
            self.op(Op::Next, Operand::NONE)?,
            self.done(&control)?,
        ];
        self.after.extend(after);
        self.note("its elements are searched right after the rung");
        Ok(call)
    }

    /// `FOR( routine, index, first, last, step )`
    pub(super) fn repeat(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let routine = operands[0];
        let (function, leaves) = self.called(routine)?;
        let index = self.target(operands[1], Role::Value)?;
        let mut values = Vec::new();
        for text in &operands[2..] {
            let expr = self.expr(text)?;
            values.push(self.value(&expr, Elem::Dint)?.0);
        }
        let [first, last, step] = &values[..] else {
            return Err("FOR has five operands".to_owned());
        };
        let turns = self.helper("turns", Elem::Dint, &format!("how often FOR calls {routine}"));
        let turn = self.helper("turn", Elem::Dint, &format!("the turn of FOR with {routine}"));
        let block = self.blocks.plain("FOR");
        let at = |turns: Expression| {
            let way = turns.with(Operator::Times, step.clone());
            self.put(Op::Calc, &index.path, first.clone().with(Operator::Plus, way))
        };
        let before = Expression::from(&turn).with(Operator::Minus, 1);
        let mut body = vec![at(before)?, self.block(Block::call(&function))];
        let end = self.op(Op::Ge, [Expression::from(&turns), 0.into()])?;
        let ends = Circuit::Series(vec![end, at((&turns).into())?]);
        let count = Operand::from(&turns);
        let begin = self.op(Op::For, [count, Operand::Taken("I".to_owned(), turn.into())])?;
        let mark = match leaves {
            None => None,
            Some(leaves) => {
                let label = self.tags.fresh(self.scope, "left");
                body.extend([
                    self.block(Block::contact(&leaves)),
                    self.op(Op::ResetCoil, [leaves])?,
                    self.block(Block::jump(&label)),
                ]);
                Some(self.block(Block::label(&label)))
            }
        };
        let next = self.op(Op::Next, Operand::NONE)?;
        let own = [first.clone(), last.clone(), step.clone(), turns.into()];
        let call = self.user(&block, own)?;
        let after = [begin, Circuit::Series(body), next, ends];
        self.after.extend(after.into_iter().chain(mark));
        self.note("the routine is called right after the rung");
        Ok(call)
    }

    /// `BRK`: the routine ends, and the loop that called it.
    pub(super) fn leave_loop(&mut self) -> Result<Circuit<Element>> {
        let routine = self.routine.clone();
        match self.called(&routine)? {
            (_, Some(leaves)) => Ok(Circuit::Series(vec![
                self.op(Op::SetCoil, [leaves])?,
                self.block(Block::ret()),
            ])),
            (_, None) => Err("no routine of the program is called in a loop here".to_owned()),
        }
    }
}

//! Instructions that go through elements or call a routine several times: the rung says how often, and a loop after it does it.

use super::{Result, Translator};
use crate::mnemonic::Role;
use crate::operand::Expr;
use crate::types::Elem;
use ladder_format::Circuit;
use ladder_format::program::Element;

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
    fn turns(&mut self, name: &str, operands: &[&str]) -> Result<(Circuit<Element>, String, String)> {
        let mode = self.mode(operands[3])?;
        let control = self.file_operand(operands[0], b'I', Elem::Dint)?;
        let what = format!("how many elements {name} goes through");
        let turns = self.helper("turns", Elem::Dint, &what);
        let block = self.blocks.plain(name);
        let call = self.block(format!("[{block}]( {control}, {mode}, {turns} )"));
        Ok((call, control, turns))
    }

    /// What is after the loop.
    fn done(&self, control: &str) -> Circuit<Element> {
        self.blocks([
            format!("[ ]( {control}.EN )"),
            format!("[GE]( {control}.POS, {control}.LEN )"),
            format!("(S)( {control}.DN )"),
        ])
    }

    /// `FAL`
    pub(super) fn file_arithmetic(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let formula = self.expr(operands[5])?;
        let each = self.compute(operands[4], &formula)?;
        let (call, control, turns) = self.turns("FAL", operands)?;
        let next = self.block(format!("[ADD]( {control}.POS, {control}.POS, 1 )"));
        let after = [
            self.block(format!("<FOR>( {turns} )")),
            Circuit::Series(vec![each, next]),
            self.block("<NEXT>"),
            self.done(&control),
        ];
        self.after.extend(after);
        self.note("its elements are computed right after the rung");
        Ok(call)
    }

    /// `FSC`
    pub(super) fn file_search(&mut self, operands: &[&str]) -> Result<Circuit<Element>> {
        let found = self.compare_formula(operands[4])?;
        let (call, control, turns) = self.turns("FSC", operands)?;
        let searches = || self.block(format!("[/]( {control}.IN )"));
        let found = vec![
            searches(),
            found,
            self.block(format!("(S)( {control}.FD )")),
            self.block(format!("(S)( {control}.IN )")),
        ];
        let next = vec![
            searches(),
            self.block(format!("[ADD]( {control}.POS, {control}.POS, 1 )")),
        ];
        let after = [
            self.block(format!("<FOR>( {turns} )")),
            Circuit::Series(found),
            Circuit::Series(next),
            self.block("<NEXT>"),
            self.done(&control),
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
        let mut texts = Vec::new();
        for text in &operands[2..] {
            let expr = self.expr(text)?;
            texts.push(self.value(&expr, Elem::Dint)?.0);
        }
        let [first, last, step] = &texts[..] else {
            return Err("FOR has five operands".to_owned());
        };
        let turns = self.helper("turns", Elem::Dint, &format!("how often FOR calls {routine}"));
        let turn = self.helper("turn", Elem::Dint, &format!("the turn of FOR with {routine}"));
        let block = self.blocks.plain("FOR");
        let at = |turns: &str| self.block(format!("[CALC]( {}, {first} + {turns} * {step} )", index.text));
        let mut body = vec![
            at(&format!("({turn} - 1)")),
            self.block(format!("<CALL>( {function} )")),
        ];
        let end = self.block(format!("[GE]( {turns}, 0 )"));
        let mut after = vec![self.block(format!("<FOR>( {turns}, I => {turn} )"))];
        let ends = Circuit::Series(vec![end, at(&turns)]);
        match leaves {
            None => after.extend([Circuit::Series(body), self.block("<NEXT>"), ends]),
            Some(leaves) => {
                let label = self.tags.fresh(self.scope, "left");
                body.extend([
                    self.block(format!("[ ]( {leaves} )")),
                    self.block(format!("(R)( {leaves} )")),
                    self.block(format!("<JMP>( {label} )")),
                ]);
                let mark = self.block(format!("<LBL>( {label} )"));
                after.extend([Circuit::Series(body), self.block("<NEXT>"), ends, mark]);
            }
        }
        let call = self.block(format!("[{block}]( {first}, {last}, {step}, {turns} )"));
        self.after.extend(after);
        self.note("the routine is called right after the rung");
        Ok(call)
    }

    /// `BRK`: the routine ends, and the loop that called it.
    pub(super) fn leave_loop(&mut self) -> Result<Circuit<Element>> {
        let routine = self.routine.clone();
        match self.called(&routine)? {
            (_, Some(leaves)) => Ok(self.blocks([format!("(S)( {leaves} )"), "<RET>".to_owned()])),
            (_, None) => Err("no routine of the program is called in a loop here".to_owned()),
        }
    }
}

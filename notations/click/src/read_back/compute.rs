//! Searches, formulas, and blocks that are formulas in Click.

use super::Back;
use super::value::Refusal;
use crate::bank::Kind;
use crate::calc;
use crate::model::{Formula, Instruction, Math, MathKind, Operator, Relation, Search};
use crate::operand::kind;
use ladder_analysis::program::{Argument, Bound};
use ladder_instructions::Op;

impl Back<'_> {
    pub(super) fn search(&self, arguments: &[Bound]) -> Result<Instruction, Refusal> {
        let [result, relation, value, among, named @ ..] = arguments else {
            return Err("the search lacks operands".to_owned());
        };
        let relation = match relation.argument {
            Argument::Operator(op) => Relation::of(op),
            _ => None,
        };
        let name_of = |bound: &Bound| bound.operand.map_or("", |operand| operand.name);
        let flag = named.iter().find(|bound| name_of(bound) == "FOUND");
        let flag = flag.ok_or("Click's search tells in a bit whether it found anything: give FOUND =>")?;
        let continuous = match named.iter().find(|bound| name_of(bound) == "NEXT") {
            None => false,
            Some(next) if self.pin(next)?.is_always() => true,
            Some(_) => return Err("a search of Click is continuous or is not: NEXT is always on".to_owned()),
        };
        Ok(Instruction::Search(Search {
            relation: relation.ok_or("the search has no relation")?,
            value: self.operand(value)?,
            among: self.span_of(among)?,
            result: self.tag(result)?,
            flag: self.tag(flag)?,
            continuous,
        }))
    }

    pub(super) fn math(&self, target: &Bound, formula: &Bound) -> Result<Instruction, Refusal> {
        let Argument::Value(expr) = &formula.argument else {
            return Err("Click has no such formula".to_owned());
        };
        let formula = self.formula(expr)?;
        let target = self.operand(target)?;
        let is_hex = kind(&target) == Some(Kind::Hex) || calc::parts(&formula).contains(&Kind::Hex);
        let kind = if is_hex { MathKind::Hex } else { MathKind::Decimal };
        Ok(Instruction::Math(Math {
            kind,
            formula,
            target,
        }))
    }

    /// `[ADD]( y, a, b )` and its like are formulas in Click.
    pub(super) fn arithmetic(&self, op: Op, target: &Bound, parts: &[Bound]) -> Result<Instruction, Refusal> {
        let operator = match op {
            Op::Add => Operator::Add,
            Op::Sub => Operator::Subtract,
            Op::Mul => Operator::Multiply,
            Op::Div => Operator::Divide,
            Op::Mod => Operator::Modulo,
            Op::And => Operator::And,
            Op::Or => Operator::Or,
            _ => Operator::Xor,
        };
        let target = self.operand(target)?;
        let mut formula: Option<Formula> = None;
        for part in parts {
            let part = Formula::Value(self.operand(part)?);
            formula = Some(match formula {
                None => part,
                Some(before) => Formula::Binary(Box::new(before), operator, Box::new(part)),
            });
        }
        let formula = formula.ok_or("it has no operands")?;
        let kind = match kind(&target) {
            Some(Kind::Hex) => MathKind::Hex,
            Some(Kind::Bit | Kind::Text) | None => return Err("Click computes with numbers".to_owned()),
            _ if matches!(op, Op::And | Op::Or | Op::Xor) => {
                return Err("Click combines the bits of WORDs only".to_owned());
            }
            _ => MathKind::Decimal,
        };
        Ok(Instruction::Math(Math {
            kind,
            formula,
            target,
        }))
    }
}

//! Instructions of Logix that the reader makes several blocks of, found again.

use super::block::{compared_values, number};
use super::network::{only, parts};
use super::rung::{Piece, Series, it};
use super::{Result, Writer};
use ladder_analysis::program::{
    Argument, BinaryOperator, Block, BlockKind, Expr, ExprKind, Network, Place, TagId, UnaryOperator,
};
use ladder_analysis::values::types::Scalar;
use ladder_format::Circuit;
use ladder_instructions::Op;

fn op_of(block: &Block) -> Option<Op> {
    match block.kind {
        BlockKind::Instruction(row) => Some(row.op),
        BlockKind::User(_) => None,
    }
}

fn value_at(block: &Block, number: usize) -> Option<&Expr> {
    match &block.arguments.get(number)?.argument {
        Argument::Value(value) => Some(value),
        _ => None,
    }
}

fn read(expr: &Expr) -> Option<TagId> {
    match &expr.kind {
        ExprKind::Read(Place::Tag(tag)) => Some(*tag),
        ExprKind::Pass(inner) => read(inner),
        _ => None,
    }
}

fn binary(expr: &Expr, wanted: BinaryOperator) -> Option<(&Expr, &Expr)> {
    match &expr.kind {
        ExprKind::Binary(operator, left, right) if *operator == wanted => Some((left, right)),
        ExprKind::Pass(inner) => binary(inner, wanted),
        _ => None,
    }
}

impl Writer<'_> {
    /// What the parts begin with as one instruction, and how many of them that are.
    pub(super) fn pattern(
        &mut self,
        network: &Network,
        series: &[Circuit<usize>],
    ) -> Result<Option<(Series, usize)>> {
        let block = |at: usize| match series.get(at) {
            Some(Circuit::Element(block)) => Some(&network.blocks[*block]),
            _ => None,
        };
        if let Some(Circuit::Parallel(legs)) = series.first() {
            let limits = self.limits(network, legs)?;
            return Ok(limits
                .filter(|(_, taken)| *taken == legs.len())
                .map(|(limits, _)| (only(limits), 1)));
        }
        let Some(first) = block(0) else { return Ok(None) };
        if op_of(first) == Some(Op::Typ)
            && let (Some(helper), Some(value)) = (self.helper(first), value_at(first, 1))
            && Self::is_simple(value)
            && series[1..].iter().any(|part| match part {
                Circuit::Element(block) => {
                    let op = op_of(&network.blocks[*block]);
                    op.is_none_or(|op| matches!(op, Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge))
                }
                _ => false,
            })
        {
            let value = self.value(value)?;
            self.absorb(helper, Some(value));
            return Ok(Some((Vec::new(), 1)));
        }
        if op_of(first) == Some(Op::Len)
            && let (Some(helper), Some(value)) = (self.helper(first), value_at(first, 1))
            && Self::is_simple(value)
        {
            let length = format!("{}.LEN", self.value(value)?);
            self.absorb(helper, Some(length));
            return Ok(Some((Vec::new(), 1)));
        }
        if op_of(first) == Some(Op::SetCoil)
            && let Some(Argument::Place(Place::Tag(tag), _)) =
                first.arguments.first().map(|bound| &bound.argument)
            && self.facts.leaves.contains(tag)
            && block(1).and_then(op_of) == Some(Op::Ret)
        {
            return Ok(Some((only(it("BRK", &[])), 2)));
        }
        if op_of(first) != Some(Op::Calc) {
            return Ok(None);
        }
        if let Some((copy, taken)) = self.bytes(network, series)? {
            return Ok(Some((only(copy), taken)));
        }
        let (Some(helper), Some(formula), Some(next)) = (self.helper(first), value_at(first, 1), block(1))
        else {
            return Ok(None);
        };
        if formula.ty == Scalar::Bool {
            // An input of an Add-On Instruction.
            if op_of(next).is_none()
                && self.input.is_own
                && let Some(bit) = self.computed_bit(formula)?
            {
                self.absorb(helper, Some(bit));
                return Ok(Some((Vec::new(), 1)));
            }
            let is_next = matches!(op_of(next), Some(Op::Contact | Op::NegatedContact));
            if !is_next || value_at(next, 0).and_then(read) != Some(helper) {
                return Ok(None);
            }
            let open = op_of(next) == Some(Op::Contact);
            let Some(piece) = self.computed(formula, open)? else {
                return Ok(None);
            };
            self.absorb(helper, None);
            return Ok(Some((only(piece), 2)));
        }
        // The sides of a comparison.
        let mut sides = vec![(helper, formula)];
        let mut compared = (next, 2);
        if op_of(next) == Some(Op::Calc)
            && let (Some(helper), Some(formula), Some(then)) =
                (self.helper(next), value_at(next, 1), block(2))
        {
            sides.push((helper, formula));
            compared = (then, 3);
        }
        let (Some((_, values)), Some(op)) = (compared_values(compared.0), op_of(compared.0)) else {
            return Ok(None);
        };
        let [left, right] = &values[..] else {
            return Ok(None);
        };
        let of = |value: &Expr| {
            let found = read(value).and_then(|tag| sides.iter().find(|(helper, _)| *helper == tag));
            found.map(|(_, formula)| (*formula).clone())
        };
        let (one, other) = (of(left), of(right));
        if usize::from(one.is_some()) + usize::from(other.is_some()) != sides.len() {
            return Ok(None);
        }
        let left = one.unwrap_or_else(|| (*left).clone());
        let right = other.unwrap_or_else(|| (*right).clone());
        let piece = self.compared(op, &left, &right)?;
        for (helper, _) in sides {
            self.absorb(helper, None);
        }
        Ok(Some((only(piece), compared.1)))
    }

    /// The helper that a block writes: a tag that the reader declared for one instruction.
    fn helper(&self, block: &Block) -> Option<TagId> {
        match &block.arguments.first()?.argument {
            Argument::Place(Place::Tag(tag), _) => self.facts.helpers.contains(tag).then_some(*tag),
            _ => None,
        }
    }

    /// Notes that a helper is not needed; what stands for it in operands.
    fn absorb(&mut self, helper: TagId, value: Option<String>) {
        let name = self.input.program.tags[helper.0 as usize].name.clone();
        self.facts.absorbed.insert(helper, value);
        self.facts.absorbed_names.insert(ladder_syntax::Name::new(&name));
    }

    /// `word.[index]`, whose formula this is.
    fn computed_bit(&mut self, formula: &Expr) -> Result<Option<String>> {
        if let ExprKind::Compare(Op::Ne, left, right) = &formula.kind
            && number(right) == Some(0.0)
            && let Some((shifted, one)) = binary(left, BinaryOperator::And)
            && number(one) == Some(1.0)
            && let Some((word, index)) = binary(shifted, BinaryOperator::Shr)
            && Self::is_simple(word)
        {
            let (word, index) = (self.value(word)?, self.formula(index)?);
            return Ok(Some(format!("{word}.[{index}]")));
        }
        Ok(None)
    }

    /// `word OR 1 SHL index` and `word AND NOT (1 SHL index)`, which the coils that latch such a bit become here.
    pub(super) fn latched_bit(&mut self, to: &str, formula: &Expr) -> Result<Option<Piece>> {
        let set = binary(formula, BinaryOperator::Or);
        let reset = || {
            let (word, not) = binary(formula, BinaryOperator::And)?;
            match &not.kind {
                ExprKind::Unary(UnaryOperator::Not, bit) => Some((word, &**bit)),
                _ => None,
            }
        };
        let (name, word, bit) = match (set, reset()) {
            (Some((word, bit)), _) => ("OTL", word, bit),
            (None, Some((word, bit))) => ("OTU", word, bit),
            (None, None) => return Ok(None),
        };
        let Some((one, index)) = binary(bit, BinaryOperator::Shl) else {
            return Ok(None);
        };
        if number(one) != Some(1.0) || !Self::is_simple(word) || !self.value(word)?.eq_ignore_ascii_case(to) {
            return Ok(None);
        }
        let index = self.formula(index)?;
        Ok(Some(it(name, &[&format!("{to}.[{index}]")])))
    }

    /// A formula that decides, as one instruction.
    fn computed(&mut self, formula: &Expr, open: bool) -> Result<Option<Piece>> {
        if let Some(bit) = self.computed_bit(formula)? {
            return Ok(Some(it(if open { "XIC" } else { "XIO" }, &[&bit])));
        }
        if let ExprKind::Compare(op, left, right) = &formula.kind
            && *op == Op::Eq
            && open
            && let (Some((source, mask)), Some((other, again))) = (
                binary(left, BinaryOperator::And),
                binary(right, BinaryOperator::And),
            )
            && Self::is_simple(source)
            && Self::is_simple(other)
            && Self::is_simple(mask)
            && self.source(mask.range) == self.source(again.range)
        {
            let (source, mask, other) = (self.value(source)?, self.value(mask)?, self.value(other)?);
            return Ok(Some(it("MEQ", &[&source, &mask, &other])));
        }
        if !open {
            return Ok(None);
        }
        let text = self.formula(formula)?;
        Ok(Some(it("CMP", &[&text])))
    }

    /// Legs that begin with a `LIM`, and how many they are.
    pub(super) fn limits(
        &mut self,
        network: &Network,
        legs: &[Circuit<usize>],
    ) -> Result<Option<(Piece, usize)>> {
        if !self.input.is_own {
            return Ok(None);
        }
        let compared = |circuit: &Circuit<usize>, name: &str| -> Option<Vec<Expr>> {
            let [Circuit::Element(block)] = parts(circuit) else {
                return None;
            };
            let (own, values) = compared_values(&network.blocks[*block])?;
            (own == name).then(|| values.into_iter().cloned().collect())
        };
        let mut texts = |values: &[Expr]| -> Result<Vec<String>> {
            values.iter().map(|value| self.value(value)).collect()
        };
        let turned = |one: &Circuit<usize>, other: &Circuit<usize>| {
            Some((
                compared(one, "LEQ").filter(|it| it.len() == 2)?,
                compared(other, "GEQ")?,
            ))
        };
        if let [first, second, ..] = legs {
            if let Some((below, above)) = turned(first, second)
                && let (Some(high), Some(low)) = (number(&below[1]), number(&above[1]))
                && low > high
            {
                let (below, above) = (texts(&below)?, texts(&above)?);
                if below[0] == above[0] {
                    return Ok(Some((it("LIM", &[&above[1], &below[0], &below[1]]), 2)));
                }
            }
            if let Some(inside) = compared(first, "LEQ").filter(|it| it.len() == 3)
                && let Circuit::Series(outside) = second
                && let [test, Circuit::Parallel(outside)] = &outside[..]
                && let (Some(greater), [one, other]) = (compared(test, "GRT"), &outside[..])
                && let Some((below, above)) = turned(one, other)
            {
                let inside = texts(&inside)?;
                let whole = [texts(&greater)?, texts(&below)?, texts(&above)?].concat();
                let [low, value, high] = &inside[..] else {
                    return Ok(None);
                };
                if whole == [low, high, value, high, value, low].map(String::clone) {
                    return Ok(Some((it("LIM", &[low, value, high]), 2)));
                }
            }
        }
        Ok(None)
    }
}

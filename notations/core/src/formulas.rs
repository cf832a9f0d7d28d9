//! Formulas that call functions (`[CALC]( y, a + MIN(b, c * 2) )`), for systems whose formulas have others: what they call becomes
//! an instruction of its own, in front of the formula, and tags hold the parts.

use crate::elements::{Declared, Replaced, by_origin, replace};
use crate::fresh::Fresh;
use crate::rewritten::own_networks;
use ladder_analysis::Analysis;
use ladder_analysis::context::Body;
use ladder_analysis::program::{Argument, Block, BlockKind, Expr, ExprKind};
use ladder_format::program::{self, Declaration, Expression, Operand, Path, ProgramSketch};
use ladder_instructions::{Op, Shape};

/// The comment on a tag for a part.
const PART: &str = "a part of a formula";

/// The functions. No other system has them in its formulas.
const FUNCTIONS: [Op; 5] = [Op::Min, Op::Max, Op::Limit, Op::Sel, Op::Mux];

/// A program in whose formulas none of `MIN`, `MAX`, `LIMIT`, `SEL` and `MUX` is called. None: it has none of them.
pub(crate) fn by_instructions(analysis: &Analysis) -> Option<ProgramSketch> {
    let networks = own_networks(analysis)?;
    let bodies = &analysis.context.bodies;
    let blocks = networks
        .iter()
        .flat_map(|(network, number)| network.blocks.iter().map(|block| (block, bodies[*number])));
    let formulas: Vec<(&Block, &Expr, Body)> = blocks
        .filter_map(|(block, body)| Some((block, formula(block)?, body)))
        .collect();
    if formulas.is_empty() {
        return None;
    }
    let mut sketch = ProgramSketch::of_text(&analysis.context.parse);
    let drawn = by_origin(&sketch.items);
    let mut parts = Parts {
        names: Fresh::of(&analysis.context, "part_"),
        declared: Vec::new(),
    };
    let (mut instead, mut declared) = (Replaced::new(), Declared::default());
    for (block, formula, body) in formulas {
        let at = block.location.range.start().into();
        if let Some(chain) = drawn.get(&at).and_then(|drawn| parts.of(formula, drawn)) {
            instead.insert(at, chain);
            declared.add(body, parts.declared.drain(..));
        }
    }
    replace(&mut sketch.items, &instead);
    declared.put(&mut sketch.items);
    Some(sketch)
}

/// The formula of a block, if it calls one of the functions.
fn formula(block: &Block) -> Option<&Expr> {
    let BlockKind::Instruction(row) = block.kind else {
        return None;
    };
    match (row.op, &block.arguments.get(1)?.argument) {
        (Op::Calc, Argument::Value(formula)) => calls(formula).then_some(formula),
        _ => None,
    }
}

/// The parts of formulas.
struct Parts {
    names: Fresh,
    declared: Vec<Declaration>,
}

impl Parts {
    /// What is in the place of a formula that calls one of the functions.
    fn of(&mut self, formula: &Expr, drawn: &program::Block) -> Option<Vec<program::Block>> {
        let [Operand::Value(to), Operand::Value(own)] = drawn.operands() else {
            return None;
        };
        let mut chain = Vec::new();
        let value = self.without_calls(formula, own.clone(), &mut chain)?;
        chain.push(program::Block::of(Op::Calc, [to.clone(), value.clone()]).ok()?);
        // The value of the last call is that of the formula.
        if let [.., last, _] = &chain[..]
            && matches!(last.operands().first(), Some(Operand::Value(result)) if *result == value)
        {
            let operands =
                std::iter::once(Operand::from(to.clone())).chain(last.operands()[1..].iter().cloned());
            let last = program::Block::of(last.op()?, operands.collect::<Vec<_>>()).ok()?;
            self.declared.pop();
            chain.truncate(chain.len() - 2);
            chain.push(last);
        }
        Some(chain)
    }

    /// An expression without these calls; the instructions in their place are added to the chain. None: it is not drawn as it is meant.
    fn without_calls(
        &mut self,
        formula: &Expr,
        own: Expression,
        chain: &mut Vec<program::Block>,
    ) -> Option<Expression> {
        if !calls(formula) {
            return Some(own);
        }
        let (inner, own): (Vec<&Expr>, Expression) = match (&formula.kind, own) {
            (ExprKind::Pass(inner), own) => return self.without_calls(inner, own, chain),
            (_, Expression::Group(own)) => {
                let inner = self.without_calls(formula, *own, chain)?;
                return Some(match inner {
                    Expression::Path(_) => inner,
                    inner => Expression::Group(Box::new(inner)),
                });
            }
            (ExprKind::Call(op, arguments), Expression::Call(name, own)) if FUNCTIONS.contains(op) => {
                let operands = arguments.iter().zip(own);
                let operands: Option<Vec<Expression>> = operands
                    .map(|(argument, own)| self.operand(argument, own, chain))
                    .collect();
                return self.part(formula, &name, operands?, chain);
            }
            (ExprKind::Call(_, arguments), own @ Expression::Call(..)) => (arguments.iter().collect(), own),
            (ExprKind::Unary(_, inner), own @ Expression::Unary(..)) => (vec![&**inner], own),
            (
                ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right),
                own @ Expression::Binary(..),
            ) => (vec![&**left, &**right], own),
            _ => return None,
        };
        let mut inner = inner.into_iter();
        let mut is_drawn = true;
        let without = own.map_inner(&mut |own| {
            let part = inner
                .next()
                .and_then(|inner| self.without_calls(inner, own.clone(), chain));
            is_drawn &= part.is_some();
            part.unwrap_or(own)
        });
        is_drawn.then_some(without)
    }

    /// An argument of a call as an operand: a tag, a literal, or a part.
    fn operand(
        &mut self,
        argument: &Expr,
        own: Expression,
        chain: &mut Vec<program::Block>,
    ) -> Option<Expression> {
        let mut inner = argument;
        while let ExprKind::Pass(of) = &inner.kind {
            inner = of;
        }
        let own = self.without_calls(inner, own, chain)?;
        match (&inner.kind, &own) {
            (ExprKind::Constant(_) | ExprKind::Read(_), _) => Some(own),
            (ExprKind::Call(op, _), Expression::Path(_)) if FUNCTIONS.contains(op) => Some(own),
            _ => self.part(inner, "CALC", vec![own], chain),
        }
    }

    fn part(
        &mut self,
        of: &Expr,
        mnemonic: &str,
        operands: Vec<Expression>,
        chain: &mut Vec<program::Block>,
    ) -> Option<Expression> {
        let name = self.names.next();
        let part = Expression::from(Path::tag(&name));
        self.declared.push(Declaration {
            comment: Some(PART.to_owned()),
            ..Declaration::new(name, of.ty.name())
        });
        let operands = std::iter::once(part.clone()).chain(operands);
        chain.push(program::Block::spelled(Shape::Logical, mnemonic, operands).ok()?);
        Some(part)
    }
}

/// Whether a formula calls one of the functions.
fn calls(formula: &Expr) -> bool {
    match &formula.kind {
        ExprKind::Call(op, arguments) => FUNCTIONS.contains(op) || arguments.iter().any(calls),
        ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => calls(inner),
        ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => calls(left) || calls(right),
        _ => false,
    }
}

//! Comparisons as conditions on variables.

use super::gate::{Ask, Variable};
use super::value_space::{Bound, Regions};
use super::variables::{Draft, Reader};
use crate::names::operand_value::{Number, number, scalar};
use crate::networks::BlockAt;
use crate::values::literal::Literal;
use crate::written::facts::Node;
use ladder_instructions::Op;

/// A comparison before all numbers are known that its value is compared with.
#[derive(Debug, Clone, Copy)]
pub(super) enum Comparison {
    Known(Ask),
    Always(bool),
    Number { variable: usize, op: Op, with: Number },
}

impl Reader<'_> {
    pub(super) fn comparison(&mut self, bound: BlockAt<'_>, op: Op) -> Draft {
        let operands = &bound.facts.operands;
        let pairs = operands.windows(2);
        let compares = pairs.map(|pair| self.compare(op, &pair[0].value, &pair[1].value));
        Draft::Compares(compares.collect())
    }

    fn compare(&mut self, op: Op, left: &Node, right: &Node) -> Comparison {
        let (context, scope) = (self.context, self.network.scope);
        match (number(context, scope, left), number(context, scope, right)) {
            (Some(a), Some(b)) => Comparison::Always(holds(op, a, b)),
            (None, Some(with)) => self.with_number(op, left, with, right),
            (Some(with), None) => self.with_number(turned(op), right, with, left),
            (None, None) => self.pair(op, left, right),
        }
    }

    fn with_number(&mut self, op: Op, node: &Node, with: Number, written: &Node) -> Comparison {
        let Some((key, tags)) = self.key(node) else {
            return Comparison::Known(self.unknown());
        };
        self.note_read(&tags);
        let key = format!("number {}", self.versioned(&key, &tags));
        let name = self.text(node);
        let variable = self.variable(key, Variable::Number(name, Regions::default()));
        let ty = scalar(self.context, self.network.scope, node);
        let bound = Bound {
            at: with,
            text: self.text(written),
        };
        self.bounds
            .entry(variable)
            .or_insert((Vec::new(), ty))
            .0
            .push(bound);
        Comparison::Number { variable, op, with }
    }

    fn pair(&mut self, op: Op, left: &Node, right: &Node) -> Comparison {
        if let Some(ask) = self
            .with_bool(op, left, right)
            .or_else(|| self.with_bool(op, right, left))
        {
            return Comparison::Known(ask);
        }
        let (Some((a, mut tags)), Some((b, others))) = (self.key(left), self.key(right)) else {
            return Comparison::Known(self.unknown());
        };
        if a == b {
            return Comparison::Always(matches!(op, Op::Eq | Op::Ge | Op::Le));
        }
        tags.extend(others);
        self.note_read(&tags);
        let (a, b, op, left, right) = if a < b {
            (a, b, op, left, right)
        } else {
            (b, a, turned(op), right, left)
        };
        let key = self.versioned(&format!("{a} to {b}"), &tags);
        let variable = Variable::Pair(self.text(left), self.text(right));
        let variable = self.variable(key, variable);
        // A third comparison may follow from two others.
        self.some_impossible |= self
            .variables
            .iter()
            .filter(|v| matches!(v, Variable::Pair(..)))
            .count()
            > 1
            || self.variables.iter().any(|v| matches!(v, Variable::Number(..)));
        Comparison::Known(Ask {
            variable,
            mask: order_mask(op),
        })
    }

    /// `[EQ]( flag, TRUE )`
    fn with_bool(&mut self, op: Op, tag: &Node, literal: &Node) -> Option<Ask> {
        let Some(&Literal::Bool(value)) = literal.literal() else {
            return None;
        };
        matches!(op, Op::Eq | Op::Ne).then(|| self.contact(tag, value != (op == Op::Eq)))
    }

    pub(super) fn ask(&mut self, comparison: Comparison) -> Ask {
        match comparison {
            Comparison::Known(ask) => ask,
            Comparison::Always(value) => {
                let ask = self.unknown();
                Ask {
                    mask: if value { 0b11 } else { 0 },
                    ..ask
                }
            }
            Comparison::Number { variable, op, with } => {
                let mask = match &self.variables[variable] {
                    Variable::Number(_, regions) => regions.mask(op, with),
                    _ => 0,
                };
                Ask { variable, mask }
            }
        }
    }
}

/// `a op b` as `b op a`.
const fn turned(op: Op) -> Op {
    match op {
        Op::Gt => Op::Lt,
        Op::Ge => Op::Le,
        Op::Lt => Op::Gt,
        Op::Le => Op::Ge,
        other => other,
    }
}

/// For which of less, equal, greater a comparison holds.
pub(super) const fn order_mask(op: Op) -> u64 {
    match op {
        Op::Eq => 0b010,
        Op::Ne => 0b101,
        Op::Gt => 0b100,
        Op::Ge => 0b110,
        Op::Lt => 0b001,
        _ => 0b011,
    }
}

fn holds(op: Op, a: Number, b: Number) -> bool {
    let order = match (a, b) {
        (Number::Int(a), Number::Int(b)) => a.cmp(&b),
        _ => a.real().total_cmp(&b.real()),
    };
    order_mask(op) >> (order as i8 + 1) & 1 == 1
}

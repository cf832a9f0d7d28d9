//! Conditions as contacts.

use super::super::scope::Type;
use super::super::tree::{Expression as Tree, ExpressionKind};
use super::place::is_computed;
use super::value::Value;
use super::{Lowered, Lowering};
use ladder_analysis::values::types::Scalar;
use ladder_format::Circuit;
use ladder_format::program::{Block, Element, Expression, Operator, Sign};
use ladder_instructions::Op;

/// A condition is drawn with no more contacts.
const MOST_CONTACTS: usize = 10;

/// A condition whose parts are contacts, comparisons, and what is in series and in parallel.
#[derive(Debug, Clone)]
pub(super) enum Power {
    /// Always, or never.
    Always(bool),
    /// One block, and the one that says the opposite.
    Contact(Box<(Block, Block)>),
    All(Vec<Power>),
    Any(Vec<Power>),
}

impl Power {
    fn contacts(&self) -> usize {
        match self {
            Power::Always(_) => 0,
            Power::Contact(_) => 1,
            Power::All(parts) | Power::Any(parts) => parts.iter().map(Power::contacts).sum(),
        }
    }

    /// The condition that holds when this one does not.
    pub(super) fn negated(self) -> Power {
        let all = |parts: Vec<Power>| parts.into_iter().map(Power::negated).collect();
        match self {
            Power::Always(truth) => Power::Always(!truth),
            Power::Contact(pair) => {
                let (block, opposite) = *pair;
                Power::Contact(Box::new((opposite, block)))
            }
            Power::All(parts) => Power::Any(all(parts)),
            Power::Any(parts) => Power::All(all(parts)),
        }
    }
}

impl Lowering<'_, '_> {
    /// The condition as contacts; what it compares may be computed before it. None: it is not drawn so.
    pub(super) fn power(&mut self, tree: &Tree) -> Lowered<Option<Power>> {
        if !is_drawable(tree) {
            return Ok(None);
        }
        let power = self.drawn(tree)?;
        Ok(power.filter(|power| power.contacts() <= MOST_CONTACTS))
    }

    fn drawn(&mut self, tree: &Tree) -> Lowered<Option<Power>> {
        match &tree.kind {
            ExpressionKind::Group(inner) => self.drawn(inner),
            ExpressionKind::Unary(Sign::Not, inner) => Ok(self.drawn(inner)?.map(Power::negated)),
            ExpressionKind::Binary(operator @ (Operator::And | Operator::Or), left, right)
            | ExpressionKind::Lazy(operator, left, right) => {
                let (Some(left), Some(right)) = (self.drawn(left)?, self.drawn(right)?) else {
                    return Ok(None);
                };
                Ok(Some(joined(*operator, left, right)))
            }
            ExpressionKind::Binary(operator, left, right) if operator.compares() => {
                let left = self.value(left)?;
                let right = self.value(right)?;
                self.compared(*operator, left, right)
            }
            _ => {
                let value = self.value(tree)?;
                let value = self.fit(value, Scalar::Bool)?;
                Ok(contact(&value))
            }
        }
    }

    fn compared(&mut self, operator: Operator, left: Value, right: Value) -> Lowered<Option<Power>> {
        if left.is_bool() || right.is_bool() {
            return Ok(None);
        }
        let (left, right) = self.comparable(left, right)?;
        let (left, right) = (self.constant(left)?, self.constant(right)?);
        let operands = [left.expression, right.expression];
        let block = |op| Block::of(op, operands.clone());
        let (op, opposite) = match operator {
            Operator::Equal => (Op::Eq, Op::Ne),
            Operator::NotEqual => (Op::Ne, Op::Eq),
            Operator::Less => (Op::Lt, Op::Ge),
            Operator::LessEqual => (Op::Le, Op::Gt),
            Operator::Greater => (Op::Gt, Op::Le),
            _ => (Op::Ge, Op::Lt),
        };
        Ok(Some(Power::Contact(Box::new((block(op)?, block(opposite)?)))))
    }

    /// One operand of a comparison.
    fn constant(&mut self, value: Value) -> Lowered<Value> {
        match value.ty {
            Type::Enumeration(_) => Ok(value),
            _ => self.atom(value),
        }
    }

    /// The condition as contacts after what is computed first, whatever it is.
    pub(super) fn condition(&mut self, tree: &Tree) -> Lowered<Power> {
        let (chain, used) = (self.chain.len(), self.used.len());
        if let Some(power) = self.power(tree)? {
            return Ok(power);
        }
        self.chain.truncate(chain);
        self.release(used);
        let value = self.value(tree)?;
        let value = self.fit(value, Scalar::Bool)?;
        let is_computed = value.bare().path().is_some_and(is_computed);
        let value = if is_computed {
            self.made_by("MOV", Scalar::Bool, vec![value.bare().clone()])?
        } else {
            self.atom(value)?
        };
        contact(&value).ok_or_else(|| "such a condition is not read".to_owned())
    }

    /// What has power if a condition holds.
    pub(super) fn circuit(&self, power: &Power) -> Circuit<Element> {
        let all = |parts: &[Power]| parts.iter().map(|part| self.circuit(part)).collect();
        match power {
            Power::Always(true) => Circuit::Series(Vec::new()),
            Power::Always(false) => self.element(Block::contact(ladder_format::program::Path::system("OFF"))),
            Power::Contact(pair) => self.element(pair.0.clone()),
            Power::All(parts) => Circuit::Series(all(parts)),
            Power::Any(parts) => Circuit::Parallel(all(parts)),
        }
    }

    /// What has power if a condition does not hold, a fault on the way to it included.
    pub(super) fn opposite(&self, power: Power) -> Vec<Circuit<Element>> {
        let is_faultless = self.chain.is_empty();
        match power {
            Power::Contact(_) | Power::Always(_) if is_faultless => vec![self.circuit(&power.negated())],
            Power::Any(ref parts)
                if is_faultless && parts.iter().all(|part| matches!(part, Power::Contact(_))) =>
            {
                vec![self.circuit(&power.negated())]
            }
            power => vec![self.circuit(&power), self.element(Block::inverter())],
        }
    }
}

/// The contact of a BOOL.
fn contact(value: &Value) -> Option<Power> {
    match value.bare() {
        Expression::Literal(literal) => Some(Power::Always(literal.as_str() == "TRUE")),
        Expression::Path(path) => {
            let pair = (Block::contact(path), Block::negated_contact(path));
            Some(Power::Contact(Box::new(pair)))
        }
        _ => None,
    }
}

fn joined(operator: Operator, left: Power, right: Power) -> Power {
    let mut parts = Vec::new();
    for part in [left, right] {
        match (operator, part) {
            (Operator::And, Power::All(inner)) | (Operator::Or, Power::Any(inner)) => parts.extend(inner),
            (_, part) => parts.push(part),
        }
    }
    match operator {
        Operator::And => Power::All(parts),
        _ => Power::Any(parts),
    }
}

/// Whether a condition is made of what contacts can say, and no fault can be in it.
fn is_drawable(tree: &Tree) -> bool {
    !super::expression::may_fault(tree) && is_logical(tree)
}

fn is_logical(tree: &Tree) -> bool {
    match &tree.kind {
        ExpressionKind::Group(inner) | ExpressionKind::Unary(Sign::Not, inner) => is_logical(inner),
        ExpressionKind::Binary(Operator::And | Operator::Or, left, right)
        | ExpressionKind::Lazy(_, left, right) => is_logical(left) && is_logical(right),
        ExpressionKind::Binary(operator, ..) => operator.compares(),
        ExpressionKind::Place(_) | ExpressionKind::Literal(..) => true,
        _ => false,
    }
}

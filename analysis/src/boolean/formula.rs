//! The power of a network as people write it: `(start OR run) AND NOT stop`.
//!
//! Put together along the order of evaluation, and simplified only where the drawing asks for it: what two branches
//! share in front of them is written once.

use super::written::{written, written_block};
use crate::names::context::{Body, Context};
use crate::names::operand_value::tag;
use crate::networks::network::Meaning;
use crate::networks::{BlockAt, NetworkAt};
use crate::program::Step;
use crate::values::types::Type;
use crate::written::facts::NodeKind;
use ladder_instructions::{
    Coil, Edge, Instruction, Op, Power, Semantics, SetPower, StatePower, StateType, Timing,
};
use std::fmt;

/// A formula with more parts than this helps nobody.
const MOST: usize = 60;

/// How many steps a network may have.
const MOST_STEPS: usize = 400;

/// When power is at a place.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Formula {
    Always,
    Never,
    /// A tag, or something that is written like a function.
    Name(String),
    /// A comparison.
    Compare(String),
    Not(Box<Formula>),
    And(Vec<Formula>),
    Or(Vec<Formula>),
}

/// The formulas of one network.
#[derive(Debug)]
pub struct Formulas<'c> {
    context: &'c Context,
    network: NetworkAt<'c>,
    /// For each step of its order; none where it would be too long, or a block is not known.
    steps: Vec<Option<Formula>>,
}

/// The formulas of a network. None if its drawing has an error, or it is too large.
pub fn formulas(context: &Context, network: usize) -> Option<Formulas<'_>> {
    let facts = context.networks.at(network);
    let order = &facts.order.steps;
    if facts.broken || order.len() > MOST_STEPS {
        return None;
    }
    let rail = if rail_may_be_dead(context, network) {
        Formula::Name("RAIL".to_owned())
    } else {
        Formula::Always
    };
    let mut steps: Vec<Option<Formula>> = Vec::with_capacity(order.len());
    for step in order {
        let formula = match *step {
            Step::Start { rail: true } => Some(rail.clone()),
            Step::Start { rail: false } => Some(Formula::Never),
            Step::Join { upper, lower } => match (&steps[upper], &steps[lower]) {
                (Some(upper), Some(lower)) => Some(or(upper.clone(), lower.clone())),
                _ => None,
            },
            Step::Block { block, en } => after(context, facts, facts.block(block), steps[en].as_ref()),
        };
        steps.push(formula.filter(|formula| formula.size() <= MOST));
    }
    Some(Formulas {
        context,
        network: facts,
        steps,
    })
}

/// Whether an `<MCR>` in front of the network may take the left rail's power.
fn rail_may_be_dead(context: &Context, network: usize) -> bool {
    let body = context.bodies.get(network).copied().unwrap_or(Body::Main);
    let has = |index: usize| {
        context
            .networks
            .at(index)
            .blocks
            .iter()
            .any(|block| block.op() == Some(Op::Mcr))
    };
    !has(network) && (0..network).any(|index| context.bodies[index] == body && has(index))
}

impl Formulas<'_> {
    /// When a step has power. None if that is not known, or would be too long.
    pub fn power(&self, step: usize) -> Option<String> {
        Some(self.steps.get(step)?.as_ref()?.to_string())
    }

    /// What each block does that acts: the block's number, and `run := start AND NOT stop`. In the order of
    /// evaluation.
    pub fn effects(&self) -> impl Iterator<Item = (usize, String)> {
        self.network.order.steps.iter().filter_map(|step| match *step {
            Step::Block { block, en } => Some((block, self.effect(self.network.block(block), en)?)),
            _ => None,
        })
    }

    fn effect(&self, bound: BlockAt<'_>, en: usize) -> Option<String> {
        let scope = self.network.scope;
        let en = self.steps[en].as_ref()?;
        let first = || Some(written(self.context, scope, &bound.facts.operands.first()?.value));
        let conditionally = || {
            let block = written_block(self.context, scope, bound);
            Some(match en {
                Formula::Always => block,
                en => format!("IF {en}: {block}"),
            })
        };
        let Meaning::Instruction(row) = bound.meaning else {
            return conditionally();
        };
        match row.coil {
            Some(Coil::Follows) => Some(format!("{} := {en}", first()?)),
            Some(Coil::Negated) => Some(format!("{} := {}", first()?, not(en.clone()))),
            Some(Coil::Sets) => {
                let tag = first()?;
                let text = or(Formula::Name(tag.clone()), en.clone());
                Some(format!("{tag} := {text}"))
            }
            // A timer or counter is cleared.
            Some(Coil::Resets) if self.is_state(bound) => conditionally(),
            Some(Coil::Resets) => {
                let tag = first()?;
                let text = and(Formula::Name(tag.clone()), not(en.clone()));
                Some(format!("{tag} := {text}"))
            }
            Some(Coil::OnEdge(edge)) => Some(format!("{} := {}({en})", first()?, change(edge))),
            None => match row.state() {
                Some(state) if state.is_timer() => Some(format!("{}.IN := {en}", first()?)),
                Some(state) if state.is_counter() => Some(format!("{}.CU := {en}", first()?)),
                _ if row.role == ladder_instructions::Role::Condition => None,
                _ => conditionally(),
            },
        }
    }
}

impl Formulas<'_> {
    fn is_state(&self, bound: BlockAt<'_>) -> bool {
        let Some((name, _)) = bound.facts.first_name() else {
            return false;
        };
        tag(self.context, self.network.scope, name)
            .is_some_and(|(_, tag)| matches!(tag.ty, Some(Type::State(_))))
    }
}

/// When power leaves a block.
fn after(
    context: &Context,
    network: NetworkAt<'_>,
    bound: BlockAt<'_>,
    en: Option<&Formula>,
) -> Option<Formula> {
    let text = |index: usize| {
        let operand = bound.facts.operands.get(index)?;
        match &operand.value.kind {
            NodeKind::Missing => None,
            _ => Some(written(context, network.scope, &operand.value)),
        }
    };
    let is_range = bound
        .facts
        .operands
        .first()
        .is_some_and(|operand| matches!(operand.value.kind, NodeKind::Range(..)));
    let row = match bound.meaning {
        Meaning::Instruction(row) => row,
        Meaning::User(_) => return Some(Formula::Name(format!("{}.ENO", bound.facts.head.text()))),
        Meaning::Unknown | Meaning::UnknownUser => return None,
    };
    let semantics = context.profile.semantics();
    let condition = match row.power {
        Power::Level { high: true } if is_range => Formula::Name(format!("ALL({})", text(0)?)),
        Power::Level { high: true } => Formula::Name(text(0)?),
        Power::Level { high: false } if is_range => Formula::Name(format!("NONE({})", text(0)?)),
        Power::Level { high: false } => not(Formula::Name(text(0)?)),
        Power::TagEdge(edge) => Formula::Name(format!("{}({})", change(edge), text(0)?)),
        Power::Compares => {
            let mut all = Formula::Always;
            for index in 1..bound.facts.operands.len() {
                let pair = format!("{} {} {}", text(index - 1)?, sign(row.op), text(index)?);
                all = and(all, Formula::Compare(pair));
            }
            all
        }
        Power::Inverts => return Some(not(en?.clone())),
        Power::EnEdge(edge) => return Some(Formula::Name(format!("{}({})", change(edge), en?))),
        Power::SetTag if semantics.set_power == SetPower::Tag => return text(0).map(Formula::Name),
        Power::Output if passes_on(row, semantics) => return en.cloned(),
        Power::Output => {
            let state = row.state()?;
            let output = Formula::Name(format!("{}.{}", text(0)?, state.output()));
            let is_bistable = !state.is_timer() && !state.is_counter();
            if is_bistable || semantics.timing != Timing::Ticks {
                return Some(output);
            }
            // There the output means that the time is over or the count reached, also while EN is low.
            match state {
                StateType::Tof => not(output),
                _ => output,
            }
        }
        Power::Passes | Power::PassesIfDone | Power::SetTag => return en.cloned(),
    };
    Some(and(en?.clone(), condition))
}

/// Whether the power after a timer or counter is its EN.
pub(super) fn passes_on(row: &Instruction, semantics: &Semantics) -> bool {
    let counts = row
        .state()
        .is_some_and(|state| state.is_timer() || state.is_counter());
    counts && semantics.state_power == StatePower::En
}

const fn change(edge: Edge) -> &'static str {
    match edge {
        Edge::Rising => "RISE",
        Edge::Falling => "FALL",
    }
}

const fn sign(op: Op) -> &'static str {
    match op {
        Op::Eq => "=",
        Op::Ne => "<>",
        Op::Gt => ">",
        Op::Ge => ">=",
        Op::Lt => "<",
        _ => "<=",
    }
}

fn not(formula: Formula) -> Formula {
    match formula {
        Formula::Always => Formula::Never,
        Formula::Never => Formula::Always,
        Formula::Not(inner) => *inner,
        other => Formula::Not(Box::new(other)),
    }
}

fn and(a: Formula, b: Formula) -> Formula {
    match (a, b) {
        (Formula::Never, _) | (_, Formula::Never) => Formula::Never,
        (Formula::Always, other) | (other, Formula::Always) => other,
        (a, b) => {
            let mut parts = factors(a);
            parts.extend(factors(b));
            Formula::And(parts)
        }
    }
}

fn or(a: Formula, b: Formula) -> Formula {
    match (a, b) {
        (Formula::Always, _) | (_, Formula::Always) => Formula::Always,
        (Formula::Never, other) | (other, Formula::Never) => other,
        (a, b) if a == b => a,
        (a, b) => {
            // What both have in front of them is where they branched.
            let (mut a, mut b) = (factors(a), factors(b));
            let shared = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
            let front = product(a.drain(..shared).collect());
            b.drain(..shared);
            if a.is_empty() || b.is_empty() {
                return front;
            }
            let mut terms = terms(product(a));
            for term in self::terms(product(b)) {
                if !terms.contains(&term) {
                    terms.push(term);
                }
            }
            let branches = if terms.len() == 1 {
                terms.remove(0)
            } else {
                Formula::Or(terms)
            };
            and(front, branches)
        }
    }
}

fn factors(formula: Formula) -> Vec<Formula> {
    match formula {
        Formula::And(parts) => parts,
        other => vec![other],
    }
}

fn terms(formula: Formula) -> Vec<Formula> {
    match formula {
        Formula::Or(parts) => parts,
        other => vec![other],
    }
}

fn product(mut parts: Vec<Formula>) -> Formula {
    match parts.len() {
        0 => Formula::Always,
        1 => parts.remove(0),
        _ => Formula::And(parts),
    }
}

impl Formula {
    fn size(&self) -> usize {
        match self {
            Formula::Not(inner) => 1 + inner.size(),
            Formula::And(parts) | Formula::Or(parts) => parts.iter().map(Formula::size).sum(),
            // A function of a formula is as long as that.
            Formula::Name(text) | Formula::Compare(text) => 1 + text.len() / 40,
            _ => 1,
        }
    }
}

impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let join = |f: &mut fmt::Formatter<'_>, parts: &[Formula], word: &str| {
            for (index, part) in parts.iter().enumerate() {
                if index > 0 {
                    f.write_str(word)?;
                }
                match part {
                    Formula::Or(_) => write!(f, "({part})")?,
                    Formula::And(_) if word == " OR " => write!(f, "{part}")?,
                    Formula::And(_) => write!(f, "({part})")?,
                    _ => write!(f, "{part}")?,
                }
            }
            Ok(())
        };
        match self {
            Formula::Always => f.write_str("TRUE"),
            Formula::Never => f.write_str("FALSE"),
            Formula::Name(text) | Formula::Compare(text) => f.write_str(text),
            Formula::Not(inner) => match **inner {
                Formula::Name(_) => write!(f, "NOT {inner}"),
                _ => write!(f, "NOT ({inner})"),
            },
            Formula::And(parts) => join(f, parts, " AND "),
            Formula::Or(parts) => join(f, parts, " OR "),
        }
    }
}

#[cfg(test)]
mod tests;

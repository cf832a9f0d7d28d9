//! Which variable each condition of a network asks about, and what the blocks write.

use super::comparison::Comparison;
use super::formula::passes_on;
use super::gate::{Ask, CoilKind, Gate, Gates, Variable};
use super::value_space::{Bound, Regions};
use super::written::written;
use crate::names::context::Context;
use crate::names::operand_value::tag;
use crate::names::path_type::path_type;
use crate::networks::named::access;
use crate::networks::network::{Formal, Meaning};
use crate::networks::{BlockAt, NetworkAt};
use crate::program::Access;
use crate::program::Step;
use crate::values::literal::Literal;
use crate::values::types::{Scalar, Type};
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Coil, Edge, Instruction, Op, Power, SetPower, Timing};
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt::Write;

/// A tag: its scope and its index there.
type TagId = (usize, usize);

/// The conditions of a network and their variables.
pub(crate) fn gates(context: &Context, network: NetworkAt<'_>) -> Option<Gates> {
    let mut reader = Reader {
        context,
        network,
        variables: Vec::new(),
        by_key: FxHashMap::default(),
        versions: FxHashMap::default(),
        epoch: 0,
        unknown_writes: FxHashSet::default(),
        bounds: FxHashMap::default(),
        reads_unknown_write: false,
        some_impossible: false,
    };
    let steps = &network.order.steps;
    let mut consumed = vec![false; steps.len()];
    for step in steps {
        match *step {
            Step::Start { .. } => {}
            Step::Block { en, .. } => consumed[en] = true,
            Step::Join { upper, lower } => {
                consumed[upper] = true;
                consumed[lower] = true;
            }
        }
    }
    let mut drafts = vec![Draft::Done(Gate::Pass); network.blocks.len()];
    for (index, step) in steps.iter().enumerate() {
        if let Step::Block { block, .. } = *step {
            drafts[block] = reader.block(network.block(block), consumed[index]);
        }
    }
    reader.finish(drafts)
}

/// A gate whose comparisons wait until all numbers that a value is compared with are known.
#[derive(Debug, Clone)]
pub(super) enum Draft {
    Done(Gate),
    Compares(Vec<Comparison>),
}

pub(super) struct Reader<'c> {
    pub(super) context: &'c Context,
    pub(super) network: NetworkAt<'c>,
    pub(super) variables: Vec<Variable>,
    pub(super) by_key: FxHashMap<String, usize>,
    /// How often the value of a tag has changed in the network so far.
    pub(super) versions: FxHashMap<TagId, u32>,
    /// How often any tag may have changed.
    pub(super) epoch: u32,
    pub(super) unknown_writes: FxHashSet<TagId>,
    /// For variables that are numbers: what they are compared with, and their type.
    pub(super) bounds: FxHashMap<usize, (Vec<Bound>, Option<Scalar>)>,
    pub(super) reads_unknown_write: bool,
    pub(super) some_impossible: bool,
}

impl Reader<'_> {
    fn block(&mut self, bound: BlockAt<'_>, consumed: bool) -> Draft {
        let operand = |index: usize| bound.facts.operands.get(index).map(|operand| &operand.value);
        let Meaning::Instruction(row) = bound.meaning else {
            self.epoch += 1;
            return Draft::Done(self.output(consumed));
        };
        let semantics = self.context.profile.semantics();
        let gate = match row.power {
            Power::Level { high } => match operand(0) {
                Some(node) => Gate::If(vec![self.contact(node, !high)]),
                None => Gate::Pass,
            },
            Power::TagEdge(edge) => match operand(0) {
                Some(node) => {
                    let tag = self.contact(node, edge == Edge::Falling);
                    Gate::If(vec![tag, self.unknown()])
                }
                None => Gate::Pass,
            },
            Power::Inverts => Gate::Inverter,
            Power::EnEdge(Edge::Rising) => Gate::If(vec![self.unknown()]),
            Power::EnEdge(Edge::Falling) => Gate::IfNot(self.unknown()),
            Power::Compares => return self.comparison(bound, row.op),
            Power::Output if passes_on(row, semantics) => {
                self.writes(bound);
                Gate::Pass
            }
            Power::Output => {
                self.writes(bound);
                let gate = self.output(consumed);
                if let (Gate::Gives(ask), Some(node)) = (&gate, operand(0))
                    // There the power is not the output.
                    && semantics.timing != Timing::Ticks
                    && let Some(state) = row.state()
                    && let Some((key, tags)) = self.key(node)
                {
                    let key = self.versioned(&format!("{key}.{}", state.output()), &tags);
                    self.by_key.insert(key, ask.variable);
                }
                gate
            }
            Power::PassesIfDone => {
                self.writes(bound);
                if consumed {
                    Gate::If(vec![self.unknown()])
                } else {
                    Gate::Pass
                }
            }
            Power::Passes | Power::SetTag => self.passing(row, bound, consumed),
        };
        Draft::Done(gate)
    }

    /// What passes on its EN, or the tag that it sets.
    fn passing(&mut self, row: &Instruction, bound: BlockAt<'_>, consumed: bool) -> Gate {
        let kind = match row.coil {
            Some(Coil::Follows) => CoilKind::Power,
            Some(Coil::Negated) => CoilKind::Negated,
            Some(Coil::Sets) => CoilKind::Set,
            Some(Coil::Resets) => CoilKind::Reset,
            Some(Coil::OnEdge(_)) | None => {
                self.epoch += u32::from(row.op == Op::Call);
                self.writes(bound);
                return Gate::Pass;
            }
        };
        let gate = self.coil(
            kind,
            bound.facts.operands.first().map(|operand| &operand.value),
            consumed,
        );
        if kind == CoilKind::Set && self.context.profile.semantics().set_power == SetPower::En {
            return Gate::Pass;
        }
        gate
    }

    pub(super) fn unknown(&mut self) -> Ask {
        self.variables.push(Variable::Unknown);
        Ask {
            variable: self.variables.len() - 1,
            mask: 0b10,
        }
    }

    fn output(&mut self, consumed: bool) -> Gate {
        if consumed {
            Gate::Gives(self.unknown())
        } else {
            Gate::Pass
        }
    }

    pub(super) fn contact(&mut self, node: &Node, negated: bool) -> Ask {
        let is_range = matches!(node.kind, NodeKind::Range(..));
        let Some((key, tags)) = self.key(node) else {
            return self.unknown();
        };
        self.note_read(&tags);
        let key = self.versioned(&key, &tags);
        // All of a range, and none of it, are two things.
        let (key, mask) = match (is_range, negated) {
            (true, true) => (format!("none of {key}"), 0b10),
            (_, true) => (key, 0b01),
            (_, false) => (key, 0b10),
        };
        let name = self.text(node);
        let variable = match system_constant(node) {
            Some(value) => Variable::Fixed(value),
            None if is_range => Variable::Unknown,
            None => Variable::Bool(name),
        };
        Ask {
            variable: self.variable(key, variable),
            mask,
        }
    }

    pub(super) fn variable(&mut self, key: String, variable: Variable) -> usize {
        let next = self.variables.len();
        let index = *self.by_key.entry(key).or_insert(next);
        if index == next {
            self.variables.push(variable);
        }
        index
    }

    fn coil(&mut self, kind: CoilKind, operand: Option<&Node>, consumed: bool) -> Gate {
        let key = operand
            .filter(|node| !matches!(node.kind, NodeKind::Range(..)))
            .and_then(|node| Some((self.key(node)?, self.text(node))));
        let Some(((key, tags), name)) = key else {
            if let Some(tag) = operand.and_then(|node| self.base(node)) {
                self.changes_unknown(tag);
            }
            return match kind {
                CoilKind::Set if consumed => Gate::Gives(self.unknown()),
                _ => Gate::Pass,
            };
        };
        let before = self.versioned(&key, &tags);
        let variable = self.variable(before, Variable::Bool(name));
        for tag in tags {
            *self.versions.entry(tag).or_default() += 1;
        }
        let tags: Vec<TagId> = operand
            .and_then(|node| self.key(node))
            .map_or(Vec::new(), |(_, tags)| tags);
        let after = self.versioned(&key, &tags);
        self.by_key.insert(after, variable);
        Gate::Coil(kind, Some(variable))
    }

    /// What a block writes has another value from here on.
    fn writes(&mut self, bound: BlockAt<'_>) {
        for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            let access = access(&bound, *formal, &self.context.user_blocks);
            if access.is_some_and(Access::writes)
                && !matches!(formal, Formal::Unknown)
                && let Some(tag) = self.base(&operand.value)
            {
                self.changes_unknown(tag);
            }
        }
    }

    fn changes_unknown(&mut self, tag: TagId) {
        *self.versions.entry(tag).or_default() += 1;
        self.unknown_writes.insert(tag);
    }

    pub(super) fn note_read(&mut self, tags: &[TagId]) {
        self.reads_unknown_write |=
            self.epoch > 0 || tags.iter().any(|tag| self.unknown_writes.contains(tag));
    }

    /// The tag whose memory a place lies in.
    fn base(&self, node: &Node) -> Option<TagId> {
        match &node.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => {
                let (id, _) = tag(self.context, self.network.scope, name)?;
                Some(self.context.first_at_address(id))
            }
            NodeKind::Member(base, _) | NodeKind::Index(base, _) | NodeKind::Range(base, ..) => {
                self.base(base)
            }
            NodeKind::Paren(inner) => self.base(inner),
            _ => None,
        }
    }

    /// What a place is, however it is written, and the tags that it depends on. None if that depends on values:
    /// an element whose index is a tag.
    pub(super) fn key(&self, node: &Node) -> Option<(String, Vec<TagId>)> {
        match &node.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => {
                let (id, facts) = tag(self.context, self.network.scope, name)?;
                // What is at one address changes together, and is one thing where it has one type.
                let first = self.context.first_at_address(id);
                let is_one = self.context.scopes[first.0].tags[first.1].ty == facts.ty;
                let of = if is_one { first } else { id };
                Some((format!("{}:{}", of.0, of.1), vec![first]))
            }
            NodeKind::Paren(inner) => self.key(inner),
            NodeKind::Member(base, word) => {
                let word = match word.text.to_ascii_uppercase() {
                    // Two names of one member; in a structure they are two members.
                    word if word == "DN" && self.is_state(base) => "Q".to_owned(),
                    word => word,
                };
                if matches!(&base.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS")) {
                    return Some((format!("SYS.{word}"), Vec::new()));
                }
                let (mut key, tags) = self.key(base)?;
                let _ = write!(key, ".{word}");
                Some((key, tags))
            }
            NodeKind::Index(base, index) => {
                let (mut key, tags) = self.key(base)?;
                let _ = write!(key, "[{}]", literal_index(index)?);
                Some((key, tags))
            }
            NodeKind::Range(base, first, last) => {
                let (mut key, tags) = self.key(base)?;
                let _ = write!(key, "[{}..{}]", literal_index(first)?, literal_index(last)?);
                Some((key, tags))
            }
            _ => None,
        }
    }

    /// Whether a place holds a timer, counter or bistable.
    fn is_state(&self, place: &Node) -> bool {
        let mut root = |root: &Node| tag(self.context, self.network.scope, root.name()?)?.1.ty;
        let found = path_type(place, self.context.profile.semantics(), &mut root);
        matches!(found, Some((Type::State(_), _)))
    }

    pub(super) fn versioned(&self, key: &str, tags: &[TagId]) -> String {
        let changes: u32 = tags
            .iter()
            .map(|tag| self.versions.get(tag).copied().unwrap_or(0))
            .sum();
        format!("{key}@{changes}.{}", if tags.is_empty() { 0 } else { self.epoch })
    }

    pub(super) fn text(&self, node: &Node) -> String {
        written(self.context, self.network.scope, node)
    }

    fn finish(mut self, drafts: Vec<Draft>) -> Option<Gates> {
        for (variable, (bounds, ty)) in std::mem::take(&mut self.bounds) {
            let regions = Regions::new(bounds, ty)?;
            self.some_impossible |= regions.some_impossible;
            if let Variable::Number(_, empty) = &mut self.variables[variable] {
                *empty = regions;
            }
        }
        let mut of_block = Vec::with_capacity(drafts.len());
        for draft in drafts {
            of_block.push(match draft {
                Draft::Done(gate) => gate,
                Draft::Compares(comparisons) => {
                    let asks = comparisons.into_iter().map(|comparison| self.ask(comparison));
                    Gate::If(asks.collect())
                }
            });
        }
        Some(Gates {
            variables: self.variables,
            of_block,
            reads_unknown_write: self.reads_unknown_write,
            some_impossible: self.some_impossible,
        })
    }
}

fn literal_index(node: &Node) -> Option<i128> {
    match &node.kind {
        NodeKind::Literal(literal) => match **literal {
            Ok(Literal::Int(n)) => Some(n),
            _ => None,
        },
        NodeKind::Unary(_, inner) => literal_index(inner).map(|n| -n),
        _ => None,
    }
}

fn system_constant(node: &Node) -> Option<bool> {
    let NodeKind::Member(base, word) = &node.kind else {
        return None;
    };
    let is_system = matches!(&base.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS"));
    match word.text.to_ascii_uppercase().as_str() {
        "ON" if is_system => Some(true),
        "OFF" if is_system => Some(false),
        _ => None,
    }
}

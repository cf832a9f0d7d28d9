//! Which variable each condition of a network asks about, and what the blocks write.

use super::value_space::{Bound, Regions};
use super::written::written;
use crate::context::Context;
use crate::facts::{Node, NodeKind};
use crate::literal::Literal;
use crate::network::{Formal, Meaning};
use crate::networks::{BlockAt, NetworkAt};
use crate::operand_value::{Number, number, scalar, tag};
use crate::program::Step;
use crate::scope::Access;
use crate::types::Scalar;
use crate::uses::access;
use ladder_instructions::{Coil, Edge, Instruction, Op, Power, SetPower, Timing};
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt::Write;

/// A tag: its scope and its index there.
type TagId = (usize, usize);

/// Something whose value decides about power.
#[derive(Debug, Clone)]
pub(crate) enum Variable {
    /// A BOOL tag, bit or element, as it is written.
    Bool(String),
    /// `SYS.ON` or `SYS.OFF`: its value.
    Fixed(bool),
    /// A number that is compared with numbers: the stretches that these cut its values into.
    Number(String, Regions),
    /// Two values that are compared: less, equal, greater.
    Pair(String, String),
    /// What nobody can name: the memory of an edge, the output of a timer, the rail behind an `<MCR>`.
    Unknown,
}

/// A condition: the variable, and for which of its values (a bit each) it conducts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Ask {
    pub(crate) variable: usize,
    pub(crate) mask: u64,
}

/// What a block makes of the power that enters it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Gate {
    /// It passes it on.
    Pass,
    /// It passes it on if all conditions hold.
    If(Vec<Ask>),
    /// `[NOT]`
    Inverter,
    /// It gives power if none enters it and the condition holds.
    IfNot(Ask),
    /// It gives power by itself.
    Gives(Ask),
    /// A coil.
    Coil(CoilKind, Option<usize>),
}

/// What a coil writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CoilKind {
    Power,
    Negated,
    Set,
    Reset,
}

/// A network's blocks as gates.
#[derive(Debug)]
pub(crate) struct Gates {
    pub(crate) variables: Vec<Variable>,
    /// One for each block of the network.
    pub(crate) of_block: Vec<Gate>,
    /// A condition asks for a value that a block of the network has written, and that cannot be computed here.
    pub(crate) reads_unknown_write: bool,
    /// Not every combination of values can occur: something holds for all combinations is still true, that one
    /// combination shows something is not.
    pub(crate) some_impossible: bool,
}

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
enum Draft {
    Done(Gate),
    Compares(Vec<Comparison>),
}

#[derive(Debug, Clone, Copy)]
enum Comparison {
    Known(Ask),
    Always(bool),
    Number { variable: usize, op: Op, with: Number },
}

struct Reader<'c> {
    context: &'c Context,
    network: NetworkAt<'c>,
    variables: Vec<Variable>,
    by_key: FxHashMap<String, usize>,
    /// How often the value of a tag has changed in the network so far.
    versions: FxHashMap<TagId, u32>,
    /// How often any tag may have changed.
    epoch: u32,
    unknown_writes: FxHashSet<TagId>,
    /// For variables that are numbers: what they are compared with, and their type.
    bounds: FxHashMap<usize, (Vec<Bound>, Option<Scalar>)>,
    reads_unknown_write: bool,
    some_impossible: bool,
}

impl Reader<'_> {
    fn block(&mut self, bound: BlockAt<'_>, consumed: bool) -> Draft {
        let operand = |index: usize| bound.facts.operands.get(index).map(|operand| &operand.value);
        let Meaning::Instruction(row) = bound.meaning else {
            self.epoch += 1;
            return Draft::Done(self.output(consumed));
        };
        let law = self.context.profile.law();
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
            Power::Output => {
                self.writes(bound);
                let gate = self.output(consumed);
                if let (Gate::Gives(ask), Some(node)) = (&gate, operand(0))
                    // There the power is not the output.
                    && law.timing != Timing::Ticks
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
        if kind == CoilKind::Set && self.context.profile.law().set_power == SetPower::En {
            return Gate::Pass;
        }
        gate
    }

    fn unknown(&mut self) -> Ask {
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

    fn contact(&mut self, node: &Node, negated: bool) -> Ask {
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

    fn variable(&mut self, key: String, variable: Variable) -> usize {
        let next = self.variables.len();
        let index = *self.by_key.entry(key).or_insert(next);
        if index == next {
            self.variables.push(variable);
        }
        index
    }

    fn comparison(&mut self, bound: BlockAt<'_>, op: Op) -> Draft {
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
        let NodeKind::Literal(Ok(Literal::Bool(value))) = literal.kind else {
            return None;
        };
        matches!(op, Op::Eq | Op::Ne).then(|| self.contact(tag, value != (op == Op::Eq)))
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

    fn note_read(&mut self, tags: &[TagId]) {
        self.reads_unknown_write |=
            self.epoch > 0 || tags.iter().any(|tag| self.unknown_writes.contains(tag));
    }

    /// The tag whose memory a place lies in.
    fn base(&self, node: &Node) -> Option<TagId> {
        match &node.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => {
                Some(tag(self.context, self.network.scope, name)?.0)
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
    fn key(&self, node: &Node) -> Option<(String, Vec<TagId>)> {
        match &node.kind {
            NodeKind::Name(name) | NodeKind::Address(name) => {
                let (id, _) = tag(self.context, self.network.scope, name)?;
                Some((format!("{}:{}", id.0, id.1), vec![id]))
            }
            NodeKind::Paren(inner) => self.key(inner),
            NodeKind::Member(base, word) => {
                let word = match word.text.to_ascii_uppercase() {
                    word if word == "DN" => "Q".to_owned(),
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

    fn versioned(&self, key: &str, tags: &[TagId]) -> String {
        let changes: u32 = tags
            .iter()
            .map(|tag| self.versions.get(tag).copied().unwrap_or(0))
            .sum();
        format!("{key}@{changes}.{}", if tags.is_empty() { 0 } else { self.epoch })
    }

    fn text(&self, node: &Node) -> String {
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

    fn ask(&mut self, comparison: Comparison) -> Ask {
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

impl Variable {
    /// How many values it has.
    pub(crate) fn size(&self) -> usize {
        match self {
            Variable::Bool(_) | Variable::Fixed(_) | Variable::Unknown => 2,
            Variable::Number(_, regions) => regions.count(),
            Variable::Pair(..) => 3,
        }
    }

    /// That it has one of its values, as a person says it; none if it has no name.
    pub(crate) fn says(&self, value: usize) -> Option<String> {
        Some(match self {
            Variable::Bool(name) => format!("{name} = {value}"),
            Variable::Number(name, regions) => regions.says(name, value),
            Variable::Pair(left, right) => format!("{left} {} {right}", ["<", "=", ">"][value]),
            Variable::Fixed(_) | Variable::Unknown => return None,
        })
    }
}

fn literal_index(node: &Node) -> Option<i128> {
    match &node.kind {
        NodeKind::Literal(Ok(Literal::Int(n))) => Some(*n),
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

//! `unhandled-value`: a chain of networks handles an enumeration value by value, and leaves some of them out.
//!
//! It is such a chain if it asks for two values at least. A value is left out if no network of the program or body asks for it,
//! next to the chain or elsewhere, and none asks for all others: with `[NE]`, or with `[NOT]` after `[EQ]`.

use crate::boolean::written::written;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::{Body, Context};
use crate::networks::{BlockAt, NetworkAt};
use crate::values::compound::EnumId;
use crate::values::types::{Scalar, Type};
use crate::written::facts::{Node, NodeKind, Operator};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use std::collections::hash_map::Entry;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Program,
    "unhandled-value",
    Severity::Info,
));

/// A shorter chain is one question, not a choice among all values; and so is one for a single value.
const SHORTEST: usize = 2;

/// Networks one after the other that compare one tag.
#[derive(Clone)]
struct Chain {
    path: Name,
    shown: String,
    body: Body,
    id: EnumId,
    first: TextRange,
    networks: usize,
    /// Without those that are there twice.
    values: Vec<SmolStr>,
    /// A network asks for all values but some.
    has_else: bool,
}

impl Chain {
    fn is_long(&self) -> bool {
        self.networks >= SHORTEST && self.values.len() >= SHORTEST
    }

    fn add(&mut self, values: impl IntoIterator<Item = SmolStr>, has_else: bool) {
        self.has_else |= has_else;
        for value in values {
            let is_it = |known: &SmolStr| Name::new(known) == Name::new(&value);
            if !self.values.iter().any(is_it) {
                self.values.push(value);
            }
        }
    }
}

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.types.have_values() {
        return;
    }
    let mut chains: Vec<Chain> = Vec::new();
    let mut is_open = false;
    for network in &context.networks {
        let body = context.bodies[network.index];
        let compared = compared(context, network);
        let goes_on = |chain: &&mut Chain, path: &Name| is_open && chain.body == body && chain.path == *path;
        let Some(found) = compared else {
            is_open = false;
            continue;
        };
        match chains.last_mut().filter(|chain| goes_on(chain, &found.path)) {
            Some(chain) => {
                chain.networks += 1;
                chain.add(found.values, found.has_else);
            }
            None => chains.push(found),
        }
        is_open = true;
    }
    let mut asked: FxHashMap<(Body, Name), Chain> = FxHashMap::default();
    for chain in &chains {
        match asked.entry((chain.body, chain.path.clone())) {
            Entry::Vacant(free) => {
                free.insert(chain.clone());
            }
            Entry::Occupied(mut all) => all.get_mut().add(chain.values.iter().cloned(), chain.has_else),
        }
    }
    // Each path is reported once, at its first chain.
    for chain in chains.iter().filter(|chain| chain.is_long()) {
        let all = asked.remove(&(chain.body, chain.path.clone()));
        out.extend(all.and_then(|all| unhandled(chain, &all)));
    }
}

/// What a network compares with values of an enumeration.
fn compared(context: &Context, network: NetworkAt<'_>) -> Option<Chain> {
    let mut found: Option<Chain> = None;
    let mut is_turned = false;
    for block in network.blocks().filter(|block| !block.faulty) {
        is_turned |= block.op() == Some(Op::Inverter);
        let value = |node: &Node| context.value_of(network.scope, block, node);
        for (left, right, is_else) in comparisons(&block) {
            let (path, (id, value)) = match (value(left), value(right)) {
                (None, Some(value)) => (left, value),
                (Some(value), None) => (right, value),
                _ => continue,
            };
            if context.path_type(network.scope, path) != Some(Type::Scalar(Scalar::Enum(id))) {
                continue;
            }
            let shown = written(context, network.scope, path);
            let chain = found.get_or_insert_with(|| Chain {
                path: Name::new(&shown),
                shown: shown.clone(),
                body: context.bodies[network.index],
                id,
                first: block.range(),
                networks: 1,
                values: Vec::new(),
                has_else: false,
            });
            if chain.path == Name::new(&shown) {
                // Only what is asked for by itself is handled.
                chain.add((!is_else).then_some(value), is_else);
            }
        }
    }
    if let Some(chain) = &mut found {
        chain.has_else |= is_turned;
    }
    found
}

/// The two sides of what a block compares, and whether for being different; `=` in an expression handles no value.
fn comparisons<'n>(block: &'n BlockAt<'_>) -> Vec<(&'n Node, &'n Node, bool)> {
    let mut found = Vec::new();
    match (block.op(), &*block.facts.operands) {
        (Some(op @ (Op::Eq | Op::Ne)), [left, right]) => {
            found.push((&left.value, &right.value, op == Op::Ne));
        }
        (Some(Op::Calc), [_, expression]) => in_expression(&expression.value, &mut found),
        _ => {}
    }
    found
}

// An expression nests no deeper than it was parsed.
fn in_expression<'n>(node: &'n Node, found: &mut Vec<(&'n Node, &'n Node, bool)>) {
    match &node.kind {
        NodeKind::Binary(Operator::NotEqual, left, right) => found.push((left, right, true)),
        NodeKind::Binary(_, left, right) => {
            in_expression(left, found);
            in_expression(right, found);
        }
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => in_expression(inner, found),
        _ => {}
    }
}

/// What a chain leaves out of all that its program or body asks for.
fn unhandled(chain: &Chain, all: &Chain) -> Option<Diagnostic> {
    if all.has_else {
        return None;
    }
    let enumeration = chain.id.get();
    let is_missing = |name: &&SmolStr| {
        let key = Name::new(name);
        !all.values.iter().any(|value| Name::new(value) == key)
    };
    let missing: Vec<&str> = enumeration
        .values
        .iter()
        .map(|(name, _)| name)
        .filter(is_missing)
        .map(SmolStr::as_str)
        .collect();
    let (shown, count) = (&chain.shown, chain.networks);
    (!missing.is_empty()).then(|| {
        let message = format!(
            "these {count} networks ask for values of `{shown}`, and none for {}",
            missing.join(", ")
        );
        Diagnostic::new(RULE, chain.first, message)
            .help("add a network for each, if something is to happen then")
    })
}

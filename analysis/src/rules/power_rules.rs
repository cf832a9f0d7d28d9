//! The rules that decide on a network's boolean function: which networks are worth it, and one table for all of
//! them.

use super::survey::Survey;
use super::tags_shown::TagsShown;
use crate::boolean::power::{NetworkPower, Powers, Question};
use crate::names::context::Context;
use crate::names::operand_value::{Number, number, scalar};
use crate::networks::named::Named;
use crate::networks::{BlockAt, NetworkAt};
use crate::program::Access;
use crate::program::Step;
use crate::values::types::Scalar;
use ladder_instructions::{Op, Power, Role};
use smallvec::SmallVec;

/// A network and its table.
pub(super) struct Table<'c> {
    pub(super) tags: TagsShown<'c>,
    pub(super) network: NetworkAt<'c>,
    pub(super) power: NetworkPower<'c>,
    /// The powers as the network runs.
    pub(super) powers: Powers,
    /// For each block the step that gives its power.
    pub(super) step_of: Vec<usize>,
    /// For each step the one that its power comes from by way of conditions only, whichever way it takes.
    parents: Vec<Option<usize>>,
}

/// The table of a network in which one value is asked for more than once: where each is asked for once, every contact counts.
pub(super) fn table<'c>(survey: &Survey<'c>, network: NetworkAt<'c>) -> Option<Table<'c>> {
    let is_worth_it = is_worth_it(survey.context, network) && !network.blocks().any(|bound| bound.faulty);
    is_worth_it.then(|| Table::new(survey.context, network, survey.rail_varies(network)))?
}

impl<'c> Table<'c> {
    fn new(context: &'c Context, network: NetworkAt<'c>, rail_varies: bool) -> Option<Table<'c>> {
        let power = NetworkPower::new(context, network, rail_varies)?;
        let powers = power.powers(Question::default());
        let mut step_of = vec![0; network.blocks.len()];
        for (index, step) in network.order.steps.iter().enumerate() {
            if let Step::Block { block, .. } = *step {
                step_of[block] = index;
            }
        }
        let mut table = Table {
            tags: TagsShown::of(context, network),
            network,
            power,
            powers,
            step_of,
            parents: Vec::with_capacity(network.order.steps.len()),
        };
        for step in &network.order.steps {
            let parent = match *step {
                Step::Block { block, en } if is_condition(network.block(block)) => Some(en),
                Step::Join { upper, lower } => table.origin(upper, lower),
                _ => None,
            };
            table.parents.push(parent);
        }
        Some(table)
    }

    /// The step where two branches begin, if they are made of conditions only and get their power from nowhere else.
    pub(super) fn origin(&self, upper: usize, lower: usize) -> Option<usize> {
        let (mut a, mut b) = (upper, lower);
        while a != b {
            let later = if a > b { &mut a } else { &mut b };
            *later = self.parents[*later]?;
        }
        Some(a)
    }

    pub(super) fn block(&self, block: usize) -> BlockAt<'c> {
        self.network.block(block)
    }
}

/// Whether a block is a contact, an edge or a comparison: it decides about power and does nothing else.
pub(super) fn is_condition(bound: BlockAt<'_>) -> bool {
    bound
        .instruction()
        .is_some_and(|row| row.role == Role::Condition && !matches!(row.op, Op::Lbl | Op::Fun))
}

/// Whether conditions of the network read one tag at two places, or after the place where the network writes it, or
/// a comparison in it may have one answer only.
fn is_worth_it(context: &Context, network: NetworkAt<'_>) -> bool {
    let compares = |bound| compares_numbers(context, network, bound);
    if network.blocks().any(compares) {
        return true;
    }
    let scope = &context.scopes[network.scope];
    let shared = |tag: usize| {
        let shared = context.alias_of(&scope.tags[tag]).unwrap_or((network.scope, tag));
        context.first_at_address(shared)
    };
    let mut uses: SmallVec<[((usize, usize), &Named); 16]> = context
        .names_of(network)
        .iter()
        .map(|(named, tag)| (shared(tag), named))
        .collect();
    uses.sort_by_key(|(tag, _)| *tag);
    uses.chunk_by(|(a, _), (b, _)| a == b)
        .any(|of_tag| of_tag.len() > 1 && is_asked_again(network, of_tag))
}

fn is_asked_again(network: NetworkAt<'_>, uses: &[((usize, usize), &Named)]) -> bool {
    let uses = || uses.iter().map(|(_, named)| *named);
    let block = |place: &Named| place.block as usize;
    let mut asked = uses()
        .filter(|place| place.kind.access() == Access::Read && is_condition(network.block(block(place))));
    let Some(first) = asked.next() else { return false };
    if asked.next().is_some() {
        return true;
    }
    let writes = |at: usize| uses().any(|place| place.kind.access().writes() && block(place) == at);
    if !uses().any(|place| place.kind.access().writes()) {
        return false;
    }
    // Whichever comes first in the order of evaluation.
    let first_step = network.order.steps.iter().find_map(|step| match *step {
        Step::Block { block: at, .. } if at == block(first) || writes(at) => Some(at),
        _ => None,
    });
    first_step.is_some_and(|at| at != block(first))
}

/// A comparison of two numbers, or with a number at the end of its type.
fn compares_numbers(context: &Context, network: NetworkAt<'_>, bound: BlockAt<'_>) -> bool {
    if !bound
        .instruction()
        .is_some_and(|row| row.power == Power::Compares)
    {
        return false;
    }
    let mut types = bound
        .facts
        .operands
        .iter()
        .map(|o| scalar(context, network.scope, &o.value));
    let numbers = bound
        .facts
        .operands
        .iter()
        .filter_map(|o| number(context, network.scope, &o.value));
    let bounds = types
        .find_map(|ty| ty.and_then(Scalar::bounds))
        .unwrap_or((i128::MIN, i128::MAX));
    let mut count = 0;
    for number in numbers {
        count += 1;
        if matches!(number, Number::Int(n) if n <= bounds.0 || n >= bounds.1) {
            return true;
        }
    }
    count > 1
}

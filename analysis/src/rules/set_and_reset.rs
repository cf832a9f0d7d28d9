//! `set-and-reset`: whenever one coil sets a tag, another resets it in the same scan, or the other way round.
//!
//! Decided for coils whose conditions are in series: the later one always acts with the earlier one if each of
//! its conditions is one of the earlier one's, and nothing between them writes what they ask for.

use super::parts::{self, Part};
use super::tag_view::TagView;
use crate::boolean::written::written;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::names::operand_value::{each_tag_path, tag};
use crate::networks::NetworkAt;
use crate::networks::control_flow::ControlFlow;
use crate::written::facts::{Node, NodeKind};

use crate::networks::use_place::Use;
use crate::program::Step;
use ladder_instructions::{Coil, Power, Role};
use rustc_hash::FxHashSet;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "set-and-reset", Severity::Warning).about_types());

/// What in a network leaves it unclear whether a coil acts with another one above it.
const UNCLEAR: ControlFlow = ControlFlow::LEAVES
    .with(ControlFlow::FOR)
    .with(ControlFlow::CALL)
    .with(ControlFlow::FLOW_BLOCK);

/// How many coils of one tag are compared with each other.
const MOST: usize = 16;

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let is_latch = view.places.sets > 0 && view.places.writes > view.places.sets;
    if is_latch && !view.unread.read && !view.around.any.has(ControlFlow::MCR) {
        for part in view.parts().filter(|part| !part.is_span) {
            in_part(view, &part, out);
        }
    }
}

fn in_part(view: &TagView<'_>, part: &Part<'_>, out: &mut Vec<Diagnostic>) {
    let (context, any) = (view.context, view.around.any);
    let coil = |place: &Use| context.networks.at(place.network).block(place.block).coil();
    let sets = |place: &Use| coil(place) == Some(Coil::Sets);
    let writers = part.own.iter().filter(|place| place.access().writes());
    let coils: Vec<Latch> = writers
        .map(|place| context.networks.use_of(*place))
        .filter(|place| matches!(coil(place), Some(Coil::Sets | Coil::Resets)))
        .take(MOST)
        .filter_map(|place| Latch::new(context, place, sets(&place)))
        .collect();
    for (index, earlier) in coils.iter().enumerate() {
        let undone = coils[index + 1..].iter().find(|later| {
            later.sets != earlier.sets
                && later.conditions.is_subset(&earlier.conditions)
                && context.bodies[later.place.network] == context.bodies[earlier.place.network]
                && !is_unclear_between(context, any, earlier, later)
                && !is_changed_between(context, earlier, later)
        });
        if let Some(later) = undone {
            out.push(found(part.name, earlier, later));
        }
    }
}

/// Whether a network from the earlier coil to the later one may move the program on to another place.
fn is_unclear_between(context: &Context, any: ControlFlow, earlier: &Latch, later: &Latch) -> bool {
    let mut networks = context
        .networks
        .range(earlier.place.network..later.place.network + 1);
    any.has(UNCLEAR) && networks.any(|network| network.control_flow.has(UNCLEAR))
}

struct Latch {
    place: Use,
    sets: bool,
    /// Where it is in its network's order of evaluation.
    step: usize,
    /// What must be so for it to act.
    conditions: FxHashSet<String>,
    /// The tags that these ask for, and which part of each.
    asked: Vec<((usize, usize), Option<String>)>,
}

impl Latch {
    /// None unless its conditions are in series after the left rail.
    fn new(context: &Context, place: Use, sets: bool) -> Option<Latch> {
        let network = context.networks.at(place.network);
        if network.broken {
            return None;
        }
        let steps = &network.order.steps;
        let is_it = |step: &Step| matches!(*step, Step::Block { block, .. } if block == place.block);
        let step = steps.iter().position(is_it)?;
        let mut coil = Latch {
            place,
            sets,
            step,
            conditions: FxHashSet::default(),
            asked: Vec::new(),
        };
        let Step::Block { mut en, .. } = steps[step] else {
            return None;
        };
        loop {
            match steps[en] {
                Step::Start { rail } => return rail.then_some(coil),
                Step::Join { .. } => return None,
                Step::Block { block, en: before } => {
                    coil.pass(context, network, block)?;
                    en = before;
                }
            }
        }
    }

    fn pass(&mut self, context: &Context, network: NetworkAt<'_>, block: usize) -> Option<()> {
        let bound = network.block(block);
        let row = bound.instruction().filter(|_| !bound.faulty)?;
        match row.power {
            Power::Passes if row.coil.is_some() => return Some(()),
            Power::EnEdge(_) | Power::Inverts => return None,
            _ if row.role != Role::Condition => return None,
            _ => {}
        }
        let mut key = row.block();
        for operand in &bound.facts.operands {
            key.push(' ');
            key.push_str(&same_text(context, network.scope, &operand.value)?);
            each_tag_path(&operand.value, &mut |path| {
                if let Some((id, _)) = path
                    .root_name()
                    .and_then(|name| tag(context, network.scope, name))
                {
                    self.asked.push((id, parts::fixed(context, network.scope, path)));
                }
            });
        }
        self.conditions.insert(key);
        Some(())
    }
}

/// A text that is the same for the same value; none for what the text does not say whole.
fn same_text(context: &Context, scope: usize, node: &Node) -> Option<String> {
    let text = written(context, scope, node);
    (!text.contains("...") && !matches!(node.kind, NodeKind::Missing)).then_some(text)
}

/// Whether a block from the earlier coil to the later one writes what the two ask for.
fn is_changed_between(context: &Context, earlier: &Latch, later: &Latch) -> bool {
    let networks = earlier.place.network..=later.place.network;
    // In one network the order of the text is not that of evaluation.
    if earlier.place.network == later.place.network && later.step < earlier.step {
        return true;
    }
    earlier.asked.iter().any(|((scope, tag), asked)| {
        let tag = &context.scopes[*scope].tags[*tag];
        let mut names = std::iter::once(tag).chain(context.others_at_address(tag));
        names.any(|name| {
            let mut writers = context.writers(name);
            writers.any(|place| {
                networks.contains(&place.network)
                    && !parts::apart(asked.as_deref(), parts::fixed_at(context, &place).as_deref())
            })
        })
    })
}

fn found(name: &str, earlier: &Latch, later: &Latch) -> Diagnostic {
    let (does, undoes) = if earlier.sets {
        ("sets", "resets")
    } else {
        ("resets", "sets")
    };
    Diagnostic::new(
        RULE,
        earlier.place.range,
        format!(
            "whenever this {does} `{name}`, another coil {undoes} it in the same scan: this has no effect"
        ),
    )
    .help("change one of the conditions, or remove one of the coils")
    .related(later.place.range, format!("this {undoes} `{name}`"))
}

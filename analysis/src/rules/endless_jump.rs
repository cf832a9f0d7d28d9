//! `endless-jump`: a jump back that a scan cannot get out of.

use super::flow::{Exit, Flow};
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::names::context::Context;
use crate::names::operand_value::tag;
use crate::networks::control_flow::ControlFlow;
use crate::networks::{BlockAt, NetworkAt};
use crate::program::Step;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::Op;
use std::cell::LazyCell;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "endless-jump", Severity::Warning).when(When::Whole));

pub(super) fn check(flow: &Flow<'_>, out: &mut Vec<Diagnostic>) {
    let reached = flow.reached();
    let can_end = LazyCell::new(|| flow.can_end());
    for exit in &flow.exits {
        let Some(to) = exit.to.filter(|&to| to <= exit.from && reached[exit.from]) else {
            continue;
        };
        if exit.always && !can_end[to] {
            out.push(endless(
                flow,
                exit,
                to,
                "a scan that comes here never ends: this always jumps back".to_owned(),
            ));
        } else if let Some(name) = waits(flow, exit, to) {
            let message = format!(
                "a scan waits here for ever while the condition holds: nothing in the loop changes {name}"
            );
            out.push(endless(flow, exit, to, message));
        }
    }
}

fn endless(flow: &Flow<'_>, exit: &Exit, to: usize, message: String) -> Diagnostic {
    let target = flow.context.networks.at(flow.networks[to]);
    let mut found = Diagnostic::new(RULE, flow.block(exit).range(), message).help(
        "do not wait within a scan: the program runs again and again by itself, and inputs are read between two scans",
    );
    let label = target.blocks().find(|bound| bound.op() == Some(Op::Lbl));
    if let Some(label) = label {
        found = found.related(label.range(), "it jumps to here");
    }
    found
}

/// What the condition of a jump back asks for, if it asks only for tags that nothing between the label and the
/// jump writes.
fn waits(flow: &Flow<'_>, exit: &Exit, to: usize) -> Option<String> {
    // The exits are in the order of their networks. This asked first, no network is checked for two of them.
    let before = |network: usize| flow.exits.partition_point(|other| other.from < network);
    if exit.always || before(exit.from + 1) - before(to) != 1 {
        return None;
    }
    let control_flow = flow.control_flow(to..=exit.from);
    let unclear = ControlFlow::CALL
        .with(ControlFlow::USER_BLOCK)
        .with(ControlFlow::FLOW_BLOCK)
        .with(ControlFlow::MCR)
        .with(ControlFlow::FOR)
        .with(ControlFlow::RETURN)
        .with(ControlFlow::END);
    if control_flow.has(unclear) {
        return None;
    }
    let context = flow.context;
    let network = context.networks.at(flow.networks[exit.from]);
    let conditions = conditions_before(network, exit)?;
    let mut asked = Vec::new();
    for bound in &conditions {
        for operand in &bound.facts.operands {
            tags(context, network.scope, &operand.value, &mut asked)?;
        }
    }
    let in_loop = |network: usize| {
        let at = flow.place(network);
        at.is_some_and(|at| (to..=exit.from).contains(&at))
    };
    let written = asked.iter().any(|&(scope, tag)| {
        let tag = &context.scopes[scope].tags[tag];
        let mut names = std::iter::once(tag).chain(context.others_at_address(tag));
        names.any(|tag| context.writers(tag).any(|place| in_loop(place.network)))
    });
    let &(scope, tag) = asked.first().filter(|_| !written)?;
    Some(if asked.len() == 1 {
        format!("`{}`", context.scopes[scope].tags[tag].name)
    } else {
        "what it asks for".to_owned()
    })
}

/// All conditions that the power of an exit passes; none if other blocks have a part in it.
fn conditions_before<'c>(network: NetworkAt<'c>, exit: &Exit) -> Option<Vec<BlockAt<'c>>> {
    let mut found = Vec::new();
    let mut seen = vec![false; exit.step + 1];
    let mut open = vec![exit.step];
    while let Some(step) = open.pop() {
        if std::mem::replace(&mut seen[step], true) {
            continue;
        }
        match network.order.steps[step] {
            Step::Start { .. } => {}
            Step::Join { upper, lower } => open.extend([upper, lower]),
            Step::Block { block, en } => {
                let bound = network.block(block);
                match bound.op()? {
                    Op::Jmp | Op::Lbl | Op::Inverter => {}
                    Op::Contact
                    | Op::NegatedContact
                    | Op::Eq
                    | Op::Ne
                    | Op::Gt
                    | Op::Ge
                    | Op::Lt
                    | Op::Le => {
                        found.push(bound);
                    }
                    _ => return None,
                }
                open.push(en);
            }
        }
    }
    Some(found)
}

/// The tags that a value depends on.
fn tags(context: &Context, scope: usize, node: &Node, out: &mut Vec<(usize, usize)>) -> Option<()> {
    match &node.kind {
        NodeKind::Name(name) | NodeKind::Address(name) => out.push(tag(context, scope, name)?.0),
        NodeKind::Member(base, _) => {
            // System tags stay the same during a scan.
            if !matches!(&base.kind, NodeKind::Name(name) if name.eq_ignore_ascii_case("SYS")) {
                tags(context, scope, base, out)?;
            }
        }
        NodeKind::Index(base, index) => {
            tags(context, scope, base, out)?;
            tags(context, scope, index, out)?;
        }
        NodeKind::Range(base, first, last) => {
            for part in [base, first, last] {
                tags(context, scope, part, out)?;
            }
        }
        NodeKind::Paren(inner) | NodeKind::Unary(_, inner) => tags(context, scope, inner, out)?,
        NodeKind::Literal(_) => {}
        _ => return None,
    }
    Some(())
}

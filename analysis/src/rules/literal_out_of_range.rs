//! `literal-out-of-range`: a number does not fit the type of its place. What does not fit an elementary type is found while operands
//! are resolved; here are the constants that are written where a declaration says `INT(0..100)`.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::Context;
use crate::names::limits::{self, Limited};
use crate::names::operand_value::{Number, number};
use crate::networks::network::{Formal, Meaning};
use crate::networks::{BlockAt, NetworkAt};
use crate::program::ParameterKind;
use crate::written::facts::Node;
use ladder_instructions::Op;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Blocks, "literal-out-of-range", Severity::Error).about_types());

pub(super) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if !context.types.have_limits {
        return;
    }
    for network in &context.networks {
        for block in network.blocks().filter(|block| !block.faulty) {
            match block.meaning {
                Meaning::Instruction(row) => copied(context, network, block, row.op, out),
                Meaning::User(user) => passed(context, network, block, user, out),
                Meaning::Unknown | Meaning::UnknownUser => {}
            }
        }
    }
}

/// Checks the constants that an instruction may copy to its result as they are.
fn copied(context: &Context, network: NetworkAt<'_>, block: BlockAt<'_>, op: Op, out: &mut Vec<Diagnostic>) {
    let first = match op {
        Op::Mov | Op::Calc | Op::Fill | Op::Shift => 1,
        Op::Sel | Op::Mux | Op::Lut => 2,
        _ => return,
    };
    let operands = &block.facts.operands;
    let limited = operands
        .first()
        .and_then(|result| context.limits(network.scope, &result.value));
    if let Some(limited) = limited {
        for operand in operands.iter().skip(first) {
            out.extend(outside(context, network, block, &operand.value, limited));
        }
    }
}

/// Checks the constants that are given for inputs.
fn passed(
    context: &Context,
    network: NetworkAt<'_>,
    block: BlockAt<'_>,
    user: usize,
    out: &mut Vec<Diagnostic>,
) {
    let facts = &context.user_blocks[user];
    let file = facts.import.as_ref().map(|import| &import.file);
    for (operand, formal) in block.facts.operands.iter().zip(block.formals.iter()) {
        let Formal::Parameter(index) = formal else {
            continue;
        };
        let parameter = &facts.parameters[*index];
        let declared = parameter
            .declared
            .as_ref()
            .filter(|_| parameter.kind == ParameterKind::Input);
        if let Some(limited) = declared.and_then(|declared| context.limits_of(&declared.spec, file)) {
            out.extend(outside(context, network, block, &operand.value, limited));
        }
    }
}

fn outside(
    context: &Context,
    network: NetworkAt<'_>,
    block: BlockAt<'_>,
    node: &Node,
    limited: Limited,
) -> Option<Diagnostic> {
    let Number::Int(number) = number(context, network.scope, node)? else {
        return None;
    };
    let message = limits::message(number, limited)?;
    Some(Diagnostic::new(RULE, block.absolute(node.range), message))
}

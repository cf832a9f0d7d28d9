//! `no-output`: a network that writes nothing and calls, jumps or ends nothing.

use super::form::Form;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::{BlockAt, NetworkAt};
use ladder_instructions::{Op, Role};
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{Parse, TextRange};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(RuleGroup::Wiring, "no-output", Severity::Warning));

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    if network.broken || network.blocks().any(may_act) {
        return;
    }
    let Some(range) = first_rung(form.parse, network) else {
        return;
    };
    let found = Diagnostic::new(RULE, range, "this network does nothing: no block in it acts");
    out.push(if network.blocks.is_empty() {
        found.help("put blocks onto the wire, or remove the line")
    } else {
        found.help(
            "its contacts only pass power on: end it with a coil or another block that acts, or remove it",
        )
    });
}

/// The drawing of the first rung, without the comments at its ends.
pub(super) fn first_rung(parse: &Parse, network: NetworkAt<'_>) -> Option<TextRange> {
    (0..network.wiring.rungs[0].parts.len())
        .filter(|&part| {
            let kind = network.wiring.rungs[0].parts[part].kind;
            !matches!(kind, PartKind::Comment | PartKind::Bar)
        })
        .map(|part| network.part_range(parse, 0, part))
        .reduce(TextRange::cover)
}

/// Whether a block does more than pass power on, or might.
pub(super) fn may_act(bound: BlockAt<'_>) -> bool {
    match bound.instruction() {
        Some(row) => row.role == Role::Acting || matches!(row.op, Op::Lbl | Op::Fun),
        // A user-defined block acts; of an unknown one nothing is known.
        None => true,
    }
}

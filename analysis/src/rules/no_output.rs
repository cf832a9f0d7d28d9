//! `no-output`: a network that writes nothing and calls, jumps or ends nothing, and does not say so with `# NOP #` in a wire.

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
    if network.broken || network.blocks().any(may_act) || is_meant(form.parse, network) {
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

/// Whether the comment `# NOP #` is a piece of one of its wires: what other systems call a rung that is to do nothing.
fn is_meant(parse: &Parse, network: NetworkAt<'_>) -> bool {
    network.wiring.rungs.iter().enumerate().any(|(rung, drawn)| {
        let mut threes = drawn.parts.windows(3).enumerate();
        threes.any(|(before, parts)| {
            let [left, comment, right] = [&parts[0], &parts[1], &parts[2]];
            let joins =
                left.range.end() == comment.range.start() && comment.range.end() == right.range.start();
            comment.kind == PartKind::Comment && joins && {
                let text = parse.text_in(network.part_range(parse, rung, before + 1));
                text.trim_matches('#').trim() == "NOP"
            }
        })
    })
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

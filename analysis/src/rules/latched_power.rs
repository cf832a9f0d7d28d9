//! `latched-power`: something is after a set coil, whose power is the tag and not the rung's. A warning where that acts.

use super::wiring_walk::Walk;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::control_flow::ControlFlow;
use crate::program::Step;
use ladder_format::Edit;
use ladder_instructions::{Coil, SetPower};
use ladder_syntax::wiring::PartKind;
use ladder_syntax::{TextRange, TextSize};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Wiring, "latched-power", Severity::Warning).fixed(Applicability::Unsafe));

pub(super) fn check(walk: &Walk<'_>, out: &mut Vec<Diagnostic>) {
    let sets = walk.network.control_flow.has(ControlFlow::SET) && walk.network.blocks.len() > 1;
    if !sets || walk.tags.profile().semantics().set_power == SetPower::En {
        return;
    }
    // For each step the set coil whose power it carries, and the step of that coil.
    let mut latched: Vec<Option<(usize, usize)>> = Vec::with_capacity(walk.steps().len());
    let mut reported = vec![false; walk.network.blocks.len()];
    for (index, step) in walk.steps().iter().enumerate() {
        latched.push(match *step {
            Step::Start { .. } => None,
            Step::Join { upper, lower } => latched[upper].or(latched[lower]),
            Step::Block { block, en } => {
                if let Some((coil, of)) = latched[en].filter(|&(coil, _)| !reported[coil]) {
                    reported[coil] = true;
                    out.push(found(walk, coil, block, walk.useful[of]));
                }
                match walk.block(block).coil() {
                    Some(Coil::Sets) => Some((block, index)),
                    _ => latched[en],
                }
            }
        });
    }
}

/// `acts`: a block that acts has the power of the coil, at once or further on its way.
fn found(walk: &Walk<'_>, coil: usize, after: usize, acts: bool) -> Diagnostic {
    let fix = branch_before(walk, coil);
    let (coil, after) = (walk.block(coil), walk.block(after));
    let name = coil
        .facts
        .operands
        .first()
        .map_or_else(String::new, |o| walk.tags.written(&o.value));
    let mut found = Diagnostic::new(
        RULE,
        after.range(),
        format!(
            "{} is after {}: its power is `{name}`, and stays on when the rung before goes off",
            walk.tags.written_block(after),
            coil.head_text()
        ),
    )
    .help("draw a branch before the set coil; if the latched power is meant, put a contact of the tag on a rung of its own")
    .related(coil.range(), "the set coil");
    if !acts {
        found.severity = Severity::Info;
    }
    found.fixes.extend(fix);
    found
}

/// Draws a branch before a set coil: what is after it on its line comes onto a line of its own right below, which also takes the
/// connectors of the line down to their partners. None where something after the coil is connected, or where power may
/// go both ways at a connector.
fn branch_before(walk: &Walk<'_>, coil: usize) -> Option<Fix> {
    let (wiring, coil) = (&walk.network.wiring, walk.block(coil));
    let (number, at) = (coil.facts.rung, coil.facts.part);
    let rung = &wiring.rungs[number];
    let segment = rung.parts[at].segment?;
    if rung.segments[segment as usize].parts.start == at {
        return None;
    }
    let rest = &rung.parts[at + 1..];
    let is_plain = rest.iter().all(|part| match part.kind {
        PartKind::Block => part.segment == Some(segment),
        PartKind::Wire | PartKind::RightRail | PartKind::Bar => true,
        _ => false,
    });
    let mut blocks = rest.iter().filter(|part| part.kind == PartKind::Block);
    let first = blocks.next().filter(|_| is_plain)?;
    let last = blocks.next_back().unwrap_or(first);
    let rail = if rest.iter().any(|part| part.kind == PartKind::RightRail) {
        "+"
    } else {
        ""
    };
    let mut line = "|  ".to_owned();
    for point in wiring.points.iter().filter(|point| point.upper == number) {
        let below = &wiring.rungs[number + 1];
        let wire = &below.segments[below.parts[point.up].segment? as usize].parts;
        line.push_str(match (wire.start == point.up, wire.end == point.up + 1) {
            (true, false) => "/--\\  ",
            (false, true) => "\\--/  ",
            _ => return None,
        });
    }
    let (start, text) = walk.tags.line_of(number);
    let drawn = text.trim_end();
    let after = &text[usize::from(first.range.start())..usize::from(last.range.end())];
    let end = match &text[text.trim_end_matches(['\r', '\n']).len()..] {
        "" => "\n",
        end => end,
    };
    let own = TextRange::new(coil.range().end(), start + TextSize::of(drawn));
    let edits = vec![
        Edit {
            range: TextRange::empty(coil.range().start()),
            text: "\\--".to_owned(),
        },
        Edit {
            range: own,
            text: format!("--{rail}{end}{line}/--{after}--{rail}"),
        },
    ];
    let title = format!("Draw a branch before {}", walk.tags.written_block(coil));
    Some(Fix::new(Applicability::Unsafe, title, edits))
}

//! `order-sensitive`: a network that would do something else if all of its contacts were read first.

use super::no_output::may_act;
use super::power_rules::Table;
use crate::boolean::power::Question;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_instructions::Coil;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "order-sensitive", Severity::Info).about_types());

pub(super) fn check(table: &Table<'_>, out: &mut Vec<Diagnostic>) {
    let power = &table.power;
    // Where values are not known, or exclude each other, no combination proves anything.
    if power.gates.reads_unknown_write || power.gates.some_impossible {
        return;
    }
    let first = power.powers(Question {
        read_first: true,
        ..Question::default()
    });
    for (index, bound) in table.network.blocks().enumerate() {
        if !may_act(bound) {
            continue;
        }
        let (Some(now), Some(then)) = (&table.powers.effects[index], &first.effects[index]) else {
            continue;
        };
        let differing = now.differing(then);
        let Some(point) = differing.first() else { continue };
        let on = now.holds(point);
        let tag = bound.facts.operands.first();
        let name = tag.map_or_else(String::new, |o| table.tags.written(&o.value));
        // The other way round is another finding: all values that decide which way it is are named.
        let this_way = &differing & if on { now } else { then };
        let values = power.says(point, &this_way);
        let result = if let Some(coil) = bound.coil() {
            let value = if matches!(coil, Coil::Follows | Coil::Negated) || on {
                u8::from(on)
            } else {
                0
            };
            format!(
                "`{name}` becomes {value}, but {} if all contacts were read first",
                1 - value
            )
        } else {
            let (now, then) = if on {
                ("gets power", "none")
            } else {
                ("gets no power", "power")
            };
            format!(
                "{} {now}, but {then} if all contacts were read first",
                bound.head_text()
            )
        };
        let mut found = Diagnostic::new(
            RULE,
            bound.range(),
            if values.is_empty() {
                format!("the order of this network matters: {result}")
            } else {
                format!("the order of this network matters: with {values}: {result}")
            },
        )
        .help("a contact reads what a coil of the same network has just written: give the later part a rung of its own");
        for place in reads_after_writes(table) {
            found = found.related(place, "this contact sees what the network has just written");
        }
        out.push(found);
        return;
    }
}

/// The contacts that read a tag which a coil of the network has written before them.
fn reads_after_writes(table: &Table<'_>) -> Vec<ladder_syntax::TextRange> {
    use crate::boolean::gate::Gate;
    use crate::program::Step;
    let gates = &table.power.gates;
    let mut written = vec![false; gates.variables.len()];
    let mut places = Vec::new();
    for step in &table.network.order.steps {
        let Step::Block { block, .. } = *step else {
            continue;
        };
        match &gates.of_block[block] {
            Gate::Coil(_, Some(variable)) => written[*variable] = true,
            Gate::If(asks) if asks.iter().any(|ask| written[ask.variable]) => {
                places.push(table.block(block).range());
            }
            _ => {}
        }
    }
    places
}

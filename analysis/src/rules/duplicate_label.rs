//! `duplicate-label`: a label appears more than once; says which one each jump takes.

use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::{Body, Context};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHashMap;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "duplicate-label",
    Severity::Info,
));

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    let mut first: FxHashMap<(Body, &Name), usize> = FxHashMap::default();
    // Each label after the first, with the first.
    let mut again = Vec::new();
    for (index, label) in context.labels.iter().enumerate() {
        let key = (context.bodies[label.network], &label.key);
        match first.get(&key) {
            Some(&first) => again.push((index, first)),
            None => {
                first.insert(key, index);
            }
        }
    }
    if again.is_empty() {
        return;
    }
    let jumps = jumps(context);
    let mut reported = vec![false; context.labels.len()];
    for (index, first) in again {
        let label = &context.labels[index];
        let mut found = Diagnostic::new(
            RULE,
            label.at,
            format!("the label `{}` appears more than once", label.name),
        )
        .help("a jump takes the nearest label after it, else the nearest before it")
        .related(context.labels[first].at, "it is here first");
        // Jumps to the first label are reported with the second.
        let targets: &[usize] = if std::mem::replace(&mut reported[first], true) {
            &[index]
        } else {
            &[first, index]
        };
        for &target in targets {
            let target = &context.labels[target];
            let line = context.line_number(target.at.start());
            for &jump in jumps.get(&(target.network, &target.key)).into_iter().flatten() {
                found = found.related(jump, format!("this jump goes to line {line}"));
            }
        }
        out.push(found);
    }
}

/// The jumps to each label, by the network that they go to.
fn jumps(context: &Context) -> FxHashMap<(usize, &Name), Vec<TextRange>> {
    let mut jumps: FxHashMap<(usize, &Name), Vec<TextRange>> = FxHashMap::default();
    for (index, network) in context.networks.iter().enumerate() {
        for bound in network.blocks().filter(|bound| bound.op() == Some(Op::Jmp)) {
            let Some((name, range)) = bound.facts.first_name() else {
                continue;
            };
            let Some((target, key)) = context.jump_label(index, &Name::new(name)) else {
                continue;
            };
            jumps
                .entry((target, key))
                .or_default()
                .push(bound.absolute(range));
        }
    }
    jumps
}

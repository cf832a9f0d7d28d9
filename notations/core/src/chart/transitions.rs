//! Which transitions happen, and what they make of the steps.

use super::lower::Lowering;
use super::mentions;
use super::model::{Condition, Step, Transition};
use super::networks::{Networks, Part, any, block, contact, element, zero};
use ladder_format::program::{Block, Path};
use ladder_instructions::Op;
use std::collections::{HashMap, HashSet};

/// The conditions in the order of priority, then the steps that are left, then those that are reached.
pub(super) fn lower(
    lowering: &mut Lowering<'_>,
    steps: &[Step],
    transitions: Vec<Transition>,
    networks: &mut Networks,
) -> Result<(), String> {
    let order = order(&transitions);
    let last_reads = last_reads(steps, &transitions, &order);
    let tags: Vec<String> = transitions
        .iter()
        .map(|transition| {
            let (from, to) = (names(steps, &transition.from), names(steps, &transition.to));
            let about = format!("from {from} to {to}");
            lowering.tag(&like(steps, transition), "BOOL", about)
        })
        .collect();
    // A step that nothing asks any more may end at once.
    let ends_at_once: Vec<bool> = transitions
        .iter()
        .enumerate()
        .map(|(number, transition)| {
            let is_last = |step: &usize| last_reads.get(step).is_none_or(|last| order[*last] == number);
            transition.priority.is_some() || transition.from.iter().all(is_last)
        })
        .collect();
    if !transitions.is_empty() {
        networks.comment("transitions");
    }
    let mut conditions: Vec<Option<Condition>> = Vec::new();
    let mut ends = Vec::new();
    for transition in transitions {
        conditions.push(Some(transition.condition));
        ends.push((transition.from, transition.to, transition.origin));
    }
    for number in order {
        let (from, _, origin) = &ends[number];
        let condition = conditions[number].take().unwrap_or_default();
        let active = || from.iter().map(|step| contact(&steps[*step].active, *origin));
        let mut parts: Vec<Part> = Vec::new();
        let mut label = None;
        let tag = || Path::tag(&tags[number]);
        if condition.before.is_empty() {
            parts.extend(active());
        } else {
            let end = lowering.fresh(&format!("{}_end", tags[number]));
            let mut skip: Vec<Part> = active().collect();
            skip.push(element(Block::inverter(), *origin));
            skip.push(block(Op::ResetCoil, [tag().into()], *origin)?);
            skip.push(element(Block::jump(&end), *origin));
            networks.push(skip);
            networks.extend(condition.before);
            label = Some(end);
        }
        parts.extend(condition.power);
        parts.push(element(Block::coil(tag()), *origin));
        if ends_at_once[number] {
            parts.extend(resets(steps, from, *origin)?);
        }
        networks.push(parts);
        if let Some(label) = label {
            networks.label(label);
        }
    }
    for (number, (from, _, origin)) in ends.iter().enumerate() {
        if !ends_at_once[number] {
            let mut parts = vec![contact(&tags[number], *origin)];
            parts.extend(resets(steps, from, *origin)?);
            networks.push(parts);
        }
    }
    for (number, (_, to, origin)) in ends.iter().enumerate() {
        let mut parts = vec![contact(&tags[number], *origin)];
        for step in to.iter().filter(|step| lowering.needs_elapsed[**step]) {
            let elapsed = Path::tag(&steps[*step].elapsed);
            parts.push(block(Op::Mov, [elapsed.into(), zero()?], *origin)?);
        }
        // Power goes on after a set coil whatever comes in.
        let sets = to.iter().map(|step| Path::tag(&steps[*step].active));
        let sets = sets.map(|tag| block(Op::SetCoil, [tag.into()], *origin));
        parts.push(any(sets.collect::<Result<_, String>>()?));
        if number == 0 {
            networks.comment("the steps that they lead to");
        }
        networks.push(parts);
    }
    Ok(())
}

fn resets(steps: &[Step], from: &[usize], origin: Option<u32>) -> Result<Vec<Part>, String> {
    let tags = from.iter().map(|step| Path::tag(&steps[*step].active));
    tags.map(|tag| block(Op::ResetCoil, [tag.into()], origin))
        .collect()
}

fn names(steps: &[Step], ends: &[usize]) -> String {
    let names: Vec<&str> = ends.iter().map(|step| steps[*step].name.as_str()).collect();
    names.join(", ")
}

/// What the tag of a transition is called: of its first steps.
fn like(steps: &[Step], transition: &Transition) -> String {
    let name = |ends: &[usize]| ends.first().map_or("", |step| steps[*step].active.as_str());
    format!("{}_to_{}", name(&transition.from), name(&transition.to))
}

/// The order in which conditions are evaluated. One with a priority goes before the first that has a larger one.
fn order(transitions: &[Transition]) -> Vec<usize> {
    let mut order: Vec<usize> = Vec::new();
    let priority = |number: usize| transitions[number].priority.unwrap_or(0);
    for (number, transition) in transitions.iter().enumerate() {
        let at = match transition.priority {
            Some(own) => order.iter().position(|other| priority(*other) > own),
            None => None,
        };
        order.insert(at.unwrap_or(order.len()), number);
    }
    order
}

/// The last place in the order of conditions at which it matters whether a step is active.
fn last_reads(steps: &[Step], transitions: &[Transition], order: &[usize]) -> HashMap<usize, usize> {
    let by_tag: HashMap<String, usize> = steps
        .iter()
        .enumerate()
        .map(|(number, step)| (step.active.to_lowercase(), number))
        .collect();
    let mut last = HashMap::new();
    for (place, number) in order.iter().enumerate() {
        let Transition { from, condition, .. } = &transitions[*number];
        let mut mentioned = HashSet::new();
        mentions::of_items(&condition.before, &mut mentioned);
        condition
            .power
            .iter()
            .for_each(|part| mentions::of_circuit(part, &mut mentioned));
        let mentioned = mentioned.iter().filter_map(|tag| by_tag.get(tag));
        for step in from.iter().chain(mentioned) {
            last.insert(*step, place);
        }
    }
    last
}

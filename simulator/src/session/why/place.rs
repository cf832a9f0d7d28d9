//! From what blocks name to points, and back.

use crate::memory::Bit;
use crate::simulation::{Simulation, name, number};
use crate::tags::Point;
use ladder_analysis::program::{
    Argument, Block, BlockKind, Expr, ExprKind, Member, Place, RangeRef, Step, Tag, TagId,
};
use ladder_analysis::values::types::Type;
use ladder_analysis::values::value::Value;
use ladder_instructions::Group;
use std::ops::Range;

/// The tag that a point is, or is a part of. None for system tags and ports.
pub(super) fn tag_of(simulation: &Simulation, point: &Point) -> Option<TagId> {
    let homes = simulation.compiled.homes.iter();
    let found = homes.zip(0..).find(|(home, _)| home.holds(point.slot));
    found.map(|(_, tag)| TagId(tag))
}

/// The tag that has the state of a block in which a point is: `m1` of `m1.t.ET`.
pub(super) fn holder_of(simulation: &Simulation, point: &Point) -> Option<TagId> {
    let tags = &simulation.program().tags;
    let is_holder = |(_, tag): &(u32, &Tag)| {
        let rest = point.name.strip_prefix(tag.name.as_str());
        matches!(tag.ty, Type::Compound(ty) if ty.block().is_some())
            && rest.is_some_and(|rest| rest.starts_with('.'))
    };
    let holders = (0..).zip(tags).filter(is_holder);
    let (number, _) = holders.min_by_key(|(_, tag)| tag.name.len())?;
    Some(TagId(number))
}

/// The tags that an argument names, or may name.
pub(super) fn argument_tags(argument: &Argument) -> Vec<TagId> {
    match argument {
        Argument::Parts(parts) => parts.iter().flat_map(argument_tags).collect(),
        Argument::ChosenState(chosen) => {
            let all = 0..chosen.count;
            all.map(|n| TagId(chosen.first.0 + n * chosen.step)).collect()
        }
        argument => argument.root().into_iter().collect(),
    }
}

/// The name of what an argument writes, if it is always the same: a tag, or an element with a constant index.
pub(super) fn written_name(simulation: &Simulation, argument: &Argument) -> Option<String> {
    match argument {
        Argument::Place(place, _) => (!Simulation::has_index(place))
            .then(|| name(simulation, place))
            .flatten(),
        Argument::State(tag) => Some(simulation.program().tags[tag.0 as usize].name.clone()),
        _ => None,
    }
}

/// What a block reads, with the values of now. Of a timer or counter how far it has come.
pub(super) fn values_read(simulation: &Simulation, block: &Block) -> Vec<(Point, Value)> {
    let mut names = Vec::new();
    for bound in &block.arguments {
        match &bound.argument {
            Argument::Value(expr) => read_in(simulation, expr, &mut names),
            Argument::Range(range) => range_names(simulation, range, &mut names),
            Argument::State(tag) if matches!(block.kind, BlockKind::Instruction(row) if row.group == Group::State) =>
            {
                let tag = &simulation.program().tags[tag.0 as usize].name;
                names.extend(["ET", "CV"].map(|member| format!("{tag}.{member}")));
            }
            Argument::ChosenState(chosen) if matches!(block.kind, BlockKind::Instruction(row) if row.group == Group::State) =>
            {
                let members = [Member::Et, Member::Cv].into_iter();
                names.extend(
                    members
                        .filter_map(|member| name(simulation, &Place::ChosenMember(chosen.clone(), member))),
                );
            }
            Argument::Place(place, _) if matches!(block.kind, BlockKind::Instruction(row) if row.group == Group::Condition) =>
            {
                names.extend(name(simulation, place));
            }
            _ => {}
        }
    }
    let mut values: Vec<(Point, Value)> = Vec::new();
    for point in names.iter().filter_map(|name| simulation.resolve(name).ok()) {
        if values.iter().all(|(known, _)| *known != point) {
            let value = simulation.value(&point);
            values.push((point, value));
        }
    }
    values
}

fn read_in(simulation: &Simulation, expr: &Expr, names: &mut Vec<String>) {
    match &expr.kind {
        ExprKind::Constant(_) => {}
        ExprKind::Read(place) => names.extend(name(simulation, place)),
        ExprKind::Pass(inner) | ExprKind::Unary(_, inner) => read_in(simulation, inner, names),
        ExprKind::Binary(_, left, right) | ExprKind::Compare(_, left, right) => {
            read_in(simulation, left, names);
            read_in(simulation, right, names);
        }
        ExprKind::Call(_, arguments) => {
            for argument in arguments {
                read_in(simulation, argument, names);
            }
        }
        ExprKind::Sum(range) => range_names(simulation, range, names),
        ExprKind::Offset(subscripts) => {
            for subscript in subscripts {
                read_in(simulation, &subscript.index, names);
            }
        }
    }
}

/// The first elements of a range stand for all.
fn range_names(simulation: &Simulation, range: &RangeRef, names: &mut Vec<String>) {
    const SHOWN: i64 = 16;
    let tag = &simulation.program().tags[range.tag.0 as usize];
    let first = number(simulation, &range.first);
    let last = range.last.as_ref().and_then(|last| number(simulation, last));
    if let (Some(first), Some(last)) = (first, last) {
        let elements = first..=last.min(first.saturating_add(SHOWN - 1));
        names.extend(elements.map(|index| tag.element_name(index)));
    }
}

/// The slot of each step's power in a network; where nothing is drawn there is no power.
pub(super) fn slots(simulation: &Simulation, network: usize, elements: Range<usize>) -> Vec<Bit> {
    let steps = &simulation.program().networks[network].steps;
    let start = |step: &Step| match step {
        Step::Start { rail: true } => Bit::HIGH,
        _ => Bit::LOW,
    };
    let mut slots: Vec<Bit> = steps.iter().map(start).collect();
    let elements = simulation.compiled.elements[elements].iter();
    for element in elements.filter(|element| element.network as usize == network) {
        slots[element.step as usize] = element.power;
    }
    slots
}

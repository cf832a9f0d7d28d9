//! What the notation calls the tags of a program.

use super::model::Family;
use super::parse::variable;
use ladder_analysis::program::{Argument, ExprKind, Location, Place as Operand, Program, Role, Tag, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::StateType;
use ladder_notation::{LineColumn, Report};
use std::collections::{HashMap, HashSet};

/// Names for the tags that can have one.
#[derive(Debug, Default)]
pub(super) struct Names {
    spelled: HashMap<TagId, Result<String, String>>,
    timers: HashSet<TagId>,
    /// The presets that are tags: what they are at first, by their timer or counter.
    presets: HashMap<TagId, i64>,
}

impl Names {
    pub(super) fn of(&self, tag: TagId) -> Result<String, String> {
        let unknown = || Err("it is not a variable there".to_owned());
        self.spelled.get(&tag).cloned().unwrap_or_else(unknown)
    }

    pub(super) fn is_timer(&self, tag: TagId) -> bool {
        self.timers.contains(&tag)
    }

    /// What the preset of a timer or counter is at first, if a tag holds it.
    pub(super) fn preset(&self, state: TagId) -> Option<i64> {
        self.presets.get(&state).copied()
    }
}

/// Finds a name for every tag, and reports those that change.
pub(super) fn names(program: &Program, report: &mut Report, place: impl Fn(Location) -> LineColumn) -> Names {
    let mut names = Names::default();
    let mut taken = HashSet::new();
    let presets = presets(program);
    let all = || (0..).map(TagId).zip(&program.tags);
    for (id, tag) in all() {
        let family = family(tag);
        if family == Ok(Family::Timer) {
            names.timers.insert(id);
        }
        let kept = variable(&tag.name).filter(|own| family == Ok(own.family) || fits(tag, own.family));
        if let Some(own) = kept {
            taken.insert((own.family, own.number));
            names.spelled.insert(id, Ok(own.to_string()));
        }
    }
    let mut next: HashMap<Family, u32> = HashMap::new();
    for (id, tag) in all() {
        if names.spelled.contains_key(&id) || tag.constant {
            continue;
        }
        if presets.contains_key(&id) {
            continue;
        }
        let name = family(tag).map(|family| {
            let number = next.entry(family).or_insert(1);
            while !taken.insert((family, *number)) {
                *number += 1;
            }
            match family {
                Family::Integer | Family::Float => format!("{}{number:02}", family.letters()),
                _ => format!("{}{number}", family.letters()),
            }
        });
        if let Ok(name) = &name {
            let why = format!(
                "the IoT ladder language has variables such as I1, Q1 and MI01 only; it is `{name}` there"
            );
            report.approximated(place(tag.location), format!("tag `{}`", tag.name), why);
        }
        names.spelled.insert(id, name);
    }
    for (tag, state) in presets {
        let Ok(owner) = names.of(state) else { continue };
        names.spelled.insert(tag, Ok(format!("{owner}:PRE")));
        let first = program.tags[tag.0 as usize].initial.first();
        let first = match first {
            Some(Value::Int(number)) => *number,
            _ => 0,
        };
        names.presets.insert(state, first);
    }
    names
}

/// The integer tags that are the preset of one timer or counter and are called otherwise than a variable.
fn presets(program: &Program) -> HashMap<TagId, TagId> {
    let mut presets: HashMap<TagId, Option<TagId>> = HashMap::new();
    for block in program.networks.iter().flat_map(|network| &network.blocks) {
        let mut arguments = block.arguments.iter();
        let Some(Argument::State(state)) = arguments.next().map(|bound| &bound.argument) else {
            continue;
        };
        let Some(Argument::Value(mut value)) = arguments.next().map(|bound| bound.argument.clone()) else {
            continue;
        };
        while let ExprKind::Pass(inside) = value.kind {
            value = *inside;
        }
        if let ExprKind::Read(Operand::Tag(tag)) = value.kind {
            let of = presets.entry(tag).or_insert(Some(*state));
            *of = of.filter(|of| of == state);
        }
    }
    let one = |(tag, state): (TagId, Option<TagId>)| {
        let row = &program.tags[tag.0 as usize];
        // So is one that nothing declares and nothing writes.
        let is_internal = row.role == Role::Internal || (row.shared && row.address.is_none());
        let is_own = variable(&row.name).is_none() && !row.constant && is_internal;
        let is_integer = matches!(row.ty, Type::Scalar(scalar) if scalar.is_integer());
        Some((tag, state.filter(|_| is_own && is_integer)?))
    };
    presets.into_iter().filter_map(one).collect()
}

/// Whether a tag with a name of this family may keep it.
fn fits(tag: &Tag, family: Family) -> bool {
    let Type::Scalar(scalar) = tag.ty else {
        return false;
    };
    match family {
        Family::Input => {
            tag.role != Role::Output && matches!(scalar, Scalar::Bool | Scalar::Usint | Scalar::Byte)
        }
        Family::Output => {
            tag.role != Role::Input && matches!(scalar, Scalar::Bool | Scalar::Usint | Scalar::Byte)
        }
        Family::Integer => scalar.is_integer(),
        Family::Float => scalar.is_real(),
        Family::Timer | Family::Counter => false,
    }
}

/// The family that a tag belongs to, by its type.
fn family(tag: &Tag) -> Result<Family, String> {
    Ok(match (tag.ty, tag.role) {
        (Type::Scalar(Scalar::Bool | Scalar::Usint | Scalar::Byte), Role::Input) => Family::Input,
        (Type::Scalar(Scalar::Bool | Scalar::Usint | Scalar::Byte), Role::Output) => Family::Output,
        (Type::Scalar(Scalar::Bool), Role::Internal) => Family::Integer,
        (Type::Scalar(scalar), _) if scalar.is_real() => Family::Float,
        (Type::Scalar(scalar), _) if scalar.is_integer() && scalar.width() <= 32 => Family::Integer,
        (Type::State(StateType::Ton | StateType::Tof), _) => Family::Timer,
        (Type::State(StateType::Ctu | StateType::Ctd), _) => Family::Counter,
        _ => return Err(format!("there is nothing of the type of `{}` there", tag.name)),
    })
}

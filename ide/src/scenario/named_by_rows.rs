//! The tags of a file, and the parts of tags, that rows of a scenario can name.

use crate::completion::{CompletionKind, Topic};
use crate::symbol::{Symbol, tag_of};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::program::Role;
use ladder_analysis::program::element_name;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_simulator::members_of;
use ladder_simulator::scenario::Direction;
use ladder_syntax::Name;

/// This many elements of an array are proposed.
const ELEMENTS: i64 = 16;
/// So many elementary parts of a tag are proposed.
const COLUMNS: usize = 64;

/// A tag, or a part of one, that can begin a row.
pub(super) struct Proposed {
    pub(super) order: u8,
    pub(super) name: String,
    /// None: its name goes on.
    pub(super) direction: Option<Direction>,
    pub(super) kind: CompletionKind,
    pub(super) detail: String,
    pub(super) topic: Topic,
}

/// Whose tags rows name.
#[derive(Clone, Copy)]
pub(super) enum Owner<'n> {
    /// The program's own.
    Program,
    /// A file's that it uses, with the name that goes before them.
    Used(&'n str),
    /// A plant's, with its name.
    Plant(&'n str),
}

/// What rows can name of a file.
pub(super) fn tags_of(file: &Context, owner: Owner<'_>) -> Vec<Proposed> {
    let mut found = Vec::new();
    let Some(scope) = file.scopes.first() else {
        return found;
    };
    for tag in &scope.tags {
        let is_used = matches!(owner, Owner::Used(_));
        if tag.constant || is_used && !is_shown_to_others(file, tag) {
            continue;
        }
        let shared = file.shared(tag);
        let Some(ty) = shared.ty else { continue };
        let (order, direction, role) = match shared.role {
            Role::Input => (0, Direction::Given, "input"),
            Role::Output => (1, Direction::Expected, "output"),
            Role::Internal => (2, Direction::Expected, "internal"),
        };
        for (name, ty) in values_of(file, shared, ty) {
            let is_tag = name == *shared.name;
            let (name, of, topic) = match owner {
                Owner::Program => (name, String::new(), Topic::Tag(0, shared.name.to_string())),
                Owner::Used(before) | Owner::Plant(before) => (
                    format!("{before}.{name}"),
                    format!(" of {}", file.name),
                    Topic::Nothing,
                ),
            };
            found.push(Proposed {
                order: order + u8::from(!is_tag) * 2,
                name,
                direction: Some(direction),
                kind: if is_tag {
                    CompletionKind::Tag
                } else {
                    CompletionKind::Member
                },
                detail: format!("{}, {role}{of}", ty.name()),
                topic,
            });
        }
    }
    found
}

/// Whether a program that uses the file has its tag: what no function names is left out, and what is the same in all files
/// goes by its name alone.
fn is_shown_to_others(file: &Context, tag: &TagFacts) -> bool {
    let is_in_function = |network: usize| matches!(file.bodies[network], Body::Function(_));
    matches!(tag_of(file, 0, &Name::new(&tag.name)), Some(Symbol::Tag { .. }))
        && file.uses(tag).any(|place| is_in_function(place.network))
}

/// A tag, or what it has that is a value, with the types.
fn values_of(program: &Context, tag: &TagFacts, ty: Type) -> Vec<(String, Scalar)> {
    match ty {
        Type::Scalar(ty) => vec![(tag.name.to_string(), ty)],
        Type::State(state) => {
            let semantics = program.profile.semantics();
            let member = |name: &str| {
                Some((
                    format!("{}.{name}", tag.name),
                    ladder_analysis::state_member(state, name)?.ty(semantics),
                ))
            };
            members_of(state).filter_map(member).collect()
        }
        Type::Array { first, last, element } => (first..=last.min(first.saturating_add(ELEMENTS - 1)))
            .map(|index| (format!("{}[{index}]", tag.name), element))
            .collect(),
        Type::Compound(_) => {
            let values = ty.column_list().into_iter().filter_map(|column| {
                let name = format!("{}{}", tag.name, column.path);
                let (first, count) = match *column.dimensions {
                    [] => return Some(vec![(name, column.ty.scalar()?)]),
                    [(first, last)] => (first, last - first + 1),
                    _ => (0, column.count() as i64),
                };
                let scalar = column.ty.scalar()?;
                let shown = first..first + count.min(ELEMENTS);
                let names = shown.map(|index| element_name(&name, &column.dimensions, index));
                Some(names.map(|name| (name, scalar)).collect())
            });
            values.take(COLUMNS).flatten().collect()
        }
    }
}

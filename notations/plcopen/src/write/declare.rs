//! Types and variables.

use super::compiler::Compiler;
use super::names::{Names, identifier};
use super::text::{self, Words};
use crate::model::{Initial, Role, Type, Variable};
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::TagFacts;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{DEFAULT_STRING, Scalar, Type as OwnType};
use ladder_analysis::values::value::Value;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_analysis::written::type_spec::{Declared, SpecKind, TypeSpec};
use ladder_instructions::StateType;
use ladder_notation::{LineColumn, comments};
use ladder_syntax::TextSize;

/// How a function block of the standard is called there.
pub(super) fn state_name(state: StateType) -> &'static str {
    match state {
        StateType::Ton => "TON",
        StateType::Tof => "TOF",
        StateType::Tp => "TP",
        // They count in DINT here.
        StateType::Ctu => "CTU_DINT",
        StateType::Ctd => "CTD_DINT",
        StateType::Ctud => "CTUD_DINT",
        StateType::Sr => "SR",
        StateType::Rs => "RS",
        // Of these the units are written along.
        StateType::Rto => "LADDER_RTO",
        StateType::Rtof => "LADDER_RTOF",
        StateType::Ctc => "LADDER_CTC",
    }
}

/// A type by its name.
pub(super) fn named(name: impl Into<String>) -> Type {
    Type::Named(name.into())
}

/// An elementary type, or an enumeration.
pub(super) fn scalar(scalar: Scalar) -> Type {
    match scalar {
        Scalar::String(DEFAULT_STRING) => Type::Text(None),
        Scalar::String(length) => Type::Text(Some(length.into())),
        Scalar::Enum(id) => named(identifier(&id.get().name)),
        other => named(other.name()),
    }
}

/// Whether a variable of a type is an instance of a function block there.
pub(super) fn is_instance(ty: OwnType) -> bool {
    match ty {
        OwnType::State(_) => true,
        OwnType::Compound(id) => !matches!(id.get(), Compound::Array(_)),
        _ => false,
    }
}

/// What an array is of.
fn element(ty: OwnType) -> Option<OwnType> {
    match ty {
        OwnType::Array { element, .. } => Some(OwnType::Scalar(element)),
        OwnType::Compound(id) => match id.get() {
            Compound::Array(array) => Some(array.element),
            _ => None,
        },
        _ => None,
    }
}

/// Why a second name for a structure is not written.
pub(super) const ALIAS: &str = "a structure has one name there: use that of its declaration";

/// Whether the compilers that are built on matiec take a variable of a type. The generator of OpenPLC makes function blocks of
/// structures, and instances of blocks are neither handed to a block nor held by arrays and other structures there.
///
/// # Errors
///
/// Why not.
pub(super) fn is_taken(ty: OwnType, role: Role) -> Result<(), String> {
    let is_plain = |ty: OwnType| match ty {
        OwnType::Compound(_) => matches!(element(ty), Some(OwnType::Scalar(_))),
        ty => !is_instance(ty),
    };
    if let Some(OwnType::Scalar(Scalar::Date | Scalar::Dt)) = element(ty) {
        return Err(
            "compilers there have no arrays of DATE and DT: give each element a tag of its own".to_owned(),
        );
    }
    let is_held = match ty {
        OwnType::Compound(id) => match id.get() {
            Compound::Structure(structure) => structure.members.iter().all(|member| is_plain(member.ty)),
            Compound::Array(_) => is_plain(ty),
            Compound::Block(_) => true,
        },
        _ => true,
    };
    if !is_held {
        return Err("compilers there have arrays of elementary values alone, and structures of such values and arrays: give each part \
             a tag of its own"
            .to_owned());
    }
    if is_instance(ty) && matches!(role, Role::Input | Role::Output | Role::InOut) {
        return Err(
            "compilers there hand no timer, counter, block or structure to a block: hand what is in it"
                .to_owned(),
        );
    }
    Ok(())
}

/// What a part with limits begins with where nothing else is said.
pub(super) fn lowest(spec: &TypeSpec) -> Option<Initial> {
    match spec.kind {
        SpecKind::Subrange(_, (low, _)) if low != 0 => Some(Initial::Simple(low.to_string())),
        _ => None,
    }
}

/// Whether what is called so is a structure with another name of its own, which compilers take for another type.
pub(super) fn is_alias(name: &str, ty: OwnType) -> bool {
    let OwnType::Compound(id) = ty else { return false };
    matches!(id.get(), Compound::Structure(structure) if !structure.name.eq_ignore_ascii_case(name))
}

/// Whether a declaration only says which values of an elementary type a tag may have: generators have no functions for such types.
fn is_limited(spec: &TypeSpec, ty: OwnType) -> bool {
    match (&spec.kind, ty) {
        (SpecKind::Subrange(..), _) => true,
        (SpecKind::Named(_), OwnType::Scalar(ty)) => !ty.is_enumeration(),
        (SpecKind::Array(_, element), OwnType::Array { element: ty, .. }) => {
            is_limited(element, OwnType::Scalar(ty))
        }
        _ => false,
    }
}

/// A block's name without its sign.
pub(super) fn block_name(blocks: &Names, name: &str) -> String {
    blocks
        .get(name)
        .map_or_else(|| identifier(name.trim_start_matches('$')), str::to_owned)
}

/// A type where a tag of it is declared.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn type_of(blocks: &Names, ty: OwnType) -> Result<Type, String> {
    let bounds = |(first, last): &(i64, i64)| (first.to_string(), last.to_string());
    Ok(match ty {
        OwnType::Scalar(ty) => scalar(ty),
        OwnType::State(state) => named(state_name(state)),
        OwnType::Array { first, last, element } => {
            Type::Array(vec![bounds(&(first, last))], Box::new(scalar(element)))
        }
        OwnType::Compound(id) => match id.get() {
            Compound::Structure(structure) => named(identifier(&structure.name)),
            Compound::Block(name) => named(block_name(blocks, &name)),
            Compound::Array(array) => {
                let element = Box::new(type_of(blocks, array.element)?);
                Type::Array(array.dimensions.iter().map(bounds).collect(), element)
            }
        },
    })
}

/// A type as a declaration writes it.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn type_in(source: &Source<'_>, spec: &TypeSpec) -> Result<Type, String> {
    Ok(match &spec.kind {
        SpecKind::Known(ty) => type_of(source.blocks, *ty)?,
        SpecKind::Unread => return Err("its type means nothing".to_owned()),
        // Generators have no functions for a type with limits, and no name for it in structures.
        SpecKind::Subrange(base, _) => named(base.name()),
        SpecKind::Named(name) => named(identifier(name)),
        SpecKind::Block(name) => named(block_name(source.blocks, name)),
        SpecKind::Array(bounds, element) => {
            let bounds = bounds
                .iter()
                .map(|(first, last)| (first.to_string(), last.to_string()));
            Type::Array(bounds.collect(), Box::new(type_in(source, element)?))
        }
        SpecKind::Enumeration(values) => {
            let mut next = 0;
            let values = values.iter().map(|(name, _, number)| {
                let told = (*number != next).then(|| number.to_string());
                next = number + 1;
                (identifier(name), told)
            });
            Type::Enumeration(values.collect())
        }
        SpecKind::Structure(members) => {
            let members = members.iter().map(|member| {
                let declared = &member.declared;
                let mut variable = Variable::local(
                    place(source.context, member.at.start()),
                    identifier(&member.name),
                    type_in(source, &declared.spec)?,
                );
                variable.initial = declared_initial(source, declared)?.or_else(|| lowest(&declared.spec));
                variable.comment = told(source.context, member.at.start());
                Ok(variable)
            });
            Type::Structure(members.collect::<Result<_, String>>()?)
        }
    })
}

/// Where something is in the ladder text.
pub(super) fn place(context: &Context, offset: ladder_syntax::TextSize) -> LineColumn {
    let line = context.line_number(offset) as u32;
    let start = context
        .parse
        .line_at(offset)
        .map_or(offset, |line| context.parse.line_start(line));
    LineColumn {
        line,
        column: u32::from(offset - start) + 1,
    }
}

/// What the comments on a line say of what is declared on it.
pub(super) fn told(context: &Context, offset: ladder_syntax::TextSize) -> Option<String> {
    let line = context.parse.line_at(offset)?;
    let all = comments::on_line(&context.parse, line);
    let words: Vec<&str> = all.iter().flat_map(|comment| comments::told(comment)).collect();
    (!words.is_empty()).then(|| words.join(" "))
}

/// A value at the start as it is written.
///
/// # Errors
///
/// Why it has no counterpart.
fn initial_in(words: Words<'_>, node: &Node) -> Result<Initial, String> {
    Ok(match &node.kind {
        NodeKind::Array(values) => {
            let values = values.iter().map(|value| match &value.kind {
                NodeKind::Repeat(times, values) => {
                    let times = words.node(times)?.parse().ok();
                    match (times, &values[..]) {
                        (Some(times), [value]) => Ok((times, initial_in(words, value)?)),
                        _ => Err("what is repeated is one value there".to_owned()),
                    }
                }
                _ => Ok((1, initial_in(words, value)?)),
            });
            Initial::Array(values.collect::<Result<_, String>>()?)
        }
        NodeKind::Members(values) => {
            let values = values
                .iter()
                .map(|(name, value)| Ok((identifier(&name.text), initial_in(words, value)?)));
            Initial::Structure(values.collect::<Result<_, String>>()?)
        }
        _ => Initial::Simple(words.enumerator(node)?),
    })
}

/// A value at the start in a declaration.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn declared_initial(source: &Source<'_>, declared: &Declared) -> Result<Option<Initial>, String> {
    let Some(initial) = &declared.initial else {
        return Ok(None);
    };
    let words = Words {
        text: &initial.line,
        base: TextSize::default(),
        names: source.globals,
        compiler: source.compiler,
    };
    initial_in(words, &initial.node).map(Some)
}

/// What declarations are read from.
#[derive(Clone, Copy)]
pub(super) struct Source<'s> {
    pub(super) context: &'s Context,
    /// The names of blocks.
    pub(super) blocks: &'s Names,
    /// The names that initial values may mention.
    pub(super) globals: &'s Names,
    pub(super) compiler: Compiler,
}

/// The value that a tag begins with.
///
/// # Errors
///
/// Why it has no counterpart.
fn initial(source: &Source<'_>, tag: &TagFacts) -> Result<Option<Initial>, String> {
    if let (Some(declared), Some(ty)) = (&tag.cold.declared, tag.ty)
        && !is_limited(&declared.spec, ty)
    {
        return declared_initial(source, declared);
    }
    let values = &tag.cold.initial;
    let one = |value: &Value, ty| text::value(value, ty).map(Initial::Simple);
    match (tag.ty, &values[..]) {
        (_, []) => Ok(None),
        (Some(OwnType::Scalar(ty)), [value, ..]) => one(value, ty).map(Some),
        (Some(OwnType::Array { element, .. }), values) => {
            let mut runs: Vec<(u32, &Value)> = Vec::new();
            for value in values {
                match runs.last_mut() {
                    Some((times, last)) if *last == value => *times += 1,
                    _ => runs.push((1, value)),
                }
            }
            let runs = runs
                .into_iter()
                .map(|(times, value)| Ok((times, one(value, element)?)));
            Ok(Some(Initial::Array(runs.collect::<Result<_, String>>()?)))
        }
        _ => Err("its value at the start has no counterpart".to_owned()),
    }
}

/// Whether no part of an array or a structure begins with a value of an enumeration, at which compilers there end with a fault of
/// their own.
///
/// # Errors
///
/// If one does.
fn has_no_name(initial: &Initial, ty: OwnType) -> Result<(), String> {
    let of_part = |initial: &Initial, ty: OwnType| match ty {
        OwnType::Scalar(ty) if ty.is_enumeration() => Err(
            "compilers there take no value of an enumeration for a part of an \
             array or a structure: move it in the first scan"
                .to_owned(),
        ),
        ty => has_no_name(initial, ty),
    };
    match (initial, ty) {
        (Initial::Array(values), _) => element(ty).map_or(Ok(()), |element| {
            let mut values = values.iter();
            values.try_for_each(|(_, value)| of_part(value, element))
        }),
        (Initial::Structure(values), OwnType::Compound(id)) => match id.get() {
            Compound::Structure(structure) => values.iter().try_for_each(|(name, value)| {
                let mut members = structure.members.iter();
                let member = members.find(|member| identifier(&member.name) == *name);
                member.map_or(Ok(()), |member| of_part(value, member.ty))
            }),
            _ => Ok(()),
        },
        _ => Ok(()),
    }
}

/// What a structure begins with as what its members begin with: generators have no other place for it.
///
/// # Errors
///
/// If a member has parts that begin with something already.
pub(super) fn in_members(ty: &mut Type, initial: Initial) -> Result<Option<Initial>, String> {
    let (Type::Structure(members), Initial::Structure(values)) = (ty, &initial) else {
        return Ok(Some(initial));
    };
    for (name, value) in values {
        for member in members.iter_mut().filter(|member| member.name == *name) {
            if matches!(member.initial, Some(Initial::Structure(_))) {
                return Err(
                    "what it begins with is declared with its members there: declare it so here, too"
                        .to_owned(),
                );
            }
            member.initial = Some(value.clone());
        }
    }
    Ok(None)
}

/// A tag as a variable of this name. Its qualifier is the caller's.
///
/// # Errors
///
/// Why it has no counterpart.
pub(super) fn variable(
    source: &Source<'_>,
    tag: &TagFacts,
    name: &str,
    role: Role,
) -> Result<Variable, String> {
    if let (Some(ty), Compiler::Matiec) = (tag.ty, source.compiler) {
        is_taken(ty, role)?;
    }
    if let (Some(declared), Some(ty)) = (&tag.cold.declared, tag.ty)
        && let SpecKind::Named(name) = &declared.spec.kind
        && is_alias(name, ty)
    {
        return Err(ALIAS.to_owned());
    }
    let at = source.context.place_of(tag).start();
    let ty = match (&tag.cold.declared, tag.ty) {
        (Some(declared), Some(ty)) if is_limited(&declared.spec, ty) => type_of(source.blocks, ty)?,
        (Some(declared), _) => type_in(source, &declared.spec)?,
        (None, Some(ty)) => type_of(source.blocks, ty)?,
        (None, None) => return Err("its type is not known".to_owned()),
    };
    let mut variable = Variable::local(place(source.context, at), name.to_owned(), ty);
    variable.role = role;
    variable.address = tag.cold.address.as_deref().map(str::to_ascii_uppercase);
    variable.initial = initial(source, tag)?;
    if let (Some(initial), Some(ty), Compiler::Matiec) = (&variable.initial, tag.ty, source.compiler) {
        has_no_name(initial, ty)?;
    }
    if tag.is_declared() {
        variable.comment = told(source.context, at);
    }
    Ok(variable)
}

//! Values at the start: of an enumeration its values, in a structure its members.

use super::item::{Completion, CompletionKind, Snippet, Topic};
use super::members::values;
use super::proposals::Proposals;
use crate::path::member_type;
use crate::typing::Typing;
use ladder_analysis::context::Context;
use ladder_analysis::values::compound::Compound;
use ladder_analysis::values::types::{Scalar, Type};

/// What a place in a value asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Asked {
    /// A value of a type.
    Value(Type),
    /// An array that the declaration itself writes, of as many arrays of a type.
    Elements(usize, Type),
    /// A member of a structure.
    Member(Type),
    /// Something else, or nothing that is known.
    Unknown,
}

pub(super) fn propose(typing: &Typing<'_>, out: &mut Proposals<'_>) {
    match asked(typing.context, &typing.text[..typing.word.start]) {
        Asked::Value(Type::Scalar(Scalar::Enum(id))) => values(&id.get(), 0, out),
        Asked::Value(Type::Scalar(Scalar::Bool)) | Asked::Unknown => {
            for (word, doc) in [("TRUE", "High."), ("FALSE", "Low.")] {
                out.word((0, 0), CompletionKind::Value, word, "literal", Topic::Words(doc));
            }
        }
        Asked::Member(Type::Compound(id)) => {
            if let Compound::Structure(structure) = id.get() {
                for member in structure.members.iter().filter(|member| !member.ty.keeps_state()) {
                    out.add_at((0, 0), named(typing, &member.name, member.ty));
                }
            }
        }
        Asked::Value(_) | Asked::Elements(..) | Asked::Member(_) => {}
    }
}

fn named(typing: &Typing<'_>, name: &str, ty: Type) -> Completion {
    let written = typing.rest(typing.word.end).trim_start().starts_with(":=");
    Completion {
        label: format!("{name} :="),
        detail: ty.to_string(),
        kind: CompletionKind::Member,
        range: typing.absolute(typing.word.clone()),
        filter: name.to_owned(),
        text: if written {
            Snippet::plain_text(name)
        } else {
            Snippet::default().text(&format!("{name} := ")).end()
        },
        topic: Topic::Nothing,
    }
}

/// What is asked for at the end of a declaration that goes up to there.
fn asked(context: &Context, text: &str) -> Asked {
    let text = text.rsplit(';').next().unwrap_or(text);
    let Some((names, rest)) = text.split_once(':') else {
        return Asked::Unknown;
    };
    let (ty, value) = rest.split_at(end_of_type(rest));
    let mut asked = declared(context, names, ty);
    let mut around = Vec::new();
    let mut from = 0;
    let value = value.strip_prefix(":=").unwrap_or(value);
    for (place, letter) in value.char_indices() {
        let word = value[from..place].trim();
        asked = match letter {
            '[' => {
                around.push(Around::Array(asked));
                element(asked)
            }
            // `6(..)` is as many of the same.
            '(' if word.ends_with(|c: char| c.is_ascii_digit()) => {
                around.push(Around::Repeat(asked));
                asked
            }
            '(' => {
                around.push(Around::Structure(asked));
                member(asked)
            }
            ']' | ')' => match around.pop() {
                Some(Around::Array(it) | Around::Repeat(it) | Around::Structure(it)) => it,
                None => Asked::Unknown,
            },
            ',' => match around.last() {
                Some(Around::Array(it)) => element(*it),
                Some(Around::Structure(it)) => member(*it),
                Some(Around::Repeat(_)) | None => asked,
            },
            ':' => match asked {
                Asked::Member(ty) => member_type(context, ty, word).map_or(Asked::Unknown, Asked::Value),
                other => other,
            },
            _ => continue,
        };
        from = place + letter.len_utf8();
    }
    asked
}

/// What is open in a value, with what was asked for in its place.
enum Around {
    Array(Asked),
    Repeat(Asked),
    Structure(Asked),
}

/// What a declaration of this type asks for.
fn declared<'t>(context: &Context, names: &'t str, mut ty: &'t str) -> Asked {
    let mut arrays = 0;
    if ty.trim_start().starts_with('(') {
        // An enumeration is asked for its own first value.
        ty = names;
    }
    while let Some(at) = ty.to_ascii_uppercase().find(" OF ") {
        (ty, arrays) = (&ty[at + 4..], arrays + 1);
    }
    match context.types.find(ty.trim()).and_then(|found| found.ty) {
        Some(ty) if arrays > 0 => Asked::Elements(arrays, ty),
        Some(ty) => Asked::Value(ty),
        None => Asked::Unknown,
    }
}

fn element(array: Asked) -> Asked {
    match array {
        Asked::Elements(1, ty) => Asked::Value(ty),
        Asked::Elements(arrays, ty) => Asked::Elements(arrays - 1, ty),
        Asked::Value(ty) => ty.array().map_or(Asked::Unknown, |(_, ty)| Asked::Value(ty)),
        _ => Asked::Unknown,
    }
}

const fn member(structure: Asked) -> Asked {
    match structure {
        Asked::Value(ty) => Asked::Member(ty),
        _ => Asked::Unknown,
    }
}

/// Where the type ends that a text begins with: before `:=`, which may be inside of an enumeration too.
fn end_of_type(text: &str) -> usize {
    let mut depth = 0usize;
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            ':' if depth == 0 => return at,
            _ => {}
        }
    }
    text.len()
}

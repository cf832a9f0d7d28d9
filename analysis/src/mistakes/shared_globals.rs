//! Globals of one name must agree in type and initial value (LANGUAGE §4): `duplicate-declaration` where two of them
//! do not, `bad-declaration` where a VAR_EXTERNAL names none.

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::exports::{Exports, Global, is_one_address};
use crate::others::Others;
use crate::rule::Rule;
use crate::scope::TagFacts;
use crate::types::Type;
use crate::value::Value;
use ladder_syntax::Name;

const HELP: &str =
    "a global is one tag for the whole workspace: its declarations agree in type, initial value and address";

/// A VAR_GLOBAL declaration of the file against the one before it, and against those of other files.
pub(crate) fn check_declared(
    context: &Context,
    tag: &TagFacts,
    first: Option<&(usize, usize)>,
    out: &mut Vec<Diagnostic>,
) {
    if let Some(&(scope, index)) = first {
        let first = &context.scopes[scope].tags[index];
        let said = Said {
            ty: first.ty,
            initial: &first.rare.initial,
            address: first.rare.address.as_deref(),
        };
        if let Some(differs) = difference(tag, &said).filter(|_| !first.mistyped) {
            let otherwise = match differs {
                Differs::Address => said.address.map_or_else(String::new, |at| format!("at {at}")),
                Differs::Type | Differs::Value => format!("as {}", shown(first.ty)),
            };
            let message = format!("`{}` is declared otherwise before, {otherwise}", tag.name);
            out.push(
                Diagnostic::new(Rule::DuplicateDeclaration, context.declared_at(tag), message)
                    .help(HELP)
                    .related(
                        context.declared_at(first),
                        format!("`{}` is first declared here", first.name),
                    ),
            );
        }
    }
    let key = Name::new(&tag.name);
    for (file, global) in context.others.globals(&key) {
        let said = Said {
            ty: global.ty,
            initial: &global.initial,
            address: global.address.as_deref(),
        };
        if let Some(differs) = difference(tag, &said).filter(|_| global.ty.is_some()) {
            out.push(otherwise(context, tag, differs, file, global));
            return;
        }
    }
}

/// What a declaration says.
struct Said<'d> {
    ty: Option<Type>,
    initial: &'d [Value],
    address: Option<&'d str>,
}

/// What one declaration says otherwise than another.
#[derive(Clone, Copy)]
enum Differs {
    Type,
    Value,
    Address,
}

fn difference(tag: &TagFacts, other: &Said<'_>) -> Option<Differs> {
    if tag.mistyped {
        return None;
    }
    if tag.ty != other.ty {
        return Some(Differs::Type);
    }
    if *tag.rare.initial != *other.initial {
        return Some(Differs::Value);
    }
    (!is_one_address(tag.rare.address.as_deref(), other.address)).then_some(Differs::Address)
}

fn shown(ty: Option<Type>) -> String {
    ty.map_or_else(|| "another type".to_owned(), |ty| ty.to_string())
}

fn otherwise(
    context: &Context,
    tag: &TagFacts,
    differs: Differs,
    file: &Exports,
    global: &Global,
) -> Diagnostic {
    let message = match differs {
        Differs::Type => format!("`{}` is {} in {}", tag.name, shown(global.ty), file.file),
        Differs::Value => format!("`{}` starts with another value in {}", tag.name, file.file),
        Differs::Address => format!("`{}` lies at another address in {}", tag.name, file.file),
    };
    Diagnostic::new(Rule::DuplicateDeclaration, context.declared_at(tag), message)
        .help(HELP)
        .related_in(
            &file.file,
            file.place_of(global),
            format!("`{}` is declared here as well", global.name),
        )
}

/// A tag that several other files declare: they must agree where this file uses it. Gives whether they do.
pub(crate) fn check_others(
    context: &Context,
    tag: &TagFacts,
    others: &Others,
    first: &Exports,
    global: &Global,
    out: &mut Vec<Diagnostic>,
) -> bool {
    let differing = others
        .globals(&global.key)
        .find(|(_, other)| !global.agrees(other));
    let Some((file, other)) = differing else {
        return true;
    };
    let message = format!(
        "`{}` is declared in {} and in {}, and not alike",
        tag.name, first.file, file.file
    );
    let used = context.uses(tag).next();
    let at = used.map_or(context.declared_at(tag), |place| place.range);
    out.push(
        Diagnostic::new(Rule::DuplicateDeclaration, at, message)
            .help(HELP)
            .related_in(
                &first.file,
                first.place_of(global),
                format!("`{}` is declared here", global.name),
            )
            .related_in(&file.file, file.place_of(other), "and here"),
    );
    false
}

/// A VAR_EXTERNAL declaration names a global, and agrees with it in type. Gives whether it does.
pub(crate) fn check_external(
    context: &Context,
    tag: &TagFacts,
    global: Option<&TagFacts>,
    out: &mut Vec<Diagnostic>,
) -> bool {
    let Some(global) = global else {
        let message = format!("no file of the workspace declares `{}` as VAR_GLOBAL", tag.name);
        out.push(
            Diagnostic::new(Rule::BadDeclaration, context.declared_at(tag), message).help(
                "VAR_EXTERNAL names a global that is declared elsewhere: declare it, or correct the name",
            ),
        );
        return false;
    };
    if tag.mistyped || global.mistyped || tag.ty == global.ty {
        return true;
    }
    let message = format!(
        "`{}` is {} here, the global of this name is {}",
        tag.name,
        shown(tag.ty),
        shown(global.ty)
    );
    let found = Diagnostic::new(Rule::BadDeclaration, context.declared_at(tag), message)
        .help("write the type of the global");
    out.push(match &global.rare.foreign {
        Some(_) => found,
        None => found.related(context.declared_at(global), "the global is declared here"),
    });
    false
}

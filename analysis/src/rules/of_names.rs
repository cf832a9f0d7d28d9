//! What is wrong with names, in sentences: `bad-declaration`, `duplicate-declaration` and the rules about literals.

use super::{bad_declaration, duplicate_type, literals, recursive_type, unknown_type};
use crate::findings::diagnostic::Diagnostic;
use crate::names::context::Context;
use crate::names::problem::{Differs, InFile, NameProblem};
use crate::names::scope::{Entry, TagFacts};
use crate::values::types::Type;
use ladder_syntax::TextRange;

const HELP: &str =
    "a global is one tag for the whole workspace: its declarations agree in type, initial value and address";

/// The finding about a problem.
pub(crate) fn diagnostic(context: &Context, problem: &NameProblem) -> Diagnostic {
    let tag = |(scope, tag): Entry| &context.scopes[scope].tags[tag];
    match problem {
        NameProblem::Meaningless(range, message) => bad_declaration::wrong(*range, message),
        NameProblem::InitialValue(problem) => literals::diagnostic(problem),
        NameProblem::Twice {
            name,
            at,
            first,
            first_at,
        } => Diagnostic::new(
            super::duplicate_declaration::RULE,
            *at,
            format!("`{name}` is declared twice"),
        )
        .help(
            "remove one of the declarations, or give one tag another name; capitals do not tell names apart",
        )
        .related(*first_at, format!("`{first}` is first declared here")),
        NameProblem::TypesInBlock(range) => super::wrong_place::types_in_block(*range),
        NameProblem::InOutsOfProgram(range) => super::wrong_place::in_outs_of_program(*range),
        NameProblem::TypeTwice { name, at, first_at } => duplicate_type::twice(name, *at, *first_at),
        NameProblem::TypeOfFiles { name, at, files } => duplicate_type::in_files(name, *at, files),
        NameProblem::UnknownType { name, at, near } => unknown_type::unknown(name, near.as_deref(), *at),
        NameProblem::RecursiveType { names, at } => recursive_type::recursive(names, *at),
        NameProblem::GlobalOtherwise {
            tag: second,
            first,
            differs,
        } => otherwise_in_this_file(tag(*second), tag(*first), *differs),
        NameProblem::OtherwiseInFile {
            tag: own,
            other,
            differs,
        } => otherwise_in_another(tag(*own), *differs, other),
        NameProblem::FilesDiffer {
            tag: used,
            first,
            second,
        } => files_differ(context, tag(*used), first, second),
        NameProblem::NoGlobal { tag: external } => no_global(tag(*external)),
        NameProblem::ExternalOtherwise { name, at, ty, global } => {
            external_otherwise(name, *at, *ty, tag(*global))
        }
    }
}

fn otherwise_in_this_file(second: &TagFacts, first: &TagFacts, differs: Differs) -> Diagnostic {
    let otherwise = match differs {
        Differs::Address => {
            let address = first.cold.address.as_deref();
            address.map_or_else(String::new, |at| format!("at {at}"))
        }
        Differs::Type | Differs::Value => format!("as {}", shown(first.ty)),
    };
    let message = format!("`{}` is declared otherwise before, {otherwise}", second.name);
    let related = format!("`{}` is first declared here", first.name);
    Diagnostic::new(super::duplicate_declaration::RULE, second.declared_at, message)
        .help(HELP)
        .related(first.declared_at, related)
}

fn otherwise_in_another(tag: &TagFacts, differs: Differs, InFile { file, global }: &InFile) -> Diagnostic {
    let message = match differs {
        Differs::Type => format!("`{}` is {} in {file}", tag.name, shown(global.ty)),
        Differs::Value => format!("`{}` starts with another value in {file}", tag.name),
        Differs::Address => format!("`{}` lies at another address in {file}", tag.name),
    };
    let related = format!("`{}` is declared here as well", global.name);
    Diagnostic::new(super::duplicate_declaration::RULE, tag.declared_at, message)
        .help(HELP)
        .related_in(file, global.at, related)
}

fn files_differ(context: &Context, tag: &TagFacts, first: &InFile, second: &InFile) -> Diagnostic {
    let message = format!(
        "`{}` is declared in {} and in {}, and not alike",
        tag.name, first.file, second.file
    );
    let used = context.uses(tag).next();
    let at = used.map_or(tag.declared_at, |place| place.range);
    let related = format!("`{}` is declared here", first.global.name);
    Diagnostic::new(super::duplicate_declaration::RULE, at, message)
        .help(HELP)
        .related_in(&first.file, first.global.at, related)
        .related_in(&second.file, second.global.at, "and here")
}

fn no_global(tag: &TagFacts) -> Diagnostic {
    let message = format!("no file of the workspace declares `{}` as VAR_GLOBAL", tag.name);
    bad_declaration::wrong(tag.declared_at, message)
        .help("VAR_EXTERNAL names a global that is declared elsewhere: declare it, or correct the name")
}

fn external_otherwise(name: &str, at: TextRange, ty: Option<Type>, global: &TagFacts) -> Diagnostic {
    let message = format!(
        "`{name}` is {} here, the global of this name is {}",
        shown(ty),
        shown(global.ty)
    );
    let found = bad_declaration::wrong(at, message).help("write the type of the global");
    match &global.cold.foreign {
        Some(_) => found,
        None => found.related(global.declared_at, "the global is declared here"),
    }
}

fn shown(ty: Option<Type>) -> String {
    ty.map_or_else(|| "another type".to_owned(), |ty| ty.to_string())
}

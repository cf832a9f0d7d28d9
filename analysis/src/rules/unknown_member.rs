//! `unknown-member`: the word or number after a point names no part of the tag.

use super::near_names::{self, Meant};
use crate::findings::article::with_article;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::did_you_mean;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::scope::Scope;
use crate::program::SystemTag;
use crate::values::compound::Structure;
use crate::values::types::{Scalar, Type};
use crate::written::facts::Word;
use ladder_instructions::StateType;
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Names, "unknown-member", Severity::Error).about_types());

/// How many members a message names.
const MOST_NAMED: usize = 20;

fn unknown(range: TextRange, message: String) -> Diagnostic {
    Diagnostic::new(RULE, range, message)
}

pub(crate) fn system(word: &str, range: TextRange) -> Diagnostic {
    unknown(range, format!("there is no system tag SYS.{word}"))
        .help(format!("the system tags are {}", SystemTag::list()))
}

pub(crate) fn of_state(name: &str, state: StateType, word: &str, range: TextRange) -> Diagnostic {
    let members = match state {
        StateType::Sr | StateType::Rs => "Q1",
        StateType::Ctud => "CU CD R LD PV CV QU QD Q CC",
        state if state.is_counter() => "CU CD R LD PV CV Q CC",
        _ => "IN PT Q ET R TT",
    };
    unknown(
        range,
        format!(
            "`{name}` is {} and has no member `{word}`",
            with_article(state.name())
        ),
    )
    .help(format!("its members are {members}"))
}

/// A member of a timer, on a tag that is neither declared nor the tag of a block.
pub(crate) fn of_no_state(
    scope: &Scope,
    name: &str,
    word: &str,
    base: TextRange,
    range: TextRange,
) -> Diagnostic {
    let found = unknown(
        range,
        format!("`{name}` has no `{word}`: no block makes it a timer or counter, and it is not declared"),
    );
    let states = scope
        .tags
        .iter()
        .filter(|tag| matches!(tag.ty, Some(Type::State(_))));
    match did_you_mean::closest(name, states.map(|tag| tag.name.as_str())) {
        Some(near) => near_names::ask(found, name, near, Meant::name(near, "Replace with", base)),
        None => found.help(format!(
            "check the name, or write the block that it belongs to, such as [TON]( {name}, T#5s )"
        )),
    }
}

pub(crate) fn of_scalar(ty: Scalar, word: &str, range: TextRange) -> Diagnostic {
    if ty.is_integer() || ty.is_bits() {
        let last = ty.width() - 1;
        return unknown(
            range,
            format!("{ty} has the bits 0 to {last}, there is no `{word}`"),
        );
    }
    unknown(range, format!("{ty} has no members"))
}

/// A member that a structure does not have.
pub(crate) fn of_structure(structure: &Structure, word: &Word, range: TextRange) -> Diagnostic {
    let message = format!("{} has no member `{}`", structure.name, word.text);
    let members = || structure.members.iter().map(|member| member.name.as_str());
    let found = unknown(range, message);
    match did_you_mean::closest(&word.text, members()) {
        Some(near) => found.help(format!("did you mean {near}?")),
        None => found.help(format!(
            "its members are {}",
            members().take(MOST_NAMED).collect::<Vec<_>>().join(" ")
        )),
    }
}

/// A member of what has none.
pub(crate) fn of_part(ty: &Type, word: &Word, range: TextRange) -> Diagnostic {
    let found = unknown(
        range,
        format!("{} has no member `{}`", with_article(ty), word.text),
    );
    match ty.array() {
        Some(_) => found.help("write the index of an element before the point"),
        None => found,
    }
}

/// What the state of a user-defined block does not show.
pub(crate) fn of_instance(block: &str, word: &Word, range: TextRange) -> Diagnostic {
    unknown(range, format!("{block} has no input or output `{}`", word.text))
        .help("what a block declares in VAR, and its in-outs, is its own")
}

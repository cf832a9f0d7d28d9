//! The state of a user-defined block, which belongs to its place, gets a tag of its own: `[$Motor]( go )` is
//! `[$Motor]( motor1, go )`.

use super::declared::is_free;
use super::names::numbered;
use super::place::{OnNetwork, Selected};
use super::scenarios::{InScenarios, Place};
use super::{Action, ActionKind};
use crate::symbol::{Symbol, block_file};
use ladder_analysis::context::Context;
use ladder_analysis::library;
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::SectionKind;
use ladder_analysis::networks::network::{Formal, Meaning};
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::program::ParameterKind;
use ladder_analysis::written::user_block::Parameter;
use ladder_format::Edit;
use ladder_syntax::{Name, TextRange};
use std::sync::Arc;

pub(super) fn offer(place: &Selected<'_>, out: &mut Vec<Action>) {
    let Some(on) = &place.on else { return };
    let Some(block) = on.block() else { return };
    let Meaning::User(user) = block.meaning else {
        return;
    };
    if has_state(&block) {
        return;
    }
    let context = place.context;
    let name = &context.user_blocks[user].name;
    let base = name.trim_start_matches('$').to_lowercase();
    let tag = numbered(&base, "", |name| !is_free(context, name));
    let title = format!("Give the state of `{}` the tag `{tag}`", block.head_text());
    match named(place, on, block, name, &tag) {
        Ok((edits, scenarios)) => {
            let action = Action::new(ActionKind::Rewrite, title, edits);
            out.push(action.in_scenarios(scenarios).making_up(tag));
        }
        Err(why) => out.push(Action::disabled(ActionKind::Rewrite, title, why)),
    }
}

/// Whether a tag keeps the state of a block.
fn has_state(block: &BlockAt<'_>) -> bool {
    block
        .formals
        .iter()
        .any(|formal| matches!(formal, Formal::Instance))
}

/// An input that is left out, and that the body may write: a state without a tag has the default again in each run.
fn written_input<'c>(context: &'c Context, block: BlockAt<'c>) -> Option<&'c str> {
    let Meaning::User(user) = block.meaning else {
        return None;
    };
    let facts = &context.user_blocks[user];
    if facts.file().is_some_and(|file| library::source(file).is_some()) {
        return None;
    }
    let is_given = |number| {
        let is_it = |formal: &Formal| matches!(formal, Formal::Parameter(given) if *given == number);
        block.formals.iter().any(is_it)
    };
    let may_be_written = |parameter: &Parameter| match facts.import {
        None => {
            let tag = &context.scopes[user + 1].tags[parameter.tag];
            context.uses(tag).any(|place| place.access.writes())
        }
        Some(_) => true,
    };
    let mut parameters = facts.parameters.iter().enumerate();
    let left_out = parameters.find(|(number, parameter)| {
        parameter.kind == ParameterKind::Input && !is_given(*number) && may_be_written(parameter)
    });
    left_out.map(|(_, parameter)| parameter.name.as_str())
}

fn named(
    place: &Selected<'_>,
    on: &OnNetwork<'_>,
    block: BlockAt<'_>,
    name: &str,
    tag: &str,
) -> Result<(Vec<Edit>, InScenarios), String> {
    let context = place.context;
    if place.has_errors() {
        return Err("fix the errors of the file first".to_owned());
    }
    if let Some(input) = written_input(context, block) {
        return Err(format!(
            "its body may write the input `{input}`, which a tag would keep from one run to the next: give `{input}` here first"
        ));
    }
    let scope = on.facts.scope;
    let declared = [(SectionKind::Var, tag.to_owned(), name.to_owned())];
    let mut edits = Places::new(context, scope)
        .declare_all(&declared)
        .ok_or("a section of declarations is not closed")?;
    edits.push(match block.facts.operands.first() {
        Some(first) => Edit {
            range: TextRange::empty(block.absolute(first.range).start()),
            text: format!("{tag}, "),
        },
        None => Edit {
            range: TextRange::new(block.head_range().end(), block.range().end()),
            text: format!("( {tag} )"),
        },
    });
    let symbol = |name: &str| {
        let name = Name::new(name);
        Some(Symbol::Block {
            file: block_file(context, &name).unwrap_or_else(|| Arc::clone(&context.name)),
            name,
        })
    };
    let scenarios = symbol(name).map(|block_symbol| InScenarios::Instance {
        place: Place {
            block: block_symbol,
            outer: scope
                .checked_sub(1)
                .and_then(|outer| symbol(&context.user_blocks[outer].name)),
            number: number(context, scope, block, name),
        },
        tag: tag.to_owned(),
    });
    Ok((edits, scenarios.unwrap_or(InScenarios::Nothing)))
}

/// The number of a block among those of its name whose state belongs to their place, in the order of the text.
fn number(context: &Context, scope: usize, block: BlockAt<'_>, name: &str) -> usize {
    let key = Name::new(name);
    let networks = context.networks.iter().filter(|network| network.scope == scope);
    let blocks = networks.flat_map(NetworkAt::blocks);
    let alike = blocks
        .filter(|other| other.user_name().is_some_and(|name| Name::new(name) == key) && !has_state(other));
    let before = alike.take_while(|other| other.range().start() < block.range().start());
    before.count() + 1
}

//! Two blocks on one timer, counter or instance: the one that the finding is about gets a tag of its own.

use crate::refactor::names::tag_like;
use crate::refactor::{Action, ActionKind};
use ladder_analysis::names::declaring::Places;
use ladder_analysis::names::scope::SectionKind;
use ladder_analysis::networks::network::Formal;
use ladder_analysis::with_article;
use ladder_analysis::{Analysis, Diagnostic};
use ladder_format::Edit;
use ladder_instructions::{Accepts, StateType};

pub(super) fn offer(analysis: &Analysis, found: &Diagnostic) -> Option<Action> {
    let context = &analysis.context;
    let networks = context.networks.iter();
    let network = networks
        .into_iter()
        .find(|network| network.range.contains_range(found.range))?;
    let (bound, place, state) = network.blocks().find_map(|bound| {
        let mut operands = bound.facts.operands.iter().zip(bound.formals.iter());
        let (operand, formal) =
            operands.find(|(operand, _)| bound.absolute(operand.value.range).contains_range(found.range))?;
        let state = match formal {
            Formal::Operand(row) => match row.accepts {
                Accepts::State(state) => Some(state),
                _ => None,
            },
            _ => None,
        };
        Some((bound, bound.absolute(operand.value.range), state))
    })?;
    // `lines[k].delay` becomes `delay_1`.
    let written = context.parse.text_in(place).to_string();
    let without_index = written.split('[').next().unwrap_or_default();
    let last = match written.rsplit_once('.') {
        Some((_, member)) => member.split('[').next().unwrap_or(member),
        None => without_index,
    };
    let name = tag_like(context, last.trim());
    let (kind, ty) = match state {
        Some(state) => (kind(state), state.name().to_owned()),
        None => ("state", bound.facts.head.text().to_owned()),
    };
    let mut edits = vec![Edit {
        range: place,
        text: name.clone(),
    }];
    // In a file without declarations the first would make all other tags look forgotten.
    if network.scope > 0 || context.scopes[network.scope].declares() {
        edits.extend(Places::new(context, network.scope).declare(SectionKind::Var, &name, &ty)?);
    }
    let title = format!("Give this block {} of its own: `{name}`", with_article(kind));
    Some(Action::new(ActionKind::QuickFix, title, edits).making_up(name))
}

fn kind(state: StateType) -> &'static str {
    if state.is_timer() {
        "timer"
    } else if state.is_counter() {
        "counter"
    } else {
        "state"
    }
}

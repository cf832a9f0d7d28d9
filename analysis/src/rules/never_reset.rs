//! `never-reset`: a retentive timer or a counter that nothing resets or loads: it runs to its end once.

use super::parts::Part;
use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::networks::network::Formal;
use crate::networks::use_kind::Effect;
use crate::networks::use_place::{Use, UseRef};
use crate::values::types::Type;
use ladder_instructions::{Accepts, StateType};

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "never-reset", Severity::Warning).when(When::Whole));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let keeps_state = view.tag.ty.is_some_and(Type::keeps_state);
    if keeps_state && view.places.keeps > 0 && view.is_all_known() && !view.unread.written {
        out.extend(view.parts().filter_map(|part| in_part(view, &part)));
    }
}

fn in_part(view: &TagView<'_>, part: &Part<'_>) -> Option<Diagnostic> {
    let networks = &view.context.networks;
    // What else writes the tag or a member of it resets or loads it, or may.
    if part.is_span || part.touched.writes != part.touched.keeps {
        return None;
    }
    let keeps = |place: &&UseRef| place.effect() == Effect::KeepsState && place.access().writes();
    let mut owners = part.own.iter().filter(keeps);
    let owner = *owners.clone().next()?;
    let state = match networks.formal_of(owner) {
        Formal::Operand(row) => match row.accepts {
            Accepts::State(state) => state,
            _ => return None,
        },
        _ => return None,
    };
    // A CTC begins again by itself.
    let ends = matches!(
        state,
        StateType::Rto | StateType::Rtof | StateType::Ctu | StateType::Ctd | StateType::Ctud
    );
    if !ends || owners.any(|place| resets_itself(view, &networks.use_of(*place))) {
        return None;
    }
    let name = part.name;
    let (what, end) = if state.is_timer() {
        ("reset", "once it has run out it stays so")
    } else {
        ("reset or load", "it counts to its end once")
    };
    let verb = if state.is_timer() {
        "resets"
    } else {
        "resets or loads"
    };
    let message = format!("nothing {verb} the {} `{name}`: {end}", state.name());
    let at = networks.use_of(owner).range;
    Some(Diagnostic::new(RULE, at, message).help(format!(
        "{what} it with (R)( {name} ), or with an operand of its block"
    )))
}

/// Whether a block that keeps its state there is given what resets or loads it, or counts it down again.
fn resets_itself(view: &TagView<'_>, place: &Use) -> bool {
    let given = view.context.block_at(place).formals.iter();
    given
        .filter_map(|formal| match formal {
            Formal::Operand(row) => Some(row.name),
            _ => None,
        })
        .any(|name| matches!(name, "R" | "LD" | "CD"))
}

//! `never-reset`: a retentive timer or a counter that nothing resets or loads: it runs to its end once.

use super::tag_view::TagView;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity, When};
use crate::networks::network::Formal;
use crate::networks::use_kind::Effect;
use crate::networks::use_place::Use;
use crate::values::types::Type;
use ladder_instructions::StateType;

pub(crate) const RULE: Rule =
    Rule(&RuleFacts::new(RuleGroup::Program, "never-reset", Severity::Warning).when(When::Whole));

pub(super) fn check(view: &TagView<'_>, out: &mut Vec<Diagnostic>) {
    let (context, tag) = (view.context, view.tag);
    let Some(Type::State(state)) = tag.ty else { return };
    // A CTC begins again by itself.
    let ends = matches!(
        state,
        StateType::Rto | StateType::Rtof | StateType::Ctu | StateType::Ctd | StateType::Ctud
    );
    // What else writes the tag or a member of it resets or loads it, or may.
    let mut writers = tag.uses.writers();
    if !ends || !view.is_all_known() || !writers.all(|place| place.effect() == Effect::KeepsState) {
        return;
    }
    let owner = context.writers(tag).next();
    let Some(owner) = owner.filter(|_| !context.writers(tag).any(|place| resets_itself(view, &place))) else {
        return;
    };
    let name = &tag.name;
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
    out.push(Diagnostic::new(RULE, owner.range, message).help(format!(
        "{what} it with (R)( {name} ), or with an operand of its block"
    )));
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

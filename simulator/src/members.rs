//! The members of timers, counters and bistables by their names (LANGUAGE §4).

use ladder_analysis::program::Member;
use ladder_instructions::StateType;

/// The members of a type by the names of LANGUAGE §4.
pub(crate) fn members(state: StateType) -> &'static [(&'static str, Member)] {
    use Member::*;
    if state.is_timer() {
        return &[("Q", Q), ("ET", Et), ("IN", In), ("PT", Pt)];
    }
    match state {
        StateType::Ctud => &[
            ("QU", Qu),
            ("QD", Qd),
            ("CV", Cv),
            ("CU", Cu),
            ("CD", Cd),
            ("R", R),
            ("LD", Ld),
            ("PV", Pv),
        ],
        StateType::Sr | StateType::Rs => &[("Q1", Q1)],
        _ => &[("Q", Q), ("CV", Cv), ("CU", Cu), ("R", R), ("LD", Ld), ("PV", Pv)],
    }
}

/// The names of the members that a timer, counter or bistable has, those first that show what it does.
pub fn members_of(state: StateType) -> impl Iterator<Item = &'static str> {
    members(state).iter().map(|(name, _)| *name)
}

/// Of all members the ones that a list of all tags shows.
pub(crate) fn shown(state: StateType) -> &'static [(&'static str, Member)] {
    use Member::*;
    if state.is_timer() {
        return &[("Q", Q), ("ET", Et)];
    }
    match state {
        StateType::Ctud => &[("QU", Qu), ("QD", Qd), ("CV", Cv)],
        StateType::Sr | StateType::Rs => &[("Q1", Q1)],
        _ => &[("Q", Q), ("CV", Cv)],
    }
}

/// A member by its name or by the one that controllers give it.
pub(crate) fn member_of(state: StateType, name: &str) -> Option<(&'static str, Member)> {
    let name = name.to_ascii_uppercase();
    if let Some(&found) = members(state).iter().find(|(known, _)| *known == name) {
        return Some(found);
    }
    let timer = state.is_timer();
    let alias = match name.as_str() {
        "EN" if timer => "IN",
        "EN" => "CU",
        "PRE" if timer => "PT",
        "PRE" => "PV",
        "AC" | "ACC" if timer => "ET",
        "AC" | "ACC" => "CV",
        "DN" | "Q" if state == StateType::Ctud => "QU",
        "DN" => "Q",
        "R" if timer => return Some(("R", Member::R)),
        "TT" if timer => return Some(("TT", Member::Timing)),
        "CC" if state.is_counter() => return Some(("CC", Member::Changed)),
        _ => return None,
    };
    members(state).iter().find(|(known, _)| *known == alias).copied()
}

//! Whether two whole programs do the same, as far as their networks say it one by one.

use crate::comparison::{Change, Comparison};
use crate::meaning::number;
use crate::outline::Kind;
use crate::report::{heading, reason};
use crate::verdict::Verdict;
use ladder_prover::{Compared, Meaning};

/// What is known of two programs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Whole {
    /// They do the same.
    Same,
    /// They do not: what shows it.
    Other(Vec<String>),
    /// It is not known: why.
    NotDecided(Vec<String>),
}

/// Whether two programs do the same, of whose edited networks that was [asked](Comparison::decide). All networks must be there in
/// both and do the same, in an order that is the same or does not matter.
pub fn whole(comparison: &Comparison<'_>) -> Whole {
    let is_as_written = |change: &Change<'_>| is_harmless(change) && change.meaning.is_none();
    if comparison.changes.iter().all(is_as_written) {
        return Whole::Same;
    }
    let compared = match comparison.compared() {
        Ok(compared) => compared,
        Err(cause) => return Whole::NotDecided(vec![cause]),
    };
    let (mut others, mut open) = (Vec::new(), Vec::new());
    for change in &comparison.changes {
        if is_harmless(change) || (change.moved && may_move(comparison, change, &compared)) {
            continue;
        }
        let mut said = heading(comparison, change);
        if let Some(reason) = reason(change) {
            said.push_str(&format!(": {reason}"));
        }
        if change.moved && says_the_same(change) {
            said.push_str(": it has passed networks, and the order may matter");
        }
        match change.meaning {
            Some(Meaning::Other(_)) => others.push(said),
            _ => open.push(said),
        }
    }
    for tag in compared.declared_differently() {
        open.push(format!("{tag} is declared or used differently"));
    }
    match (others.is_empty(), open.is_empty()) {
        (true, true) => Whole::Same,
        (true, false) => Whole::NotDecided(open),
        (false, _) => Whole::Other(others),
    }
}

/// Whether a change cannot matter by itself.
fn is_harmless(change: &Change<'_>) -> bool {
    let kind = change.entry().kind;
    if kind == Kind::Comment {
        return true;
    }
    let is_in_structure = change.entry().place.starts_with(Kind::Structure.text());
    if change.moved && (kind == Kind::Network || is_in_structure) {
        return false;
    }
    says_the_same(change)
}

fn says_the_same(change: &Change<'_>) -> bool {
    matches!(
        change.verdict,
        Verdict::Same | Verdict::Redrawn | Verdict::Commented
    ) || change.meaning == Some(Meaning::Same)
}

/// Whether a network that has moved may change places with each of those that it has passed.
fn may_move(comparison: &Comparison<'_>, change: &Change<'_>, compared: &Compared) -> bool {
    let of = |change: &Change<'_>| {
        let numbers = [change.old, change.new].map(|entry| entry.and_then(number));
        let [old, new] = numbers;
        old.zip(new)
    };
    let Some((old, new)) = of(change).filter(|_| says_the_same(change)) else {
        return false;
    };
    let others = comparison
        .changes
        .iter()
        .filter(|other| other.entry().kind == Kind::Network);
    others.filter_map(of).all(|(other_old, other_new)| {
        let has_passed = (old < other_old) != (new < other_new);
        !has_passed || old == other_old || compared.may_swap(new, other_new)
    })
}

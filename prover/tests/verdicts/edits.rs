//! Changes of programs: those of people and those of mutants.

use super::case::Case;
use ladder_generator::generator::Dice;

/// Words of a network and what is put in the place of one of them.
const WORDS: [(&str, &str); 22] = [
    ("[ ](", "[/]("),
    ("[/](", "[ ]("),
    ("[P](", "[ ]("),
    ("[N](", "[P]("),
    ("( )(", "(/)("),
    ("(S)(", "( )("),
    ("(R)(", "(/)("),
    ("(P)(", "( )("),
    ("[EQ]", "[NE]"),
    ("[NE]", "[EQ]"),
    ("[GT]", "[GE]"),
    ("[GE]", "[GT]"),
    ("[LT]", "[LE]"),
    ("[LE]", "[LT]"),
    ("[ADD]", "[SUB]"),
    ("[SUB]", "[ADD]"),
    ("T#30ms", "T#60ms"),
    ("T#10ms", "T#20ms"),
    (", 1", ", 2"),
    (", 3", ", 4"),
    (", 7", ", 8"),
    ("<FOR>( 2", "<FOR>( 3"),
];

/// A program with one change. None: it has nothing of the kind that was chosen.
pub(crate) fn edited(case: &Case, dice: &mut Dice) -> Option<Case> {
    let mut new = case.clone();
    let networks = &mut new.networks;
    let at = dice.below(networks.len());
    match dice.below(9) {
        0 | 1 => networks.swap(at, (at + 1) % case.networks.len()),
        2 => {
            let moved = networks.remove(at);
            let to = dice.below(networks.len() + 1);
            networks.insert(to, moved);
        }
        3 => {
            // A label, a state and a function are there once.
            let doubled = networks[at].clone();
            let is_state = ["<LBL>", "[T", "[RTO", "[CT", "[$"]
                .iter()
                .any(|word| doubled.contains(word));
            if is_state {
                return None;
            }
            networks.push(doubled);
        }
        4 => drop(networks.remove(at)),
        // The controller runs something else in the place of an unread part.
        _ if case.parts.iter().any(|(part, _)| *part == networks[at]) => return None,
        _ => {
            let (word, other) = dice.of(&WORDS);
            let places: Vec<usize> = networks[at].match_indices(word).map(|(at, _)| at).collect();
            let place = *places.get(dice.below(places.len().max(1)))?;
            networks[at].replace_range(place..place + word.len(), other);
        }
    }
    (new.networks != case.networks).then_some(new)
}

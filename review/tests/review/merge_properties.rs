//! What holds for merges of any edits.

use crate::harness::outline;
use ladder_format::{Options, format_text};
use ladder_review::{Merged, Sides, compare, merge};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// A network by its number, its form, and whether it has a comment.
type Network = (String, u8, bool);

#[derive(Debug, Clone)]
struct Program {
    declared: Vec<(String, u8)>,
    networks: Vec<Network>,
}

#[derive(Debug, Clone, Copy)]
enum Edit {
    Change(usize, u8),
    Remove(usize),
    Insert(usize),
    Move(usize, usize),
    Declare(usize),
    Retype(usize),
    Undeclare(usize),
}

fn line((number, form, _): &Network) -> String {
    let contact = ["[ ]", "[/]", "[P]"][usize::from(form % 3)];
    format!("+--{contact}( a{number} )--[ ]( b )--( )( y{number} )--+")
}

impl Program {
    fn text(&self) -> String {
        let mut text = String::from("# A program #\n\nVAR_INPUT\n    b : BOOL;\n");
        for (name, form) in &self.declared {
            let ty = ["BOOL", "INT", "DINT"][usize::from(form % 3)];
            text.push_str(&format!("    {name} : {ty};\n"));
        }
        text.push_str("END_VAR\n");
        for network in &self.networks {
            text.push('\n');
            if network.2 {
                text.push_str(&format!("# About {} #\n", network.0));
            }
            text.push_str(&line(network));
            text.push('\n');
        }
        text
    }

    /// `side` makes what is new different from what the other side adds.
    fn edited(&self, edits: &[Edit], side: &str) -> Program {
        let mut program = self.clone();
        for (count, edit) in edits.iter().enumerate() {
            let Program { declared, networks } = &mut program;
            let (length, names) = (networks.len(), declared.len());
            match *edit {
                Edit::Insert(at) => {
                    networks.insert(at % (length + 1), (format!("{side}{count}"), 0, at % 2 == 0));
                }
                Edit::Declare(at) => declared.insert(at % (names + 1), (format!("d{side}{count}"), 0)),
                Edit::Change(at, form) if length > 0 => networks[at % length].1 = form,
                Edit::Remove(at) if length > 0 => drop(networks.remove(at % length)),
                Edit::Move(from, to) if length > 0 => {
                    let network = networks.remove(from % length);
                    networks.insert(to % length, network);
                }
                Edit::Retype(at) if names > 0 => declared[at % names].1 += 1,
                Edit::Undeclare(at) if names > 0 => drop(declared.remove(at % names)),
                _ => {}
            }
        }
        program
    }
}

fn programs(numbers: std::ops::Range<usize>) -> impl Strategy<Value = Program> {
    (vec((numbers, any::<bool>()), 0..9), 0usize..5).prop_map(|(networks, declared)| Program {
        declared: (0..declared).map(|name| (format!("d{name}"), 0)).collect(),
        networks: networks
            .into_iter()
            .map(|(number, comment)| (number.to_string(), 0, comment))
            .collect(),
    })
}

/// Programs without two networks of one number.
fn distinct_programs() -> impl Strategy<Value = Program> {
    programs(0..1).prop_map(|mut program| {
        for (number, network) in program.networks.iter_mut().enumerate() {
            network.0 = number.to_string();
        }
        program
    })
}

fn edits() -> impl Strategy<Value = Vec<Edit>> {
    let edit = prop_oneof![
        (0usize..9, 0u8..3).prop_map(|(at, form)| Edit::Change(at, form)),
        (0usize..9).prop_map(Edit::Remove),
        (0usize..9).prop_map(Edit::Insert),
        (0usize..9, 0usize..9).prop_map(|(from, to)| Edit::Move(from, to)),
        (0usize..9).prop_map(Edit::Declare),
        (0usize..9).prop_map(Edit::Retype),
        (0usize..9).prop_map(Edit::Undeclare),
    ];
    vec(edit, 0..6)
}

fn merged(base: &str, ours: &str, theirs: &str) -> Merged {
    let (base, ours, theirs) = (outline(base), outline(ours), outline(theirs));
    let sides = Sides {
        base: &base,
        ours: &ours,
        theirs: &theirs,
    };
    merge(sides).expect("the texts are clear")
}

fn laid_out(text: &str) -> String {
    format_text(text, &Options::default())
}

fn networks(text: &str) -> BTreeSet<String> {
    let lines = text.lines().filter(|line| line.starts_with('+'));
    lines.map(str::to_owned).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn what_one_side_did_is_the_result(base in programs(0..6), edits in edits()) {
        let (base, side) = (base.text(), base.edited(&edits, "o").text());
        for (ours, theirs) in [(&base, &side), (&side, &base), (&side, &side)] {
            let merged = merged(&base, ours, theirs);
            prop_assert!(merged.conflicts.is_empty());
            prop_assert_eq!(laid_out(&merged.text), laid_out(&side));
        }
    }

    #[test]
    fn nothing_is_lost(base in distinct_programs(), ours in edits(), theirs in edits()) {
        let (ours, theirs) = (base.edited(&ours, "o").text(), base.edited(&theirs, "t").text());
        let base = base.text();
        let merged = merged(&base, &ours, &theirs);
        let (was, result) = (networks(&base), networks(&merged.text));
        let (ours, theirs) = (networks(&ours), networks(&theirs));
        for network in ours.union(&theirs) {
            let removed = was.contains(network) && !(ours.contains(network) && theirs.contains(network));
            prop_assert!(result.contains(network) || removed, "{network}\n{}", merged.text);
        }
        // Nor is anything there that nobody wrote.
        for network in &result {
            prop_assert!(ours.contains(network) || theirs.contains(network), "{network}");
        }
    }

    #[test]
    fn independent_edits_are_both_there(base in distinct_programs(), forms in vec((any::<bool>(), 0u8..4), 9)) {
        // Each network is edited, removed, or followed by a new one, by one of the sides.
        let (mut ours, mut theirs) = (base.clone(), base.clone());
        (ours.networks, theirs.networks) = (Vec::new(), Vec::new());
        let mut expected = BTreeSet::new();
        for (network, &(is_ours, form)) in base.networks.iter().zip(&forms) {
            let mut edited = vec![network.clone()];
            match form {
                0 => edited.clear(),
                3 => edited.push((format!("n{}", network.0), 0, false)),
                form => edited[0].1 = form,
            }
            expected.extend(edited.iter().map(line));
            let (one, other) = if is_ours { (&mut ours, &mut theirs) } else { (&mut theirs, &mut ours) };
            one.networks.extend(edited);
            other.networks.push(network.clone());
        }
        let merged = merged(&base.text(), &ours.text(), &theirs.text());
        prop_assert!(merged.conflicts.is_empty(), "{:?}", merged.conflicts);
        prop_assert_eq!(networks(&merged.text), expected);
    }

    #[test]
    fn a_conflict_is_a_text_like_any_other(base in distinct_programs(), ours in edits(), theirs in edits()) {
        let (ours, theirs) = (base.edited(&ours, "o").text(), base.edited(&theirs, "t").text());
        let merged = merged(&base.text(), &ours, &theirs);
        let text = laid_out(&merged.text);
        prop_assert_eq!(laid_out(&text), text.clone());
        let parsed = ladder_syntax::parse(&text);
        prop_assert!(parsed.errors().is_empty(), "{text}");
    }

    #[test]
    fn a_comparison_says_nothing_of_layout(base in programs(0..6)) {
        let text = base.text();
        let (old, new) = (outline(&text), outline(&laid_out(&text)));
        let comparison = compare(&old, &new);
        prop_assert!(comparison.changes.iter().all(|change| !change.moved));
        let counts = comparison.counts();
        prop_assert!(counts.iter().all(|(what, _)| matches!(*what, "same" | "drawn differently")));
    }
}

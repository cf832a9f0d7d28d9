//! What holds for merges of any edits.

use crate::harness::outline;
use ladder_format::{Options, format_text};
use ladder_review::{Merged, Sides, compare, merge};
use proptest::collection::vec;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// A network or a comment on a line of its own: its number, its form, and whether a network has a comment.
type Network = (String, u8, bool);

/// From this form on it is a comment on a line of its own.
const NOTE: u8 = 3;

/// A name and a form.
type Named = (String, u8);

#[derive(Debug, Clone)]
struct Program {
    setting: u8,
    types: Vec<Named>,
    declared: Vec<Named>,
    blocks: Vec<Named>,
    networks: Vec<Network>,
}

#[derive(Debug, Clone, Copy)]
enum Edit {
    Change(usize, u8),
    Remove(usize),
    Insert(usize),
    Move(usize, usize),
    Setting(u8),
    Name(List, NameEdit, usize),
}

/// What holds things with names.
#[derive(Debug, Clone, Copy)]
enum List {
    Types,
    Declared,
    Blocks,
}

#[derive(Debug, Clone, Copy)]
enum NameEdit {
    Add,
    Change,
    Remove,
}

fn line((number, form, _): &Network) -> String {
    if *form >= NOTE {
        return format!("# Note {number}, {form} #");
    }
    let contact = ["[ ]", "[/]", "[P]"][usize::from(*form)];
    format!("+--{contact}( a{number} )--[ ]( b )--( )( y{number} )--+")
}

/// The form that an edit makes of another.
fn edited_form(was: u8, form: u8) -> u8 {
    was - was % NOTE + form
}

impl List {
    const ALL: [List; 3] = [List::Types, List::Declared, List::Blocks];

    /// What is written of one of them.
    fn text(self, (name, form): &Named) -> String {
        let ty = ["BOOL", "INT", "DINT"][usize::from(form % 3)];
        let contact = ["[ ]", "[/]", "[P]"][usize::from(form % 3)];
        match self {
            List::Types => format!("    T{name} : STRUCT\n        of{name} : {ty};\n    END_STRUCT;\n"),
            List::Declared => format!("    d{name} : {ty};\n"),
            List::Blocks => format!(
                "\nFUNCTION_BLOCK [$B{name}]\nVAR_OUTPUT\n    o{name} : BOOL;\nEND_VAR\n\n\
                 # Inside of {name} #\n+--{contact}( EN )--( )( o{name} )--+\nEND_FUNCTION_BLOCK\n"
            ),
        }
    }
}

impl Program {
    fn text(&self) -> String {
        let mut text = String::from("# A program #\n\n");
        if self.setting > 0 {
            text.push_str(&format!(
                "# ladder: profile {} #\n\n",
                ["iot", "click"][usize::from(self.setting % 2)]
            ));
        }
        let all = |list: List| -> String { self.list(list).iter().map(|named| list.text(named)).collect() };
        text.push_str(&format!("TYPE\n{}END_TYPE\n\n", all(List::Types)));
        text.push_str(&format!(
            "VAR_INPUT\n    b : BOOL;\n{}END_VAR\n",
            all(List::Declared)
        ));
        text.push_str(&all(List::Blocks));
        for network in &self.networks {
            text.push('\n');
            if network.2 && network.1 < NOTE {
                text.push_str(&format!("# About {} #\n", network.0));
            }
            text.push_str(&line(network));
            text.push('\n');
        }
        text
    }

    fn list(&self, list: List) -> &Vec<Named> {
        match list {
            List::Types => &self.types,
            List::Declared => &self.declared,
            List::Blocks => &self.blocks,
        }
    }

    fn list_mut(&mut self, list: List) -> &mut Vec<Named> {
        match list {
            List::Types => &mut self.types,
            List::Declared => &mut self.declared,
            List::Blocks => &mut self.blocks,
        }
    }

    /// `side` makes what is new different from what the other side adds.
    fn edited(&self, edits: &[Edit], side: &str) -> Program {
        let mut program = self.clone();
        for (count, edit) in edits.iter().enumerate() {
            if let Edit::Name(list, edit, at) = *edit {
                let names = program.list_mut(list);
                let length = names.len();
                match edit {
                    NameEdit::Add => names.insert(at % (length + 1), (format!("{side}{count}"), 0)),
                    NameEdit::Change if length > 0 => names[at % length].1 += 1,
                    NameEdit::Remove if length > 0 => drop(names.remove(at % length)),
                    _ => {}
                }
                continue;
            }
            let networks = &mut program.networks;
            let length = networks.len();
            match *edit {
                Edit::Setting(setting) => program.setting = setting,
                Edit::Insert(at) => {
                    networks.insert(at % (length + 1), (format!("{side}{count}"), 0, at % 2 == 0));
                }
                Edit::Change(at, form) if length > 0 => {
                    let was = &mut networks[at % length].1;
                    *was = edited_form(*was, form);
                }
                Edit::Remove(at) if length > 0 => drop(networks.remove(at % length)),
                Edit::Move(from, to) if length > 0 => {
                    let network = networks.remove(from % length);
                    networks.insert(to % length, network);
                }
                _ => {}
            }
        }
        program
    }
}

fn programs(numbers: std::ops::Range<usize>) -> impl Strategy<Value = Program> {
    let network = (numbers, any::<bool>(), prop_oneof![3 => Just(0), 1 => Just(NOTE)]);
    (vec(network, 0..9), 0usize..5, 0usize..3, 0usize..3, 0u8..3).prop_map(
        |(networks, declared, types, blocks, setting)| {
            let names = |count: usize| (0..count).map(|name| (name.to_string(), 0)).collect();
            Program {
                setting,
                types: names(types),
                declared: names(declared),
                blocks: names(blocks),
                networks: networks
                    .into_iter()
                    .map(|(number, comment, form)| (number.to_string(), form, comment))
                    .collect(),
            }
        },
    )
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
    let list = proptest::sample::select(&List::ALL);
    let name_edit = prop_oneof![
        Just(NameEdit::Add),
        Just(NameEdit::Change),
        Just(NameEdit::Remove)
    ];
    let edit = prop_oneof![
        2 => (0usize..9, 0u8..3).prop_map(|(at, form)| Edit::Change(at, form)),
        1 => (0usize..9).prop_map(Edit::Remove),
        1 => (0usize..9).prop_map(Edit::Insert),
        1 => (0usize..9, 0usize..9).prop_map(|(from, to)| Edit::Move(from, to)),
        1 => (0u8..3).prop_map(Edit::Setting),
        4 => (list, name_edit, 0usize..5).prop_map(|(list, edit, at)| Edit::Name(list, edit, at)),
    ];
    vec(edit, 0..7)
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

/// All that is written of what has a number, line by line, and the settings; not the marks of conflicts. Other lines are there
/// several times.
fn lines(text: &str) -> BTreeSet<String> {
    let is_told = |line: &&str| line.contains(|c: char| c.is_ascii_digit()) || line.starts_with("# ladder:");
    let lines = text.lines().map(str::trim).filter(is_told);
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
        let (was, result) = (lines(&base), lines(&merged.text));
        let (ours, theirs) = (lines(&ours), lines(&theirs));
        for line in ours.union(&theirs) {
            let removed = was.contains(line) && !(ours.contains(line) && theirs.contains(line));
            prop_assert!(result.contains(line) || removed, "{line}\n{}", merged.text);
        }
        // Nor is anything there that nobody wrote.
        for line in &result {
            prop_assert!(ours.contains(line) || theirs.contains(line), "{line}\n{}", merged.text);
        }
    }

    #[test]
    fn independent_edits_are_both_there(base in distinct_programs(), forms in vec((any::<bool>(), 0u8..4), 30)) {
        // Each thing is edited, removed, or followed by a new one, by one of the sides.
        let (mut ours, mut theirs, mut both) = (base.clone(), base.clone(), base.clone());
        let mut forms = forms.into_iter().cycle();
        let mut next = || forms.next().unwrap_or_default();
        (ours.networks, theirs.networks, both.networks) = (Vec::new(), Vec::new(), Vec::new());
        for network in &base.networks {
            let (is_ours, form) = next();
            let mut edited = vec![network.clone()];
            match form {
                0 => edited.clear(),
                3 => edited.push((format!("n{}", network.0), 0, false)),
                form => edited[0].1 = edited_form(network.1, form),
            }
            both.networks.extend(edited.iter().cloned());
            let (one, other) = if is_ours { (&mut ours, &mut theirs) } else { (&mut theirs, &mut ours) };
            one.networks.extend(edited);
            other.networks.push(network.clone());
        }
        for list in List::ALL {
            for program in [&mut ours, &mut theirs, &mut both] {
                program.list_mut(list).clear();
            }
            for named in base.list(list) {
                let (is_ours, form) = next();
                let mut edited = vec![named.clone()];
                match form {
                    0 => edited.clear(),
                    3 => edited.push((format!("n{}", named.0), 0)),
                    form => edited[0].1 = form,
                }
                both.list_mut(list).extend(edited.iter().cloned());
                let (one, other) = if is_ours { (&mut ours, &mut theirs) } else { (&mut theirs, &mut ours) };
                one.list_mut(list).extend(edited);
                other.list_mut(list).push(named.clone());
            }
        }
        let (is_ours, form) = next();
        let one = if is_ours { &mut ours } else { &mut theirs };
        (one.setting, both.setting) = (form % 3, form % 3);
        let merged = merged(&base.text(), &ours.text(), &theirs.text());
        prop_assert!(merged.conflicts.is_empty(), "{:?}", merged.conflicts);
        prop_assert_eq!(lines(&merged.text), lines(&both.text()));
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

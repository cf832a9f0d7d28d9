//! Texts as they are typed, and as they are stored.

use super::{Random, between_others, context, given};
use crate::drawing::beside::Side;
use crate::redraw::{Change, Given, change, points_of};
use ladder_analysis::names::scope::SectionKind;
use ladder_format::{Options, apply};
use ladder_syntax::{TextRange, TextSize, parse};

/// Every kind of change at a place.
fn all_at(place: TextSize) -> Vec<Change> {
    let what = TextRange::at(place, TextSize::new(1));
    let text = "[ ]( x )".to_owned();
    vec![
        Change::Insert {
            at: place,
            given: given(&text),
        },
        Change::Parallel {
            from: place,
            to: place + TextSize::new(12),
            side: Side::Below,
            given: given(&text),
        },
        Change::Delete { what: vec![what] },
        Change::DeleteNetwork { network: place },
        Change::Operand {
            what,
            given: given("x"),
        },
        Change::Head {
            what: TextRange::at(place, TextSize::new(3)),
            text: "[P]".to_owned(),
        },
        Change::Move {
            what: vec![what],
            to: place + TextSize::new(17),
        },
        Change::BranchEnd {
            what: place,
            to: place + TextSize::new(17),
        },
        Change::Close {
            what: place,
            to: TextSize::new(16),
        },
        Change::Network {
            near: Some(place),
            is_above: true,
            given: given("[ ]( x )--( )( z )"),
        },
        Change::Comment {
            network: place,
            text: "x".to_owned(),
        },
        Change::EditComment { what, text },
        Change::MoveNetwork {
            network: place,
            before: None,
        },
        Change::Duplicate { network: place },
        Change::Split { at: place },
        Change::Merge {
            networks: vec![place, TextSize::new(0)],
        },
    ]
}

#[test]
fn what_is_half_typed_is_not_changed() {
    let whole = "+--\\--[ ]( a )--\\--[TON]( t, T#5s )--( )( y )--+\n|  /--[/]( b )--/                              |\n";
    for cut in 0..whole.len() {
        for text in [
            &whole[..cut],
            &whole[cut..],
            &format!("{}{}", &whole[..cut], &whole[cut + 1..]),
        ] {
            let context = context(text);
            for place in (0..text.len())
                .step_by(3)
                .map(|place| TextSize::new(place as u32))
            {
                let wanted = all_at(place);
                for wanted in wanted {
                    if place >= TextSize::of(text) {
                        continue;
                    }
                    // Refused with a reason, or made; what is made reads as a drawing without new errors.
                    match change(&context, &wanted, &Options::default()) {
                        Err(why) => assert!(!why.is_empty()),
                        Ok(done) => {
                            let new = apply(text, &done.edits);
                            let count = |text: &str| parse(text).errors().len();
                            assert!(count(&new) <= count(text), "{wanted:?} of\n{text}\n{new}");
                        }
                    }
                }
            }
        }
    }
}

/// A text as another editor stores it: with a mark before it, other line ends, and a block that tabulators indent.
fn stored(text: &str) -> String {
    format!("\u{feff}{}", text.replace('\n', "\r\n"))
}

/// A place of a text in what is stored.
fn in_stored(text: &str, at: TextSize) -> TextSize {
    let lines = text[..at.into()].matches('\n').count();
    at + TextSize::new((lines + '\u{feff}'.len_utf8()) as u32)
}

const TABS: &str = "VAR_INPUT\n\tstart :\tBOOL;\nEND_VAR\n\n";

#[test]
fn marks_line_ends_and_tabulators_stay() {
    let mut random = Random(71);
    let mut made = 0;
    for step in 0..150 {
        let text = format!("{TABS}{}", between_others(&mut random, 2));
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let at = points[random.below(points.len())];
        for number in 0..16 {
            let of = |at: TextSize| all_at(at).swap_remove(number);
            let wanted = of(at);
            let Ok(done) = change(&context(&text), &wanted, &Options::default()) else {
                continue;
            };
            let new = apply(&text, &done.edits);
            let other = stored(&text);
            // A change in which a second place counts from the first one is about another place there.
            let moved = map(&wanted, &|at| in_stored(&text, at));
            let same = change(&context(&other), &moved, &Options::default());
            let same = same.unwrap_or_else(|why| panic!("{why} in step {step}: {wanted:?} of\n{text}"));
            assert_eq!(apply(&other, &same.edits), stored(&new), "{wanted:?}");
            assert_eq!(same.said, done.said);
            made += 1;
            let is_declared = !done.declared.is_empty();
            assert!(is_declared || new.starts_with(TABS), "{wanted:?} made\n{new}");
        }
    }
    assert!(made > 800, "only {made} were made");
}

/// The same change with other places.
fn map(what: &Change, to: &dyn Fn(TextSize) -> TextSize) -> Change {
    let range = |range: &TextRange| TextRange::new(to(range.start()), to(range.end()));
    let mut what = what.clone();
    match &mut what {
        Change::Insert { at, .. } | Change::Split { at } => *at = to(*at),
        Change::Parallel { from, to: end, .. } => (*from, *end) = (to(*from), to(*end)),
        Change::Delete { what } => *what = what.iter().map(range).collect(),
        Change::Operand { what, .. } | Change::Head { what, .. } | Change::EditComment { what, .. } => {
            *what = range(what);
        }
        Change::Move { what, to: end } => {
            *what = what.iter().map(range).collect();
            *end = to(*end);
        }
        Change::BranchEnd { what, to: end } | Change::Close { what, to: end } => {
            (*what, *end) = (to(*what), to(*end));
        }
        Change::DeleteNetwork { network }
        | Change::Comment { network, .. }
        | Change::Duplicate { network } => *network = to(*network),
        Change::Network { near, .. } => *near = near.map(to),
        Change::MoveNetwork { network, before } => {
            *network = to(*network);
            *before = before.map(to);
        }
        Change::Merge { networks } => networks.iter_mut().for_each(|at| *at = to(*at)),
        _ => panic!("it has no place"),
    }
    what
}

#[test]
fn what_is_switched_off_stays_to_the_letter() {
    let mut random = Random(73);
    for _ in 0..50 {
        let text = between_others(&mut random, 2);
        let (above, own) = text.split_at(super::ABOVE.len());
        let text = format!("{above}# ladder: fmt off #\n{own}# ladder: fmt on #\n");
        let network = &text[above.len() + 20..];
        let at = TextSize::new((above.len() + 20 + random.below(network.find('\n').unwrap_or(1))) as u32);
        for wanted in all_at(at) {
            let is_whole = matches!(
                wanted,
                Change::Network { .. }
                    | Change::Comment { .. }
                    | Change::DeleteNetwork { .. }
                    | Change::MoveNetwork { .. }
                    | Change::Duplicate { .. }
            );
            match change(&context(&text), &wanted, &Options::default()) {
                Ok(_) => assert!(is_whole, "{wanted:?} was made of\n{text}"),
                Err(why) => assert!(
                    is_whole || why.contains("`fmt off`") || why.contains("comment"),
                    "{why}"
                ),
            }
        }
    }
}

#[test]
fn a_name_that_is_new_is_declared_and_nothing_else_changes() {
    const BODY: &str = "FUNCTION_BLOCK [$B]\nVAR a : BOOL; END_VAR\n+--[ ]( EN )--[ ]( a )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
    let mut random = Random(79);
    for step in 0..100 {
        let own = between_others(&mut random, 2);
        let mut names: Vec<&str> = own.split(['(', ')']).map(str::trim).collect();
        names.retain(|name| name.starts_with(|c: char| c.is_ascii_lowercase()) && !name.contains(' '));
        names.sort_unstable();
        names.dedup();
        let declared = format!("VAR\n    {} : BOOL;\nEND_VAR\n", names.join(", "));
        let text = format!("{declared}\n{own}\n{BODY}");
        let declare = [None, Some((SectionKind::Output, "BOOL".to_owned()))][step % 2].clone();
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let insert = Change::Insert {
            at: points[random.below(points.len())],
            given: Given {
                declare: declare.clone(),
                ..given("[ ]( fresh )--[TON]( late, T#1s )")
            },
        };
        let done = change(&context(&text), &insert, &Options::default()).expect("it can be");
        let new = apply(&text, &done.edits);
        let section = declare.map_or(SectionKind::Input, |(section, _)| section);
        let told: Vec<_> = done
            .declared
            .iter()
            .map(|tag| (tag.name.as_str(), tag.section))
            .collect();
        assert_eq!(told, [("fresh", section), ("late", SectionKind::Var)]);
        assert!(new.contains("    fresh : BOOL;\n"), "{new}");
        assert!(
            new.contains(super::ABOVE) && new.ends_with(&format!("{}\n{BODY}", super::BELOW)),
            "{new}"
        );
        let errors = |text: &str| {
            let analysis = ladder_analysis::analyze(&std::sync::Arc::new(parse(text)), "test.clad");
            let all = analysis.diagnostics().iter();
            all.filter(|found| found.severity == ladder_analysis::Severity::Error)
                .count()
        };
        assert_eq!(errors(&new), errors(&text), "{new}");
    }
}

#[test]
fn a_half_typed_text_is_refused_with_a_reason() {
    let text = "+--[ ]( a )--( )( y )--+\n";
    let at = TextSize::new(12);
    for whole in [
        "\\--[ ]( b )--[TON]( t, T#5s )--\\\n/--[/]( c )--------------------/",
        "XIC(b) BST XIO(c) NXB XIC(d) BND OTE(e)",
        "[CALC]( n, (n + 1) * 2 )--[ ]( d )",
    ] {
        for cut in (0..whole.len()).filter(|cut| whole.is_char_boundary(*cut)) {
            let insert = Change::Insert {
                at,
                given: given(&whole[..cut]),
            };
            match change(&context(text), &insert, &Options::default()) {
                Err(why) => assert!(!why.is_empty()),
                Ok(done) => {
                    let new = apply(text, &done.edits);
                    assert_eq!(parse(&new).errors().len(), 0, "{:?} made\n{new}", &whole[..cut]);
                    let selected = done.select.iter().map(|range| &new[*range]);
                    let selected: Vec<&str> = selected.collect();
                    assert!(!selected.is_empty() || cut == 0, "{:?}", &whole[..cut]);
                }
            }
        }
    }
}

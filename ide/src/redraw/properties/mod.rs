//! What holds for every change of every network in series and in parallel: 5,000 random changes of random networks.

use super::{Change, Given, change, points_of};
use crate::drawing::beside::Side;
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::Drawing;
use crate::drawing::term::{Rung, items, normal};
use ladder_analysis::context as read;
use ladder_analysis::context::Context;
use ladder_format::{Circuit, ElementKind, Options, apply, format_text};
use ladder_syntax::{TextRange, TextSize, parse};
use std::sync::Arc;

/// A sequence of numbers that look random.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 33) as usize % count
    }
}

/// A series of elements and branches; no branch is empty or another parallel alone.
fn series(random: &mut Random, depth: usize, names: &mut usize) -> Vec<Circuit<String>> {
    let count = 1 + random.below(3);
    let mut parts = Vec::new();
    for _ in 0..count {
        if depth > 0 && random.below(3) == 0 {
            let branches = (0..2 + random.below(2)).map(|_| {
                let mut branch = series(random, depth - 1, names);
                if matches!(branch.as_slice(), [Circuit::Parallel(_)]) {
                    branch.push(leaf(names));
                }
                Circuit::Series(branch)
            });
            parts.push(Circuit::Parallel(branches.collect()));
        } else {
            parts.push(leaf(names));
        }
    }
    parts
}

fn leaf(names: &mut usize) -> Circuit<String> {
    *names += 1;
    Circuit::Element(format!("[ ]( n{names} )"))
}

const ABOVE: &str = "# above #\n+--[ ]( q )-( )( r )--+ # as it is typed #\n\n";
const BELOW: &str = "\n+-[ ]( q )---( )( s )--+\n";

fn text_of(parts: Vec<Circuit<String>>) -> String {
    let circuit = Circuit::Series(parts);
    circuit.draw(&Options::default(), "\n", |text| {
        let acts = text.starts_with('(');
        let kind = if acts {
            ElementKind::Acting
        } else {
            ElementKind::Condition
        };
        (kind, text.as_str())
    })
}

/// The term of the middle network, with the texts of its elements.
fn term(text: &str) -> Vec<Circuit<String>> {
    let parsed = parse(text);
    let drawing = Drawing::of_text(&parsed, &parsed.structure().networks[1]).expect("it is drawn");
    let rung = Rung::read(&drawing).unwrap_or_else(|| panic!("no term:\n{text}"));
    let by = |item: Item| Circuit::Element(item.text);
    rung.parts.into_iter().map(|part| part.replaced(&by)).collect()
}

fn context(text: &str) -> Context {
    read(&Arc::new(parse(text)), "test.clad")
}

fn at(text: &str, what: &str) -> TextRange {
    let start = text
        .find(what)
        .unwrap_or_else(|| panic!("{what} is not in\n{text}"));
    TextRange::at(TextSize::new(start as u32), TextSize::of(what))
}

/// The text after a change, and what is selected in it.
fn changed(text: &str, what: &Change) -> Result<(String, Vec<String>), String> {
    let done = change(&context(text), what, &Options::default())?;
    for pair in done.edits.windows(2) {
        assert!(pair[0].range.end() < pair[1].range.start(), "{:?}", done.edits);
    }
    let new = apply(text, &done.edits);
    let selected = done.select.iter().map(|range| new[*range].to_owned());
    let selected = selected.collect();
    if let Some(focus) = done.focus {
        assert!(new.is_char_boundary(focus.into()));
    }
    Ok((new, selected))
}

/// What holds after each change: the network is the drawing of its term, the others are as they were.
#[track_caller]
fn check(old: &str, new: &str) {
    let middle = |text: &str| {
        text.strip_prefix(ABOVE)
            .and_then(|text| text.strip_suffix(BELOW))
            .map(str::to_owned)
    };
    let own = middle(new).unwrap_or_else(|| panic!("other networks changed:\n{old}\n{new}"));
    assert_eq!(
        format_text(&own, &Options::default()),
        own,
        "not canonical, from\n{old}"
    );
    assert_eq!(
        text_of(term(new)),
        own,
        "not the drawing of its term, from\n{old}"
    );
}

fn blocks(parts: &[Circuit<String>]) -> Vec<String> {
    let of_part = |part: &Circuit<String>| match part {
        Circuit::Element(text) => vec![text.clone()],
        Circuit::Series(parts) | Circuit::Parallel(parts) => blocks(parts),
    };
    parts.iter().flat_map(of_part).collect()
}

fn given(text: &str) -> Given {
    Given {
        text: text.to_owned(),
        ..Given::default()
    }
}

#[test]
fn a_network_stays_the_drawing_of_its_term() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut made, mut refused) = (0, 0);
    let mut text = String::new();
    for step in 0..5_000 {
        // A new network now and then: changes make it grow.
        if step % 8 == 0 {
            let mut names = 0;
            let mut parts = series(&mut random, 3, &mut names);
            parts.push(Circuit::Element("( )( y )".to_owned()));
            text = format!("{ABOVE}{}{BELOW}", text_of(parts));
        }
        let before = blocks(&term(&text));
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let point = points[random.below(points.len())];
        let thing = before[random.below(before.len())].clone();
        let name = format!("[/]( m{step} )");
        let around = at(&text, &thing);
        let wanted = match random.below(5) {
            0 | 1 => Change::Insert {
                at: point,
                given: given(&name),
            },
            2 => Change::Parallel {
                from: around.start(),
                to: around.end(),
                side: if random.below(3) == 0 {
                    Side::Above
                } else {
                    Side::Below
                },
                given: given(&name),
            },
            3 => Change::Delete { what: vec![around] },
            _ => Change::Move {
                what: vec![around],
                to: point,
            },
        };
        let Ok((new, selected)) = changed(&text, &wanted) else {
            refused += 1;
            continue;
        };
        made += 1;
        if !new.contains("[ ](") || before.len() < 2 {
            continue;
        }
        check(&text, &new);
        let after = blocks(&term(&new));
        match &wanted {
            Change::Insert { .. } | Change::Parallel { .. } => {
                assert_eq!(selected, [name.as_str()]);
                // What was there runs in the order in which it did.
                let rest: Vec<_> = after.iter().filter(|text| **text != name).cloned().collect();
                assert_eq!(rest, before, "from\n{text}\nto\n{new}");
                // Deleting it again is the inverse.
                let back = Change::Delete {
                    what: vec![at(&new, &name)],
                };
                assert_eq!(
                    changed(&new, &back).expect("it goes again").0,
                    text,
                    "from\n{new}"
                );
            }
            Change::Delete { .. } => {
                let rest: Vec<_> = before.iter().filter(|text| **text != thing).cloned().collect();
                assert_eq!(after, rest, "from\n{text}\nto\n{new}");
            }
            _ => {
                let rest = |all: &[String]| {
                    all.iter()
                        .filter(|text| **text != thing)
                        .cloned()
                        .collect::<Vec<_>>()
                };
                assert_eq!(rest(&after), rest(&before), "from\n{text}\nto\n{new}");
                assert!(selected.is_empty() || selected == [thing.as_str()]);
            }
        }
        text = new;
    }
    assert!(
        made > 4_000 && refused < 500,
        "{made} were made, {refused} refused"
    );
}

/// A network from a fork on: branches that end by themselves, at the right rail, at nothing, or with a loose wire.
fn with_ends(random: &mut Random, depth: usize, names: &mut usize) -> Vec<Circuit<Item>> {
    let own = series(random, depth, names);
    let by = |text: String| Circuit::Element(Item::block(text));
    let mut parts: Vec<Circuit<Item>> = own.into_iter().map(|part| part.replaced(&by)).collect();
    if depth > 0 && random.below(2) == 0 {
        let branches = (0..2 + random.below(2)).map(|_| Circuit::Series(with_ends(random, depth - 1, names)));
        parts.push(Circuit::Parallel(branches.collect()));
    } else {
        let end = match random.below(3) {
            0 => Item::new(ItemKind::Open, "", true),
            1 => Item::new(ItemKind::Stub, "--", true),
            _ => Item::right_rail(),
        };
        parts.push(Circuit::Element(end));
    }
    parts
}

#[test]
fn branches_that_end_by_themselves_are_a_term() {
    let mut random = Random(11);
    for step in 0..1_000 {
        let mut names = 0;
        let parts = with_ends(&mut random, 3, &mut names);
        let like = parse("+--[ ]( a )--+\n");
        let like = Drawing::of_text(&like, &like.structure().networks[0]).expect("it is drawn");
        let rung = Rung {
            parts: Vec::new(),
            railed: false,
        };
        let drawn = rung.draw_bare(&like, normal(parts)).text();
        let text = format_text(&format!("{drawn}\n"), &Options::default());
        let parsed = parse(&text);
        assert_eq!(parsed.structure().networks.len(), 1, "{text}");
        let drawing = Drawing::of_text(&parsed, &parsed.structure().networks[0]).expect("it is drawn");
        let read = Rung::with_ends(&drawing).unwrap_or_else(|| panic!("no term:\n{text}"));
        let again = read.draw(&drawing, read.parts.clone()).text();
        assert_eq!(format_text(&format!("{again}\n"), &Options::default()), text);
        // What is put in goes again, and nothing else with it.
        let points = points_of(&context(&text), 0).expect("it can be changed");
        let insert = Change::Insert {
            at: points[random.below(points.len())],
            given: given("[/]( m )"),
        };
        let (new, selected) = changed(&text, &insert).unwrap_or_else(|why| panic!("{why}\n{text}"));
        assert_eq!(selected, ["[/]( m )"]);
        assert_eq!(format_text(&new, &Options::default()), new);
        let name = format!("[ ]( n{} )", 1 + step % names);
        let around = at(&new, &name);
        let beside = Change::Parallel {
            from: around.start(),
            to: around.end(),
            side: Side::Below,
            given: given("[P]( p )"),
        };
        let (more, _) = changed(&new, &beside).unwrap_or_else(|why| panic!("{why}\n{new}"));
        assert_eq!(format_text(&more, &Options::default()), more);
        for (from, gone, to) in [(&more, "[P]( p )", &new), (&new, "[/]( m )", &text)] {
            let back = Change::Delete {
                what: vec![at(from, gone)],
            };
            assert_eq!(
                &changed(from, &back).expect("it goes again").0,
                to,
                "from\n{from}"
            );
        }
    }
}

#[test]
fn every_point_is_a_place_of_the_term() {
    fn places(parts: &[Circuit<String>]) -> usize {
        let inner = parts.iter().map(|part| match part {
            Circuit::Parallel(branches) => branches
                .iter()
                .map(|branch| match branch {
                    Circuit::Series(parts) => places(parts),
                    part => places(std::slice::from_ref(part)),
                })
                .sum(),
            _ => 0,
        });
        parts.len() + 1 + inner.sum::<usize>()
    }
    let mut random = Random(7);
    for _ in 0..500 {
        let mut names = 0;
        let mut parts = series(&mut random, 3, &mut names);
        parts.push(Circuit::Element("( )( y )".to_owned()));
        let text = text_of(parts);
        let points = points_of(&context(&text), 0).expect("it can be changed");
        let parsed = parse(&text);
        let drawing = Drawing::of_text(&parsed, &parsed.structure().networks[0]).expect("it is drawn");
        let rung = Rung::read(&drawing).expect("it is a term");
        let by = |item: Item| Circuit::Element(item.text);
        let term: Vec<_> = rung
            .parts
            .iter()
            .cloned()
            .map(|part| part.replaced(&by))
            .collect();
        assert_eq!(points.len(), places(&term), "{text}");
        let all = rung.parts.iter().flat_map(items).count();
        assert_eq!(normal(rung.parts.clone()).iter().flat_map(items).count(), all);
    }
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
                let wanted = [
                    Change::Insert {
                        at: place,
                        given: given("[ ]( x )"),
                    },
                    Change::Delete {
                        what: vec![TextRange::at(place, TextSize::new(1))],
                    },
                ];
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

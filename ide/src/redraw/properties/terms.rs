//! Things come, go and move, and the network stays the drawing of its term.

use super::{ABOVE, BELOW, Random, at, blocks, changed, check, context, given, series, term, text_of};
use crate::drawing::beside::Side;
use crate::drawing::item::Item;
use crate::drawing::rows::Drawing;
use crate::drawing::term::{Rung, items, normal};
use crate::redraw::{Change, points_of};
use ladder_format::Circuit;
use ladder_syntax::parse;

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

//! Whole networks move, are drawn once more, part and join.

use super::{Random, blocks, changed, context, series, text_of};
use crate::drawing::rows::Drawing;
use crate::drawing::term::Rung;
use crate::redraw::{Change, points_of};
use ladder_format::{Circuit, Options, format_text};
use ladder_syntax::{TextSize, parse};

/// Some networks as they are laid out, some with comments that touch them.
fn networks(random: &mut Random, count: usize) -> Vec<String> {
    let mut names = 0;
    let networks = (0..count).map(|number| {
        let mut parts = series(random, 2, &mut names);
        parts.push(Circuit::Element(format!("( )( y{number} )")));
        let comment = match random.below(3) {
            0 => format!("# ladder: allow(double-coil): number {number} #\n# of the plant #\n"),
            1 => format!("# number {number} #\n"),
            _ => String::new(),
        };
        comment + &text_of(parts)
    });
    networks.collect()
}

fn file(networks: &[String]) -> String {
    networks.join("\n")
}

/// A place in each network.
fn places(networks: &[String]) -> Vec<TextSize> {
    let mut at = 0;
    let places = networks.iter().map(|network| {
        let rung = at + network.find('+').expect("it has a rail");
        at += network.len() + 1;
        TextSize::new(rung as u32)
    });
    places.collect()
}

/// The blocks of a network of a text, as its term has them.
fn blocks_of(text: &str, number: usize) -> Vec<String> {
    let parsed = parse(text);
    let drawing = Drawing::of_text(&parsed, &parsed.structure().networks[number]).expect("it is drawn");
    let rung = Rung::read(&drawing).unwrap_or_else(|| panic!("no term:\n{text}"));
    let by = |item: crate::drawing::item::Item| Circuit::Element(item.text);
    let parts: Vec<_> = rung.parts.into_iter().map(|part| part.replaced(&by)).collect();
    blocks(&parts)
}

#[test]
fn networks_change_places_with_what_touches_them() {
    let mut random = Random(53);
    for _ in 0..200 {
        let all = networks(&mut random, 4);
        let text = file(&all);
        let places = places(&all);
        let from = random.below(all.len());
        let before = Some(random.below(all.len() + 1)).filter(|before| *before < all.len());
        let wanted = Change::MoveNetwork {
            network: places[from],
            before: before.map(|before| places[before]),
        };
        let to = before.unwrap_or(all.len());
        let moved = changed(&text, &wanted);
        if to == from || to == from + 1 {
            assert_eq!(moved.expect_err("it is there"), "the network is there already");
            continue;
        }
        let (new, selected) = moved.expect("it can be");
        let mut order = all.clone();
        let network = order.remove(from);
        order.insert(if to > from { to - 1 } else { to }, network);
        assert_eq!(new, file(&order));
        assert_eq!(selected, [all[from].trim_end()]);
    }
}

#[test]
fn a_network_is_drawn_once_more_and_goes_again() {
    let mut random = Random(59);
    for _ in 0..100 {
        let all = networks(&mut random, 3);
        let text = file(&all);
        let number = random.below(all.len());
        let network = places(&all)[number];
        let (new, selected) = changed(&text, &Change::Duplicate { network }).expect("it can be");
        let mut twice = all.clone();
        twice.insert(number, all[number].clone());
        assert_eq!(new, file(&twice));
        assert_eq!(selected, [all[number].trim_end()]);
        let copy = places(&twice)[number + 1];
        let (back, _) = changed(&new, &Change::DeleteNetwork { network: copy }).expect("it can be");
        assert_eq!(back, text);
    }
}

#[test]
fn a_network_parts_and_the_others_stay() {
    let mut random = Random(61);
    let mut made = 0;
    for _ in 0..300 {
        let all = networks(&mut random, 3);
        let text = file(&all);
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let at = points[random.below(points.len())];
        let Ok((new, selected)) = changed(&text, &Change::Split { at }) else {
            continue;
        };
        made += 1;
        let own = new
            .strip_prefix(&format!("{}\n", all[0]))
            .expect("the first stays");
        let own = own
            .strip_suffix(&format!("\n{}", all[2]))
            .expect("the last stays");
        assert_eq!(format_text(own, &Options::default()), own);
        let before = blocks_of(&text, 1);
        let (mut first, mut second) = (blocks_of(&new, 1), blocks_of(&new, 2));
        if !selected.is_empty() {
            assert_eq!(selected, ["( )( split_1 )", "[ ]( split_1 )"]);
            assert_eq!(first.pop().expect("it has one"), selected[0]);
            assert_eq!(second.remove(0), selected[1]);
        }
        first.extend(second);
        assert_eq!(first, before, "from\n{text}\nto\n{new}");
    }
    assert!(made > 150, "only {made} were made");
}

#[test]
fn networks_join_and_the_others_stay() {
    let mut random = Random(67);
    for _ in 0..100 {
        let all = networks(&mut random, 4);
        // What is said of one network is not said of both.
        let all: Vec<String> = all
            .into_iter()
            .map(|text| text[text.find('+').unwrap_or(0)..].to_owned())
            .collect();
        let text = file(&all);
        let merge = Change::Merge {
            networks: places(&all)[1..3].to_vec(),
        };
        let (new, selected) = changed(&text, &merge).expect("it can be");
        assert!(selected.is_empty(), "{selected:?}");
        let own = new
            .strip_prefix(&format!("{}\n", all[0]))
            .expect("the first stays");
        let own = own
            .strip_suffix(&format!("\n{}", all[3]))
            .expect("the last stays");
        assert_eq!(format_text(own, &Options::default()), own);
        let mut both = blocks_of(&text, 1);
        both.extend(blocks_of(&text, 2));
        assert_eq!(blocks_of(&new, 1), both, "from\n{text}\nto\n{new}");
    }
}

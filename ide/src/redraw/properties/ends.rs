//! Branches that end by themselves, and ends of branches that are joined elsewhere.

use super::{
    ABOVE, BELOW, Random, at, between_others, blocks, changed, check, context, given, inverse, series, term,
};
use crate::drawing::beside::Side;
use crate::drawing::item::{Item, ItemKind};
use crate::drawing::rows::Drawing;
use crate::drawing::term::{Rung, normal};
use crate::redraw::{Change, points_of};
use ladder_format::{Circuit, Options, format_text};
use ladder_syntax::{TextSize, parse};

fn items_of(parts: Vec<Circuit<String>>) -> Vec<Circuit<Item>> {
    let by = |text: String| Circuit::Element(Item::block(text));
    parts.into_iter().map(|part| part.replaced(&by)).collect()
}

/// The canonical text of a network whose ends are among its parts.
fn drawn(parts: Vec<Circuit<Item>>) -> String {
    let like = parse("+--[ ]( a )--+\n");
    let like = Drawing::of_text(&like, &like.structure().networks[0]).expect("it is drawn");
    let rung = Rung {
        parts: Vec::new(),
        railed: false,
    };
    let drawn = rung.draw_bare(&like, normal(parts)).text();
    format_text(&format!("{drawn}\n"), &Options::default())
}

/// A network from a fork on: branches that end by themselves, at the right rail, at nothing, or with a loose wire.
fn with_ends(random: &mut Random, depth: usize, names: &mut usize) -> Vec<Circuit<Item>> {
    let mut parts = items_of(series(random, depth, names));
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
        let text = drawn(parts);
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

/// The connectors of the middle network of a text.
fn connectors(text: &str) -> Vec<TextSize> {
    let end = text.len() - BELOW.len();
    let own = text[ABOVE.len()..end].match_indices(['\\', '/']);
    // One in a head, as of `[/]`, is none.
    let own = own.filter(|(at, _)| !text[ABOVE.len()..][..*at].ends_with('['));
    own.map(|(at, _)| TextSize::new((ABOVE.len() + at) as u32))
        .collect()
}

/// Whether nowhere more than two branches are beside each other.
fn are_pairs(parts: &[Circuit<String>]) -> bool {
    parts.iter().all(|part| match part {
        Circuit::Element(_) => true,
        Circuit::Series(parts) => are_pairs(parts),
        Circuit::Parallel(branches) => branches.len() == 2 && are_pairs(branches),
    })
}

#[test]
fn the_end_of_a_branch_moves_and_comes_back() {
    let mut random = Random(23);
    let (mut made, mut tried, mut came_back) = (0, 0, 0);
    while made < 150 {
        tried += 1;
        assert!(tried < 5_000, "only {made} were made");
        let text = between_others(&mut random, 2);
        let ends = connectors(&text);
        if ends.is_empty() {
            continue;
        }
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let wanted = Change::BranchEnd {
            what: ends[random.below(ends.len())],
            to: points[random.below(points.len())],
        };
        let Ok((new, selected)) = changed(&text, &wanted) else {
            continue;
        };
        made += 1;
        check(&text, &new);
        assert!(selected.is_empty(), "{selected:?}");
        let sorted = |text: &str| {
            let mut blocks = blocks(&term(text));
            blocks.sort();
            blocks
        };
        assert_eq!(sorted(&new), sorted(&text), "from\n{text}\nto\n{new}");
        // The branches below one go with its end: they do not come back alone.
        let is_alone = |text: &str| are_pairs(&term(text));
        if !is_alone(&text) || !is_alone(&new) {
            continue;
        }
        came_back += 1;
        let points = points_of(&context(&new), 1).expect("it can be changed");
        let all = connectors(&new)
            .into_iter()
            .flat_map(|what| points.iter().map(move |&to| Change::BranchEnd { what, to }));
        let back = inverse(&new, &text, all);
        assert!(
            back.is_some() || new == text,
            "nothing leads from\n{new}\nback to\n{text}"
        );
    }
    assert!(came_back > 20, "only {came_back} came back");
}

#[test]
fn a_loose_end_is_closed() {
    let mut random = Random(31);
    let (mut made, mut tried) = (0, 0);
    while made < 150 {
        tried += 1;
        assert!(tried < 5_000, "only {made} were made");
        let mut names = 0;
        let mut branch = |end: Item| {
            let mut parts = items_of(series(&mut random, 1, &mut names));
            parts.push(Circuit::Element(end));
            parts
        };
        let mut parts = branch(Item::block("[ ]( m )"));
        let mut upper = branch(Item::block("( )( y )"));
        upper.push(Circuit::Element(Item::right_rail()));
        let mut lower = branch(Item::block("[ ]( last )"));
        lower.push(Circuit::Element(Item::new(ItemKind::Open, "", true)));
        parts.push(Circuit::Parallel([upper, lower].map(Circuit::Series).into()));
        let text = format!("{ABOVE}{}{BELOW}", drawn(parts));
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let close = Change::Close {
            what: at(&text, "[ ]( last )").end(),
            to: points[random.below(points.len())],
        };
        let Ok((new, selected)) = changed(&text, &close) else {
            continue;
        };
        made += 1;
        check(&text, &new);
        assert!(selected.is_empty(), "{selected:?}");
        let (mut before, mut after) = (of_rows(&text), of_rows(&new));
        before.sort();
        after.sort();
        assert_eq!(after, before, "from\n{text}\nto\n{new}");
    }
}

/// The blocks of the middle network of a text, line by line.
fn of_rows(text: &str) -> Vec<String> {
    let parsed = parse(text);
    let drawing = Drawing::of_text(&parsed, &parsed.structure().networks[1]).expect("it is drawn");
    let items = drawing.rows.iter().flat_map(|row| &row.items);
    let blocks = items.filter(|item| item.is_block());
    blocks.map(|item| item.text.clone()).collect()
}

//! A change and its inverse give every byte back.

use super::{
    ABOVE, BELOW, Random, at, between_others, blocks, changed, check, context, given, inverse, term,
};
use crate::redraw::{Change, points_of};
use ladder_format::Circuit;
use ladder_syntax::{TextRange, TextSize};

/// How many branches there are.
fn branches(parts: &[Circuit<String>]) -> usize {
    let of_part = |part: &Circuit<String>| match part {
        Circuit::Element(_) => 0,
        Circuit::Series(parts) => branches(parts),
        Circuit::Parallel(parts) => parts.len() + branches(parts),
    };
    parts.iter().map(of_part).sum()
}

#[test]
fn what_is_moved_comes_back() {
    let mut random = Random(41);
    let mut made = 0;
    for _ in 0..400 {
        let text = between_others(&mut random, 2);
        let all = blocks(&term(&text));
        let thing = &all[random.below(all.len())];
        let points = points_of(&context(&text), 1).expect("it can be changed");
        let wanted = Change::Move {
            what: vec![at(&text, thing)],
            to: points[random.below(points.len())],
        };
        let Ok((new, _)) = changed(&text, &wanted) else {
            continue;
        };
        // Where a branch was emptied there is nothing to go back to.
        if branches(&term(&new)) != branches(&term(&text)) {
            continue;
        }
        made += 1;
        let points = points_of(&context(&new), 1).expect("it can be changed");
        let what = at(&new, thing);
        let all = points.iter().map(|&to| Change::Move { what: vec![what], to });
        assert!(
            new == text || inverse(&new, &text, all).is_some(),
            "nothing leads from\n{new}\nback to\n{text}"
        );
    }
    assert!(made > 150, "only {made} were made");
}

#[test]
fn heads_and_operands_are_replaced_and_nothing_else() {
    let mut random = Random(43);
    for _ in 0..200 {
        let text = between_others(&mut random, 2);
        let all = blocks(&term(&text));
        let thing = &all[random.below(all.len())];
        let block = at(&text, thing);
        let head = TextRange::at(block.start(), TextSize::new(3));
        let old = text[head].to_owned();
        let other = if old == "( )" { "(S)" } else { "[P]" };
        let with_head = |text: &str| Change::Head {
            what: head,
            text: text.to_owned(),
        };
        let (new, selected) = changed(&text, &with_head(other)).expect("it can be");
        assert_eq!(new, {
            let mut new = text.clone();
            new.replace_range(std::ops::Range::<usize>::from(head), other);
            new
        });
        assert_eq!(selected, [thing.replacen(&old, other, 1)]);
        assert_eq!(changed(&new, &with_head(&old)).expect("it can be").0, text);

        let name = TextRange::new(block.start() + TextSize::new(5), block.end() - TextSize::new(2));
        let longer = Change::Operand {
            what: name,
            given: given("a_longer_name"),
        };
        let (new, selected) = changed(&text, &longer).expect("it can be");
        check(&text, &new);
        assert_eq!(selected, [format!("{old}( a_longer_name )")]);
        let what = at(&new, "a_longer_name");
        let back = Change::Operand {
            what,
            given: given(&text[name]),
        };
        assert_eq!(changed(&new, &back).expect("it can be").0, text);
    }
}

#[test]
fn a_comment_comes_and_goes() {
    let mut random = Random(47);
    for _ in 0..100 {
        let text = between_others(&mut random, 2);
        let lines = text[ABOVE.len()..text.len() - BELOW.len()].lines().count();
        let first = ABOVE.lines().count();
        let line = first + random.below(lines);
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        let comment = Change::Comment {
            network: TextSize::new(start as u32),
            text: "why\nand how".to_owned(),
        };
        let (new, selected) = changed(&text, &comment).expect("it can be");
        assert_eq!(selected, ["# why #\n# and how #"]);
        let mut expected = text.clone();
        expected.insert_str(ABOVE.len(), "# why #\n# and how #\n");
        assert_eq!(new, expected);
        let without = |text: &str, comment: &str| {
            let delete = Change::EditComment {
                what: at(text, comment),
                text: String::new(),
            };
            changed(text, &delete).expect("it can be").0
        };
        assert_eq!(without(&without(&new, "# why #"), "# and how #"), text);
    }
}

//! Changes of the diagram: what a text becomes, with `«»` around what is selected then, and what is said; or why not. `$0`, `$1`
//! .. in a text are the places that a change is about.

mod blocks;
mod branches;
mod networks;
mod put_in;

use super::{Change, Given, change};
use crate::drawing::beside::Side;
use expect_test::Expect;
use ladder_analysis::context;
use ladder_format::{Options, apply};
use ladder_syntax::{TextRange, TextSize, parse};
use std::sync::Arc;

fn given(text: &str) -> Given {
    Given {
        text: text.to_owned(),
        ..Given::default()
    }
}

fn copied(text: &str) -> Given {
    Given {
        copied: true,
        ..given(text)
    }
}

/// The text of a fixture, and its places.
fn fixture(marked: &str) -> (String, Vec<TextSize>) {
    let mut text = marked.to_owned();
    let mut places = Vec::new();
    let next = |text: &str| {
        let mut marks = text.match_indices('$').map(|(at, _)| at);
        marks.find(|at| text[at + 1..].starts_with(|c: char| c.is_ascii_digit()))
    };
    while let Some(at) = next(&text) {
        let number = text[at + 1..at + 2].to_owned();
        text.replace_range(at..at + 2, "");
        places.push((number, TextSize::new(at as u32)));
    }
    places.sort();
    (text, places.into_iter().map(|(_, place)| place).collect())
}

#[track_caller]
fn check(marked: &str, what: impl Fn(&[TextSize]) -> Change, expected: Expect) {
    let (text, places) = fixture(marked);
    let context = context(&Arc::new(parse(&text)), "test.clad");
    let shown = match change(&context, &what(&places), &Options::default()) {
        Err(why) => format!("{why}\n"),
        Ok(done) => {
            let mut new = apply(&text, &done.edits);
            for range in done.select.iter().rev() {
                new.insert(range.end().into(), '»');
                new.insert(range.start().into(), '«');
            }
            format!("{}{}\n", new.replace('\r', "␍"), done.said)
        }
    };
    expected.assert_eq(&shown);
}

fn insert(text: &'static str) -> impl Fn(&[TextSize]) -> Change {
    move |at| Change::Insert {
        at: at[0],
        given: given(text),
    }
}

fn below(text: &'static str) -> impl Fn(&[TextSize]) -> Change {
    move |at| Change::Parallel {
        from: at[0],
        to: at[1],
        side: Side::Below,
        given: given(text),
    }
}

fn delete(at: &[TextSize]) -> Change {
    let what = at.chunks(2).map(|pair| TextRange::new(pair[0], pair[1]));
    Change::Delete { what: what.collect() }
}

fn moved(at: &[TextSize]) -> Change {
    Change::Move {
        what: vec![TextRange::new(at[0], at[1])],
        to: at[2],
    }
}

//! What holds for every change of every network in series and in parallel: random changes of random networks.

mod ends;
mod inverse;
mod networks;
mod terms;
mod texts;

use super::{Change, Given, change};
use crate::drawing::item::Item;
use crate::drawing::rows::Drawing;
use crate::drawing::term::Rung;
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

/// A network with a coil at its end, between two others.
fn between_others(random: &mut Random, depth: usize) -> String {
    let mut names = 0;
    let mut parts = series(random, depth, &mut names);
    parts.push(Circuit::Element("( )( y )".to_owned()));
    format!("{ABOVE}{}{BELOW}", text_of(parts))
}

/// What changes a text back into one before: the first of some changes that does.
fn inverse(new: &str, text: &str, all: impl IntoIterator<Item = Change>) -> Option<Change> {
    let context = context(new);
    all.into_iter().find(|what| {
        let done = change(&context, what, &Options::default());
        done.is_ok_and(|done| apply(new, &done.edits) == text)
    })
}

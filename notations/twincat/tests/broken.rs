//! Units with something broken in them: each is read, or refused with a reason; nothing is left out in silence.

use ladder_format::{Options, format_text};
use ladder_notation::{Lines, Outcome, Source, convert};
use ladder_notation_twincat::TwinCat;
use proptest::prelude::*;
use proptest::sample::{Index, select};

const SOUND: &str = include_str!("../../../fuzz/seeds/notations/twincat");

/// What can happen to a file.
#[derive(Debug, Clone)]
enum Mutation {
    /// A stretch of the text is gone.
    Delete(Index, usize),
    /// A word is put in.
    Insert(Index, &'static str),
    /// The text of a value, or an attribute, is another.
    Replace(Index, &'static str),
    /// A line is there twice.
    Twice(Index),
    /// A line is gone.
    Without(Index),
}

const WORDS: &[&str] = &[
    "",
    "\"\"",
    "1",
    "3",
    "4",
    "8",
    "16",
    "64",
    "-1",
    "99999999999",
    "true",
    "BoxTreeOperand",
    "BoxTreeDemux",
    "BoxTreeParallel",
    "Operand",
    "TON",
    "AND",
    "ADD",
    "EN",
    "a.b",
    "\"# ladder: fmt off #\"",
    "\"x := 1\"",
    "<n/>",
    "???",
    "END_VAR",
    "VAR",
    "é",
    "{",
    "}",
    "(*",
];

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<Index>;
    prop_oneof![
        1 => (at(), 1..30usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        2 => (at(), select(WORDS)).prop_map(|(at, word)| Mutation::Insert(at, word)),
        8 => (at(), select(WORDS)).prop_map(|(at, word)| Mutation::Replace(at, word)),
        2 => at().prop_map(Mutation::Twice),
        2 => at().prop_map(Mutation::Without),
    ]
}

impl Mutation {
    fn of(&self, text: &mut String) {
        let whole = |text: &str, mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        if text.is_empty() {
            return;
        }
        match self {
            Mutation::Delete(at, length) => {
                let at = at.index(text.len());
                let range = whole(text, at)..whole(text, (at + length).min(text.len()));
                text.replace_range(range, "");
            }
            Mutation::Insert(at, word) => {
                let at = whole(text, at.index(text.len()));
                text.insert_str(at, word);
            }
            Mutation::Replace(at, word) => {
                let mut ranges = Vec::new();
                for (open, close) in [("=\"", "\""), (">", "<")] {
                    let starts = text.match_indices(open).map(|(at, _)| at + open.len());
                    ranges.extend(starts.filter_map(|start| Some(start..start + text[start..].find(close)?)));
                }
                ranges.retain(|range| !text[range.clone()].trim().is_empty());
                if !ranges.is_empty() {
                    text.replace_range(at.get(&ranges).clone(), word);
                }
            }
            Mutation::Twice(at) | Mutation::Without(at) => {
                let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
                let number = at.index(lines.len());
                if matches!(self, Mutation::Twice(_)) {
                    lines.insert(number, lines[number]);
                } else {
                    lines.remove(number);
                }
                *text = lines.concat();
            }
        }
    }
}

fn holds(text: &str) {
    let options = Options::default();
    let converted = match convert(&TwinCat, &Source::alone("test", text.as_bytes()), &options) {
        Ok(converted) => converted,
        Err(error) => return assert!(error.message.len() > 10, "{error}"),
    };
    let written = &converted.written.text;
    let errors = ladder_syntax::parse(written).errors();
    assert!(errors.is_empty(), "{errors:?}\n{written}\nof\n{text}");
    assert_eq!(format_text(written, &options), *written);
    if converted.report.remarks().any(|entry| entry.element == "body") {
        return;
    }
    // What a network writes is told, or the network is refused.
    let lines = Lines::of(text);
    let document = roxmltree::Document::parse(text).expect("it was read");
    let has = |node: roxmltree::Node<'_, '_>, name: &str| {
        node.children().any(|field| field.attribute("n") == Some(name))
    };
    for network in document.descendants().filter(|node| has(*node, "NetworkItems")) {
        if network
            .ancestors()
            .all(|around| around.attribute("n") != Some("NetworkList"))
        {
            continue;
        }
        // What came to stand in another network is a part of that.
        if network
            .ancestors()
            .skip(1)
            .any(|around| has(around, "NetworkItems"))
        {
            continue;
        }
        let place = lines.place(text, network.range().start);
        let end = lines.place(text, network.range().end);
        let mut own = converted
            .report
            .entries
            .iter()
            .filter(|entry| (place..=end).contains(&entry.place));
        let is_there = network
            .descendants()
            .any(|node| node.attribute("t") == Some("BoxTreeAssign"));
        assert!(
            !is_there || own.next().is_some(),
            "{place} is not told: {written}\nof\n{text}"
        );
    }
    for entry in &converted.report.entries {
        let acts = ["coil ", "jump ", "return"]
            .iter()
            .any(|word| entry.element.starts_with(word));
        let is_drawn = || {
            converted
                .written
                .places
                .iter()
                .any(|(_, origin)| converted.places[*origin as usize] == entry.place)
        };
        assert!(
            !acts || entry.outcome != Outcome::Translated || is_drawn(),
            "{} {} stands nowhere:\n{written}\nof\n{text}",
            entry.place,
            entry.element
        );
    }
}

#[test]
fn the_unit_itself_holds() {
    holds(SOUND);
    let converted = convert(
        &TwinCat,
        &Source::alone("test", SOUND.as_bytes()),
        &Options::default(),
    );
    let converted = converted.expect("it is read");
    assert_eq!(converted.report.remarks().count(), 0, "{:?}", converted.report);
}

proptest! {
    #[test]
    fn broken_units_are_read_or_refused(mutations in prop::collection::vec(mutation(), 1..6)) {
        let mut text = SOUND.to_owned();
        for mutation in &mutations {
            mutation.of(&mut text);
        }
        holds(&text);
    }
}

//! Programs of OpenPLC Editor 4 with something broken in them: each is read, or refused with a reason; nothing is left out in
//! silence.

use ladder_format::{Options, format_text};
use ladder_notation::{Outcome, Source, convert};
use ladder_notation_openplc::OpenPlc;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use serde_json::Value;

/// A program with branches, a timer and values, as the editor saves it.
const SOUND: &str = include_str!("../../../fuzz/seeds/notations/openplc");

/// What can happen to a file.
#[derive(Debug, Clone)]
enum Mutation {
    /// A stretch of the text is gone.
    Delete(Index, usize),
    /// A word is put in.
    Insert(Index, &'static str),
    /// Of all values in the JSON one is another.
    Replace(Index, &'static str),
    /// A value ends where another of its kind does: wires, names, kinds.
    Swap(Index, Index),
    /// An element or wire is there twice.
    Twice(Index),
    /// An element or wire is gone.
    Without(Index),
}

const WORDS: &[&str] = &[
    "null",
    "\"\"",
    "-1",
    "1e300",
    "true",
    "[]",
    "{}",
    "\"left-rail\"",
    "\"output\"",
    "\"input-top\"",
    "\"parallel\"",
    "\"TON\"",
    "\"a b\"",
    "\"x := 1\"",
    "\"# ladder: fmt off #\"",
    "\"$\"",
    "99999999999999999999",
];

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<Index>;
    prop_oneof![
        1 => (at(), 1..30usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        1 => (at(), select(WORDS)).prop_map(|(at, word)| Mutation::Insert(at, word)),
        6 => (at(), select(WORDS)).prop_map(|(at, word)| Mutation::Replace(at, word)),
        6 => (at(), at()).prop_map(|(one, other)| Mutation::Swap(one, other)),
        3 => at().prop_map(Mutation::Twice),
        3 => at().prop_map(Mutation::Without),
    ]
}

/// Where the values of a JSON are, each as the way to it.
fn ways(value: &Value, way: &str, out: &mut Vec<String>, is_wanted: &dyn Fn(&Value) -> bool) {
    if is_wanted(value) {
        out.push(way.to_owned());
    }
    match value {
        Value::Array(values) => {
            for (number, value) in values.iter().enumerate() {
                ways(value, &format!("{way}/{number}"), out, is_wanted);
            }
        }
        Value::Object(values) => {
            for (name, value) in values {
                ways(
                    value,
                    &format!("{way}/{}", name.replace('~', "~0").replace('/', "~1")),
                    out,
                    is_wanted,
                );
            }
        }
        _ => {}
    }
}

/// The part of the text that is JSON.
fn json_of(text: &str) -> Option<(std::ops::Range<usize>, Value)> {
    let range = text.find('{')?..text.rfind('}')? + 1;
    let value = serde_json::from_str(text.get(range.clone())?).ok()?;
    Some((range, value))
}

impl Mutation {
    fn of(&self, text: &mut String) {
        let whole = |text: &str, mut at: usize| {
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        if let (Mutation::Delete(at, _) | Mutation::Insert(at, _), false) = (self, text.is_empty()) {
            let at = whole(text, at.index(text.len()));
            match self {
                Mutation::Delete(_, length) => {
                    let end = whole(text, (at + length).min(text.len()));
                    text.replace_range(at..end, "");
                }
                Mutation::Insert(_, word) => text.insert_str(at, word),
                _ => {}
            }
            return;
        }
        let Some((range, mut json)) = json_of(text) else {
            return;
        };
        let found = |json: &Value, is_wanted: &dyn Fn(&Value) -> bool| {
            let mut all = Vec::new();
            ways(json, "", &mut all, is_wanted);
            all
        };
        let is_leaf = |value: &Value| !value.is_array() && !value.is_object();
        match self {
            Mutation::Replace(at, word) => {
                let all = found(&json, &is_leaf);
                if let Some(value) = all
                    .get(at.index(all.len().max(1)))
                    .and_then(|way| json.pointer_mut(way))
                {
                    *value = serde_json::from_str(word).unwrap_or(Value::Null);
                }
            }
            Mutation::Swap(one, other) => {
                let all = found(&json, &Value::is_string);
                if all.is_empty() {
                    return;
                }
                let new = json
                    .pointer(&all[one.index(all.len())])
                    .cloned()
                    .unwrap_or(Value::Null);
                if let Some(value) = json.pointer_mut(&all[other.index(all.len())]) {
                    *value = new;
                }
            }
            Mutation::Twice(at) | Mutation::Without(at) => {
                let all = found(&json, &|value| {
                    value.as_array().is_some_and(|values| !values.is_empty())
                });
                if all.is_empty() {
                    return;
                }
                if let Some(Value::Array(values)) = json.pointer_mut(&all[at.index(all.len())]) {
                    let number = at.index(values.len());
                    if matches!(self, Mutation::Twice(_)) {
                        values.push(values[number].clone());
                    } else {
                        values.remove(number);
                    }
                }
            }
            _ => {}
        }
        text.replace_range(range, &json.to_string());
    }
}

fn holds(text: &str) {
    let options = Options::default();
    let converted = match convert(&OpenPlc, &Source::alone("test", text.as_bytes()), &options) {
        Ok(converted) => converted,
        Err(error) => return assert!(error.message.len() > 10, "{error}"),
    };
    let written = &converted.written.text;
    let errors = ladder_syntax::parse(written).errors();
    assert!(errors.is_empty(), "{errors:?}\n{written}\nof\n{text}");
    assert_eq!(format_text(written, &options), *written);
    // Every contact and coil of the file is told.
    let Some((_, json)) = json_of(text) else { return };
    let mut elements = 0;
    let nodes = json["rungs"].as_array().into_iter().flatten();
    for node in nodes.flat_map(|rung| rung["nodes"].as_array().into_iter().flatten()) {
        elements += usize::from(matches!(node["type"].as_str(), Some("contact" | "coil")));
    }
    let told = converted.report.entries.iter();
    let told = told.filter(|entry| {
        let is_one = entry.element.starts_with("contact") || entry.element.starts_with("coil");
        is_one || matches!(entry.outcome, Outcome::Refused(_))
    });
    let told = told.count();
    let is_whole = converted
        .report
        .entries
        .iter()
        .all(|entry| entry.element != "drawing");
    assert!(
        !is_whole || told >= elements,
        "{told} of {elements}:\n{written}\nof\n{text}"
    );
}

#[test]
fn the_program_itself_holds() {
    let (_, json) = json_of(SOUND).expect("it has JSON in it");
    assert!(
        json["rungs"][0]["nodes"]
            .as_array()
            .is_some_and(|nodes| nodes.len() > 3)
    );
    holds(SOUND);
}

proptest! {
    #[test]
    fn broken_programs_are_read_or_refused(mutations in prop::collection::vec(mutation(), 1..6)) {
        let mut text = SOUND.to_owned();
        for mutation in &mutations {
            mutation.of(&mut text);
        }
        holds(&text);
    }
}

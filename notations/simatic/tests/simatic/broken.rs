//! Documents with something broken in them: read, or refused with a place, and each part of a network is accounted for.

use ladder_format::Options;
use ladder_notation::{Entry, Notation, Outcome, Source, convert};
use ladder_notation_simatic::{Simatic, SimaticMl};
use proptest::prelude::*;
use proptest::sample::Index;

const DOCUMENT: &str = include_str!("../../../../fuzz/seeds/notations/simatic");
const EXPORT: &str = include_str!("../../../../fuzz/seeds/notations/simatic_xml");

#[derive(Debug, Clone)]
enum Mutation {
    Delete(Index, usize),
    Repeat(Index, usize),
    Insert(Index, &'static str),
    SwapLines(Index, Index),
    Truncate(Index),
}

impl Mutation {
    fn of(&self, text: &str) -> String {
        let signs: Vec<char> = text.chars().collect();
        if signs.is_empty() {
            return String::new();
        }
        let at = |index: &Index| index.index(signs.len());
        let whole = |parts: &[&[char]]| parts.concat().into_iter().collect::<String>();
        match self {
            Mutation::Delete(index, length) => {
                let (from, to) = (at(index), (at(index) + length).min(signs.len()));
                whole(&[&signs[..from], &signs[to..]])
            }
            Mutation::Repeat(index, length) => {
                let (from, to) = (at(index), (at(index) + length).min(signs.len()));
                whole(&[&signs[..to], &signs[from..]])
            }
            Mutation::Insert(index, word) => {
                let word: Vec<char> = word.chars().collect();
                whole(&[&signs[..at(index)], &word, &signs[at(index)..]])
            }
            Mutation::SwapLines(one, other) => {
                let mut lines: Vec<&str> = text.lines().collect();
                let (one, other) = (one.index(lines.len()), other.index(lines.len()));
                lines.swap(one, other);
                lines.join("\n")
            }
            Mutation::Truncate(index) => whole(&[&signs[..at(index)]]),
        }
    }
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = any::<Index>;
    let words = prop::sample::select(vec![
        " ",
        "\n",
        "#",
        "\"",
        "'",
        "$",
        "(",
        ")",
        "{",
        "}",
        "[",
        "]",
        ":=",
        "=>",
        ",",
        ";",
        "%",
        ".",
        "wire#w1",
        "wire#powerrail",
        "END_RUNG",
        "RUNG",
        "Not()",
        "//",
        "(*",
        "Contact( #fill )",
        "\u{feff}",
        "\0",
        "<",
        ">",
        "&amp;",
        "NETWORK",
        "END_NETWORK",
        "T#5s",
        "-1",
        "99999999999999999999",
    ]);
    prop_oneof![
        (at(), 1..60usize).prop_map(|(at, length)| Mutation::Delete(at, length)),
        (at(), 1..200usize).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        (at(), words).prop_map(|(at, word)| Mutation::Insert(at, word)),
        (at(), at()).prop_map(|(one, other)| Mutation::SwapLines(one, other)),
        at().prop_map(Mutation::Truncate),
    ]
}

/// The places of the networks in LAD, each by its first and last line, and how many operand lists stand in each: what a
/// person counts.
fn counted(text: &str) -> Vec<(u32, u32, usize)> {
    let mut plain = String::new();
    let mut quote = None;
    let mut rest = text.chars().peekable();
    let mut escaped = false;
    while let Some(c) = rest.next() {
        let shown = match quote {
            Some(own) => {
                if (c == own && !escaped) || c == '\n' {
                    quote = None;
                }
                escaped = c == '$' && own == '\'' && !escaped;
                if c == '\n' { '\n' } else { '_' }
            }
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                '_'
            }
            None if c == '/' && rest.peek() == Some(&'/') => {
                while rest.peek().is_some_and(|c| *c != '\n') {
                    rest.next();
                }
                ' '
            }
            None => c,
        };
        plain.push(shown);
    }
    let mut found = Vec::new();
    // A network in another language is open, too: what is in it opens none.
    let mut open: Option<(u32, usize, i32, bool)> = None;
    let mut language_is_ladder = true;
    for (number, (line, original)) in plain.lines().zip(text.lines()).enumerate() {
        let number = number as u32 + 1;
        if open.is_none() && original.contains("S7_Language") {
            language_is_ladder = original.contains("LAD");
        }
        let trimmed = line.trim();
        let mut words = trimmed.split(|c: char| !c.is_alphanumeric() && c != '_');
        if open.is_none() && words.clone().any(|word| word == "NETWORK") {
            open = Some((number, 0, 0, language_is_ladder));
            continue;
        }
        if words.any(|word| word == "END_NETWORK") {
            if let Some((first, count, _, true)) = open.take() {
                found.push((first, number, count));
            }
            continue;
        }
        if let Some((_, count, depth, _)) = &mut open {
            for c in line.chars() {
                match c {
                    '(' => {
                        *count += usize::from(*depth == 0);
                        *depth += 1;
                    }
                    ')' => *depth -= 1,
                    _ => {}
                }
            }
        }
    }
    found
}

/// What must hold of any text.
fn holds(notation: &dyn Notation, text: &str) {
    let source = Source::alone("block", text.as_bytes());
    let converted = match convert(notation, &source, &Options::default()) {
        Ok(converted) => converted,
        Err(error) => {
            assert!(error.message.len() > 10, "{error}");
            return;
        }
    };
    let errors = ladder_syntax::parse(&converted.written.text).errors();
    assert!(errors.is_empty(), "{errors:?}\n{}", converted.written.text);
    if notation.name() != "simatic" || text.contains("(*") {
        return;
    }
    let mut entries = converted.report.entries.iter();
    let end = entries.find(|entry| entry.element == "what stands after the end");
    let end = end.map_or(u32::MAX, |entry| entry.place.line);
    for (first, last, count) in counted(text).into_iter().filter(|(first, ..)| *first < end) {
        let inside = converted
            .report
            .entries
            .iter()
            .filter(|entry| (first..=last).contains(&entry.place.line));
        let of = |name: &str| {
            inside
                .clone()
                .filter(|entry| entry.element.starts_with(name))
                .count()
        };
        // A network that cannot be read is there as a text, as is one of a block that is not read as a whole.
        let is_text = |entry: &Entry| match &entry.outcome {
            Outcome::Approximated(why) => {
                why.starts_with("the network cannot be read") || why.starts_with("a network in")
            }
            _ => false,
        };
        let is_whole = |entry: &Entry| entry.element.starts_with("body of");
        if converted.report.entries.iter().any(is_whole) {
            return;
        }
        // A line of a network that came to stand above the block begins none.
        if inside.clone().any(is_text) || of("FUNCTION_BLOCK") > 0 {
            continue;
        }
        let told = inside.clone().count() - of("network");
        assert_eq!(
            told,
            count,
            "lines {first} to {last}: {:#?}\n{text}",
            inside.collect::<Vec<_>>()
        );
    }
}

#[test]
fn the_documents_themselves_hold() {
    assert_eq!(
        counted(DOCUMENT)
            .iter()
            .map(|(.., count)| *count)
            .collect::<Vec<_>>(),
        [8, 7]
    );
    holds(&Simatic, DOCUMENT);
    holds(&SimaticMl, EXPORT);
}

proptest! {
    #[test]
    fn broken_documents(mutations in prop::collection::vec(mutation(), 1..4)) {
        let mut text = DOCUMENT.to_owned();
        for mutation in &mutations {
            text = mutation.of(&text);
        }
        holds(&Simatic, &text);
    }

    #[test]
    fn broken_exports(mutations in prop::collection::vec(mutation(), 1..3)) {
        let mut text = EXPORT.to_owned();
        for mutation in &mutations {
            text = mutation.of(&text);
        }
        holds(&SimaticMl, &text);
    }
}

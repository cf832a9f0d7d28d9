//! The words of the textbook grammar.

use ladder_instructions::Op;
use ladder_notation::{LineColumn, ReadError};

/// What a word is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WordKind {
    Start,
    End,
    Open,
    Close,
    /// `&`
    And,
    /// `V`
    Or,
    /// An element without its name.
    Element(Element),
    /// `I0.1`
    Name(Name),
}

/// The four elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Element {
    OpenContact,
    ClosedContact,
    ActiveCoil,
    InactiveCoil,
}

impl Element {
    pub(super) const ALL: [Element; 4] = [
        Element::OpenContact,
        Element::ClosedContact,
        Element::ActiveCoil,
        Element::InactiveCoil,
    ];

    /// The two words that it is written with.
    pub(super) const fn words(self) -> (&'static str, &'static str) {
        match self {
            Element::OpenContact => ("open", "contact"),
            Element::ClosedContact => ("closed", "contact"),
            Element::ActiveCoil => ("active", "coil"),
            Element::InactiveCoil => ("inactive", "coil"),
        }
    }

    pub(super) const fn is_coil(self) -> bool {
        matches!(self, Element::ActiveCoil | Element::InactiveCoil)
    }

    /// The instruction of ladder text.
    pub(super) const fn op(self) -> Op {
        match self {
            Element::OpenContact => Op::Contact,
            Element::ClosedContact => Op::NegatedContact,
            Element::ActiveCoil => Op::Coil,
            Element::InactiveCoil => Op::NegatedCoil,
        }
    }
}

/// A variable: its letter (`I`, `M` or `Q`), its number, and the value that it is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Name {
    pub(super) letter: char,
    pub(super) number: u32,
    pub(super) value: Option<bool>,
}

/// A word and where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Word {
    pub(super) kind: WordKind,
    pub(super) place: LineColumn,
}

/// The words of a text.
pub(super) fn words(text: &str) -> Result<Vec<Word>, ReadError> {
    let mut words: Vec<Word> = Vec::new();
    let mut rest = text;
    let mut at_line_start = true;
    let mut place = LineColumn::START;
    while let Some(c) = rest.chars().next() {
        let mut found = None;
        let length = match c {
            '\n' | '\r' => {
                at_line_start = true;
                1
            }
            '|' if words.last().is_some_and(|word| word.kind != WordKind::End) => {
                let message = "`|` is before `start` and after `end` only; `V` is between branches";
                return Err(ReadError::at(place, message));
            }
            '#' if at_line_start => rest.find('\n').unwrap_or(rest.len()),
            c if c.is_whitespace() || c == '|' || c == '\u{feff}' => c.len_utf8(),
            c => {
                at_line_start = false;
                let (kind, length) = match c {
                    '(' => (WordKind::Open, 1),
                    ')' => (WordKind::Close, 1),
                    '&' => (WordKind::And, 1),
                    _ => word(rest).map_err(|message| ReadError::at(place, message))?,
                };
                found = Some(Word { kind, place });
                length
            }
        };
        words.extend(found);
        // Counted on the way: a line may be as long as the file.
        for c in rest[..length].chars() {
            if c == '\n' {
                (place.line, place.column) = (place.line + 1, 0);
            }
            place.column += 1;
        }
        rest = &rest[length..];
    }
    Ok(words)
}

/// The word that a text begins with, and its length in bytes.
fn word(text: &str) -> Result<(WordKind, usize), String> {
    let length = text
        .find(|c: char| !c.is_ascii_alphanumeric() && c != '.')
        .unwrap_or(text.len());
    let first = &text[..length];
    let is = |word: &str| first.eq_ignore_ascii_case(word);
    match first {
        _ if is("start") => return Ok((WordKind::Start, length)),
        _ if is("end") => return Ok((WordKind::End, length)),
        _ if is("v") => return Ok((WordKind::Or, length)),
        _ => {}
    }
    for element in Element::ALL {
        let (one, two) = element.words();
        let kind = WordKind::Element(element);
        if is(&format!("{one}{two}")) {
            return Ok((kind, length));
        }
        if is(one) {
            let after = text[length..].trim_start();
            let second = after
                .get(..two.len())
                .filter(|word| word.eq_ignore_ascii_case(two));
            let Some(second) = second else {
                return Err(format!("`{one}` is followed by `{two}`"));
            };
            return Ok((kind, text.len() - after.len() + second.len()));
        }
    }
    if let Some(name) = name(first) {
        return Ok((WordKind::Name(name), length));
    }
    let shown = match first {
        "" => text.chars().next().unwrap_or_default().escape_debug().to_string(),
        first => first.chars().take(40).collect(),
    };
    Err(format!(
        "`{shown}` is not a word of the textbook grammar; its words are `start`, `end`, `(`, `)`, `&`, `V`, `open contact`, \
         `closed contact`, `active coil`, `inactive coil` and names such as `I0.1`, `M2` and `Q3`"
    ))
}

fn name(word: &str) -> Option<Name> {
    let letter = word.chars().next()?.to_ascii_uppercase();
    if !matches!(letter, 'I' | 'M' | 'Q') {
        return None;
    }
    let (number, value) = match word[1..].split_once('.') {
        Some((number, "0")) => (number, Some(false)),
        Some((number, "1")) => (number, Some(true)),
        Some(_) => return None,
        None => (&word[1..], None),
    };
    let number = number
        .parse()
        .ok()
        .filter(|_| number.bytes().all(|c| c.is_ascii_digit()))?;
    Some(Name {
        letter,
        number,
        value,
    })
}

//! The elements of networks that were read, as texts.

use ladder_format::Circuit;
use ladder_format::program::{Drawing, Element, Item, Network, RungPiece};
use ladder_syntax::Name;
use std::collections::HashMap;
use std::ops::Range;

/// What a network holds, if it is one rung without branches.
pub(crate) fn series(network: &Network) -> Option<Vec<&str>> {
    match &network.drawing {
        Drawing::Circuit(circuit) => {
            let mut found = Vec::new();
            in_series(circuit, &mut found).then_some(found)
        }
        Drawing::Rungs(rungs) => match &rungs[..] {
            [rung] => rung
                .iter()
                .filter(|piece| **piece != RungPiece::Rail)
                .map(|piece| match piece {
                    RungPiece::Element(element) => Some(element.text.as_str()),
                    _ => None,
                })
                .collect(),
            _ => None,
        },
    }
}

/// Whether a circuit has no branches: then its elements are found, a series in another one as part of that.
fn in_series<'c>(circuit: &'c Circuit<Element>, found: &mut Vec<&'c str>) -> bool {
    match circuit {
        Circuit::Element(element) => {
            found.push(&element.text);
            true
        }
        Circuit::Series(parts) => parts.iter().all(|part| in_series(part, found)),
        Circuit::Parallel(_) => false,
    }
}

/// Calls something with the text of each element, those in blocks among them.
pub(crate) fn elements(items: &[Item], found: &mut impl FnMut(&str)) {
    for item in items {
        match item {
            Item::Block { items, .. } => elements(items, found),
            Item::Network(Network {
                drawing: Drawing::Circuit(circuit),
                ..
            }) => {
                texts(circuit, found);
            }
            Item::Network(Network {
                drawing: Drawing::Rungs(rungs),
                ..
            }) => {
                for piece in rungs.iter().flatten() {
                    if let RungPiece::Element(element) = piece {
                        found(&element.text);
                    }
                }
            }
            _ => {}
        }
    }
}

fn texts(circuit: &Circuit<Element>, found: &mut impl FnMut(&str)) {
    match circuit {
        Circuit::Element(element) => found(&element.text),
        Circuit::Series(parts) | Circuit::Parallel(parts) => parts.iter().for_each(|part| texts(part, found)),
    }
}

/// Changes the text of each element.
pub(crate) fn change(items: &mut [Item], with: &impl Fn(&mut String)) {
    for item in items {
        match item {
            Item::Block { items, .. } => change(items, with),
            Item::Network(Network {
                drawing: Drawing::Circuit(circuit),
                ..
            }) => {
                let whole = std::mem::replace(circuit, Circuit::Series(Vec::new()));
                *circuit = whole.replaced(&|mut element: Element| {
                    with(&mut element.text);
                    Circuit::Element(element)
                });
            }
            Item::Network(Network {
                drawing: Drawing::Rungs(rungs),
                ..
            }) => {
                for piece in rungs.iter_mut().flatten() {
                    if let RungPiece::Element(element) = piece {
                        with(&mut element.text);
                    }
                }
            }
            _ => {}
        }
    }
}

/// The words of an element's operands that may be tags.
pub(crate) fn words(text: &str) -> impl Iterator<Item = &str> {
    tags(text).into_iter().map(|range| &text[range])
}

/// Where tags may stand in an element: words of its operands that are no members, names of operands or functions, nor parts of
/// literals.
fn tags(text: &str) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let is_label = ["<JMP>", "<LBL>", "<CALL>", "<FUN>"]
        .iter()
        .any(|head| text.starts_with(head));
    // What stands in the brackets of a block is no tag.
    let mut signs = text.char_indices().skip(1);
    let head = signs.find(|(_, c)| matches!(c, ')' | ']' | '>'));
    let Some((start, _)) = head.filter(|_| !is_label && !text.starts_with('#')) else {
        return found;
    };
    let mut chars = text.char_indices().skip_while(|(at, _)| *at <= start).peekable();
    let (mut before, mut is_text) = (' ', false);
    while let Some((at, c)) = chars.next() {
        if c == '\'' {
            is_text = !is_text;
        }
        if is_text || !(c.is_alphanumeric() || c == '_') {
            if !c.is_whitespace() {
                before = c;
            }
            continue;
        }
        let mut end = at + c.len_utf8();
        while let Some((at, c)) = chars.next_if(|(_, c)| c.is_alphanumeric() || *c == '_') {
            end = at + c.len_utf8();
        }
        let rest = text[end..].trim_start();
        let is_other = c.is_ascii_digit()
            || matches!(before, '.' | '#' | '%' | '$')
            || ["#", "(", ":=", "=>"].iter().any(|sign| rest.starts_with(sign));
        if !is_other {
            found.push(at..end);
        }
        before = 'a';
    }
    found
}

/// An element with other names for some tags.
pub(crate) fn with_names(text: &str, names: &HashMap<Name, String>) -> String {
    let mut out = text.to_owned();
    for range in tags(text).into_iter().rev() {
        if let Some(name) = names.get(&Name::new(&text[range.clone()])) {
            out.replace_range(range, name);
        }
    }
    out
}

/// A call of a block: `[$Rinse]( Rinse_state, go := go )`.
pub(crate) struct Call {
    pub(crate) block: Name,
    pub(crate) state: Option<String>,
    pub(crate) given: Vec<(String, String)>,
}

impl Call {
    pub(crate) fn of(text: &str) -> Option<Call> {
        let (block, rest) = text.strip_prefix("[$")?.split_once("](")?;
        let operands = rest.trim_end().strip_suffix(')')?;
        let mut operands = operands.split(',').map(str::trim);
        let state = operands
            .next()
            .filter(|state| !state.contains(":="))
            .map(str::to_owned);
        let given = operands.filter_map(|operand| operand.split_once(":="));
        let given = given.map(|(name, tag)| (name.trim().to_owned(), tag.trim().to_owned()));
        Some(Call {
            block: Name::new(&format!("${block}")),
            state,
            given: given.collect(),
        })
    }
}

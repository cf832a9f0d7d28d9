//! A contact drawn with bars, as in many books: `--| |--`, `--|/|--`. What it says is known, so the fix writes it in the
//! language: with the operand in parentheses after it, else with the names of the line above, else with a `?` for the
//! tag, which a person has to replace.

use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::excerpt::{columns, text};
use crate::rules::bad_arity::PLACEHOLDER;
use crate::rules::form::Form;
use crate::written::facts::BlockFacts;
use ladder_format::Edit;
use ladder_instructions::{Shape, known_elsewhere, lookup};
use ladder_syntax::wiring::{BarContact, PartKind};
use ladder_syntax::{LineKind, TextRange, TextSize, is_identifier};

/// This many columns a name may be away from the middle of what it is above, next to its own half.
const REACH: usize = 3;

/// What is on a rung without its tag.
struct Nameless {
    range: TextRange,
    /// As it is written in the language, without an operand.
    block: String,
}

/// One finding for each contact.
pub(super) fn findings(form: &Form<'_>, rung: usize, contacts: &[BarContact]) -> Vec<Diagnostic> {
    let named = with_names_above(form, rung, contacts);
    let found = |contact: &BarContact| {
        let network = form.network;
        let part = |part| network.part_range(form.parse, rung, part);
        let bars = part(contact.parts.start).cover(part(contact.parts.end - 1));
        let (kind, block) = kind(contact);
        let message = format!(
            "`{}` is no contact here: {kind} contact is written {block}( tag )",
            text(form.parse, bars)
        );
        let found = Diagnostic::new(super::RULE, bars, message)
            .help("`|` only draws the rails and verticals; the tag of a contact is in parentheses after it");
        if let Some(fix) = &named {
            return found.with(fix.clone());
        }
        let (range, tag) = match operand(form, rung, contact.parts.end) {
            Some(block) => (bars.cover(block.range + start(form, rung)), block.head.text()),
            None => (bars, PLACEHOLDER),
        };
        let written = format!("{block}( {tag} )");
        found.fix(Applicability::Unsafe, format!("Write {written}"), range, written)
    };
    contacts.iter().map(found).collect()
}

const fn kind(contact: &BarContact) -> (&'static str, &'static str) {
    if contact.is_closed {
        ("a closed", "[/]")
    } else {
        ("an open", "[ ]")
    }
}

fn start(form: &Form<'_>, rung: usize) -> TextSize {
    form.parse.line_start(form.network.line(rung))
}

/// The block of a part that has a first part only.
fn without_list<'f>(form: &Form<'f>, rung: usize, part: usize) -> Option<&'f BlockFacts> {
    let mut blocks = form.network.facts().blocks.iter().map(|block| &block.facts);
    blocks.find(|block| (block.rung, block.part) == (rung, part) && block.list_range.is_none())
}

/// The `( tag )` that touches a contact. The last block of a rung is rather its coil.
fn operand<'f>(form: &Form<'f>, rung: usize, part: usize) -> Option<&'f BlockFacts> {
    let parts = &form.network.wiring.rungs[rung].parts;
    let is_last = !parts[part + 1..].iter().any(|part| part.kind == PartKind::Block);
    without_list(form, rung, part).filter(|block| {
        let name = block.head.text();
        block.shape == Shape::Coil && is_identifier(name) && !is_sign(block) && !is_last
    })
}

/// Whether the first part of a block says what it is, and not its tag: `( )`, `(S)`, `(L)`.
fn is_sign(block: &BlockFacts) -> bool {
    let sign = block.head.text();
    lookup(block.shape, sign).next().is_some() || known_elsewhere(sign).is_some()
}

/// The rung with the names of the line above, if that holds nothing but a name above each contact and coil that has none.
fn with_names_above(form: &Form<'_>, rung: usize, contacts: &[BarContact]) -> Option<Fix> {
    let line = form.network.line(rung);
    let above = line.checked_sub(1)?;
    if !matches!(
        form.parse.lines()[above].kind,
        LineKind::Stray | LineKind::Rung | LineKind::Rail
    ) {
        return None;
    }
    let words = words(form, above)?;
    let nameless = nameless(form, rung, contacts)?;
    if words.is_empty() || words.len() != nameless.len() {
        return None;
    }
    let ends = nameless.iter().flat_map(|it| [it.range.start(), it.range.end()]);
    let places = columns(form.parse, line, ends.map(|at| at - start(form, rung)));
    let ends = words.iter().flat_map(|(range, _)| [range.start(), range.end()]);
    let above_start = form.parse.line_start(above);
    let names = columns(form.parse, above, ends.map(|at| at - above_start));
    let fits = places
        .chunks_exact(2)
        .zip(names.chunks_exact(2))
        .all(|(place, name)| {
            let distance = place[0].midpoint(place[1]).abs_diff(name[0].midpoint(name[1]));
            distance <= REACH + (name[1] - name[0]) / 2
        });
    if !fits {
        return None;
    }
    let blank = |(range, word): &(TextRange, String)| Edit {
        range: *range,
        text: " ".repeat(word.chars().count()),
    };
    let written = |(it, (_, word)): (&Nameless, &(TextRange, String))| Edit {
        range: it.range,
        text: format!("{}( {word} )", it.block),
    };
    let edits = words
        .iter()
        .map(blank)
        .chain(nameless.iter().zip(&words).map(written));
    let title = "Write it with the names of the line above";
    Some(Fix::new(Applicability::Unsafe, title, edits.collect()))
}

/// The words of a line that holds nothing else but bars. None: something else is there.
fn words(form: &Form<'_>, line: usize) -> Option<Vec<(TextRange, String)>> {
    let mut words = Vec::new();
    let whole = form.parse.lines()[line].text().to_owned();
    let mut at = form.parse.line_start(line);
    for piece in whole.split_inclusive([' ', '\t', '|', '\r', '\n']) {
        let word = piece.trim_end_matches([' ', '\t', '|', '\r', '\n']);
        let is_address = word
            .strip_prefix('%')
            .is_some_and(|rest| rest.chars().all(|c| c.is_ascii_alphanumeric() || c == '.'));
        if !word.is_empty() && !is_identifier(word) && !is_address {
            return None;
        }
        if !word.is_empty() {
            words.push((TextRange::at(at, TextSize::of(word)), word.to_owned()));
        }
        at += TextSize::of(piece);
    }
    Some(words)
}

/// What is on a rung without its tag, from left to right. None: some of it has its tag after it, or is not a contact or coil.
fn nameless(form: &Form<'_>, rung: usize, contacts: &[BarContact]) -> Option<Vec<Nameless>> {
    let network = form.network;
    let parts = &network.wiring.rungs[rung].parts;
    let range = |part| network.part_range(form.parse, rung, part);
    let mut nameless = Vec::new();
    for (index, part) in parts.iter().enumerate() {
        if let Some(contact) = contacts.iter().find(|contact| contact.parts.start == index) {
            nameless.push(Nameless {
                range: range(index).cover(range(contact.parts.end - 1)),
                block: kind(contact).1.to_owned(),
            });
        } else if part.kind == PartKind::Block {
            let facts = without_list(form, rung, index);
            let block = text(form.parse, range(index));
            if facts.is_some_and(is_sign) {
                nameless.push(Nameless {
                    range: range(index),
                    block,
                });
            } else if facts.is_some() {
                return None;
            }
        }
    }
    Some(nameless)
}

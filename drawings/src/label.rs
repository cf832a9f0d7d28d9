//! What is written above and below contacts, coils and boxes.

use crate::block;
use crate::element;
use crate::frame::Frame;
use crate::marks::Marks;
use crate::symbol::{Symbol, SymbolKind};
use crate::text::{self, Phrase};

/// The name of a contact is no more lines above it.
const HIGHEST: usize = 10;

/// What is written above and below each symbol. It is no longer among the phrases then.
pub(crate) type Label = (Option<Phrase>, Option<Phrase>);

pub(crate) fn labels(
    symbols: &[Symbol],
    frames: &[Frame],
    phrases: &mut [Vec<Phrase>],
    marks: &Marks,
) -> Vec<Label> {
    let mut found: Vec<Label> = vec![(None, None); symbols.len()];
    // Those whose name is above a line, in the order of their columns.
    let mut over: Vec<Vec<usize>> = vec![Vec::new(); phrases.len() + 1];
    for (number, symbol) in symbols.iter().enumerate() {
        let top = match &symbol.kind {
            SymbolKind::Frame(frame) if wants_name(&frames[*frame]) => frames[*frame].top,
            SymbolKind::Contact(inside) if element::contact_wants_name(inside) => symbol.line,
            SymbolKind::Coil(inside) if element::coil_wants_name(inside) => symbol.line,
            _ => continue,
        };
        over[top].push(number);
    }
    for (line, mut named) in over.into_iter().enumerate() {
        named.sort_by_key(|&number| symbols[number].from);
        // The lines of a box may be between a contact and its name.
        for above in (0..line).rev().take(HIGHEST) {
            let spans: Vec<(usize, usize)> = named.iter().map(|&number| span(&symbols[number])).collect();
            let about = text::about(&spans, &phrases[above]);
            let taken = about.iter().flatten().cloned().collect();
            take(&mut phrases[above], taken);
            for (&number, phrase) in named.iter().zip(about) {
                found[number].0 = phrase;
            }
            named.retain(|&number| found[number].0.is_none());
            if named.is_empty() || !marks.has_frame(above) || marks.has_symbol(above) {
                break;
            }
        }
    }
    // What is above another symbol is not below this one.
    for (number, symbol) in symbols.iter().enumerate() {
        let SymbolKind::Contact(inside) = &symbol.kind else {
            continue;
        };
        if !element::wants_below(inside, found[number].0.is_some()) || symbol.line + 1 >= phrases.len() {
            continue;
        }
        let about = text::about(&[(symbol.from, symbol.to)], &phrases[symbol.line + 1]);
        if let [Some(phrase)] = &about[..] {
            take(&mut phrases[symbol.line + 1], vec![phrase.clone()]);
            found[number].1 = Some(phrase.clone());
        }
    }
    found
}

/// Whether what is above a box is its instance, or which block it is.
fn wants_name(frame: &Frame) -> bool {
    let boxed = block::boxed(&frame.edge, &frame.inside);
    boxed.map_or(true, |boxed| boxed.row.state().is_some())
}

/// The columns over which a name may begin or end. That of a box is over the box itself.
fn span(symbol: &Symbol) -> (usize, usize) {
    match symbol.kind {
        SymbolKind::Frame(_) => (symbol.from + text::NEAR, symbol.to - text::NEAR),
        _ => (symbol.from, symbol.to),
    }
}

/// Takes phrases out of those of a line; of one that was taken apart the rest stays.
fn take(phrases: &mut Vec<Phrase>, taken: Vec<Phrase>) {
    for taken in taken {
        let Some(at) = phrases
            .iter()
            .position(|phrase| phrase.from <= taken.from && taken.to <= phrase.to)
        else {
            continue;
        };
        let whole = phrases.remove(at);
        let rest = |from: usize, to: usize| {
            let text: String = whole
                .text
                .chars()
                .skip(from - whole.from)
                .take(to - from)
                .collect();
            let blanks = text.len() - text.trim_start().len();
            Phrase {
                line: whole.line,
                from: from + blanks,
                to,
                text: text.trim().to_owned(),
            }
        };
        let rests = [rest(whole.from, taken.from), rest(taken.to, whole.to)];
        phrases.splice(at..at, rests.into_iter().filter(|rest| !rest.text.is_empty()));
    }
}

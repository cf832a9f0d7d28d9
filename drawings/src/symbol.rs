//! Contacts and coils on the lines of a sheet.

use crate::marks::{Mark, Marks};
use crate::sheet::{Sheet, arms, closes_contact, is_bar, is_wire, opens_contact};
use ladder_instructions::{Shape, lookup};
use std::collections::HashSet;

/// What is between the bars of a contact is no longer.
const LONGEST: usize = 40;
/// What is between two bars with nothing in it is no wider.
const WIDEST_GAP: usize = 3;
/// So many contacts below each other, without a line between, are seen through.
const STACKED: usize = 64;

/// Something on a rung.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Symbol {
    pub(crate) line: usize,
    /// Its first column, and the one after its last.
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) kind: SymbolKind,
}

/// What it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum SymbolKind {
    /// With what is between its bars.
    Contact(String),
    /// With what is between its parentheses.
    Coil(String),
    /// A block as this language has it, with its operands.
    Own,
    /// A change of the program flow, as it is between `<` and `>`: `CALL mix`. A jump too, `>>there`.
    Flow(String),
    /// A box, by its number.
    Frame(usize),
}

/// All contacts and coils, which are marked.
pub(crate) fn find(sheet: &Sheet, marks: &mut Marks) -> Vec<Symbol> {
    let candidates = contacts_of_bars(sheet, marks);
    let mut symbols = Vec::new();
    for line in 0..sheet.len() {
        let mut at = 0;
        while at < sheet.width(line) {
            let found = (marks.at(line, at) == Mark::None)
                .then(|| {
                    bracketed(sheet, line, at).or_else(|| between_bars(sheet, marks, line, at, &candidates))
                })
                .flatten();
            match found {
                Some(symbol) => {
                    marks.set(line, at..symbol.to, Mark::Symbol(symbols.len()));
                    at = symbol.to;
                    symbols.push(symbol);
                }
                None => at += 1,
            }
        }
    }
    symbols
}

/// Whether wire can come to an element from a column.
fn leads_on(c: char) -> bool {
    is_wire(c) || arms(c).is_some() || "()[]".contains(c)
}

/// Where the bracket that opens at a place is closed, with brackets of its kind inside it.
fn closing(sheet: &Sheet, line: usize, at: usize, close: char) -> Option<usize> {
    let open = sheet.at(line, at);
    let mut depth = 0;
    for column in at..sheet.width(line).min(at + 2 * LONGEST) {
        let c = sheet.at(line, column);
        if c == open {
            depth += 1;
        } else if c == close {
            depth -= 1;
            if depth == 0 {
                return Some(column);
            }
        }
    }
    None
}

/// `[ ]`, `] [`, `( )`, and what this language itself has.
fn bracketed(sheet: &Sheet, line: usize, at: usize) -> Option<Symbol> {
    let end = match sheet.at(line, at) {
        '[' => closing(sheet, line, at, ']')?,
        '(' => closing(sheet, line, at, ')')?,
        '<' => closing(sheet, line, at, '>')?,
        '>' if sheet.at(line, at + 1) == '>' => return jump(sheet, line, at),
        ']' => (at + 1..at + LONGEST).find(|&column| sheet.at(line, column) == '[')?,
        _ => return None,
    };
    let inside = sheet.text(line, at + 1, end);
    let comes = at
        .checked_sub(1)
        .is_some_and(|before| leads_on(sheet.at(line, before)));
    let symbol = |to, kind| Symbol {
        line,
        from: at,
        to,
        kind,
    };
    let list = || {
        let open = (end + 1..sheet.width(line)).find(|&column| sheet.at(line, column) != ' ')?;
        let close = (sheet.at(line, open) == '(').then(|| closing(sheet, line, open, ')'))??;
        let says = !sheet.text(line, open + 1, close).trim().is_empty();
        says.then_some(close + 1)
    };
    // With parentheses directly after it, it is a block of this language, if perhaps none that is known.
    let is_row = |shape| {
        let word = inside.trim();
        let touches = sheet.at(line, end + 1) == '(';
        touches || word.is_empty() || word.starts_with('$') || lookup(shape, word).next().is_some()
    };
    let to = end + 1;
    let goes = leads_on(sheet.at(line, to));
    match sheet.at(line, at) {
        '<' => {
            let list = list().filter(|_| is_row(Shape::Function));
            let own = list.map(|to| symbol(to, SymbolKind::Own));
            own.or_else(|| (comes || goes).then(|| symbol(to, SymbolKind::Flow(inside))))
        }
        ']' => {
            let plain = !inside.contains(is_wire) && inside.chars().all(|c| arms(c).is_none());
            (comes && goes && plain).then(|| symbol(to, SymbolKind::Contact(inside)))
        }
        _ if !comes && !goes => None,
        '[' => Some(match list().filter(|_| is_row(Shape::Logical)) {
            Some(end) => symbol(end, SymbolKind::Own),
            None => symbol(to, SymbolKind::Contact(inside)),
        }),
        _ => Some(match list().filter(|_| is_row(Shape::Coil)) {
            Some(end) => symbol(end, SymbolKind::Own),
            None => symbol(to, SymbolKind::Coil(inside)),
        }),
    }
}

/// `>>there`, `>> there`
fn jump(sheet: &Sheet, line: usize, at: usize) -> Option<Symbol> {
    let comes = at
        .checked_sub(1)
        .is_some_and(|before| leads_on(sheet.at(line, before)));
    let from = at + 2 + usize::from(sheet.at(line, at + 2) == ' ');
    let is_name =
        |column: &usize| sheet.at(line, *column).is_alphanumeric() || sheet.at(line, *column) == '_';
    let to = from + (from..sheet.width(line)).take_while(is_name).count();
    let label = sheet.text(line, from, to);
    (comes && !label.is_empty()).then(|| Symbol {
        line,
        from: at,
        to,
        kind: SymbolKind::Flow(format!("JMP {label}")),
    })
}

/// Where the contact ends that the bar at a place may open, by its own line alone.
fn bars(sheet: &Sheet, marks: &Marks, line: usize, at: usize) -> Option<usize> {
    let comes = at.checked_sub(1).map(|before| sheet.at(line, before))?;
    if !opens_contact(sheet.at(line, at)) || !leads_on(comes) {
        return None;
    }
    let rest = at + 1..sheet.width(line).min(at + LONGEST);
    let end = rest
        .take_while(|&column| marks.at(line, column) == Mark::None)
        .find(|&column| arms(sheet.at(line, column)).is_some())?;
    let inside = sheet.text(line, at + 1, end);
    let says = inside.trim();
    let fits = match says {
        "" => (1..=WIDEST_GAP).contains(&inside.len()),
        _ => !says.contains("  ") && !says.contains("--") && !says.contains(['(', '[', ')', ']', '─', '━']),
    };
    let goes = leads_on(sheet.at(line, end + 1));
    (fits && goes && closes_contact(sheet.at(line, end))).then_some(end)
}

/// The bars of all that may be a contact, by lines and columns.
fn contacts_of_bars(sheet: &Sheet, marks: &Marks) -> HashSet<(usize, usize)> {
    let mut candidates = HashSet::new();
    for line in 0..sheet.len() {
        let mut at = 0;
        while at < sheet.width(line) {
            match bars(sheet, marks, line, at) {
                Some(end) => {
                    candidates.extend([(line, at), (line, end)]);
                    at = end + 1;
                }
                None => at += 1,
            }
        }
    }
    candidates
}

/// `| |`, `┤ ├`. Two lines that pass next to each other look alike, but go on above or below.
fn between_bars(
    sheet: &Sheet,
    marks: &Marks,
    line: usize,
    at: usize,
    candidates: &HashSet<(usize, usize)>,
) -> Option<Symbol> {
    if !candidates.contains(&(line, at)) {
        return None;
    }
    let end = bars(sheet, marks, line, at)?;
    let inside = sheet.text(line, at + 1, end);
    let goes_on = |column: usize| {
        let above = (1..=line.min(STACKED)).map(|lines| line - lines);
        let above = above.map(|line| (line, sheet.at(line, column)));
        let below = (line + 1..=line + STACKED).map(|line| (line, sheet.at(line, column)));
        let mut above = above.skip_while(|(line, _)| candidates.contains(&(*line, column)));
        let mut below = below.skip_while(|(line, _)| candidates.contains(&(*line, column)));
        above
            .next()
            .and_then(|(_, c)| arms(c))
            .is_some_and(|arms| arms.down)
            || below
                .next()
                .and_then(|(_, c)| arms(c))
                .is_some_and(|arms| arms.up)
    };
    if inside.trim().is_empty()
        && is_bar(sheet.at(line, at)) == is_bar(sheet.at(line, end))
        && (goes_on(at) || goes_on(end))
    {
        return None;
    }
    Some(Symbol {
        line,
        from: at,
        to: end + 1,
        kind: SymbolKind::Contact(inside),
    })
}

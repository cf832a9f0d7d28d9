//! What is written on the lines of a sheet next to what is drawn: names, numbers of rungs, comments.

use crate::marks::{Mark, Marks};
use crate::sheet::{Sheet, arms, is_wire};

/// Words with single blanks between them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Phrase {
    pub(crate) line: usize,
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) text: String,
}

/// Whether a column has text. A dash between two letters is text too.
pub(crate) fn is_text(sheet: &Sheet, marks: &Marks, line: usize, column: usize) -> bool {
    let c = sheet.at(line, column);
    if marks.at(line, column) != Mark::None || c == ' ' {
        return false;
    }
    if is_wire(c) {
        return is_hyphen(sheet, line, column);
    }
    arms(c).is_none()
}

/// A dash between two letters or digits, or a sign.
pub(crate) fn is_hyphen(sheet: &Sheet, line: usize, column: usize) -> bool {
    let is_letter =
        |column: Option<usize>| column.is_some_and(|column| sheet.at(line, column).is_alphanumeric());
    let is_between = is_letter(column.checked_sub(1)) && is_letter(Some(column + 1));
    sheet.at(line, column) == '-' && is_between || is_sign(sheet, line, column)
}

/// The minus of a number or an index: `-7`, `T#-5s`, `a[-k]`. A dash after something that is drawn is wire.
pub(crate) fn is_sign(sheet: &Sheet, line: usize, column: usize) -> bool {
    let before = column.checked_sub(1).map_or(' ', |before| sheet.at(line, before));
    let after = sheet.at(line, column + 1);
    sheet.at(line, column) == '-'
        && match before {
            ' ' | '#' => after.is_ascii_digit(),
            '[' | ',' => after.is_alphanumeric(),
            _ => false,
        }
}

/// All phrases of a line.
pub(crate) fn phrases(sheet: &Sheet, marks: &Marks, line: usize) -> Vec<Phrase> {
    let mut phrases: Vec<Phrase> = Vec::new();
    let mut column = 0;
    while column < sheet.width(line) {
        if !is_text(sheet, marks, line, column) {
            column += 1;
            continue;
        }
        let from = column;
        let goes_on = |column: usize| {
            is_text(sheet, marks, line, column)
                || (sheet.at(line, column) == ' '
                    && marks.at(line, column) == Mark::None
                    && is_text(sheet, marks, line, column + 1))
        };
        while column < sheet.width(line) && goes_on(column) {
            column += 1;
        }
        phrases.push(Phrase {
            line,
            from,
            to: column,
            text: sheet.text(line, from, column),
        });
    }
    phrases
}

/// The signs of comments in other languages, and in ladder text.
pub(crate) const COMMENTS: [&str; 6] = ["(*", "//", "/*", ";", "!!", "#"];

/// Whether a text says of itself that it is a comment.
fn is_comment(text: &str) -> bool {
    COMMENTS.iter().any(|sign| text.starts_with(sign))
}

/// A phrase may be this far left or right of what it is about.
pub(crate) const NEAR: usize = 2;

/// For each thing, given by its columns from left to right, the phrase that is about it. A phrase that reaches over several things is
/// taken apart at its blanks.
pub(crate) fn about(things: &[(usize, usize)], phrases: &[Phrase]) -> Vec<Option<Phrase>> {
    // A phrase over several things is a list of names only if it has one word for each.
    let pieces = |phrase: &Phrase| {
        let from = things.partition_point(|(_, to)| *to <= phrase.from);
        let until = things.partition_point(|(from, _)| *from < phrase.to);
        let words = words(phrase);
        let is_list = until > from + 1 && words.len() == until - from;
        if is_list { words } else { vec![phrase.clone()] }
    };
    let pieces: Vec<Phrase> = phrases
        .iter()
        .filter(|phrase| !is_comment(&phrase.text))
        .flat_map(pieces)
        .collect();
    let mut pairs = Vec::new();
    for (number, &(from, to)) in things.iter().enumerate() {
        let first = pieces.partition_point(|piece| piece.to + NEAR <= from);
        let near = pieces[first..].iter().take_while(|piece| piece.from < to + NEAR);
        for (piece, index) in near.zip(first..) {
            let away = (from + to).abs_diff(piece.from + piece.to);
            pairs.push((away, number, index));
        }
    }
    pairs.sort_unstable();
    let mut found = vec![None; things.len()];
    let mut taken = vec![false; pieces.len()];
    for (_, thing, piece) in pairs {
        if found[thing].is_none() && !taken[piece] {
            taken[piece] = true;
            found[thing] = Some(pieces[piece].clone());
        }
    }
    found
}

fn words(phrase: &Phrase) -> Vec<Phrase> {
    let mut at = phrase.from;
    let words = phrase.text.split(' ').map(|word| {
        let from = at;
        at += ladder_format::display_width(word) as usize + 1;
        Phrase {
            line: phrase.line,
            from,
            to: at - 1,
            text: word.to_owned(),
        }
    });
    words.filter(|word| word.from < word.to).collect()
}

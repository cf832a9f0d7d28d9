//! One line of a drawing in the draft.

use ladder_format::program::Literal;
use ladder_notation::{LineColumn, ReadError};

/// A longer line is not read.
const LONGEST_LINE: usize = 64 << 10;

/// One thing on a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Piece {
    /// `+`
    Rail,
    /// `\`
    Down,
    /// `/`
    Up,
    /// Blanks, or a `|`.
    Gap,
    /// `# .. #`
    Comment(String),
    Block(Block),
}

/// `[TON]<name><reset><time><preset>`
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Block {
    /// The bracket it begins with: `[`, `(` or `<`.
    pub(super) bracket: char,
    /// What is in it, without blanks and in capitals.
    pub(super) head: String,
    pub(super) operands: Vec<String>,
    pub(super) place: LineColumn,
    /// As it is written.
    pub(super) text: String,
}

/// Reads a line; its number is for the places.
pub(super) fn pieces(line: &str, number: u32) -> Result<Vec<Piece>, ReadError> {
    if line.len() > LONGEST_LINE {
        let message = format!("the line is longer than {LONGEST_LINE} bytes");
        return Err(ReadError::at(LineColumn::line(number), message));
    }
    let mut pieces = Vec::new();
    let mut rest = line;
    let mut column = 1;
    while let Some(c) = rest.chars().next() {
        let place = LineColumn { line: number, column };
        let length = match c {
            '-' => rest.len() - rest.trim_start_matches('-').len(),
            '+' | '\\' | '/' => {
                pieces.push(match c {
                    '+' => Piece::Rail,
                    '\\' => Piece::Down,
                    _ => Piece::Up,
                });
                1
            }
            '|' => {
                pieces.push(Piece::Gap);
                1
            }
            c if c.is_whitespace() => {
                pieces.push(Piece::Gap);
                c.len_utf8()
            }
            '#' => {
                let length = rest[1..].find('#').map(|at| at + 2);
                let length = length
                    .ok_or_else(|| ReadError::at(place, "this comment has no second `#` on its line"))?;
                pieces.push(Piece::Comment(rest[1..length - 1].trim().to_owned()));
                length
            }
            '[' | '(' | '<' => {
                let (block, length) = block(rest, place)?;
                pieces.push(Piece::Block(block));
                length
            }
            c => {
                return Err(ReadError::at(
                    place,
                    format!("`{}` is nothing that a rung is drawn with", c.escape_debug()),
                ));
            }
        };
        column += rest[..length].chars().count() as u32;
        rest = &rest[length..];
    }
    pieces.dedup_by(|later, before| *later == Piece::Gap && *before == Piece::Gap);
    Ok(pieces)
}

/// The block that a text begins with, and its length.
fn block(text: &str, place: LineColumn) -> Result<(Block, usize), ReadError> {
    let bracket = text.chars().next().unwrap_or('[');
    let (head, mut end) = bracketed(text, place)?;
    let mut operands = Vec::new();
    loop {
        let after = text[end..].trim_start_matches([' ', '\t']);
        // The standard has one list in parentheses, the draft one pair of brackets for each operand.
        let start = text.len() - after.len();
        match after.chars().next() {
            Some('<') => {
                let (operand, length) = bracketed(after, place)?;
                operands.push(operand.trim().to_owned());
                end = start + length;
            }
            Some('(') if operands.is_empty() => {
                let (list, length) = bracketed(after, place)?;
                operands.extend(list.split(',').map(|operand| operand.trim().to_owned()));
                end = start + length;
                break;
            }
            _ => break,
        }
    }
    operands.retain(|operand| !operand.is_empty());
    if let Some(wrong) = operands.iter().find(|operand| !is_operand(operand)) {
        let shown: String = wrong.chars().take(40).collect();
        let message =
            format!("`{shown}` is not an operand: that is a name, a number, or an element such as `a[3]`");
        return Err(ReadError::at(place, message));
    }
    let block = Block {
        bracket,
        head: head.split_whitespace().collect::<String>().to_ascii_uppercase(),
        operands,
        place,
        text: text[..end].to_owned(),
    };
    Ok((block, end))
}

/// Whether a text can be the operand of a block: it holds no signs that a rung is drawn with.
fn is_operand(text: &str) -> bool {
    if let Some(string) = text.strip_prefix('\'').and_then(|text| text.strip_suffix('\'')) {
        return !string.contains(|c: char| c.is_control() || matches!(c, '\'' | '$' | '#'));
    }
    let is_sign = |c: char| c.is_control() || "[](){}<>/\\|,;:=\"'#".contains(c);
    let (name, index) = match text.split_once('[') {
        Some((name, rest)) => (name, rest.strip_suffix(']')),
        None => (text, Some("0")),
    };
    let is_word = |index: &str| !index.is_empty() && index.chars().all(|c| c.is_alphanumeric() || c == '_');
    if !name.starts_with(|c: char| c.is_alphabetic() || c == '_') {
        return is_literal(text);
    }
    index.is_some_and(is_word) && !name.contains(is_sign)
}

/// Whether a text is a number as ladder text has them too; only the draft has `+5`.
fn is_literal(text: &str) -> bool {
    let number = match text.strip_prefix('+') {
        Some(number) if number.starts_with('-') => return false,
        number => number.unwrap_or(text),
    };
    number.starts_with(|c: char| c.is_ascii_digit() || c == '-') && Literal::read(number).is_ok()
}

/// What is between the bracket that a text begins with and its partner, and the length of it all.
fn bracketed(text: &str, place: LineColumn) -> Result<(&str, usize), ReadError> {
    let close = match text.chars().next() {
        Some('[') => ']',
        Some('(') => ')',
        _ => '>',
    };
    match text.find(close) {
        Some(at) => Ok((&text[1..at], at + 1)),
        None => Err(ReadError::at(
            place,
            format!("the `{close}` of this block is missing on its line"),
        )),
    }
}

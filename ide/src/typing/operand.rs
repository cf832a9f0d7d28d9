//! Which operand of a block a person types, and what is around it.

use super::{Token, Typing, is_word};
use ladder_instructions::Shape;
use ladder_syntax::SyntaxKind;
use std::ops::Range;

/// An operand that is being written.
#[derive(Debug, Default)]
pub(crate) struct Operand {
    pub(crate) shape: Option<Shape>,
    /// What the block's first part says.
    pub(crate) head: String,
    /// The tag in front of all others that keeps the state of a user-defined block.
    pub(crate) state: Option<Range<usize>>,
    /// The operands by place in front of this one.
    pub(crate) before: Vec<Range<usize>>,
    /// Where it begins.
    pub(crate) start: usize,
    /// Number of operands by place in the whole list.
    pub(crate) count: usize,
    /// The name in front of `:=` or `=>`.
    pub(crate) name: Option<String>,
    /// The names of the other named operands.
    pub(crate) given: Vec<String>,
    /// What is open inside the operand, outermost first.
    pub(crate) open: Vec<Open>,
    /// Whether a value ends right in front of the word: an operator fits here, no value.
    pub(crate) after_value: bool,
    /// The place in front of the `.` that is before the word.
    pub(crate) member_of: Option<Range<usize>>,
    /// Whether the operand begins with this word.
    pub(crate) first_word: bool,
    /// Whether something of the operand is after the word.
    pub(crate) goes_on: bool,
    /// Whether that is a value: none fits in front of it.
    pub(crate) before_value: bool,
    /// Whether the list has its closing parenthesis.
    pub(crate) closed: bool,
}

/// A bracket that is open inside of an operand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Open {
    /// `a[`
    Index,
    /// `(` of an expression.
    Group,
    /// `SQRT(`, with the number of commas after it.
    Call(String, usize),
}

/// Whether the parenthesis that opens a list is closed.
pub(super) fn parenthesis_closes(list: &[Token]) -> bool {
    let mut depth = 0;
    for token in list {
        match token.kind {
            SyntaxKind::L_PAREN => depth += 1,
            SyntaxKind::R_PAREN => depth -= 1,
            _ => continue,
        }
        if depth == 0 {
            return true;
        }
    }
    false
}

/// The operand around the cursor. `from`: where the list begins.
pub(super) fn operand(list: &[Token], from: usize, closed: bool, typing: &mut Typing<'_>) -> Operand {
    let (text, word) = (&typing.text, &typing.word);
    let mut operand = Operand {
        closed,
        first_word: true,
        ..Operand::default()
    };
    let mut start = from + 1;
    // Where the value begins that ends in front of the word.
    let mut value: Option<usize> = None;
    // The same of the paths whose indices are open.
    let mut indexed: Vec<Option<usize>> = Vec::new();
    let mut last: Option<Token> = None;
    for token in list.iter().skip(1).take_while(|token| token.end <= word.start) {
        if token.kind.is_trivia() {
            continue;
        }
        operand.first_word = false;
        match token.kind {
            SyntaxKind::L_PAREN => {
                operand.open.push(match (value, last) {
                    (Some(from), Some(last)) if last.kind == SyntaxKind::IDENT => {
                        Open::Call(text[from..last.end].to_owned(), 0)
                    }
                    _ => Open::Group,
                });
                value = None;
            }
            SyntaxKind::L_BRACKET => {
                operand.open.push(Open::Index);
                indexed.push(value.take());
            }
            SyntaxKind::R_BRACKET => {
                operand.open.pop();
                value = indexed.pop().flatten().or(Some(token.start));
            }
            SyntaxKind::R_PAREN => {
                operand.open.pop();
                value.get_or_insert(token.start);
            }
            SyntaxKind::COMMA => {
                value = None;
                match operand.open.last_mut() {
                    Some(Open::Call(_, commas)) => *commas += 1,
                    Some(_) => {}
                    None => {
                        match operand.name.take() {
                            Some(name) => operand.given.push(name),
                            None => operand.before.push(start..token.start),
                        }
                        start = token.end;
                        operand.first_word = true;
                    }
                }
            }
            SyntaxKind::ASSIGN | SyntaxKind::ARROW => {
                operand.name = Some(text[start..token.start].trim().to_owned());
                value = None;
            }
            SyntaxKind::IDENT | SyntaxKind::ADDRESS | SyntaxKind::LITERAL | SyntaxKind::STRING => {
                value.get_or_insert(token.start);
            }
            SyntaxKind::DOT => {}
            _ => value = None,
        }
        last = Some(*token);
    }
    operand.start = start;
    if let (Some(last), Some(from)) = (last.filter(|last| last.kind == SyntaxKind::DOT), value) {
        operand.member_of = Some(from..last.start);
    } else if last.is_some_and(|last| last.kind == SyntaxKind::DOT)
        || text[word.clone()].starts_with(|c: char| c.is_ascii_digit())
        || text[word.end..].starts_with('#')
    {
        // A number or a duration.
        typing.literal = true;
    } else {
        operand.after_value = value.is_some();
    }
    after(list, typing, &mut operand);
    operand
}

/// What is after the word: whether the operand goes on, and which operands follow.
fn after(list: &[Token], typing: &Typing<'_>, operand: &mut Operand) {
    let mut depth = operand.open.len();
    let mut this = true;
    let mut following = 0;
    let mut name = None;
    let mut written = false;
    for token in list.iter().filter(|token| token.start >= typing.word.end) {
        match token.kind {
            kind if kind.is_trivia() => continue,
            SyntaxKind::L_PAREN | SyntaxKind::L_BRACKET => depth += 1,
            SyntaxKind::R_PAREN if depth == 0 => break,
            SyntaxKind::R_PAREN | SyntaxKind::R_BRACKET => depth = depth.saturating_sub(1),
            SyntaxKind::COMMA if depth == 0 => {
                following += usize::from(!this && name.is_none() && written);
                operand.given.extend(name.take());
                (this, written) = (false, false);
                continue;
            }
            SyntaxKind::IDENT if !this && name.is_none() && !written => {
                name = None;
            }
            SyntaxKind::ASSIGN | SyntaxKind::ARROW if !this && depth == 0 => {
                let before = typing.text[..token.start].trim_end();
                let from = before.trim_end_matches(is_word).len();
                name = Some(before[from..].to_owned());
            }
            _ => {}
        }
        written = true;
        if this && !operand.goes_on {
            operand.goes_on = true;
            operand.before_value = matches!(
                token.kind,
                SyntaxKind::IDENT | SyntaxKind::ADDRESS | SyntaxKind::LITERAL | SyntaxKind::STRING
            );
        }
    }
    following += usize::from(!this && name.is_none() && written);
    operand.given.extend(name);
    operand.count = operand.before.len() + usize::from(operand.name.is_none()) + following;
}

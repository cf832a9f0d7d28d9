//! A block on a rung: its first part in brackets, then its operand list.
//!
//! Recovery stays in the block where it can: a bracket that is not closed ends where the drawing goes on, so
//! the rest of the rung keeps its meaning.

use super::{Parser, expression};
use crate::lexer::{self, Context};
use crate::{OperandPlace, SyntaxErrorKind, SyntaxKind};

/// The block that begins with the bracket `open`.
pub(super) fn block(p: &mut Parser<'_, '_, '_>, open: SyntaxKind) {
    let kind = match open {
        SyntaxKind::L_BRACKET => SyntaxKind::LOGICAL_BLOCK,
        SyntaxKind::L_PAREN => SyntaxKind::COIL_BLOCK,
        _ => SyntaxKind::FUNCTION_BLOCK,
    };
    p.start_node(kind);
    head(p, open);
    // White space is free between the first part and the operand list; without a list it belongs to the rung.
    let (_, behind_blanks) = match p.peek_token(Context::Rung) {
        (SyntaxKind::WHITESPACE, end) => (SyntaxKind::WHITESPACE, end),
        _ => (SyntaxKind::EOF, p.at),
    };
    if p.text.as_bytes().get(behind_blanks) == Some(&b'(') {
        if behind_blanks > p.at {
            p.bump(Context::Rung);
        }
        operand_list(p);
    }
    p.finish_node();
}

/// `[TON]`, `( )`, `<JMP>`, `[$Name]`. Also used for the head in a block definition's first line.
pub(super) fn head(p: &mut Parser<'_, '_, '_>, open: SyntaxKind) {
    let close = match open {
        SyntaxKind::L_BRACKET => SyntaxKind::R_BRACKET,
        SyntaxKind::L_PAREN => SyntaxKind::R_PAREN,
        _ => SyntaxKind::R_ANGLE,
    };
    let from = p.at;
    p.start_node(SyntaxKind::BLOCK_HEAD);
    p.bump(Context::Rung);
    let mut content_end = p.at;
    let mut mnemonic = false;
    loop {
        let found = p.peek(Context::Head);
        if found == close {
            p.bump(Context::Head);
            break;
        }
        match found {
            SyntaxKind::WHITESPACE if !ends_line_behind_blanks(p) => p.bump(Context::Head),
            SyntaxKind::COMMENT => p.bump(Context::Head),
            SyntaxKind::MNEMONIC | SyntaxKind::BLOCK_NAME if !mnemonic => {
                mnemonic = true;
                p.bump(Context::Head);
                content_end = p.at;
            }
            SyntaxKind::MNEMONIC | SyntaxKind::BLOCK_NAME | SyntaxKind::ERROR => {
                p.unexpected(Context::Head, |k| {
                    matches!(
                        k,
                        SyntaxKind::MNEMONIC | SyntaxKind::BLOCK_NAME | SyntaxKind::ERROR
                    )
                });
                content_end = p.at;
            }
            _ => {
                p.error_at(
                    SyntaxErrorKind::UnclosedBlock { closing: close },
                    from,
                    content_end,
                );
                break;
            }
        }
    }
    p.finish_node();
}

/// Whether only white space stands between here and the end of the line: it then belongs to the line.
fn ends_line_behind_blanks(p: &mut Parser<'_, '_, '_>) -> bool {
    let (_, end) = p.peek_token(Context::Head);
    matches!(p.text.as_bytes().get(end), None | Some(b'\n' | b'\r'))
}

/// `( t, T#5s, R := reset )`
fn operand_list(p: &mut Parser<'_, '_, '_>) {
    let from = p.at;
    p.start_node(SyntaxKind::OPERAND_LIST);
    p.bump(Context::Operand);
    let mut content_end = p.at;
    // Whether an operand stands before this place without a comma between.
    let mut operand_before = false;
    loop {
        if ends_unclosed_list(p) {
            let closing = SyntaxKind::R_PAREN;
            p.error_at(SyntaxErrorKind::UnclosedBlock { closing }, from, content_end);
            break;
        }
        match p.peek(Context::Operand) {
            SyntaxKind::WHITESPACE | SyntaxKind::COMMENT => {
                p.bump(Context::Operand);
                continue;
            }
            SyntaxKind::R_PAREN => {
                p.bump(Context::Operand);
                break;
            }
            SyntaxKind::COMMA => {
                if !operand_before {
                    p.error_here(
                        SyntaxErrorKind::MissingOperand {
                            place: OperandPlace::List,
                        },
                        Context::Operand,
                    );
                }
                operand_before = false;
                p.bump(Context::Operand);
                if closes_list(p) {
                    p.error_here(
                        SyntaxErrorKind::MissingOperand {
                            place: OperandPlace::List,
                        },
                        Context::Operand,
                    );
                }
            }
            SyntaxKind::ERROR => p.unexpected(Context::Operand, |k| k == SyntaxKind::ERROR),
            _ => {
                if operand_before {
                    p.error_here(SyntaxErrorKind::MissingComma, Context::Operand);
                }
                expression::operand(p);
                operand_before = true;
            }
        }
        content_end = p.at;
    }
    p.finish_node();
}

/// Whether the next token, blanks aside, is the closing parenthesis.
fn closes_list(p: &mut Parser<'_, '_, '_>) -> bool {
    let rest = &p.text[p.at..];
    rest.trim_start_matches([' ', '\t']).starts_with(')')
}

/// Whether the drawing goes on here, so that an open operand list ends: the line's end, a character that no
/// expression holds, or a `-` that can only be wire.
pub(super) fn ends_unclosed_list(p: &mut Parser<'_, '_, '_>) -> bool {
    let (kind, end) = p.peek_token(Context::Operand);
    if p.is_blank(kind, end) && p.free_form {
        return false;
    }
    match (kind, end) {
        (
            SyntaxKind::EOF
            | SyntaxKind::NEWLINE
            | SyntaxKind::RAIL
            | SyntaxKind::DOWN
            | SyntaxKind::L_BRACKET,
            _,
        ) => true,
        (SyntaxKind::WHITESPACE, end) => matches!(p.text.as_bytes().get(end), None | Some(b'\n' | b'\r')),
        (SyntaxKind::MINUS, _) => is_wire(p.text, p.at),
        // The right rail behind an operand list that was never closed.
        (SyntaxKind::PLUS, end) => ends_line(p.text, end),
        _ => false,
    }
}

/// Whether the dashes at `at` are wire and not a sign: what follows them cannot follow a minus.
fn is_wire(text: &str, at: usize) -> bool {
    let rest = &text[at..];
    let dashes = rest.bytes().take_while(|&b| b == b'-').count();
    let behind = &rest[dashes..];
    match behind.bytes().next() {
        Some(b'[' | b'\\' | b'|' | b'+' | b'/' | b'<') => true,
        Some(b'(') => begins_coil(behind),
        Some(b'#') => dashes > 1,
        _ => ends_line(text, at + dashes),
    }
}

fn ends_line(text: &str, at: usize) -> bool {
    let rest = text[at..].trim_start_matches([' ', '\t', '|']);
    rest.is_empty() || rest.starts_with(['\n', '\r'])
}

/// Whether the text begins like a coil: two parentheses, at most one word in the first.
fn begins_coil(text: &str) -> bool {
    let inside = text[1..].trim_start_matches([' ', '\t']);
    let word = match inside.bytes().next() {
        Some(b'/') => 1,
        Some(b'$') => lexer::identifier_end(inside, 1).unwrap_or(0),
        _ => lexer::identifier_end(inside, 0).unwrap_or(0),
    };
    let behind = inside[word..].trim_start_matches([' ', '\t']);
    behind
        .strip_prefix(')')
        .is_some_and(|b| b.trim_start_matches([' ', '\t']).starts_with('('))
}

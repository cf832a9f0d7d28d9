//! Operands and expressions: one grammar for every operand of every block, and for initial values.
//!
//! Loosest first (LANGUAGE §5.2): `OR`; `XOR`; `AND`; `= <>`; `< <= > >=`; `SHL SHR`; `+ -`; `* / MOD`; `^`
//! (to the right); unary `-` and `NOT`.

use super::block::ends_unclosed_list;
use super::{MAX_DEPTH, MAX_TERMS, Parser};
use crate::lexer::Context;
use crate::{OperandPlace, SyntaxErrorKind, SyntaxKind};

/// One operand: an expression, or a named one with `:=` or `=>`.
pub(super) fn operand(p: &mut Parser<'_, '_, '_>) {
    p.terms = 0;
    let checkpoint = p.checkpoint();
    let from = p.at;
    expression(p, 0);
    let behind = behind_blanks(p);
    if matches!(behind, SyntaxKind::ASSIGN | SyntaxKind::ARROW) {
        p.start_node_at(checkpoint, SyntaxKind::NAMED_OPERAND);
        p.skip_trivia(Context::Operand);
        p.bump(Context::Operand);
        p.skip_trivia(Context::Operand);
        if ends_operand(p) {
            p.error_here(
                SyntaxErrorKind::MissingOperand {
                    place: OperandPlace::Named,
                },
                Context::Operand,
            );
        } else {
            expression(p, 0);
        }
        p.finish_node();
    }
    if p.at == from {
        // Nothing that an expression could begin with, and it was said: take one token, so that reading goes on.
        p.bump_as(Context::Operand, SyntaxKind::ERROR);
    }
}

/// The kind of the next token that is not white space or a comment, without taking anything.
pub(super) fn behind_blanks(p: &mut Parser<'_, '_, '_>) -> SyntaxKind {
    let mut at = p.at;
    loop {
        let (kind, end) = crate::lexer::token(p.text, at, Context::Operand);
        if !p.is_blank(kind, end) {
            return kind;
        }
        at = end;
    }
}

/// Whether no expression can begin here, because the operand, its list or the line ends.
fn ends_operand(p: &mut Parser<'_, '_, '_>) -> bool {
    ends_unclosed_list(p)
        || matches!(
            p.peek(Context::Operand),
            SyntaxKind::COMMA | SyntaxKind::R_PAREN | SyntaxKind::R_BRACKET | SyntaxKind::SEMICOLON
        )
}

const UNARY: u8 = 10;
const POWER: u8 = 9;

/// How tightly the binary operator binds that begins at the next token (0: none does).
fn binding(p: &mut Parser<'_, '_, '_>) -> u8 {
    match p.peek(Context::Operand) {
        SyntaxKind::WORD_OPERATOR => match p.peek_text(Context::Operand).to_ascii_uppercase().as_str() {
            "OR" => 1,
            "XOR" => 2,
            "AND" => 3,
            "SHL" | "SHR" => 6,
            "MOD" => 8,
            _ => 0,
        },
        SyntaxKind::EQUAL | SyntaxKind::NOT_EQUAL => 4,
        SyntaxKind::LESS | SyntaxKind::LESS_EQUAL | SyntaxKind::GREATER | SyntaxKind::GREATER_EQUAL => 5,
        SyntaxKind::PLUS | SyntaxKind::MINUS => 7,
        SyntaxKind::STAR | SyntaxKind::SLASH => 8,
        SyntaxKind::CARET => POWER,
        _ => 0,
    }
}

/// An expression whose operators all bind more tightly than `floor`.
pub(super) fn expression(p: &mut Parser<'_, '_, '_>, floor: u8) {
    if p.depth >= MAX_DEPTH || p.terms >= MAX_TERMS {
        too_complex(p);
        return;
    }
    p.depth += 1;
    let checkpoint = p.checkpoint();
    prefix(p);
    loop {
        let blank_before = p.peek(Context::Operand) == SyntaxKind::WHITESPACE;
        if (blank_before
            && matches!(behind_blanks(p), SyntaxKind::MINUS | SyntaxKind::PLUS)
            && wire_behind_blanks(p))
            || ends_unclosed_list(p)
        {
            break;
        }
        let (kind, end) = p.peek_token(Context::Operand);
        if p.is_blank(kind, end) {
            // White space goes into the expression only where it goes on.
            if !is_binary(behind_blanks(p)) {
                break;
            }
            let before_trivia = p.at;
            let saved = p.peeked;
            if !binds_behind_blanks(p, floor) {
                p.at = before_trivia;
                p.peeked = saved;
                break;
            }
            p.skip_trivia(Context::Operand);
        }
        let power = binding(p);
        if power == 0 || power <= floor {
            break;
        }
        p.terms += 1;
        if p.terms >= MAX_TERMS {
            too_complex(p);
            break;
        }
        p.start_node_at(checkpoint, SyntaxKind::BINARY_EXPR);
        p.bump(Context::Operand);
        p.skip_trivia(Context::Operand);
        if ends_operand(p) {
            p.error_here(
                SyntaxErrorKind::MissingOperand {
                    place: OperandPlace::Operator,
                },
                Context::Operand,
            );
        } else {
            // `^` groups to the right.
            expression(p, if power == POWER { POWER - 1 } else { power });
        }
        p.finish_node();
    }
    p.depth -= 1;
}

fn is_binary(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        SyntaxKind::WORD_OPERATOR
            | SyntaxKind::EQUAL
            | SyntaxKind::NOT_EQUAL
            | SyntaxKind::LESS
            | SyntaxKind::LESS_EQUAL
            | SyntaxKind::GREATER
            | SyntaxKind::GREATER_EQUAL
            | SyntaxKind::PLUS
            | SyntaxKind::MINUS
            | SyntaxKind::STAR
            | SyntaxKind::SLASH
            | SyntaxKind::CARET
    )
}

/// Looks at the operator behind white space and comments without taking anything.
fn binds_behind_blanks(p: &mut Parser<'_, '_, '_>, floor: u8) -> bool {
    let (at, peeked) = (p.at, p.peeked);
    loop {
        let (kind, end) = crate::lexer::token(p.text, p.at, Context::Operand);
        if !p.is_blank(kind, end) {
            break;
        }
        p.at = end;
    }
    p.peeked = None;
    let power = binding(p);
    (p.at, p.peeked) = (at, peeked);
    power > floor
}

/// Whether the dashes or the rail behind blanks belong to the drawing (`[ ]( a  --+`).
fn wire_behind_blanks(p: &mut Parser<'_, '_, '_>) -> bool {
    let (at, peeked) = (p.at, p.peeked);
    p.at = p.peek_token(Context::Operand).1;
    p.peeked = None;
    let ends = ends_unclosed_list(p);
    (p.at, p.peeked) = (at, peeked);
    ends
}

fn prefix(p: &mut Parser<'_, '_, '_>) {
    let sign = match p.peek(Context::Operand) {
        SyntaxKind::MINUS => true,
        SyntaxKind::WORD_OPERATOR => p.peek_text(Context::Operand).eq_ignore_ascii_case("NOT"),
        _ => false,
    };
    if !sign {
        return postfix(p);
    }
    p.start_node(SyntaxKind::UNARY_EXPR);
    p.bump(Context::Operand);
    p.skip_trivia(Context::Operand);
    if ends_operand(p) {
        p.error_here(
            SyntaxErrorKind::MissingOperand {
                place: OperandPlace::Operator,
            },
            Context::Operand,
        );
    } else {
        expression(p, UNARY);
    }
    p.finish_node();
}

/// A primary with its members and indices.
fn postfix(p: &mut Parser<'_, '_, '_>) {
    let checkpoint = p.checkpoint();
    if !primary(p) {
        return;
    }
    while matches!(
        behind_blanks(p),
        SyntaxKind::DOT | SyntaxKind::L_BRACKET | SyntaxKind::L_PAREN
    ) {
        p.terms += 1;
        if p.terms >= MAX_TERMS {
            return too_complex(p);
        }
        match behind_blanks(p) {
            SyntaxKind::DOT => {
                p.start_node_at(checkpoint, SyntaxKind::MEMBER_EXPR);
                p.skip_trivia(Context::Operand);
                p.bump(Context::Operand);
                p.skip_trivia(Context::Operand);
                match p.peek(Context::Operand) {
                    SyntaxKind::IDENT | SyntaxKind::LITERAL => p.bump(Context::Operand),
                    _ => p.error_here(
                        SyntaxErrorKind::MissingOperand {
                            place: OperandPlace::Member,
                        },
                        Context::Operand,
                    ),
                }
                p.finish_node();
            }
            // Behind blanks a bracket may be the next block of a rung whose list was never closed: an index
            // there must close again before the drawing goes on.
            SyntaxKind::L_BRACKET if is_index(p) => {
                p.start_node_at(checkpoint, SyntaxKind::INDEX_EXPR);
                p.skip_trivia(Context::Operand);
                p.bump(Context::Operand);
                index(p);
                p.finish_node();
            }
            SyntaxKind::L_PAREN => {
                p.start_node_at(checkpoint, SyntaxKind::CALL_EXPR);
                p.skip_trivia(Context::Operand);
                p.bump(Context::Operand);
                arguments(p, SyntaxKind::R_PAREN);
                p.finish_node();
            }
            _ => return,
        }
    }
}

/// Whether the bracket behind blanks opens an index: it stands directly behind the name, or is closed again
/// on the line with a character between that no block's first part has.
fn is_index(p: &mut Parser<'_, '_, '_>) -> bool {
    if p.text.as_bytes().get(p.at) == Some(&b'[') {
        return true;
    }
    let rest = p.text[p.at..].trim_start_matches([' ', '\t']);
    let Some(rest) = rest.strip_prefix('[') else {
        return false;
    };
    let inside = rest.split([']', '\n', '\r']).next().unwrap_or("");
    let behind = rest[inside.len()..].trim_start_matches([']', ' ', '\t']);
    !inside.trim().is_empty() && inside.trim() != "/" && !behind.starts_with('(')
}

/// What stands between the brackets of an index: `i`, `3..9`.
fn index(p: &mut Parser<'_, '_, '_>) {
    p.skip_trivia(Context::Operand);
    let checkpoint = p.checkpoint();
    if ends_operand(p) {
        p.error_here(
            SyntaxErrorKind::MissingOperand {
                place: OperandPlace::Index,
            },
            Context::Operand,
        );
    } else {
        expression(p, 0);
    }
    if behind_blanks(p) == SyntaxKind::DOT_DOT {
        p.start_node_at(checkpoint, SyntaxKind::RANGE_EXPR);
        p.skip_trivia(Context::Operand);
        p.bump(Context::Operand);
        p.skip_trivia(Context::Operand);
        if ends_operand(p) {
            p.error_here(
                SyntaxErrorKind::MissingOperand {
                    place: OperandPlace::Range,
                },
                Context::Operand,
            );
        } else {
            expression(p, 0);
        }
        p.finish_node();
    }
    close(p, SyntaxKind::R_BRACKET);
}

/// Takes the closing bracket, or says that it is missing.
fn close(p: &mut Parser<'_, '_, '_>, closing: SyntaxKind) {
    if behind_blanks(p) == closing {
        p.skip_trivia(Context::Operand);
        p.bump(Context::Operand);
        return;
    }
    let at = p.at;
    p.error_at(SyntaxErrorKind::UnclosedBlock { closing }, at, at);
}

/// Values between brackets, with commas. The opening bracket is taken.
pub(super) fn arguments(p: &mut Parser<'_, '_, '_>, closing: SyntaxKind) {
    loop {
        p.skip_trivia(Context::Operand);
        if p.peek(Context::Operand) == closing {
            p.bump(Context::Operand);
            return;
        }
        if ends_operand(p) && p.peek(Context::Operand) != SyntaxKind::COMMA {
            return close(p, closing);
        }
        let from = p.at;
        if p.peek(Context::Operand) == SyntaxKind::COMMA {
            p.error_here(
                SyntaxErrorKind::MissingOperand {
                    place: OperandPlace::List,
                },
                Context::Operand,
            );
        } else {
            expression(p, 0);
        }
        match behind_blanks(p) {
            SyntaxKind::COMMA => {
                p.skip_trivia(Context::Operand);
                p.bump(Context::Operand);
            }
            kind if kind == closing => {}
            _ if p.at == from => return close(p, closing),
            _ => {
                p.skip_trivia(Context::Operand);
                if ends_operand(p) {
                    return close(p, closing);
                }
                p.error_here(SyntaxErrorKind::MissingComma, Context::Operand);
            }
        }
    }
}

/// A name, literal, address or parenthesis. False if none begins here; nothing is taken then.
fn primary(p: &mut Parser<'_, '_, '_>) -> bool {
    let kind = match p.peek(Context::Operand) {
        SyntaxKind::IDENT => SyntaxKind::NAME_EXPR,
        SyntaxKind::ADDRESS => SyntaxKind::ADDRESS_EXPR,
        SyntaxKind::LITERAL | SyntaxKind::STRING => SyntaxKind::LITERAL_EXPR,
        SyntaxKind::L_PAREN => {
            p.start_node(SyntaxKind::PAREN_EXPR);
            p.bump(Context::Operand);
            p.skip_trivia(Context::Operand);
            if ends_operand(p) {
                p.error_here(
                    SyntaxErrorKind::MissingOperand {
                        place: OperandPlace::Parentheses,
                    },
                    Context::Operand,
                );
            } else {
                expression(p, 0);
            }
            close(p, SyntaxKind::R_PAREN);
            p.finish_node();
            return true;
        }
        _ => {
            p.error_here(
                SyntaxErrorKind::MissingOperand {
                    place: OperandPlace::List,
                },
                Context::Operand,
            );
            return false;
        }
    };
    p.start_node(kind);
    p.bump(Context::Operand);
    p.finish_node();
    true
}

/// Takes the rest of an operand that is too deep or too long, as one mistake. Iterative on purpose.
fn too_complex(p: &mut Parser<'_, '_, '_>) {
    let from = p.at;
    let mut open = 0u32;
    p.start_node(SyntaxKind::ERROR_NODE);
    loop {
        match p.peek(Context::Operand) {
            SyntaxKind::EOF | SyntaxKind::NEWLINE => break,
            SyntaxKind::COMMA if open == 0 => break,
            SyntaxKind::L_PAREN => open += 1,
            SyntaxKind::R_PAREN if open == 0 => break,
            SyntaxKind::R_PAREN => open -= 1,
            _ => {}
        }
        p.bump(Context::Operand);
    }
    p.finish_node();
    // Once for an operand: the callers above this one meet the same end.
    let already = p.errors.iter().any(|e| e.kind == SyntaxErrorKind::TooComplex);
    if !already {
        p.error_at(SyntaxErrorKind::TooComplex, from, p.at);
    }
    p.terms = p.terms.max(MAX_TERMS);
}

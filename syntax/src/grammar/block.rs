//! A block on a rung: its first part in brackets, then its operand list.
//!
//! Recovery stays in the block where it can: a bracket that is not closed ends where the drawing goes on, so
//! the rest of the rung keeps its meaning.

use super::{Parser, expression, plain, recovery};
use crate::builder::Builder;
use crate::error::{Many, OperandPlace, Surroundings, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::lexer;
use crate::name::is_block_name;
use std::ops::Range;

/// The block that begins with the bracket `open`.
pub(super) fn block<B: Builder>(p: &mut Parser<'_, '_, B>, open: SyntaxKind) {
    let kind = match open {
        SyntaxKind::L_BRACKET => SyntaxKind::LOGICAL_BLOCK,
        SyntaxKind::L_PAREN => SyntaxKind::COIL_BLOCK,
        _ => SyntaxKind::FUNCTION_BLOCK,
    };
    if B::TAKES_PLAIN_BLOCKS
        && let Some(end) = plain::plain_block(p.text, p.at)
    {
        p.builder.plain_block(kind, p.at..end);
        p.at = end;
        p.last_end = end;
        return;
    }
    p.start_node(kind);
    head(p, open);
    // White space is free between the first part and the operand list; without a list it belongs to the rung.
    let after_blanks = lexer::blanks_end(p.text.as_bytes(), p.at);
    if p.byte(after_blanks) == b'(' {
        blanks_token(p, after_blanks);
        operand_list(p);
    }
    p.finish_node();
}

const fn closing_bracket(open: SyntaxKind) -> (SyntaxKind, u8) {
    match open {
        SyntaxKind::L_BRACKET => (SyntaxKind::R_BRACKET, b']'),
        SyntaxKind::L_PAREN => (SyntaxKind::R_PAREN, b')'),
        _ => (SyntaxKind::R_ANGLE, b'>'),
    }
}

/// `[TON]`, `( )`, `<JMP>`, `[$Name]`. Also used for the head in a block definition's first line. Whether it
/// names a user-defined block.
pub(super) fn head<B: Builder>(p: &mut Parser<'_, '_, B>, open: SyntaxKind) -> bool {
    let (closing, closing_byte) = closing_bracket(open);
    let from = p.at;
    let mut named = false;
    let mut user = false;
    p.start_node(SyntaxKind::BLOCK_HEAD);
    p.token((open, p.at + 1));
    if let Some((word, blanks, end)) = plain_head(p, closing_byte) {
        blanks_token(p, word.start);
        if !word.is_empty() {
            p.token((SyntaxKind::MNEMONIC, word.end));
        }
        blanks_token(p, blanks);
        p.token((closing, end));
        p.finish_node();
        return false;
    }
    loop {
        let blanks = lexer::blanks_end(p.text.as_bytes(), p.at);
        let (kind, end) = lexer::in_head(p.text, blanks, p.open);
        let taken = kind == closing
            || kind == SyntaxKind::COMMENT
            || !named && matches!(kind, SyntaxKind::MNEMONIC | SyntaxKind::BLOCK_NAME);
        let literal = takes_hash(p.text, open, kind, blanks..end);
        if taken && !literal {
            blanks_token(p, blanks);
            p.token((kind, end));
            match kind {
                SyntaxKind::COMMENT => {}
                SyntaxKind::MNEMONIC => named = true,
                SyntaxKind::BLOCK_NAME => {
                    (named, user) = (true, true);
                    block_name(p, blanks, end);
                }
                _ => break,
            }
            continue;
        }
        // Something that belongs to no first part: junk in one that is closed, or the end of one that is not.
        if let Some(junk_end) = recovery::closing_after_junk(p.text, blanks, closing_byte) {
            junk(p, blanks, junk_end);
        } else if literal {
            junk(p, blanks, lexer::in_operands(p.text, blanks, p.open).1);
        } else if matches!(
            kind,
            SyntaxKind::R_BRACKET | SyntaxKind::R_PAREN | SyntaxKind::R_ANGLE
        ) {
            blanks_token(p, blanks);
            p.error(SyntaxErrorKind::WrongBracket { closing }, blanks, end);
            p.token((SyntaxKind::ERROR, end));
            break;
        } else if is_word(kind) && p.byte(blanks) != b'/' {
            junk(p, blanks, end);
        } else {
            // The bracket belongs right before the drawing: what is in front of it stays connected.
            if !matches!(
                kind,
                SyntaxKind::NEWLINE | SyntaxKind::EOF | SyntaxKind::RAIL | SyntaxKind::L_PAREN
            ) {
                blanks_token(p, blanks);
                p.last_end = blanks;
            }
            p.error(SyntaxErrorKind::UnclosedBlock { closing }, from, p.last_end);
            break;
        }
    }
    p.finish_node();
    user
}

/// A first part that is closed and holds at most a mnemonic, as nearly all do: the mnemonic, where the blanks after
/// it end, and where the bracket does. What the loop of [`head`] would find, at a fraction of the cost.
fn plain_head<B: Builder>(p: &Parser<'_, '_, B>, closing: u8) -> Option<(Range<usize>, usize, usize)> {
    let bytes = p.text.as_bytes();
    let start = lexer::blanks_end(bytes, p.at);
    let end = match p.byte(start) {
        b'/' => start + 1,
        b'A'..=b'Z' | b'a'..=b'z' | b'_' => lexer::word_end(p.text, start),
        _ => start,
    };
    let blanks = lexer::blanks_end(bytes, end);
    (p.byte(blanks) == closing).then_some((start..end, blanks, blanks + 1))
}

const fn is_word(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        SyntaxKind::ERROR | SyntaxKind::MNEMONIC | SyntaxKind::BLOCK_NAME
    )
}

/// Takes the blanks up to `end`, if there are any.
fn blanks_token<B: Builder>(p: &mut Parser<'_, '_, B>, end: usize) {
    if end > p.at {
        p.token((SyntaxKind::WHITESPACE, end));
    }
}

/// Whether a `#` directly after the word belongs to it: in a coil's parentheses it does (LANGUAGE §1), as in
/// `(T#5s)` where the first part was forgotten.
fn takes_hash(text: &str, open: SyntaxKind, kind: SyntaxKind, word: Range<usize>) -> bool {
    open == SyntaxKind::L_PAREN
        && matches!(kind, SyntaxKind::MNEMONIC | SyntaxKind::ERROR)
        && text.as_bytes().get(word.end) == Some(&b'#')
        && lexer::takes_hash(text, word.start, word.end)
}

/// Takes characters that mean nothing in a first part, up to `to`, as one error.
fn junk<B: Builder>(p: &mut Parser<'_, '_, B>, from: usize, to: usize) {
    blanks_token(p, from);
    let to = from + p.text[from..to].trim_end_matches([' ', '\t']).len();
    p.token((SyntaxKind::ERROR, to));
    p.unexpected(Surroundings::Head, from, to);
}

/// Checks the name of a user-defined block, which begins with its `$`.
fn block_name<B: Builder>(p: &mut Parser<'_, '_, B>, start: usize, end: usize) {
    if !is_block_name(&p.text[start + 1..end]) {
        p.error(SyntaxErrorKind::BadBlockName, start, end);
    }
}

/// What is directly before a place in an operand list.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    Opening,
    Comma,
    Operand,
    Junk,
}

/// `( t, T#5s, R := reset )`
fn operand_list<B: Builder>(p: &mut Parser<'_, '_, B>) {
    let from = p.at;
    p.list.begin(from);
    p.start_node(SyntaxKind::OPERAND_LIST);
    p.token((SyntaxKind::L_PAREN, from + 1));
    p.look();
    let missing = SyntaxErrorKind::MissingOperand {
        place: OperandPlace::List,
    };
    let mut before = Before::Opening;
    let mut operands = 0;
    loop {
        match p.next() {
            SyntaxKind::R_PAREN => {
                if before == Before::Comma {
                    p.error_ahead(missing);
                }
                p.bump_last_as(SyntaxKind::R_PAREN);
                break;
            }
            SyntaxKind::COMMA => {
                if matches!(before, Before::Opening | Before::Comma) {
                    p.error_ahead(missing);
                }
                before = Before::Comma;
                p.bump();
            }
            kind if expression::begins_operand(kind) && !p.drawing_goes_on() => {
                if before == Before::Operand && !expression::names(kind) {
                    p.error_ahead(SyntaxErrorKind::MissingComma);
                }
                operands += 1;
                if operands > Many::Operands.most() {
                    expression::rest_of_operands(p);
                } else {
                    expression::operand(p);
                }
                before = Before::Operand;
            }
            _ if p.drawing_goes_on() => {
                let closing = SyntaxKind::R_PAREN;
                // As in a first part: the parenthesis belongs right before the drawing.
                if !matches!(p.next(), SyntaxKind::NEWLINE | SyntaxKind::EOF | SyntaxKind::RAIL) {
                    p.space();
                    p.last_end = p.at;
                }
                p.error(SyntaxErrorKind::UnclosedBlock { closing }, from, p.last_end);
                break;
            }
            _ => {
                expression::junk(p, SyntaxKind::R_PAREN);
                before = Before::Junk;
            }
        }
    }
    p.finish_node();
}

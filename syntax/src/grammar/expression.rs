//! Operands and expressions: one grammar for every operand of every block, and for initial values.
//!
//! Loosest first (LANGUAGE §5.2): `OR`; `XOR`; `AND`; `= <>`; `< <= > >=`; `SHL SHR`; `+ -`; `* / MOD`; `^`
//! (to the right); unary `-` and `NOT`.
//!
//! White space and comments between two parts of an expression belong to the innermost node that holds both;
//! those after it belong to what it is in.

use super::declaration::keyword_at;
use super::{MAX_DEPTH, MAX_TERMS, Parser, recovery};
use crate::builder::Builder;
use crate::error::{DeclarationProblem, Many, OperandPlace, Surroundings, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::lexer;

/// Whether a token can begin an operand. Operators and `:=` count: what they lack before them is named then.
pub(super) const fn begins_operand(kind: SyntaxKind) -> bool {
    matches!(
        kind,
        SyntaxKind::IDENT
            | SyntaxKind::LITERAL
            | SyntaxKind::STRING
            | SyntaxKind::ADDRESS
            | SyntaxKind::L_PAREN
            | SyntaxKind::WORD_OPERATOR
            | SyntaxKind::PLUS
            | SyntaxKind::MINUS
            | SyntaxKind::STAR
            | SyntaxKind::SLASH
            | SyntaxKind::CARET
            | SyntaxKind::EQUAL
            | SyntaxKind::NOT_EQUAL
            | SyntaxKind::LESS
            | SyntaxKind::LESS_EQUAL
            | SyntaxKind::GREATER
            | SyntaxKind::GREATER_EQUAL
            | SyntaxKind::ASSIGN
            | SyntaxKind::ARROW
    )
}

/// Whether a value can begin here: an operand, or in a declaration a list in brackets.
pub(super) fn begins_value<B: Builder>(p: &Parser<'_, '_, B>) -> bool {
    begins_operand(p.next()) || p.free_form && p.next() == SyntaxKind::L_BRACKET
}

/// One operand: an expression, or a named one with `:=` or `=>`. Takes at least one token if one begins here.
pub(super) fn operand<B: Builder>(p: &mut Parser<'_, '_, B>) {
    p.terms = 0;
    p.too_complex = false;
    p.space();
    if let Some(node) = lone(p) {
        p.start_node(node);
        p.bump();
        p.finish_node();
        return;
    }
    let checkpoint = p.checkpoint();
    if names(p.next()) {
        p.error_ahead(missing(OperandPlace::Named));
    } else {
        expression(p, 0);
    }
    if names(p.next()) {
        p.start_node_at(checkpoint, SyntaxKind::NAMED_OPERAND);
        p.bump();
        value(p, 0, OperandPlace::Named);
        p.finish_node();
    }
}

/// The node of an operand that is a name, a literal or an address and nothing else, as nearly all are: a comma or
/// the list's end follows. What [`expression`] would make of it, at a fraction of the cost.
fn lone<B: Builder>(p: &Parser<'_, '_, B>) -> Option<SyntaxKind> {
    let node = primary_node(p.next())?;
    let after = lexer::blanks_end(p.text.as_bytes(), p.ahead.end);
    matches!(p.byte(after), b',' | b')').then_some(node)
}

/// The node of a value of one token.
const fn primary_node(token: SyntaxKind) -> Option<SyntaxKind> {
    match token {
        SyntaxKind::IDENT => Some(SyntaxKind::NAME_EXPR),
        SyntaxKind::ADDRESS => Some(SyntaxKind::ADDRESS_EXPR),
        SyntaxKind::LITERAL | SyntaxKind::STRING => Some(SyntaxKind::LITERAL_EXPR),
        _ => None,
    }
}

/// `:=` or `=>`.
pub(super) const fn names(kind: SyntaxKind) -> bool {
    matches!(kind, SyntaxKind::ASSIGN | SyntaxKind::ARROW)
}

const fn missing(place: OperandPlace) -> SyntaxErrorKind {
    SyntaxErrorKind::MissingOperand { place }
}

/// An expression that must be here.
pub(super) fn value<B: Builder>(p: &mut Parser<'_, '_, B>, floor: u8, place: OperandPlace) {
    if p.drawing_goes_on() {
        p.error_after(missing(place));
    } else if ends_operand(p) {
        p.error_ahead(missing(place));
    } else {
        expression(p, floor);
    }
}

/// Whether no expression can begin here, because the operand, its list or the line ends.
fn ends_operand<B: Builder>(p: &mut Parser<'_, '_, B>) -> bool {
    matches!(
        p.next(),
        SyntaxKind::COMMA | SyntaxKind::R_PAREN | SyntaxKind::R_BRACKET | SyntaxKind::SEMICOLON
    ) || p.drawing_goes_on()
}

const UNARY: u8 = 10;
const POWER: u8 = 9;

/// How tightly the binary operator binds that is ahead (0: none is).
fn binding<B: Builder>(p: &mut Parser<'_, '_, B>) -> u8 {
    match p.next() {
        SyntaxKind::WORD_OPERATOR => match p.next_text().as_bytes() {
            [b'O' | b'o', ..] => 1,
            [b'X' | b'x', ..] => 2,
            [b'A' | b'a', ..] => 3,
            [b'S' | b's', ..] => 6,
            [b'M' | b'm', ..] => 8,
            // NOT is before its only operand.
            _ => 0,
        },
        SyntaxKind::EQUAL | SyntaxKind::NOT_EQUAL => 4,
        SyntaxKind::LESS | SyntaxKind::LESS_EQUAL | SyntaxKind::GREATER | SyntaxKind::GREATER_EQUAL => 5,
        SyntaxKind::PLUS | SyntaxKind::MINUS if !p.drawing_goes_on() => 7,
        SyntaxKind::STAR | SyntaxKind::SLASH => 8,
        SyntaxKind::CARET => POWER,
        _ => 0,
    }
}

/// An expression whose operators all bind more tightly than `floor`.
pub(super) fn expression<B: Builder>(p: &mut Parser<'_, '_, B>, floor: u8) {
    if p.depth >= MAX_DEPTH || p.terms >= MAX_TERMS {
        return too_complex(p);
    }
    p.depth += 1;
    p.space();
    let checkpoint = p.checkpoint();
    prefix(p);
    loop {
        let power = binding(p);
        if power <= floor {
            break;
        }
        p.terms += 1;
        if p.terms >= MAX_TERMS {
            too_complex(p);
            break;
        }
        p.start_node_at(checkpoint, SyntaxKind::BINARY_EXPR);
        p.bump();
        // `^` groups to the right.
        let floor = if power == POWER { POWER - 1 } else { power };
        value(p, floor, OperandPlace::Operator);
        p.finish_node();
    }
    p.depth -= 1;
}

/// A value with the signs before it.
fn prefix<B: Builder>(p: &mut Parser<'_, '_, B>) {
    match p.next() {
        SyntaxKind::IDENT => postfix(p),
        SyntaxKind::MINUS => unary(p),
        SyntaxKind::WORD_OPERATOR if p.next_is_word("NOT") => unary(p),
        // `+5`: the sign says nothing, and no literal has it.
        SyntaxKind::PLUS => {
            p.unexpected(Surroundings::Operands, p.ahead.start, p.ahead.end);
            p.bump_as(SyntaxKind::ERROR);
            if !ends_operand(p) {
                prefix_after_plus(p);
            }
        }
        _ => postfix(p),
    }
}

/// What is after a `+` that is not an operator; a second one lacks the value before it.
fn prefix_after_plus<B: Builder>(p: &mut Parser<'_, '_, B>) {
    p.space();
    if p.next() == SyntaxKind::MINUS {
        unary(p);
    } else {
        postfix(p);
    }
}

fn unary<B: Builder>(p: &mut Parser<'_, '_, B>) {
    p.start_node(SyntaxKind::UNARY_EXPR);
    p.bump();
    value(p, UNARY, OperandPlace::Operator);
    p.finish_node();
}

/// A primary with its members, indices and arguments.
fn postfix<B: Builder>(p: &mut Parser<'_, '_, B>) {
    let checkpoint = p.checkpoint();
    if !primary(p) {
        return;
    }
    loop {
        let kind = match p.next() {
            SyntaxKind::DOT => SyntaxKind::MEMBER_EXPR,
            // A bracket may also be the next block of a rung whose list was never closed.
            SyntaxKind::L_BRACKET if !p.drawing_goes_on() => SyntaxKind::INDEX_EXPR,
            SyntaxKind::L_PAREN if !p.drawing_goes_on() => SyntaxKind::CALL_EXPR,
            _ => return,
        };
        p.terms += 1;
        if p.terms >= MAX_TERMS {
            return too_complex(p);
        }
        p.start_node_at(checkpoint, kind);
        let from = p.ahead.start;
        p.bump();
        match kind {
            SyntaxKind::MEMBER_EXPR => {
                if matches!(p.next(), SyntaxKind::IDENT | SyntaxKind::LITERAL) {
                    p.bump();
                } else {
                    p.error_ahead(missing(OperandPlace::Member));
                }
            }
            SyntaxKind::INDEX_EXPR => index(p, from),
            _ => arguments(p, SyntaxKind::R_PAREN, from),
        }
        p.finish_node();
    }
}

/// What is between the brackets of an index: `i`, `3..9`, `i, 3`.
fn index<B: Builder>(p: &mut Parser<'_, '_, B>, from: usize) {
    p.space();
    let checkpoint = p.checkpoint();
    if p.next() == SyntaxKind::DOT_DOT {
        p.error_ahead(missing(OperandPlace::Range));
    } else {
        value(p, 0, OperandPlace::Index);
    }
    if p.next() == SyntaxKind::DOT_DOT {
        p.start_node_at(checkpoint, SyntaxKind::RANGE_EXPR);
        p.bump();
        value(p, 0, OperandPlace::Range);
        p.finish_node();
    }
    if p.next() == SyntaxKind::COMMA && !p.too_complex && p.terms < MAX_TERMS {
        p.terms += 1;
        p.bump();
        return index(p, from);
    }
    if p.next() != SyntaxKind::R_BRACKET
        && let Some(end) = recovery::closing_after_junk(p.text, p.ahead.start, b']')
    {
        let junk = p.ahead.start;
        while p.ahead.start < end {
            p.bump_as(SyntaxKind::ERROR);
        }
        p.unexpected(Surroundings::Operands, junk, p.last_end);
    }
    close(p, SyntaxKind::R_BRACKET, from);
}

/// Takes what follows the expression in parentheses that are closed, so that their `)` is not taken for the
/// list's: `(a b)`, `(a, b)`.
fn rest_of_parentheses<B: Builder>(p: &mut Parser<'_, '_, B>) {
    while p.next() != SyntaxKind::R_PAREN && !p.too_complex && !p.drawing_goes_on() && !p.list_is_unclosed() {
        if p.next() == SyntaxKind::SEMICOLON && p.free_form {
            return;
        }
        if begins_operand(p.next()) && !names(p.next()) {
            p.error_ahead(SyntaxErrorKind::MissingComma);
            expression(p, 0);
        } else {
            junk(p, SyntaxKind::R_PAREN);
        }
    }
}

/// Takes the closing bracket, or says that it is missing.
fn close<B: Builder>(p: &mut Parser<'_, '_, B>, closing: SyntaxKind, from: usize) {
    if p.next() == closing {
        p.bump();
    } else if !p.too_complex {
        p.error(SyntaxErrorKind::UnclosedBlock { closing }, from, p.last_end);
    }
}

/// Values between brackets, with commas. The opening bracket at `from` is taken.
pub(super) fn arguments<B: Builder>(p: &mut Parser<'_, '_, B>, closing: SyntaxKind, from: usize) {
    let mut comma_before = false;
    loop {
        if p.next() == SyntaxKind::COMMA {
            p.error_ahead(missing(OperandPlace::List));
        } else if ends_operand(p) {
            if comma_before && p.next() == closing {
                p.error_ahead(missing(OperandPlace::List));
            }
            return close(p, closing, from);
        } else if begins_value(p) && !names(p.next()) {
            if p.depth == 0 {
                // The values of a list are counted one by one, as operands are.
                p.terms = 0;
            }
            expression(p, 0);
        } else {
            junk(p, closing);
        }
        if p.next() == SyntaxKind::COMMA {
            comma_before = true;
            p.bump();
        } else {
            comma_before = false;
            if p.next() == closing || ends_operand(p) {
                return close(p, closing, from);
            }
            if begins_value(p) && !names(p.next()) {
                p.error_ahead(SyntaxErrorKind::MissingComma);
            }
        }
    }
}

/// A name, literal, address or parenthesis. False if none begins here; nothing is taken then.
fn primary<B: Builder>(p: &mut Parser<'_, '_, B>) -> bool {
    let kind = match (primary_node(p.next()), p.next()) {
        (Some(node), _) => node,
        // `SHL(a, 2)`: an operator as a function, as IEC 61131-3 has it.
        (None, SyntaxKind::WORD_OPERATOR) if !p.next_is_word("NOT") && p.byte(p.ahead.end) == b'(' => {
            SyntaxKind::NAME_EXPR
        }
        (None, SyntaxKind::L_BRACKET) if p.free_form => {
            let from = p.ahead.start;
            p.start_node(SyntaxKind::ARRAY_EXPR);
            p.bump();
            arguments(p, SyntaxKind::R_BRACKET, from);
            p.finish_node();
            return true;
        }
        (None, SyntaxKind::L_PAREN) if p.free_form && begins_members(p) => {
            members(p);
            return true;
        }
        (None, SyntaxKind::L_PAREN) => {
            let from = p.ahead.start;
            p.start_node(SyntaxKind::PAREN_EXPR);
            p.bump();
            value(p, 0, OperandPlace::Parentheses);
            rest_of_parentheses(p);
            close(p, SyntaxKind::R_PAREN, from);
            p.finish_node();
            return true;
        }
        _ => {
            p.error_ahead(missing(OperandPlace::Operator));
            return false;
        }
    };
    p.start_node(kind);
    p.bump();
    p.finish_node();
    true
}

/// Whether a parenthesis of a declaration holds the values of a structure: a member's name and `:=` are first in it.
fn begins_members<B: Builder>(p: &Parser<'_, '_, B>) -> bool {
    let after = |mut at: usize| {
        while let Some((_, end)) = lexer::space(p.text, at, p.open) {
            at = end;
        }
        at
    };
    let name = after(p.ahead.end);
    lexer::identifier_end(p.text, name).is_some_and(|end| p.text[after(end)..].starts_with(":="))
}

/// Whether the word ahead begins or ends a section or its like.
fn is_keyword<B: Builder>(p: &Parser<'_, '_, B>) -> bool {
    p.next() == SyntaxKind::IDENT && keyword_at(p.text, p.ahead.start).is_some()
}

/// Records an error at the token ahead. A word that ends the section does not become a part of the declaration.
fn error_here<B: Builder>(p: &mut Parser<'_, '_, B>, kind: SyntaxErrorKind) {
    if is_keyword(p) {
        p.error_after(kind);
    } else {
        p.error_ahead(kind);
    }
}

/// `(speed := 20.0, running := TRUE)`
fn members<B: Builder>(p: &mut Parser<'_, '_, B>) {
    let from = p.ahead.start;
    p.start_node(SyntaxKind::STRUCT_EXPR);
    p.bump();
    loop {
        if p.next() == SyntaxKind::IDENT && !is_keyword(p) {
            p.space();
            p.start_node(SyntaxKind::NAMED_OPERAND);
            p.start_node(SyntaxKind::NAME_EXPR);
            p.bump_last_as(SyntaxKind::IDENT);
            p.finish_node();
            p.look();
            if p.next() == SyntaxKind::ASSIGN {
                p.bump();
                if begins_value(p) && !is_keyword(p) {
                    expression(p, 0);
                } else {
                    error_here(p, missing(OperandPlace::Named));
                }
            } else {
                error_here(
                    p,
                    SyntaxErrorKind::BadDeclaration(DeclarationProblem::MemberExpected),
                );
            }
            p.finish_node();
        } else {
            error_here(
                p,
                SyntaxErrorKind::BadDeclaration(DeclarationProblem::MemberExpected),
            );
        }
        if p.next() != SyntaxKind::COMMA || p.too_complex {
            break;
        }
        p.terms += 1;
        if p.terms >= MAX_TERMS {
            too_complex(p);
            break;
        }
        p.bump();
    }
    close(p, SyntaxKind::R_PAREN, from);
    p.finish_node();
}

/// Takes tokens that no operand begins with as one error, up to what can go on in a list that ends with
/// `closing`.
pub(super) fn junk<B: Builder>(p: &mut Parser<'_, '_, B>, closing: SyntaxKind) {
    let from = p.ahead.start;
    p.space();
    loop {
        p.bump_as(SyntaxKind::ERROR);
        let kind = p.next();
        if begins_operand(kind)
            || kind == closing
            || matches!(kind, SyntaxKind::COMMA | SyntaxKind::R_PAREN)
            || kind == SyntaxKind::SEMICOLON && p.free_form
            || p.drawing_goes_on()
        {
            break;
        }
    }
    p.unexpected(Surroundings::Operands, from, p.last_end);
}

/// Takes the rest of a list that holds too many operands, as one error. Iterative on purpose.
pub(super) fn rest_of_operands<B: Builder>(p: &mut Parser<'_, '_, B>) {
    p.space();
    let from = p.at;
    let mut open = 0u32;
    p.start_node(SyntaxKind::ERROR_NODE);
    loop {
        match p.next() {
            SyntaxKind::EOF | SyntaxKind::NEWLINE => break,
            SyntaxKind::L_PAREN => open += 1,
            SyntaxKind::R_PAREN if open == 0 => break,
            SyntaxKind::R_PAREN => open -= 1,
            _ if p.drawing_goes_on() => break,
            _ => {}
        }
        p.bump();
    }
    p.finish_node();
    p.error(SyntaxErrorKind::TooMany(Many::Operands), from, p.last_end);
}

/// Takes the rest of an operand that is too deep or too long, as one error. Iterative on purpose.
fn too_complex<B: Builder>(p: &mut Parser<'_, '_, B>) {
    p.terms = MAX_TERMS;
    p.space();
    let from = p.at;
    let mut open = 0u32;
    p.start_node(SyntaxKind::ERROR_NODE);
    loop {
        match p.next() {
            SyntaxKind::EOF | SyntaxKind::NEWLINE => break,
            SyntaxKind::COMMA | SyntaxKind::SEMICOLON if open == 0 => break,
            SyntaxKind::L_PAREN => open += 1,
            SyntaxKind::R_PAREN if open == 0 => break,
            SyntaxKind::R_PAREN => open -= 1,
            _ => {}
        }
        p.bump();
    }
    p.finish_node();
    // Once for an operand: the callers above this one go on with what is left of it, and come back here.
    if !std::mem::replace(&mut p.too_complex, true) {
        p.error(SyntaxErrorKind::TooComplex, from, p.last_end);
    }
}

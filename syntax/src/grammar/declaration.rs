//! Sections, declarations and the first and last line of a block definition (LANGUAGE §4, §5.7).

use super::{Parser, block, expression};
use crate::lexer::{self, Context};
use crate::line::{LineKind, Mode};
use crate::{DeclarationProblem, SyntaxErrorKind, SyntaxKind};

/// The keyword that a line begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum KeywordLine {
    Section,
    SectionEnd,
    Block,
    BlockEnd,
}

const SECTIONS: [&str; 6] = [
    "VAR",
    "VAR_INPUT",
    "VAR_OUTPUT",
    "VAR_IN_OUT",
    "VAR_GLOBAL",
    "VAR_EXTERNAL",
];

/// Names of types that are keywords inside declarations.
const TYPES: [&str; 29] = [
    "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
    "ULINT", "REAL", "LREAL", "TIME", "DATE", "TOD", "DT", "STRING", "TON", "TOF", "TP", "RTO", "RTOF",
    "CTU", "CTD", "CTUD", "CTC",
];
const MORE_TYPES: [&str; 4] = ["SR", "RS", "TIME_OF_DAY", "DATE_AND_TIME"];

fn is_one_of(word: &str, words: &[&str]) -> bool {
    words.iter().any(|w| w.eq_ignore_ascii_case(word))
}

/// Whether a word is a keyword inside declarations, so that it can name no tag.
pub fn is_declaration_keyword(word: &str) -> bool {
    is_one_of(word, &SECTIONS)
        || is_one_of(word, &TYPES)
        || is_one_of(word, &MORE_TYPES)
        || is_one_of(
            word,
            &[
                "END_VAR",
                "RETAIN",
                "CONSTANT",
                "AT",
                "ARRAY",
                "OF",
                "FUNCTION_BLOCK",
                "END_FUNCTION_BLOCK",
            ],
        )
}

fn keyword(word: &str) -> Option<KeywordLine> {
    if is_one_of(word, &SECTIONS) {
        return Some(KeywordLine::Section);
    }
    match word.to_ascii_uppercase().as_str() {
        "END_VAR" => Some(KeywordLine::SectionEnd),
        "FUNCTION_BLOCK" => Some(KeywordLine::Block),
        "END_FUNCTION_BLOCK" => Some(KeywordLine::BlockEnd),
        _ => None,
    }
}

fn keyword_at(text: &str, at: usize) -> Option<KeywordLine> {
    // All begin with V, E or F: most lines are told apart by one byte.
    if !matches!(
        text.as_bytes().get(at),
        Some(b'V' | b'v' | b'E' | b'e' | b'F' | b'f')
    ) {
        return None;
    }
    keyword(&text[at..lexer::identifier_end(text, at)?])
}

/// The keyword of the line whose first token is next.
pub(super) fn keyword_line(p: &Parser<'_, '_, '_>) -> Option<KeywordLine> {
    keyword_at(p.text, p.at)
}

/// Whether the physical line that begins at `at` ends an open declaration: it belongs to the drawing, to
/// another section or to a block definition.
pub(super) fn ends_declaration(text: &str, at: usize) -> bool {
    let rest = text[at..].trim_start_matches([' ', '\t']);
    rest.starts_with(['+', '|', '\\', '/', '[', '<']) || keyword_at(text, text.len() - rest.len()).is_some()
}

/// `VAR_INPUT RETAIN`
pub(super) fn section_header(p: &mut Parser<'_, '_, '_>) -> (LineKind, Mode) {
    p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
    loop {
        blanks(p);
        let word = p.peek_text(Context::Operand);
        if !is_one_of(word, &["RETAIN", "CONSTANT", "NON_RETAIN"]) {
            break;
        }
        p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
    }
    line_end(p);
    (LineKind::SectionHeader, Mode::Section)
}

/// `END_VAR`
pub(super) fn section_end(p: &mut Parser<'_, '_, '_>) -> (LineKind, Mode) {
    p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
    line_end(p);
    (LineKind::SectionEnd, Mode::Network)
}

/// `FUNCTION_BLOCK [$Name]`
pub(super) fn block_header(p: &mut Parser<'_, '_, '_>) -> (LineKind, Mode) {
    p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
    blanks(p);
    match p.peek(Context::Rung) {
        open @ (SyntaxKind::L_BRACKET | SyntaxKind::L_PAREN | SyntaxKind::L_ANGLE) => block::head(p, open),
        _ => p.declaration_error(DeclarationProblem::BlockHeadExpected),
    }
    rest_of_line(p);
    (LineKind::BlockHeader, Mode::Network)
}

/// `END_FUNCTION_BLOCK`
pub(super) fn block_end(p: &mut Parser<'_, '_, '_>) -> (LineKind, Mode) {
    p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
    rest_of_line(p);
    (LineKind::BlockEnd, Mode::Network)
}

/// White space and comments on the same line.
fn blanks(p: &mut Parser<'_, '_, '_>) {
    while matches!(
        p.peek(Context::Operand),
        SyntaxKind::WHITESPACE | SyntaxKind::COMMENT
    ) {
        p.bump(Context::Operand);
    }
}

/// What belongs to a line behind its last token: white space, comments, the line end. Anything else begins a
/// new logical line.
fn line_end(p: &mut Parser<'_, '_, '_>) {
    blanks(p);
    if p.peek(Context::Operand) == SyntaxKind::NEWLINE {
        p.bump(Context::Operand);
    }
}

/// As `line_end`; anything else on the line is a mistake.
fn rest_of_line(p: &mut Parser<'_, '_, '_>) {
    blanks(p);
    if !matches!(p.peek(Context::Operand), SyntaxKind::NEWLINE | SyntaxKind::EOF) {
        p.declaration_error(DeclarationProblem::Unexpected);
        skip_to_line_end(p);
    }
    line_end(p);
}

fn skip_to_line_end(p: &mut Parser<'_, '_, '_>) {
    p.start_node(SyntaxKind::ERROR_NODE);
    while !matches!(p.peek(Context::Operand), SyntaxKind::NEWLINE | SyntaxKind::EOF) {
        p.bump(Context::Operand);
    }
    p.finish_node();
}

/// `start, stop AT %IX0.0 : BOOL := TRUE;`
pub(super) fn declaration(p: &mut Parser<'_, '_, '_>) -> (LineKind, Mode) {
    p.free_form = true;
    if let Err(problem) = declaration_parts(p) {
        if problem == DeclarationProblem::SemicolonMissing {
            // Behind what was read, not at the start of the next declaration.
            let at = p.at;
            p.error_at(SyntaxErrorKind::BadDeclaration(problem), at, at);
        } else {
            p.declaration_error(problem);
        }
        recover(p);
    }
    p.free_form = false;
    line_end(p);
    (LineKind::Declaration, Mode::Section)
}

/// Skips to behind the next `;`, or to the end of the physical line.
fn recover(p: &mut Parser<'_, '_, '_>) {
    if matches!(p.peek(Context::Operand), SyntaxKind::NEWLINE | SyntaxKind::EOF) {
        return;
    }
    p.start_node(SyntaxKind::ERROR_NODE);
    loop {
        match p.peek(Context::Operand) {
            SyntaxKind::NEWLINE | SyntaxKind::EOF => break,
            SyntaxKind::SEMICOLON => {
                p.bump(Context::Operand);
                break;
            }
            // END_VAR on the line closes the section all the same.
            SyntaxKind::IDENT if p.peek_text(Context::Operand).eq_ignore_ascii_case("END_VAR") => break,
            _ => p.bump(Context::Operand),
        }
    }
    p.finish_node();
}

fn declaration_parts(p: &mut Parser<'_, '_, '_>) -> Result<(), DeclarationProblem> {
    p.start_node(SyntaxKind::NAME_LIST);
    let names = name_list(p);
    p.finish_node();
    names?;
    p.skip_trivia(Context::Operand);
    if p.peek_text(Context::Operand).eq_ignore_ascii_case("AT") {
        p.start_node(SyntaxKind::AT_CLAUSE);
        p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
        p.skip_trivia(Context::Operand);
        let address = p.peek(Context::Operand) == SyntaxKind::ADDRESS;
        if address {
            p.bump(Context::Operand);
        }
        p.finish_node();
        if !address {
            return Err(DeclarationProblem::AddressExpected);
        }
        p.skip_trivia(Context::Operand);
    }
    if p.peek(Context::Operand) != SyntaxKind::COLON {
        return Err(DeclarationProblem::TypeExpected);
    }
    p.bump(Context::Operand);
    p.skip_trivia(Context::Operand);
    p.start_node(SyntaxKind::TYPE_REF);
    let ty = type_ref(p);
    p.finish_node();
    ty?;
    if expression::behind_blanks(p) == SyntaxKind::ASSIGN {
        p.skip_trivia(Context::Operand);
        p.start_node(SyntaxKind::INITIAL_VALUE);
        p.bump(Context::Operand);
        p.skip_trivia(Context::Operand);
        let value = initial_value(p);
        p.finish_node();
        value?;
    }
    if expression::behind_blanks(p) != SyntaxKind::SEMICOLON {
        return Err(DeclarationProblem::SemicolonMissing);
    }
    p.skip_trivia(Context::Operand);
    p.bump(Context::Operand);
    Ok(())
}

fn name_list(p: &mut Parser<'_, '_, '_>) -> Result<(), DeclarationProblem> {
    loop {
        if p.peek(Context::Operand) != SyntaxKind::IDENT || keyword_line(p).is_some() {
            return Err(DeclarationProblem::NameExpected);
        }
        p.bump(Context::Operand);
        if expression::behind_blanks(p) != SyntaxKind::COMMA {
            return Ok(());
        }
        p.skip_trivia(Context::Operand);
        p.bump(Context::Operand);
        p.skip_trivia(Context::Operand);
    }
}

/// `INT`, `STRING[80]`, `ARRAY[1..100] OF INT`
fn type_ref(p: &mut Parser<'_, '_, '_>) -> Result<(), DeclarationProblem> {
    if p.peek_text(Context::Operand).eq_ignore_ascii_case("ARRAY") {
        p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
        p.skip_trivia(Context::Operand);
        expect(p, SyntaxKind::L_BRACKET, DeclarationProblem::BoundsExpected)?;
        bound(p)?;
        expect(p, SyntaxKind::DOT_DOT, DeclarationProblem::BoundsExpected)?;
        bound(p)?;
        expect(p, SyntaxKind::R_BRACKET, DeclarationProblem::BoundsExpected)?;
        p.skip_trivia(Context::Operand);
        if !p.peek_text(Context::Operand).eq_ignore_ascii_case("OF") {
            return Err(DeclarationProblem::OfExpected);
        }
        p.bump_as(Context::Operand, SyntaxKind::KEYWORD);
        p.skip_trivia(Context::Operand);
    }
    if p.peek(Context::Operand) != SyntaxKind::IDENT {
        return Err(DeclarationProblem::TypeExpected);
    }
    let word = p.peek_text(Context::Operand);
    let known = is_one_of(word, &TYPES) || is_one_of(word, &MORE_TYPES);
    let string = word.eq_ignore_ascii_case("STRING");
    p.bump_as(
        Context::Operand,
        if known {
            SyntaxKind::KEYWORD
        } else {
            SyntaxKind::IDENT
        },
    );
    if string && expression::behind_blanks(p) == SyntaxKind::L_BRACKET {
        p.skip_trivia(Context::Operand);
        p.bump(Context::Operand);
        bound(p)?;
        expect(p, SyntaxKind::R_BRACKET, DeclarationProblem::BoundsExpected)?;
    }
    Ok(())
}

/// A whole number with an optional sign.
fn bound(p: &mut Parser<'_, '_, '_>) -> Result<(), DeclarationProblem> {
    p.skip_trivia(Context::Operand);
    if p.peek(Context::Operand) == SyntaxKind::MINUS {
        p.bump(Context::Operand);
        p.skip_trivia(Context::Operand);
    }
    expect(p, SyntaxKind::LITERAL, DeclarationProblem::BoundsExpected)
}

fn expect(
    p: &mut Parser<'_, '_, '_>,
    kind: SyntaxKind,
    problem: DeclarationProblem,
) -> Result<(), DeclarationProblem> {
    p.skip_trivia(Context::Operand);
    if p.peek(Context::Operand) != kind {
        return Err(problem);
    }
    p.bump(Context::Operand);
    Ok(())
}

/// A literal, an expression of literals, or a list of them in brackets.
fn initial_value(p: &mut Parser<'_, '_, '_>) -> Result<(), DeclarationProblem> {
    if p.peek(Context::Operand) == SyntaxKind::L_BRACKET {
        p.start_node(SyntaxKind::ARRAY_EXPR);
        p.bump(Context::Operand);
        p.terms = 0;
        expression::arguments(p, SyntaxKind::R_BRACKET);
        p.finish_node();
        return Ok(());
    }
    if matches!(
        p.peek(Context::Operand),
        SyntaxKind::SEMICOLON | SyntaxKind::NEWLINE | SyntaxKind::EOF
    ) {
        return Err(DeclarationProblem::ValueExpected);
    }
    p.terms = 0;
    expression::expression(p, 0);
    Ok(())
}

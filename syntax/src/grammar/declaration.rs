//! Sections, declarations and the first and last line of a block definition (LANGUAGE §4, §5.7).

use super::{MAX_DEPTH, Parser, block, expression, plain};
use crate::builder::Builder;
use crate::conflict::OpenConflicts;
use crate::error::{DeclarationProblem, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::lexer;
use crate::line::{LineKind, Mode};
use crate::name::longest;

/// The keyword that a line begins with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum KeywordLine {
    Section,
    SectionEnd,
    StructEnd,
    Block,
    BlockEnd,
}

const SECTIONS: [&str; 7] = [
    "TYPE",
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

const KEYWORDS: [&str; 11] = [
    "END_VAR",
    "END_TYPE",
    "STRUCT",
    "END_STRUCT",
    "RETAIN",
    "CONSTANT",
    "AT",
    "ARRAY",
    "OF",
    "FUNCTION_BLOCK",
    "END_FUNCTION_BLOCK",
];

/// No word of these lists is longer.
const LONGEST_KEYWORD: usize = longest(&KEYWORDS);
const _: () = assert!(longest(&SECTIONS) <= LONGEST_KEYWORD && longest(&TYPES) <= LONGEST_KEYWORD);
const _: () = assert!(longest(&MORE_TYPES) <= LONGEST_KEYWORD);

fn is_one_of(word: &str, words: &[&str]) -> bool {
    words.iter().any(|w| w.eq_ignore_ascii_case(word))
}

/// Whether a word is a keyword inside declarations, so that it can name no tag.
pub fn is_declaration_keyword(word: &str) -> bool {
    // Most names have a digit or another sign that no keyword has.
    if word.len() > LONGEST_KEYWORD || word.bytes().any(|b| !b.is_ascii_alphabetic() && b != b'_') {
        return false;
    }
    is_one_of(word, &SECTIONS) || is_type_keyword(word) || is_one_of(word, &KEYWORDS)
}

/// Whether a word is the name of an elementary type or of a block type.
pub fn is_type_keyword(word: &str) -> bool {
    is_one_of(word, &TYPES) || is_one_of(word, &MORE_TYPES)
}

fn keyword(word: &str) -> Option<KeywordLine> {
    if is_one_of(word, &SECTIONS) {
        return Some(KeywordLine::Section);
    }
    match word.to_ascii_uppercase().as_str() {
        "END_VAR" | "END_TYPE" => Some(KeywordLine::SectionEnd),
        "END_STRUCT" => Some(KeywordLine::StructEnd),
        "FUNCTION_BLOCK" => Some(KeywordLine::Block),
        "END_FUNCTION_BLOCK" => Some(KeywordLine::BlockEnd),
        _ => None,
    }
}

/// The keyword that begins at a place.
pub(super) fn keyword_at(text: &str, at: usize) -> Option<KeywordLine> {
    // All begin with V, E, F or T: most lines are told apart by one byte.
    if !matches!(
        text.as_bytes().get(at),
        Some(b'V' | b'v' | b'E' | b'e' | b'F' | b'f' | b'T' | b't')
    ) {
        return None;
    }
    keyword(&text[at..lexer::identifier_end(text, at)?])
}

/// Whether a line that begins with this byte, after white space and comments, ends a section that is still
/// open (LANGUAGE §4).
pub(super) const fn begins_drawing(byte: u8) -> bool {
    matches!(byte, b'+' | b'|' | b'\\' | b'/' | b'[' | b'<')
}

/// Whether the physical line that begins at `at` ends an open declaration: it belongs to the drawing, to
/// another section or to a block definition.
pub(super) fn ends_declaration(text: &str, at: usize, open: OpenConflicts) -> bool {
    let mut at = at;
    while let Some((SyntaxKind::WHITESPACE | SyntaxKind::COMMENT, end)) = lexer::space(text, at, open) {
        at = end;
    }
    text.as_bytes().get(at).is_some_and(|&b| begins_drawing(b)) || keyword_at(text, at).is_some()
}

/// `VAR_INPUT RETAIN`, `TYPE`
pub(super) fn section_header<B: Builder>(p: &mut Parser<'_, '_, B>) -> (LineKind, Mode) {
    let end = lexer::identifier_end(p.text, p.at).unwrap_or(p.at);
    let mode = if p.text[p.at..end].eq_ignore_ascii_case("TYPE") {
        Mode::Types
    } else {
        Mode::Section
    };
    keyword_token(p);
    let mut qualified = false;
    loop {
        blanks(p);
        let Some(end) = lexer::identifier_end(p.text, p.at) else {
            break;
        };
        if !is_one_of(&p.text[p.at..end], &["RETAIN", "CONSTANT", "NON_RETAIN"]) {
            break;
        }
        if qualified || mode == Mode::Types {
            let problem = DeclarationProblem::Unexpected;
            p.error(SyntaxErrorKind::BadDeclaration(problem), p.at, end);
        }
        qualified = true;
        p.token((SyntaxKind::KEYWORD, end));
    }
    line_end(p);
    (LineKind::SectionHeader, mode)
}

/// What is wrong with the END_VAR or END_TYPE that is here.
pub(super) fn wrong_end<B: Builder>(p: &Parser<'_, '_, B>, mode: Mode) -> Option<DeclarationProblem> {
    let end = lexer::identifier_end(p.text, p.at)?;
    let of_types = p.text[p.at..end].eq_ignore_ascii_case("END_TYPE");
    match mode {
        Mode::Struct { .. } => Some(DeclarationProblem::StructNotClosed),
        _ if of_types != mode.is_in_types() => Some(DeclarationProblem::OtherEnd),
        _ => None,
    }
}

/// `END_VAR`, `END_TYPE`
pub(super) fn section_end<B: Builder>(p: &mut Parser<'_, '_, B>) -> (LineKind, Mode) {
    keyword_token(p);
    rest_of_line(p, DeclarationProblem::LineNotEnded);
    line_end(p);
    (LineKind::SectionEnd, Mode::Network)
}

/// `FUNCTION_BLOCK [$Name]`
pub(super) fn block_header<B: Builder>(p: &mut Parser<'_, '_, B>) -> (LineKind, Mode) {
    keyword_token(p);
    blanks(p);
    let expected = SyntaxErrorKind::BadDeclaration(DeclarationProblem::BlockHeadExpected);
    match lexer::on_rung(p.text, p.at, p.open) {
        (open @ (SyntaxKind::L_BRACKET | SyntaxKind::L_PAREN | SyntaxKind::L_ANGLE), _) => {
            let (from, errors) = (p.at, p.errors.len());
            if !block::head(p, open) && p.errors.len() == errors {
                p.error(expected, from, p.last_end);
            }
            rest_of_line(p, DeclarationProblem::Unexpected);
        }
        (SyntaxKind::NEWLINE | SyntaxKind::EOF, _) => p.error_after(expected),
        _ => rest_of_line(p, DeclarationProblem::BlockHeadExpected),
    }
    line_end(p);
    (LineKind::BlockHeader, Mode::Network)
}

/// `END_FUNCTION_BLOCK`
pub(super) fn block_end<B: Builder>(p: &mut Parser<'_, '_, B>) -> (LineKind, Mode) {
    keyword_token(p);
    rest_of_line(p, DeclarationProblem::LineNotEnded);
    line_end(p);
    (LineKind::BlockEnd, Mode::Network)
}

/// Takes the word that begins here as a keyword.
fn keyword_token<B: Builder>(p: &mut Parser<'_, '_, B>) {
    let end = lexer::in_head(p.text, p.at, p.open).1;
    p.token((SyntaxKind::KEYWORD, end));
}

/// White space and comments on the same line.
fn blanks<B: Builder>(p: &mut Parser<'_, '_, B>) {
    while let Some(token @ (SyntaxKind::WHITESPACE | SyntaxKind::COMMENT, _)) =
        lexer::space(p.text, p.at, p.open)
    {
        p.token(token);
    }
}

/// What belongs to a line after its last token: white space, comments, the line end. Anything else begins a
/// new logical line.
fn line_end<B: Builder>(p: &mut Parser<'_, '_, B>) {
    blanks(p);
    if let Some(token) = lexer::space(p.text, p.at, p.open) {
        p.token(token);
    }
}

/// Takes what is here up to the line end as one error, if something does.
fn rest_of_line<B: Builder>(p: &mut Parser<'_, '_, B>, problem: DeclarationProblem) {
    blanks(p);
    let from = p.at;
    // A drawing or a keyword is a line of its own, which says that it should be on one.
    if begins_drawing(p.byte(from)) || p.byte(from) == b'-' || keyword_at(p.text, from).is_some() {
        return;
    }
    p.look();
    if matches!(p.next(), SyntaxKind::NEWLINE | SyntaxKind::EOF) {
        return;
    }
    p.start_node(SyntaxKind::ERROR_NODE);
    while !matches!(p.next(), SyntaxKind::NEWLINE | SyntaxKind::EOF) {
        p.bump();
    }
    p.finish_node();
    p.error(SyntaxErrorKind::BadDeclaration(problem), from, p.last_end);
}

/// `END_STRUCT;`, with the structure's initial value before the `;`.
pub(super) fn struct_end<B: Builder>(p: &mut Parser<'_, '_, B>, mode: Mode) -> (LineKind, Mode) {
    p.free_form = true;
    p.look();
    p.bump_as(SyntaxKind::KEYWORD);
    let read = initial_clause(p).and_then(|()| semicolon(p));
    report(p, read);
    line_end(p);
    (LineKind::StructEnd, mode.closed())
}

/// `start, stop AT %IX0.0 : BOOL := TRUE;`, in TYPE `Speed : REAL := 1.0;`, or `Motor : STRUCT`.
pub(super) fn declaration<B: Builder>(p: &mut Parser<'_, '_, B>, mode: Mode) -> (LineKind, Mode) {
    if B::SKIPS_PLAIN_DECLARATIONS
        && let Some(end) = plain::plain_declaration(p.text, p.at)
    {
        p.at = end;
        p.last_end = end;
        line_end(p);
        return (LineKind::Declaration, mode);
    }
    p.free_form = true;
    p.look();
    let read = declaration_parts(p, mode);
    let is_struct = matches!(read, Ok(Declared::Struct));
    report(p, read.map(|_| ()));
    line_end(p);
    if is_struct {
        (LineKind::StructHeader, mode.opened())
    } else {
        (LineKind::Declaration, mode)
    }
}

/// Says what a declaration lacks, and goes on after it.
fn report<B: Builder>(p: &mut Parser<'_, '_, B>, read: Result<(), DeclarationProblem>) {
    if let Err(problem) = read {
        // What is missing is missing after what was read, not at the start of the next line's declaration.
        let next_line = p.text[p.at..p.ahead.start].contains(['\n', '\r']);
        let ends = p.next() == SyntaxKind::SEMICOLON;
        if next_line || ends_section(p) || problem == DeclarationProblem::SemicolonMissing {
            p.error_after(SyntaxErrorKind::BadDeclaration(problem));
        } else {
            p.declaration_error(problem);
        }
        if ends {
            p.bump_last_as(SyntaxKind::SEMICOLON);
        } else if !next_line {
            recover(p);
        }
    }
}

/// What a declaration turned out to be.
enum Declared {
    Whole,
    /// Its members follow.
    Struct,
}

/// Whether END_VAR or its like is ahead: it closes the section, whatever lacks before it.
fn ends_section<B: Builder>(p: &Parser<'_, '_, B>) -> bool {
    p.next() == SyntaxKind::IDENT
        && matches!(
            keyword_at(p.text, p.ahead.start),
            Some(KeywordLine::SectionEnd | KeywordLine::StructEnd)
        )
}

/// Skips to after the next `;`, or to the end of the physical line.
fn recover<B: Builder>(p: &mut Parser<'_, '_, B>) {
    let ends =
        |p: &Parser<'_, '_, B>| matches!(p.next(), SyntaxKind::NEWLINE | SyntaxKind::EOF) || ends_section(p);
    p.free_form = false;
    p.look();
    if ends(p) {
        return;
    }
    p.space();
    p.start_node(SyntaxKind::ERROR_NODE);
    while !ends(p) {
        if p.next() == SyntaxKind::SEMICOLON {
            p.bump_last_as(SyntaxKind::SEMICOLON);
            break;
        }
        p.bump();
    }
    p.finish_node();
}

fn declaration_parts<B: Builder>(
    p: &mut Parser<'_, '_, B>,
    mode: Mode,
) -> Result<Declared, DeclarationProblem> {
    p.space();
    p.start_node(SyntaxKind::NAME_LIST);
    let names = name_list(p);
    p.finish_node();
    names?;
    if p.next_is_word("AT") {
        p.space();
        p.start_node(SyntaxKind::AT_CLAUSE);
        p.bump_as(SyntaxKind::KEYWORD);
        let address = p.next() == SyntaxKind::ADDRESS;
        if address {
            p.bump();
        }
        p.finish_node();
        if !address {
            return Err(DeclarationProblem::AddressExpected);
        }
    }
    expect(p, SyntaxKind::COLON, DeclarationProblem::TypeExpected)?;
    if p.next_is_word("STRUCT") {
        match mode {
            Mode::Struct { .. } => p.declaration_error(DeclarationProblem::NestedStruct),
            Mode::Section => p.declaration_error(DeclarationProblem::StructOutsideTypes),
            Mode::Types | Mode::Network => {}
        }
        p.bump_last_as(SyntaxKind::KEYWORD);
        return Ok(Declared::Struct);
    }
    p.space();
    if p.next() == SyntaxKind::L_PAREN && mode != Mode::Types {
        p.declaration_error(DeclarationProblem::EnumerationOutsideTypes);
    }
    type_ref(p)?;
    initial_clause(p)?;
    semicolon(p)?;
    Ok(Declared::Whole)
}

/// `:= 5`, where it is.
fn initial_clause<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    if p.next() != SyntaxKind::ASSIGN {
        return Ok(());
    }
    p.space();
    p.start_node(SyntaxKind::INITIAL_VALUE);
    p.bump();
    let value = initial_value(p);
    p.finish_node();
    value
}

fn semicolon<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    if p.next() != SyntaxKind::SEMICOLON {
        return Err(DeclarationProblem::SemicolonMissing);
    }
    p.bump_last_as(SyntaxKind::SEMICOLON);
    Ok(())
}

fn name_list<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    loop {
        if p.next() != SyntaxKind::IDENT || keyword_at(p.text, p.ahead.start).is_some() {
            return Err(DeclarationProblem::NameExpected);
        }
        p.bump();
        if p.next() != SyntaxKind::COMMA {
            return Ok(());
        }
        p.bump();
    }
}

/// `INT`, `STRING[80]`, `ARRAY[1..100] OF INT`, `(IDLE, FILLING)`, `INT(0..100)`, `$Motor`
fn type_ref<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    p.start_node(SyntaxKind::TYPE_REF);
    let read = type_parts(p);
    p.finish_node();
    read
}

fn type_parts<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    if p.next() == SyntaxKind::L_PAREN {
        return enumeration(p);
    }
    if p.next_is_word("ARRAY") {
        p.bump_as(SyntaxKind::KEYWORD);
        expect(p, SyntaxKind::L_BRACKET, DeclarationProblem::BoundsExpected)?;
        loop {
            bounds(p)?;
            if p.next() != SyntaxKind::COMMA {
                break;
            }
            p.bump();
        }
        expect(p, SyntaxKind::R_BRACKET, DeclarationProblem::BoundsExpected)?;
        if !p.next_is_word("OF") {
            return Err(DeclarationProblem::OfExpected);
        }
        p.bump_as(SyntaxKind::KEYWORD);
        if p.next_is_word("ARRAY") && p.depth < MAX_DEPTH {
            p.depth += 1;
            p.space();
            let element = type_ref(p);
            p.depth -= 1;
            return element;
        }
    }
    take_block_name(p);
    if p.next() == SyntaxKind::BLOCK_NAME {
        p.bump();
        return Ok(());
    }
    if p.next() != SyntaxKind::IDENT || keyword_at(p.text, p.ahead.start).is_some() {
        return Err(DeclarationProblem::TypeExpected);
    }
    let word = p.next_text();
    let known = is_one_of(word, &TYPES) || is_one_of(word, &MORE_TYPES);
    p.bump_as(if known {
        SyntaxKind::KEYWORD
    } else {
        SyntaxKind::IDENT
    });
    if word.eq_ignore_ascii_case("STRING") && p.next() == SyntaxKind::L_BRACKET {
        p.bump();
        bound(p)?;
        expect(p, SyntaxKind::R_BRACKET, DeclarationProblem::BoundsExpected)?;
    } else if p.next() == SyntaxKind::L_PAREN {
        p.bump();
        bounds(p)?;
        expect(p, SyntaxKind::R_PAREN, DeclarationProblem::BoundsExpected)?;
    }
    Ok(())
}

/// Among operands a `$` means nothing; before a type's name it is the name of a block.
fn take_block_name<B: Builder>(p: &mut Parser<'_, '_, B>) {
    if p.byte(p.ahead.start) == b'$'
        && let Some(end) = lexer::identifier_end(p.text, p.ahead.start + 1)
    {
        p.ahead.kind = SyntaxKind::BLOCK_NAME;
        p.ahead.end = end;
    }
}

/// `(IDLE, FILLING, MIXING := 10)`
fn enumeration<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    p.bump();
    loop {
        if p.next() != SyntaxKind::IDENT || keyword_at(p.text, p.ahead.start).is_some() {
            return Err(DeclarationProblem::EnumerationValueExpected);
        }
        p.space();
        p.start_node(SyntaxKind::ENUM_VALUE);
        p.bump();
        let number = if p.next() == SyntaxKind::ASSIGN {
            p.bump();
            bound(p)
        } else {
            Ok(())
        };
        p.finish_node();
        number?;
        if p.next() != SyntaxKind::COMMA {
            break;
        }
        p.bump();
    }
    expect(
        p,
        SyntaxKind::R_PAREN,
        DeclarationProblem::EnumerationValueExpected,
    )
}

/// `1..9`
fn bounds<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    bound(p)?;
    expect(p, SyntaxKind::DOT_DOT, DeclarationProblem::BoundsExpected)?;
    bound(p)
}

/// A whole number with an optional sign, or the name of a constant.
fn bound<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    if p.next() == SyntaxKind::MINUS {
        p.bump();
    }
    if p.next() == SyntaxKind::IDENT && !ends_section(p) && !p.next_is_word("OF") {
        p.bump();
        return Ok(());
    }
    expect(p, SyntaxKind::LITERAL, DeclarationProblem::BoundsExpected)
}

fn expect<B: Builder>(
    p: &mut Parser<'_, '_, B>,
    kind: SyntaxKind,
    problem: DeclarationProblem,
) -> Result<(), DeclarationProblem> {
    if p.next() != kind {
        return Err(problem);
    }
    p.bump();
    Ok(())
}

/// A literal, an expression of literals, the values of a structure, or a list of such in brackets.
fn initial_value<B: Builder>(p: &mut Parser<'_, '_, B>) -> Result<(), DeclarationProblem> {
    p.terms = 0;
    p.too_complex = false;
    if !expression::begins_value(p) || ends_section(p) {
        return Err(DeclarationProblem::ValueExpected);
    }
    expression::expression(p, 0);
    Ok(())
}

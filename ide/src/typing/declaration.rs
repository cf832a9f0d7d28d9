//! Where in a declaration a person types.

use super::{Token, Typing};
use ladder_syntax::SyntaxKind;

/// A place in a declaration.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Declaration {
    /// After a section's keyword: RETAIN or CONSTANT.
    Header,
    /// Where a name is declared; whether it is the first thing on its line.
    Names(bool),
    /// After names: AT.
    AfterNames,
    /// After AT.
    Address,
    /// After the colon.
    Type,
    /// Inside of ARRAY's bounds.
    Bounds,
    /// After ARRAY with its bounds.
    Of,
    /// After `:=`.
    Initial,
}

/// The place of the word that is written.
pub(super) fn declaration(tokens: &[Token], typing: &Typing<'_>) -> Option<Declaration> {
    let line = typing.physical_line();
    let alone = typing.text[line.start..typing.word.start].trim().is_empty();
    let mut place = Declaration::Names(alone);
    for token in tokens.iter().take_while(|token| token.end <= typing.word.start) {
        let word = &typing.text[token.start..token.end];
        place = match token.kind {
            kind if kind.is_trivia() => continue,
            SyntaxKind::KEYWORD if word.eq_ignore_ascii_case("AT") => Declaration::Address,
            SyntaxKind::KEYWORD if word.eq_ignore_ascii_case("OF") => Declaration::Type,
            SyntaxKind::COLON => Declaration::Type,
            SyntaxKind::ASSIGN => Declaration::Initial,
            SyntaxKind::COMMA if matches!(place, Declaration::Names(_) | Declaration::AfterNames) => {
                Declaration::Names(false)
            }
            SyntaxKind::SEMICOLON => Declaration::Names(alone),
            SyntaxKind::L_BRACKET if place == Declaration::Type => Declaration::Bounds,
            SyntaxKind::R_BRACKET if place == Declaration::Bounds => Declaration::Of,
            _ if matches!(place, Declaration::Names(_)) => Declaration::AfterNames,
            // After a type nothing is to be named.
            _ => place,
        };
    }
    // A half-written line is read together with the one below it: a new physical line begins a new declaration.
    if alone && !matches!(place, Declaration::Names(_)) {
        place = Declaration::Names(true);
    }
    let number = typing.text[typing.word.clone()].starts_with(|c: char| c.is_ascii_digit());
    (!number).then_some(place)
}

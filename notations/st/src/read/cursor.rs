//! The place in the tokens where a parser is, what it found wrong, and how it goes on after that.

use super::dialect::Dialect;
use super::token::{Token, TokenKind, Tokens, tokens};
use super::tree::{Problem, Span};

/// Statements and expressions nest no deeper.
const DEEPEST: usize = 60;

/// So much is reported of one text.
const MOST_PROBLEMS: usize = 50;

/// A parser of a text.
pub(super) struct Cursor<'t> {
    pub(super) text: &'t str,
    pub(super) dialect: Dialect,
    pub(super) found: Tokens,
    pub(super) at: usize,
    depth: usize,
    pub(super) problems: Vec<Problem>,
}

/// What stops a statement: it is already reported.
pub(super) struct Stopped;

pub(super) type Parsed<T> = Result<T, Stopped>;

/// The words that end statements or begin the next part of one: recovery stops at them.
const BOUNDARIES: [&str; 24] = [
    "END_IF",
    "END_CASE",
    "END_FOR",
    "END_WHILE",
    "END_REPEAT",
    "ELSE",
    "ELSIF",
    "UNTIL",
    "END_PROGRAM",
    "END_FUNCTION_BLOCK",
    "END_FUNCTION",
    "END_ACTION",
    "END_METHOD",
    "END_VAR",
    "END_TYPE",
    "END_ORGANIZATION_BLOCK",
    "IF",
    "CASE",
    "FOR",
    "WHILE",
    "REPEAT",
    "PROGRAM",
    "FUNCTION_BLOCK",
    "FUNCTION",
];

impl<'t> Cursor<'t> {
    pub(super) fn new(text: &'t str, dialect: Dialect) -> Cursor<'t> {
        Cursor {
            text,
            dialect,
            found: tokens(text, dialect),
            at: 0,
            depth: 0,
            problems: Vec::new(),
        }
    }

    pub(super) fn token(&self) -> &Token {
        &self.found.tokens[self.at]
    }

    pub(super) fn kind(&self) -> TokenKind {
        self.token().kind
    }

    pub(super) fn span(&self) -> Span {
        self.token().span.clone()
    }

    /// Where the last token ended.
    pub(super) fn end(&self) -> usize {
        self.at
            .checked_sub(1)
            .map_or(0, |last| self.found.tokens[last].span.end)
    }

    /// The text of a token some places further.
    pub(super) fn ahead(&self, by: usize) -> (TokenKind, &'t str) {
        let last = self.found.tokens.len() - 1;
        let token = &self.found.tokens[(self.at + by).min(last)];
        (token.kind, &self.text[token.span.clone()])
    }

    pub(super) fn word(&self) -> &'t str {
        self.ahead(0).1
    }

    pub(super) fn bump(&mut self) {
        self.at += usize::from(self.kind() != TokenKind::End);
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.kind() == TokenKind::End
    }

    pub(super) fn is_sign(&self, sign: &str) -> bool {
        matches!(self.kind(), TokenKind::Sign(own) if own == sign)
    }

    pub(super) fn is_word(&self, word: &str) -> bool {
        self.kind() == TokenKind::Word && self.word().eq_ignore_ascii_case(word)
    }

    pub(super) fn is_any(&self, words: &[&str]) -> bool {
        words.iter().any(|word| self.is_word(word))
    }

    pub(super) fn take_sign(&mut self, sign: &str) -> bool {
        let found = self.is_sign(sign);
        self.at += usize::from(found);
        found
    }

    pub(super) fn take_word(&mut self, word: &str) -> bool {
        let found = self.is_word(word);
        self.at += usize::from(found);
        found
    }

    pub(super) fn expect_sign(&mut self, sign: &str) -> Parsed<()> {
        if self.take_sign(sign) {
            return Ok(());
        }
        self.expected(&format!("`{sign}`"))
    }

    pub(super) fn expect_word(&mut self, word: &str) -> Parsed<()> {
        if self.take_word(word) {
            return Ok(());
        }
        self.expected(&format!("`{word}`"))
    }

    /// Reports that something else is expected here.
    pub(super) fn expected<T>(&mut self, what: &str) -> Parsed<T> {
        let found = match self.kind() {
            TokenKind::End => "the end of the text".to_owned(),
            _ => format!(
                "`{}`",
                self.word()
                    .lines()
                    .next()
                    .unwrap_or_default()
                    .chars()
                    .take(40)
                    .collect::<String>()
            ),
        };
        let span = self.span();
        self.problem(span, format!("{what} is expected here, not {found}"))
    }

    pub(super) fn problem<T>(&mut self, span: Span, message: impl Into<String>) -> Parsed<T> {
        let message = message.into();
        if self.problems.len() < MOST_PROBLEMS {
            self.problems.push(Problem { span, message });
        }
        Err(Stopped)
    }

    /// A name as it is meant, without `#` and quotation marks.
    pub(super) fn name(&mut self) -> Parsed<String> {
        if !matches!(self.kind(), TokenKind::Word | TokenKind::Name) {
            return self.expected("a name");
        }
        let name = self.word().trim_start_matches('#').trim_matches('"').to_owned();
        self.bump();
        Ok(name)
    }

    /// Reads what is nested in something. What nests too deep ends the text.
    pub(super) fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Parsed<T>) -> Parsed<T> {
        if self.depth == DEEPEST {
            let span = self.span();
            self.at = self.found.tokens.len() - 1;
            return self.problem(
                span,
                format!("statements and parentheses nest deeper than {DEEPEST} here"),
            );
        }
        self.depth += 1;
        let read = read(self);
        self.depth -= 1;
        read
    }

    /// Goes on after the next `;`, or at a word that begins or ends a statement.
    pub(super) fn recover(&mut self) {
        while !self.is_at_end() && !self.is_any(&BOUNDARIES) {
            if self.take_sign(";") {
                return;
            }
            self.bump();
        }
    }
}

//! The tokens of Structured Text, with their places in the text.

use super::dialect::Dialect;
use std::ops::Range;

/// From one byte of the text to another.
pub(super) type Span = Range<usize>;

/// A token.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Token {
    pub(super) kind: TokenKind,
    pub(super) span: Span,
}

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TokenKind {
    /// A word: a keyword, or the name of something.
    Word,
    /// A name that cannot be a keyword: `#local`, `"odd name"`
    Name,
    /// `12`, `16#FF`
    Integer,
    /// `1.5e-3`
    Real,
    /// `T#5s`, `INT#5`, `Phase#IDLE`
    Typed,
    /// `'text'`, `"text"`
    Text,
    /// `%IX0.0`, and the `%X3` of a part of a word
    Address,
    /// `:=`
    Sign(&'static str),
    /// `{...}` that chooses what is compiled, or `{...}` and `{{...}}` with text in C.
    Pragma,
    /// What no token begins with, and what is not closed.
    Stray,
    /// After the last one.
    End,
}

/// A comment, a title of a region: what is inside.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Comment {
    pub(super) span: Span,
    pub(super) text: String,
}

/// The tokens of a text, and the comments between them.
#[derive(Debug, Default)]
pub(super) struct Tokens {
    pub(super) tokens: Vec<Token>,
    pub(super) comments: Vec<Comment>,
}

const SIGNS: [&str; 30] = [
    "[:=]", ":=", "=>", "<>", "<=", ">=", "**", "..", "+=", "-=", "*=", "/=", "(", ")", "[", "]", ",", ";",
    ":", ".", "+", "-", "*", "/", "=", "<", ">", "&", "^", "|",
];

/// The prefixes of literals whose value holds `-` and `:`.
const DATES: [&str; 9] = [
    "D",
    "DATE",
    "LDATE",
    "LD",
    "DT",
    "DATE_AND_TIME",
    "LDT",
    "TOD",
    "TIME_OF_DAY",
];

/// Pragmas that change nothing. Others choose what is compiled, or are text in C.
const PRAGMAS: [&str; 10] = [
    "attribute",
    "region",
    "endregion",
    "warning",
    "info",
    "text",
    "s7_",
    "enable code generation",
    "disable code generation",
    "analysis",
];

/// The tokens of a text.
pub(super) fn tokens(text: &str, dialect: Dialect) -> Tokens {
    let mut lexer = Lexer {
        text,
        dialect,
        at: 0,
        nests: dialect.nests_comments(),
        found: Tokens::default(),
    };
    while lexer.at < text.len() {
        lexer.step();
    }
    lexer.push(TokenKind::End, 0);
    lexer.found
}

/// The first two words of a text, if comments and pragmas are all that is before them.
pub(super) fn first_words(text: &str) -> Option<(&str, &str)> {
    let mut lexer = Lexer {
        text,
        dialect: Dialect::Iec,
        at: 0,
        nests: true,
        found: Tokens::default(),
    };
    while lexer.at < text.len() && lexer.found.tokens.len() < 2 {
        lexer.step();
    }
    match &lexer.found.tokens[..] {
        [first, second] => Some((&text[first.span.clone()], &text[second.span.clone()])),
        _ => None,
    }
}

struct Lexer<'t> {
    text: &'t str,
    dialect: Dialect,
    at: usize,
    nests: bool,
    found: Tokens,
}

impl<'t> Lexer<'t> {
    fn rest(&self) -> &'t str {
        &self.text[self.at..]
    }

    fn push(&mut self, kind: TokenKind, length: usize) {
        let span = self.at..self.at + length;
        self.at = span.end;
        self.found.tokens.push(Token { kind, span });
    }

    /// Passes over a comment; what it says is between two offsets of what is left.
    fn comment(&mut self, length: usize, inside: Span) {
        let text = self.rest()[inside].trim().to_owned();
        let span = self.at..self.at + length;
        self.at = span.end;
        if !text.is_empty() {
            self.found.comments.push(Comment { span, text });
        }
    }

    fn step(&mut self) {
        let rest = self.rest();
        let first = rest.chars().next().unwrap_or(' ');
        if first.is_whitespace() || first == '\u{feff}' {
            self.at += first.len_utf8();
            return;
        }
        if rest.starts_with("//") {
            let length = line_length(rest);
            return self.comment(length, 2..length);
        }
        if rest.starts_with("/*") || rest.starts_with("(*") {
            return self.block_comment();
        }
        match first {
            '{' => self.pragma(),
            '#' => self.after_hash(),
            '\'' => self.quoted('\'', TokenKind::Text),
            '"' if self.dialect.quotes_names() => self.quoted('"', TokenKind::Name),
            '"' => self.quoted('"', TokenKind::Text),
            '%' => {
                let goes_on = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.' | '*' | '%');
                let length = rest.find(|c| !goes_on(c)).unwrap_or(rest.len());
                // A range or the end of a sentence begins with what is left.
                let length = rest[..length].find("..").unwrap_or(length);
                self.push(TokenKind::Address, length);
            }
            '0'..='9' => self.number(),
            _ if is_name(first) => self.word(),
            '；' => self.push(TokenKind::Sign(";"), first.len_utf8()),
            _ => {
                let mut signs = SIGNS
                    .iter()
                    .filter(|sign| **sign != "[:=]" || self.dialect == Dialect::Logix);
                match signs.find(|sign| rest.starts_with(**sign)) {
                    Some(sign) => self.push(TokenKind::Sign(sign), sign.len()),
                    None => self.push(TokenKind::Stray, first.len_utf8()),
                }
            }
        }
    }

    fn block_comment(&mut self) {
        let rest = self.rest();
        let (open, close) = if rest.starts_with("/*") {
            ("/*", "*/")
        } else {
            ("(*", "*)")
        };
        if let Some(length) = line_of_debugger(rest) {
            self.at += length;
            return;
        }
        if let Some(length) = description_length(rest) {
            return self.comment(length, DESCRIPTION.0.len()..length - DESCRIPTION.1.len());
        }
        let plain = || rest[2..].find(close).map(|at| at + 4);
        let length = if self.nests && open == "(*" {
            let nested = nested_length(rest);
            // Comments that do not nest to the end do not nest at all.
            self.nests = nested.is_some();
            nested.or_else(plain)
        } else {
            plain()
        };
        match length {
            Some(length) => self.comment(length, 2..length - 2),
            None => self.push(TokenKind::Stray, rest.len()),
        }
    }

    fn pragma(&mut self) {
        let rest = self.rest();
        let close = if rest.starts_with("{{") { "}}" } else { "}" };
        let Some(end) = rest.find(close) else {
            return self.push(TokenKind::Stray, rest.len());
        };
        let inside = rest[1..end].trim_start();
        let is_idle = PRAGMAS.iter().any(|word| {
            let begin = inside.get(..word.len());
            begin.is_some_and(|begin| begin.eq_ignore_ascii_case(word))
        });
        if is_idle {
            self.at += end + close.len();
        } else {
            self.push(TokenKind::Pragma, end + close.len());
        }
    }

    /// `#local` of SCL, `#region` of Logix.
    fn after_hash(&mut self) {
        let rest = self.rest();
        let after = &rest[1..];
        if self.dialect == Dialect::Logix {
            let word = name_length(after);
            let length = line_length(rest);
            return match &after[..word].to_ascii_lowercase()[..] {
                "region" => self.comment(length, word + 1..length),
                "endregion" => self.at += length,
                _ => self.push(TokenKind::Stray, 1),
            };
        }
        if self.dialect.quotes_names() && after.starts_with('"') {
            let start = self.at;
            self.at += 1;
            self.quoted('"', TokenKind::Name);
            if let Some(last) = self.found.tokens.last_mut() {
                last.span.start = start;
            }
            return;
        }
        let length = name_length(after);
        if self.dialect.quotes_names() && length > 0 {
            self.push(TokenKind::Name, length + 1);
        } else {
            self.push(TokenKind::Stray, 1);
        }
    }

    fn quoted(&mut self, quote: char, kind: TokenKind) {
        let rest = self.rest();
        let mut chars = rest.char_indices().skip(1);
        while let Some((at, c)) = chars.next() {
            match c {
                '$' if kind == TokenKind::Text => {
                    chars.next();
                }
                '\n' => return self.push(TokenKind::Stray, at),
                c if c == quote => return self.push(kind, at + 1),
                _ => {}
            }
        }
        self.push(TokenKind::Stray, rest.len());
    }

    fn number(&mut self) {
        let rest = self.rest();
        let is_bit = self
            .found
            .tokens
            .last()
            .is_some_and(|last| last.kind == TokenKind::Sign(".") && last.span.end == self.at);
        let mut length = digits(rest);
        if is_bit {
            return self.push(TokenKind::Integer, length);
        }
        if rest[length..].starts_with('#') {
            let based = rest[length + 1..].find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            return self.push(TokenKind::Integer, based.map_or(rest.len(), |at| length + 1 + at));
        }
        let is_real = rest[length..].starts_with('.') && digits(&rest[length + 1..]) > 0;
        if is_real {
            length += 1 + digits(&rest[length + 1..]);
        }
        let exponent = exponent_length(&rest[length..]);
        length += exponent;
        let kind = if is_real || exponent > 0 {
            TokenKind::Real
        } else {
            TokenKind::Integer
        };
        self.push(kind, length);
    }

    fn word(&mut self) {
        let rest = self.rest();
        let length = name_length(rest);
        let word = &rest[..length];
        let after = &rest[length..];
        if self.dialect.quotes_names()
            && ["REGION", "END_REGION"]
                .iter()
                .any(|own| word.eq_ignore_ascii_case(own))
        {
            let whole = line_length(rest);
            return if word.len() == "REGION".len() {
                self.comment(whole, length..whole);
            } else {
                self.at += length;
            };
        }
        if let Some(value) = after.strip_prefix('#') {
            let value = typed_length(word, value);
            if value > 0 {
                return self.push(TokenKind::Typed, length + 1 + value);
            }
        }
        self.push(TokenKind::Word, length);
    }
}

fn is_name(c: char) -> bool {
    c.is_alphabetic() || c == '_'
}

fn name_length(text: &str) -> usize {
    text.find(|c: char| !c.is_alphanumeric() && c != '_')
        .unwrap_or(text.len())
}

fn line_length(text: &str) -> usize {
    text.find(['\n', '\r']).unwrap_or(text.len())
}

fn digits(text: &str) -> usize {
    if !text.starts_with(|c: char| c.is_ascii_digit()) {
        return 0;
    }
    text.find(|c: char| !c.is_ascii_digit() && c != '_')
        .unwrap_or(text.len())
}

/// `e-3`
fn exponent_length(text: &str) -> usize {
    let Some(after) = text.strip_prefix(['e', 'E']) else {
        return 0;
    };
    let sign = usize::from(after.starts_with(['+', '-']));
    match digits(&after[sign..]) {
        0 => 0,
        digits => 1 + sign + digits,
    }
}

/// How long the value of a typed literal is.
fn typed_length(prefix: &str, text: &str) -> usize {
    let is_date = DATES.iter().any(|date| prefix.eq_ignore_ascii_case(date));
    let sign = usize::from(text.starts_with(['+', '-']));
    let goes_on =
        |c: char| c.is_alphanumeric() || matches!(c, '_' | '.' | '#') || (is_date && matches!(c, '-' | ':'));
    let end = text[sign..]
        .find(|c| !goes_on(c))
        .map_or(text.len(), |at| at + sign);
    let mut end = text[..end].find("..").unwrap_or(end);
    // The sign of an exponent: REAL#1.0e-3
    let is_exponent =
        text[..end].ends_with(['e', 'E']) && text[sign..].starts_with(|c: char| c.is_ascii_digit());
    if is_exponent && !text[..end].contains('#') && text[end..].starts_with(['-', '+']) {
        end += 1 + digits(&text[end + 1..]);
    }
    if end == sign { 0 } else { end }
}

/// How long a line is that `OpenPLC` writes for its debugger after a program: the C in it may hold `*)`.
fn line_of_debugger(text: &str) -> Option<usize> {
    let line = text[..line_length(text)].trim_end();
    (line.starts_with("(*DBG:") && line.ends_with("*)")).then_some(line.len())
}

/// Around the descriptions of MULTIPROG.
const DESCRIPTION: (&str, &str) = ("(*@KEY@:DESCRIPTION*)", "(*@KEY@:END_DESCRIPTION*)");

/// How long a description is that MULTIPROG writes between two comments.
fn description_length(text: &str) -> Option<usize> {
    let (begin, end) = DESCRIPTION;
    let inside = text.strip_prefix(begin)?.find(end)?;
    Some(begin.len() + inside + end.len())
}

/// How long the comment at the beginning is if comments nest.
fn nested_length(text: &str) -> Option<usize> {
    let bytes = text.as_bytes();
    let (mut at, mut depth) = (0, 0);
    while at + 1 < bytes.len() {
        match &bytes[at..at + 2] {
            b"(*" => depth += 1,
            b"*)" => depth -= 1,
            _ => {
                at += 1;
                continue;
            }
        }
        at += 2;
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

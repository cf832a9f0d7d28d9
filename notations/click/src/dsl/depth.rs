//! How large and how deep a Python file may be. The parser calls itself for what nests, so this is asked before.

use ladder_notation::{LineColumn, ReadError};
use ruff_python_ast::token::TokenKind;
use ruff_python_parser::{Mode, lexer};

/// A larger file is not read, in bytes.
const LARGEST: usize = 1024 * 1024;
/// A longer line is not read, in bytes.
const LONGEST_LINE: usize = 10_000;
/// This many brackets may be in one another.
const DEEPEST: usize = 24;
/// This many levels of indentation.
const MOST_INDENTED: usize = 24;
/// What a statement may have one after the other, between commas, with all the brackets around.
const LONGEST_CHAIN: usize = 100;
/// This many of these may a statement have that nest without brackets, and across commas.
const MOST_LAMBDAS: usize = 24;

/// Refuses what is too large or too deep.
pub(super) fn check(text: &str) -> Result<(), ReadError> {
    if text.len() > LARGEST {
        return Err(ReadError::whole("a Python file of more than 1 MB is not read"));
    }
    for (number, line) in text.split('\n').enumerate() {
        if line.len() > LONGEST_LINE {
            let place = LineColumn::line(number as u32 + 1);
            return Err(ReadError::at(
                place,
                format!("a line of more than {LONGEST_LINE} characters is not read"),
            ));
        }
    }
    let mut depth = Depth::default();
    let mut lexer = lexer::lex(text, Mode::Module);
    loop {
        let kind = lexer.next_token();
        if kind == TokenKind::EndOfFile {
            return Ok(());
        }
        if !depth.take(kind) {
            // Tokens have no places here, but they show where lines end; to Python a CR alone ends one, too.
            let lines = text.split('\n').count();
            let place = LineColumn::line((depth.newlines + 1).min(lines) as u32);
            return Err(ReadError::at(
                place,
                "what is written here nests too deeply to be read",
            ));
        }
    }
}

struct Depth {
    /// How much is one after the other since the last comma, for each open bracket.
    chains: Vec<usize>,
    indents: usize,
    lambdas: usize,
    newlines: usize,
}

impl Default for Depth {
    fn default() -> Depth {
        Depth {
            chains: vec![0],
            indents: 0,
            lambdas: 0,
            newlines: 0,
        }
    }
}

impl Depth {
    /// Whether it is still shallow enough with a token more.
    fn take(&mut self, kind: TokenKind) -> bool {
        match kind {
            TokenKind::Newline => {
                self.newlines += 1;
                self.lambdas = 0;
                self.chains.clear();
                self.chains.push(0);
            }
            TokenKind::NonLogicalNewline => self.newlines += 1,
            TokenKind::Comment => {}
            TokenKind::Indent => self.indents += 1,
            TokenKind::Dedent => self.indents = self.indents.saturating_sub(1),
            TokenKind::Comma => _ = self.chains.last_mut().map(|chain| *chain = 0),
            TokenKind::Lpar | TokenKind::Lsqb | TokenKind::Lbrace => {
                self.count();
                self.chains.push(0);
            }
            TokenKind::Rpar | TokenKind::Rsqb | TokenKind::Rbrace if self.chains.len() > 1 => {
                self.chains.pop();
            }
            TokenKind::Lambda | TokenKind::FStringStart | TokenKind::TStringStart => {
                self.lambdas += 1;
                self.count();
            }
            _ => self.count(),
        }
        self.chains.len() <= DEEPEST
            && self.indents <= MOST_INDENTED
            && self.lambdas <= MOST_LAMBDAS
            && self.chains.iter().sum::<usize>() <= LONGEST_CHAIN
    }

    fn count(&mut self) {
        if let Some(chain) = self.chains.last_mut() {
            *chain += 1;
        }
    }
}

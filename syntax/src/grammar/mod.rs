//! The parser: one logical line at a time, recursive descent, tokens straight into a [`Builder`].
//!
//! On a rung and in a block's first part the parser takes token after token as it meets them. Among operands and
//! in declarations it looks one token ahead, past white space and comments ([`Parser::look`]); each token is
//! lexed once. What a line's parse depends on is its text and its [`Entry`], nothing else; a declaration also
//! looks at how the next lines begin, because it may go on there.

mod block;
mod declaration;
mod expression;
mod line;
mod plain;
mod recovery;

pub use declaration::{is_declaration_keyword, is_type_keyword};
pub(crate) use line::{Entry, line};

use crate::builder::Builder;
use crate::conflict::{self, OpenConflicts, Within};
use crate::error::{DeclarationProblem, Surroundings, SyntaxError, SyntaxErrorKind};
use crate::kind::SyntaxKind;
use crate::lexer::{self, Token};
use rowan::{TextRange, TextSize};

/// An expression that nests deeper is an error. This and [`MAX_TERMS`] bound the depth of the
/// tree, and with it the stack that dropping or walking it takes.
pub const MAX_DEPTH: u32 = 100;
/// An operand with more operators, members and indices is an error.
pub const MAX_TERMS: u32 = 500;

/// The next token among operands that is not white space or a comment.
#[derive(Clone, Copy)]
struct Ahead {
    kind: SyntaxKind,
    start: usize,
    end: usize,
}

/// Reads one logical line.
struct Parser<'t, 'b, B> {
    text: &'t str,
    /// Where the line starts; errors count from here.
    start: usize,
    /// Where the text begins that is not in the tree yet.
    at: usize,
    /// Valid after [`Parser::look`], until the operands end.
    ahead: Ahead,
    /// Where the last token ended that is not white space or a comment.
    last_end: usize,
    /// The last comment that was taken: where it begins and ends.
    last_comment: Option<(usize, usize)>,
    /// The conflicts that are open where the text begins that is not in the tree yet.
    open: OpenConflicts,
    /// A line of signs of a conflict was met.
    met_conflict: bool,
    builder: &'b mut B,
    errors: Vec<SyntaxError>,
    /// Line ends are white space, and this is a declaration.
    free_form: bool,
    /// Open expressions around the place that is being read.
    depth: u32,
    /// Operators in the operand that is being read.
    terms: u32,
    /// Whether the operand that is being read was reported as too complex.
    too_complex: bool,
    /// A string without its closing quote was met.
    string_cut: bool,
    /// What is known of the operand list that is being read.
    list: recovery::OpenList,
}

impl<'t, 'b, B: Builder> Parser<'t, 'b, B> {
    fn new(text: &'t str, start: usize, open: OpenConflicts, builder: &'b mut B) -> Parser<'t, 'b, B> {
        Parser {
            text,
            start,
            at: start,
            ahead: Ahead {
                kind: SyntaxKind::EOF,
                start,
                end: start,
            },
            last_end: start,
            last_comment: None,
            open,
            met_conflict: false,
            builder,
            errors: Vec::new(),
            free_form: false,
            depth: 0,
            terms: 0,
            too_complex: false,
            string_cut: false,
            list: recovery::OpenList::default(),
        }
    }

    /// The byte at a place; 0 after the end, which is junk wherever it is.
    fn byte(&self, at: usize) -> u8 {
        self.text.as_bytes().get(at).copied().unwrap_or(0)
    }

    /// Puts a token that reaches from here to `end` into the tree.
    fn token(&mut self, (kind, end): Token) {
        let start = std::mem::replace(&mut self.at, end);
        match kind {
            SyntaxKind::WHITESPACE | SyntaxKind::NEWLINE | SyntaxKind::CONFLICT => {}
            SyntaxKind::COMMENT => {
                self.last_comment = Some((start, end));
                let (open, met) = self.after_comment(self.open, start, end);
                self.open = open;
                self.met_conflict |= met;
                if !lexer::is_closed_comment(&self.text[start..end]) {
                    self.error(SyntaxErrorKind::UnclosedComment, start, start + 1);
                }
            }
            SyntaxKind::STRING => {
                self.last_end = end;
                if !lexer::is_closed_string(&self.text[start..end]) {
                    self.error(SyntaxErrorKind::UnclosedString, start, end);
                }
            }
            _ => self.last_end = end,
        }
        self.builder.token(kind, self.text, start..end);
    }

    /// Takes the token of a conflict that begins here, where a physical line does, if one does.
    fn conflict(&mut self, within: Within) -> bool {
        let Some((end, open)) = conflict::token(self.text, self.at, self.open, within) else {
            return false;
        };
        self.token((SyntaxKind::CONFLICT, end));
        self.met_conflict = true;
        self.open = open;
        true
    }

    /// The conflicts that are open after a comment, and whether a line of signs is in it.
    fn after_comment(&self, open: OpenConflicts, start: usize, end: usize) -> (OpenConflicts, bool) {
        let bytes = self.text.as_bytes();
        if !lexer::spans_lines(&bytes[start..end]) {
            return (open, false);
        }
        let comment = conflict::comment(bytes, start, open);
        (comment.open, comment.met)
    }

    /// Finds the next token among operands, past white space and comments (and in a declaration past line
    /// ends). Nothing goes into the tree.
    fn look(&mut self) {
        let mut start = lexer::blanks_end(self.text.as_bytes(), self.at);
        let mut open = self.open;
        loop {
            let (kind, end) = lexer::in_operands(self.text, start, open);
            let mut next = end;
            let space = match kind {
                SyntaxKind::WHITESPACE => true,
                SyntaxKind::COMMENT => {
                    open = self.after_comment(open, start, end).0;
                    true
                }
                SyntaxKind::NEWLINE if self.free_form => {
                    while let Some(after) = conflict::token(self.text, next, open, Within::Declaration) {
                        (next, open) = after;
                    }
                    !declaration::ends_declaration(self.text, next, open)
                }
                _ => false,
            };
            if !space {
                let end = match kind {
                    SyntaxKind::STRING => self.cut_open_string(start, end),
                    _ => end,
                };
                self.ahead = Ahead { kind, start, end };
                return;
            }
            start = next;
        }
    }

    /// Where a string ends that lacks its closing quote: where the list or the declaration seems to go on.
    /// Once on a line, because each look goes to the line's end.
    fn cut_open_string(&mut self, start: usize, end: usize) -> usize {
        let text = &self.text[start..end];
        if lexer::is_closed_string(text) || std::mem::replace(&mut self.string_cut, true) {
            return end;
        }
        let ends: &[char] = if self.free_form { &[';'] } else { &[',', ')'] };
        match text.find(ends) {
            Some(cut) => start + text[..cut].trim_end_matches([' ', '\t']).len(),
            None => end,
        }
    }

    /// The kind of the token ahead.
    const fn next(&self) -> SyntaxKind {
        self.ahead.kind
    }

    /// The text of the token ahead.
    fn next_text(&self) -> &'t str {
        &self.text[self.ahead.start..self.ahead.end]
    }

    /// Whether the token ahead is this word, in any case.
    fn next_is_word(&self, word: &str) -> bool {
        self.next_text().eq_ignore_ascii_case(word)
    }

    /// Puts the white space and comments before the token ahead into the tree.
    fn space(&mut self) {
        while self.at < self.ahead.start {
            // Mostly one blank.
            let token = match self.byte(self.at) {
                b' ' => (
                    SyntaxKind::WHITESPACE,
                    lexer::blanks_end(self.text.as_bytes(), self.at),
                ),
                _ => lexer::in_operands(self.text, self.at, self.open),
            };
            self.token(token);
            while token.0 == SyntaxKind::NEWLINE && self.conflict(Within::Declaration) {}
        }
    }

    /// Takes the token ahead, with the space before it, and looks further.
    fn bump(&mut self) {
        self.bump_as(self.ahead.kind);
    }

    /// As [`Parser::bump`], under another kind.
    fn bump_as(&mut self, kind: SyntaxKind) {
        self.bump_last_as(kind);
        self.look();
    }

    /// As [`Parser::bump_as`], but does not look further: the operands end with this token.
    fn bump_last_as(&mut self, kind: SyntaxKind) {
        self.space();
        self.token((kind, self.ahead.end));
    }

    fn start_node(&mut self, kind: SyntaxKind) {
        self.builder.start_node(kind);
    }

    fn start_node_at(&mut self, checkpoint: B::Checkpoint, kind: SyntaxKind) {
        self.builder.start_node_at(checkpoint, kind);
    }

    fn finish_node(&mut self) {
        self.builder.finish_node();
    }

    fn checkpoint(&self) -> B::Checkpoint {
        self.builder.checkpoint()
    }

    /// Records an error between two places in the text.
    fn error(&mut self, kind: SyntaxErrorKind, from: usize, to: usize) {
        let offset = |at: usize| TextSize::new((at - self.start) as u32);
        self.errors
            .push(SyntaxError::new(kind, TextRange::new(offset(from), offset(to))));
    }

    /// Records an error at the token ahead; at the end of the line, after what was read last. What a declaration lacks at the
    /// end of a line is missing there: whether it goes on in the next one is not known yet.
    fn error_ahead(&mut self, kind: SyntaxErrorKind) {
        let is_on_next_line =
            self.free_form && self.text[self.last_end..self.ahead.start].contains(['\n', '\r']);
        if is_on_next_line || matches!(self.ahead.kind, SyntaxKind::NEWLINE | SyntaxKind::EOF) {
            self.error_after(kind);
        } else {
            self.error(kind, self.ahead.start, self.ahead.end);
        }
    }

    /// Records an error as an empty range after what was read last.
    fn error_after(&mut self, kind: SyntaxErrorKind) {
        self.error(kind, self.last_end, self.last_end);
    }

    fn declaration_error(&mut self, problem: DeclarationProblem) {
        self.error_ahead(SyntaxErrorKind::BadDeclaration(problem));
    }

    /// Records characters that mean nothing where they are. What only blanks part is one error.
    fn unexpected(&mut self, place: Surroundings, from: usize, to: usize) {
        let place = if self.free_form {
            Surroundings::Declaration
        } else {
            place
        };
        if let Some(last) = self.errors.last_mut()
            && matches!(last.kind, SyntaxErrorKind::UnexpectedCharacter { place: p, .. } if p == place)
        {
            let end = self.start + usize::from(last.range.end());
            if self.text[end..from].bytes().all(|b| b == b' ' || b == b'\t') {
                last.range = TextRange::new(last.range.start(), TextSize::new((to - self.start) as u32));
                return;
            }
        }
        let after_comment = self.is_after_cut_literal(from);
        let kind = SyntaxErrorKind::UnexpectedCharacter { place, after_comment };
        self.error(kind, from, to);
    }

    /// Whether a comment ends at `at` whose closing `#` looks like that of a literal: `T` before it, `5s` after.
    fn is_after_cut_literal(&self, at: usize) -> bool {
        self.last_comment.is_some_and(|(start, end)| {
            end == at
                && self.text[start..end - 1].ends_with(char::is_alphanumeric)
                && self.text[at..].starts_with(|c: char| c.is_alphanumeric() || c == '-')
        })
    }
}

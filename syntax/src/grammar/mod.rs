//! The parser: one logical line at a time, recursive descent, tokens straight into rowan's builder.

mod block;
mod declaration;
mod expression;
mod line;

pub use declaration::is_declaration_keyword;
pub(crate) use line::line;

use crate::lexer::{self, Context};
use crate::{DeclarationProblem, Place, SyntaxError, SyntaxErrorKind, SyntaxKind};
use rowan::{Checkpoint, GreenNodeBuilder, TextRange, TextSize};

/// How deep expressions may nest, and how many operators one operand may have. Both bound the depth of the
/// tree, and with it the stack that dropping or walking it takes.
const MAX_DEPTH: u32 = 100;
const MAX_TERMS: u32 = 500;

/// Reads one logical line.
struct Parser<'t, 'b, 'c> {
    text: &'t str,
    /// Where the line starts; errors count from here.
    start: usize,
    at: usize,
    builder: &'b mut GreenNodeBuilder<'c>,
    errors: Vec<SyntaxError>,
    /// The token at `at`, if it was looked at: kind and end.
    peeked: Option<(Context, SyntaxKind, usize)>,
    /// Open expressions around the place that is being read.
    depth: u32,
    /// Line ends are white space (in a declaration).
    free_form: bool,
    /// Operators in the operand that is being read.
    terms: u32,
}

impl Parser<'_, '_, '_> {
    /// The kind of the next token.
    fn peek(&mut self, context: Context) -> SyntaxKind {
        self.peek_token(context).0
    }

    fn peek_token(&mut self, context: Context) -> (SyntaxKind, usize) {
        if let Some((c, kind, end)) = self.peeked
            && c == context
        {
            return (kind, end);
        }
        let (kind, end) = lexer::token(self.text, self.at, context);
        self.peeked = Some((context, kind, end));
        (kind, end)
    }

    /// The text of the next token.
    fn peek_text(&mut self, context: Context) -> &str {
        let (_, end) = self.peek_token(context);
        &self.text[self.at..end]
    }

    /// Takes the next token into the tree.
    fn bump(&mut self, context: Context) {
        let kind = self.peek(context);
        self.bump_as(context, kind);
    }

    /// Takes the next token under another kind.
    fn bump_as(&mut self, context: Context, kind: SyntaxKind) {
        let (found, end) = self.peek_token(context);
        if found == SyntaxKind::EOF {
            return;
        }
        if found == SyntaxKind::COMMENT && !lexer::is_closed_comment(&self.text[self.at..end]) {
            self.error_at(SyntaxErrorKind::UnclosedComment, self.at, self.at + 1);
        }
        if found == SyntaxKind::STRING && !is_closed_string(&self.text[self.at..end]) {
            self.error_at(SyntaxErrorKind::UnclosedString, self.at, end);
        }
        self.builder.token(kind.into(), &self.text[self.at..end]);
        self.at = end;
        self.peeked = None;
    }

    /// Takes white space and comments, in a declaration line ends too.
    fn skip_trivia(&mut self, context: Context) {
        loop {
            let (kind, end) = self.peek_token(context);
            if !self.is_blank(kind, end) {
                return;
            }
            self.bump(context);
        }
    }

    /// Whether a token that ends at `end` is only space between others.
    fn is_blank(&self, kind: SyntaxKind, end: usize) -> bool {
        match kind {
            SyntaxKind::WHITESPACE | SyntaxKind::COMMENT => true,
            SyntaxKind::NEWLINE => self.free_form && !declaration::ends_declaration(self.text, end),
            _ => false,
        }
    }

    fn start_node(&mut self, kind: SyntaxKind) {
        self.builder.start_node(kind.into());
    }

    fn start_node_at(&mut self, checkpoint: Checkpoint, kind: SyntaxKind) {
        self.builder.start_node_at(checkpoint, kind.into());
    }

    fn finish_node(&mut self) {
        self.builder.finish_node();
    }

    fn checkpoint(&self) -> Checkpoint {
        self.builder.checkpoint()
    }

    /// Records a mistake between two places in the text.
    fn error_at(&mut self, kind: SyntaxErrorKind, from: usize, to: usize) {
        let offset = |at: usize| TextSize::new((at - self.start) as u32);
        self.errors
            .push(SyntaxError::new(kind, TextRange::new(offset(from), offset(to))));
    }

    /// Records a mistake at the next token; at the end of a line, at the place before it.
    fn error_here(&mut self, kind: SyntaxErrorKind, context: Context) {
        let (found, end) = self.peek_token(context);
        let end = if matches!(found, SyntaxKind::NEWLINE | SyntaxKind::EOF) {
            self.at
        } else {
            end
        };
        self.error_at(kind, self.at, end);
    }

    fn declaration_error(&mut self, problem: DeclarationProblem) {
        self.error_here(SyntaxErrorKind::BadDeclaration(problem), Context::Operand);
    }

    /// Takes a run of tokens that mean nothing here as one mistake: `takes` says which kinds belong to it.
    fn unexpected(&mut self, context: Context, takes: impl Fn(SyntaxKind) -> bool) {
        let from = self.at;
        let behind_comment = self.ends_comment_in_literal(from);
        while takes(self.peek(context)) {
            self.bump_as(context, SyntaxKind::ERROR);
        }
        self.error_at(
            SyntaxErrorKind::UnexpectedCharacter {
                place: match context {
                    Context::Rung => Place::Rung,
                    Context::Head => Place::Head,
                    Context::Operand => Place::Operands,
                },
                behind_comment,
            },
            from,
            self.at,
        );
    }

    /// Whether a comment ends right before `at` that began directly behind a letter or digit, as in a block's
    /// first part or on a rung, where a `#` never belongs to a literal.
    fn ends_comment_in_literal(&self, at: usize) -> bool {
        let Some(before) = self.text[self.start..at].strip_suffix('#') else {
            return false;
        };
        let Some(open) = before.rfind('#') else {
            return false;
        };
        let inside = &before[open + 1..];
        // `T#5s` behind a commented-out opening: the text behind the comment looks like the rest of a literal.
        before[..open].ends_with(char::is_alphanumeric) || inside.ends_with(char::is_alphanumeric)
    }
}

fn is_closed_string(text: &str) -> bool {
    text.len() > 1 && text.ends_with('\'') && {
        // A quote behind an odd number of `$` is part of the string.
        let dollars = text[..text.len() - 1]
            .bytes()
            .rev()
            .take_while(|&b| b == b'$')
            .count();
        dollars % 2 == 0
    }
}

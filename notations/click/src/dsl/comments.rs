//! Comments of a Python file, handed out to what they are at.

use ladder_syntax::{LineIndex, TextSize};
use ruff_python_ast::token::{TokenKind, Tokens};
use ruff_text_size::Ranged;

/// A comment.
struct Comment {
    start: usize,
    /// Without its `#`.
    text: String,
    /// Nothing else is on its line.
    alone: bool,
    /// It begins its line, without indentation.
    outermost: bool,
}

/// The comments that nobody has taken yet.
pub(super) struct Comments {
    /// The next one comes last.
    waiting: Vec<Comment>,
}

impl Comments {
    pub(super) fn of(text: &str, tokens: &Tokens) -> Comments {
        let found = tokens.iter().filter(|token| token.kind() == TokenKind::Comment);
        let lines = LineIndex::new(text);
        let mut waiting: Vec<Comment> = found
            .filter_map(|token| {
                let start = usize::from(token.start());
                let written = text.get(start..usize::from(token.end()))?;
                let line = lines.range(lines.line(TextSize::new(start as u32)));
                let before = &text[line.start().into()..start];
                Some(Comment {
                    start,
                    text: written.trim_start_matches('#').trim().to_owned(),
                    alone: before.trim().is_empty(),
                    outermost: before.is_empty(),
                })
            })
            .filter(|comment| !comment.text.is_empty())
            .collect();
        waiting.reverse();
        Comments { waiting }
    }

    fn next_if(&mut self, wanted: impl Fn(&Comment) -> bool) -> Option<String> {
        match self.waiting.last() {
            Some(comment) if wanted(comment) => self.waiting.pop().map(|comment| comment.text),
            _ => None,
        }
    }

    /// Takes those before an offset.
    pub(super) fn before(&mut self, offset: usize) -> Vec<String> {
        std::iter::from_fn(|| self.next_if(|comment| comment.start < offset)).collect()
    }

    /// Takes those before an offset that are indented: they belong to the function above, the others to what follows.
    pub(super) fn indented_before(&mut self, offset: usize) -> Vec<String> {
        let wanted = |comment: &Comment| comment.start < offset && !comment.outermost;
        std::iter::from_fn(|| self.next_if(wanted)).collect()
    }

    /// Takes those at the end of a line before an offset.
    pub(super) fn trailing(&mut self, offset: usize) -> Vec<String> {
        let wanted = |comment: &Comment| comment.start < offset && !comment.alone;
        std::iter::from_fn(|| self.next_if(wanted)).collect()
    }
}

//! Edits: what a format changes, as small replacements.

use ladder_syntax::{TextRange, TextSize};

/// One replacement in a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// What is replaced, in bytes; empty for an insertion.
    pub range: TextRange,
    /// What is there afterwards.
    pub text: String,
}

/// The text with all edits made. They must be sorted and must not overlap, as [`format`](crate::format) gives
/// them.
pub fn apply(text: &str, edits: &[Edit]) -> String {
    let grown: usize = edits.iter().map(|edit| edit.text.len()).sum();
    let mut out = String::with_capacity(text.len() + grown);
    let mut at = 0;
    for edit in edits {
        out.push_str(&text[at..usize::from(edit.range.start())]);
        out.push_str(&edit.text);
        at = edit.range.end().into();
    }
    out.push_str(&text[at..]);
    out
}

/// Takes the replacements that a format makes, in the order of their places.
pub(crate) trait Sink {
    /// Whether many small replacements are better than few large ones: they leave cursors and breakpoints alone.
    const SMALL: bool;

    /// Forgets all replacements.
    fn clear(&mut self);

    /// The bytes from `start` to `end` become `new`.
    fn replace(&mut self, start: usize, end: usize, new: &str);
}

/// Gathers edits; those that touch become one.
#[derive(Default)]
pub(crate) struct Edits(pub(crate) Vec<Edit>);

impl Sink for Edits {
    const SMALL: bool = true;

    fn clear(&mut self) {
        self.0.clear();
    }

    fn replace(&mut self, start: usize, end: usize, new: &str) {
        let (start, end) = (TextSize::new(start as u32), TextSize::new(end as u32));
        if let Some(last) = self.0.last_mut().filter(|last| last.range.end() == start) {
            last.range = TextRange::new(last.range.start(), end);
            last.text.push_str(new);
            return;
        }
        self.0.push(Edit {
            range: TextRange::new(start, end),
            text: new.to_owned(),
        });
    }
}

/// Writes the new text directly; nothing, as long as it is the old one.
pub(crate) struct NewText<'t> {
    text: &'t str,
    out: String,
    copied: usize,
}

impl<'t> NewText<'t> {
    pub(crate) fn new(text: &'t str) -> Self {
        NewText {
            text,
            out: String::new(),
            copied: 0,
        }
    }

    /// The new text; none if nothing was replaced.
    pub(crate) fn finish(mut self) -> Option<String> {
        if self.copied == 0 && self.out.is_empty() {
            return None;
        }
        self.out.push_str(&self.text[self.copied..]);
        Some(self.out)
    }
}

impl Sink for NewText<'_> {
    const SMALL: bool = false;

    fn clear(&mut self) {
        self.out.clear();
        self.copied = 0;
    }

    fn replace(&mut self, start: usize, end: usize, new: &str) {
        self.out.push_str(&self.text[self.copied..start]);
        self.out.push_str(new);
        self.copied = end;
    }
}

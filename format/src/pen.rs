//! The pen: walks the old text and notes where the new one differs.

use crate::edit::Sink;

/// Draws over an old text. What the old text says is kept piece by piece, in order; between two pieces stands
/// what was drawn since the first of them. So nothing but the gaps can change, and no piece can be lost or
/// doubled.
pub(crate) struct Pen<'t, S> {
    text: &'t str,
    /// Up to here the old text is dealt with.
    at: usize,
    /// What stands in the new text behind `at` so far.
    gap: String,
    sink: S,
}

const BLANKS: &str = "                                                                ";
const DASHES: &str = "----------------------------------------------------------------";

impl<'t, S: Sink> Pen<'t, S> {
    pub(crate) fn new(text: &'t str, sink: S) -> Self {
        Pen {
            text,
            at: 0,
            gap: String::new(),
            sink,
        }
    }

    pub(crate) fn blanks(&mut self, count: u32) {
        push_run(&mut self.gap, BLANKS, count);
    }

    pub(crate) fn dashes(&mut self, count: u32) {
        push_run(&mut self.gap, DASHES, count);
    }

    pub(crate) fn bar(&mut self) {
        self.gap.push('|');
    }

    pub(crate) fn line_end(&mut self, line_end: &str) {
        self.gap.push_str(line_end);
    }

    /// Keeps a piece of the old text. Pieces come in the order in which they stand.
    pub(crate) fn keep(&mut self, start: usize, end: usize) {
        let start = start.max(self.at);
        if self.text.as_bytes()[self.at..start] != *self.gap.as_bytes() {
            self.sink.replace(self.at, start, &self.gap);
        }
        self.gap.clear();
        self.at = end.max(start);
    }

    /// Keeps a word of the old text, in capitals. Letters outside ASCII stay: no keyword has any.
    pub(crate) fn keep_in_capitals(&mut self, start: usize, end: usize) {
        self.keep(start, end);
        let word = &self.text[start..end];
        if word.bytes().any(|b| b.is_ascii_lowercase()) {
            self.sink.replace(start, end, &word.to_ascii_uppercase());
        }
    }

    /// What is left of the old text goes; returns the sink.
    pub(crate) fn finish(mut self) -> S {
        self.keep(self.text.len(), self.text.len());
        self.sink
    }
}

fn push_run(to: &mut String, of: &str, mut count: u32) {
    while count > of.len() as u32 {
        to.push_str(of);
        count -= of.len() as u32;
    }
    to.push_str(&of[..count as usize]);
}

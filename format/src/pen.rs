//! The pen: walks the old text and notes where the new one differs.

use crate::edit::Sink;
use memchr::memchr2;
use std::ops::Range;

/// Draws over an old text. What the old text says is kept piece by piece, in order; between two pieces is
/// what was drawn since the first of them. So nothing but the gaps can change, and no piece can be lost or
/// doubled.
pub(crate) struct Pen<'t, S> {
    text: &'t str,
    /// Up to here the old text is dealt with.
    at: usize,
    /// What is in the new text after `at` so far.
    gap: String,
    sink: S,
    /// A range of places on one physical line, and the line end that belongs there.
    line_end: (Range<usize>, &'t str),
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
            line_end: (0..0, "\n"),
        }
    }

    /// Forgets everything.
    pub(crate) fn begin_again(&mut self) {
        self.at = 0;
        self.gap.clear();
        self.sink.clear();
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

    /// Draws a new line end for the part of a physical line that ends at a place: that of the line itself;
    /// where the last line has none, that of the line before.
    pub(crate) fn split_line(&mut self, at: usize) {
        // One line may be split very often, and it may be long.
        if !self.line_end.0.contains(&at) {
            self.line_end = line_end_at(self.text, at);
        }
        self.gap.push_str(self.line_end.1);
    }

    /// Keeps a piece of the old text. Pieces come in the order in which they are.
    pub(crate) fn keep(&mut self, start: usize, end: usize) {
        let start = start.max(self.at);
        if self.text.as_bytes()[self.at..start] != *self.gap.as_bytes() {
            self.sink.replace(self.at, start, &self.gap);
        }
        self.gap.clear();
        self.at = end.max(start);
    }

    /// Puts a new text in the place of a piece of the old one.
    pub(crate) fn replace(&mut self, start: usize, end: usize, new: &str) {
        self.keep(start, end);
        self.sink.replace(start, end, new);
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

/// The line end that belongs to a place, and up to where it does.
fn line_end_at(text: &str, at: usize) -> (Range<usize>, &str) {
    let bytes = text.as_bytes();
    if let Some(n) = memchr2(b'\n', b'\r', &bytes[at..]) {
        let end = at + n;
        let length = if bytes[end..].starts_with(b"\r\n") { 2 } else { 1 };
        return (at..end + 1, &text[end..end + length]);
    }
    let before = &text[..at];
    let line_end = match before.trim_end_matches(|c| c != '\n' && c != '\r') {
        "" => "\n",
        lines if lines.ends_with("\r\n") => "\r\n",
        lines => &lines[lines.len() - 1..],
    };
    (at..text.len() + 1, line_end)
}

fn push_run(to: &mut String, of: &str, mut count: u32) {
    while count > of.len() as u32 {
        to.push_str(of);
        count -= of.len() as u32;
    }
    to.push_str(&of[..count as usize]);
}

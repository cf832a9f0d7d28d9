//! Parsing again what an edit touches.
//!
//! A line's parse depends on its text and its entry state alone. So parsing starts at the line that holds the
//! beginning of the edit and stops as soon as a new line begins where an old one did, after the edit and in
//! the same state: from there on everything is as it was.

use crate::grammar::Entry;
use crate::line::{LineKind, ReadLine};
use crate::line_tree::{BEFORE, Line, with_text};
use crate::lines::{entry_after, line_at};
use crate::parse::{Parse, parse};
use crate::summary::Summary;
use crate::unclosed_comment::unclosed_comment;
use rowan::{TextRange, TextSize};
use std::ops::Range;

/// This many lines after an edit are checked first.
const FEW_LINES: usize = 8;

/// Some of a text's lines: from the first that an edit touches to one after it.
struct Window {
    /// After a line end, unless it is the beginning of the text.
    text: String,
    /// Where the first of the lines begins in it.
    start: usize,
    /// Where the edit ends in it.
    edit_end: usize,
    /// It ends in front of this line of the text before the edit.
    last: usize,
}

/// The lines that are new, and which line of the text before the edit follows them.
struct ReadAgain {
    lines: Vec<ReadLine<()>>,
    resume: usize,
}

impl Parse {
    /// The parse of a text that came from this one's by one edit: `old_range` of the old text was replaced by
    /// `new_len` bytes, which gave `text`. The result is that of [`parse`](crate::parse()) on `text`, but lines that
    /// the edit does not touch are kept, and only the others cost time that grows with their length.
    /// If the lengths do not agree, the text is parsed again.
    #[must_use]
    pub fn edited(&self, text: &str, old_range: TextRange, new_len: TextSize) -> Parse {
        self.edited_in(text.len(), |range| text[range].to_owned(), old_range, new_len)
    }

    /// As [`Parse::edited`], for a text of `len` bytes of which `stretch` gives any range: nothing is asked for but the
    /// lines around the edit, as long as it opens no comment.
    #[must_use]
    pub fn edited_in(
        &self,
        len: usize,
        stretch: impl Fn(Range<usize>) -> String,
        old_range: TextRange,
        new_len: TextSize,
    ) -> Parse {
        let old_len = u32::from(self.text_len()) as usize;
        let edit = Range::<usize>::from(old_range);
        let new_end = edit.start + usize::from(new_len);
        if edit.end > old_len || len != old_len - edit.len() + usize::from(new_len) || self.lines().is_empty()
        {
            return parse(&stretch(0..len));
        }
        let first = self.first_touched(edit.start);
        let (start, begin) = (self.lines.line_start(first) as usize, self.entry(first));
        let mut last = self.lines.count_before(edit.end as u32) + FEW_LINES;
        let mut asked_for = 0;
        let (window, again) = loop {
            last = self.end_of_physical_line(last);
            let end = self.lines.line_start(last) as usize - edit.end + new_end;
            asked_for += end - start;
            let before = if start == 0 { "" } else { BEFORE };
            let window = Window {
                text: [before, &stretch(start..end)].concat(),
                start: before.len(),
                edit_end: before.len() + new_end - start,
                last,
            };
            match self.read_again(&window, begin, edit.end) {
                Some(again) => break (window, again),
                None => last += 2 * (last - first),
            }
        };
        let new_lines = with_text(&window.text, window.start, begin, again.lines.into_iter());
        let lines = self.lines.spliced(first..again.resume, new_lines.collect());
        let whole = || {
            asked_for += len;
            stretch(0..len)
        };
        let unclosed_comment = unclosed_comment(whole, &lines);
        Parse::new(lines, unclosed_comment, asked_for)
    }

    /// Reads a window's lines until one begins where a line of the text before the edit does, in the same state. None if
    /// what is after the window may have a say in how they are read.
    fn read_again(&self, window: &Window, begin: Entry, old_end: usize) -> Option<ReadAgain> {
        let text = &*window.text;
        let whole = window.last == self.lines.len();
        let mut lines = Vec::new();
        let (mut at, mut entry) = (window.start, begin);
        let mut resume = None;
        // A byte order mark is one at the beginning of a text only.
        let is_first = |at: usize, old: usize| old == 0 || window.start == 0 && at == 0;
        loop {
            if at >= window.edit_end
                && let Some(old) = self.line_that_starts(at - window.edit_end + old_end)
                && self.entry(old) == entry
                && !(is_first(at, old) && self.lines()[old].text().starts_with('\u{feff}'))
            {
                resume = Some(old);
                break;
            }
            if at >= text.len() {
                break;
            }
            let line = line_at(text, at, entry, &mut Summary);
            at += line.len as usize;
            entry = entry_after(&line);
            lines.push(line);
        }
        if whole {
            let resume = resume.unwrap_or(window.last);
            return Some(ReadAgain { lines, resume });
        }
        // Comments end at a `#`, declarations look past blanks and comments, and all else ends with its physical line.
        let resume = resume?;
        let mut after = self.lines.range(resume..window.last);
        let is_stop = |line: &Line| {
            !matches!(
                line.kind,
                LineKind::Blank | LineKind::Comment | LineKind::Conflict
            )
        };
        after.any(is_stop).then_some(ReadAgain { lines, resume })
    }

    /// The first line from this one on that begins a physical line; at most the number of lines.
    fn end_of_physical_line(&self, line: usize) -> usize {
        let mut line = line.min(self.lines.len());
        while line < self.lines.len() && self.entry(line).mid_line {
            line += 1;
        }
        line
    }

    /// The parse of a text that came from this one's, `old`, in whatever way: what lies between the beginning and the
    /// end that both have in common counts as one edit.
    #[must_use]
    pub fn updated(&self, old: &str, new: &str) -> Parse {
        let above = floor(new, common_prefix(old.as_bytes(), new.as_bytes()));
        let (old_rest, new_rest) = (&old.as_bytes()[above..], &new.as_bytes()[above..]);
        let mut below = common_suffix(old_rest, new_rest);
        while !new.is_char_boundary(new.len() - below) {
            below -= 1;
        }
        let size = |bytes: usize| TextSize::new(bytes as u32);
        let range = TextRange::new(size(above), size(old.len() - below));
        self.edited(new, range, size(new.len() - below - above))
    }

    /// The line to start again from: one that begins a physical line before the edit, and that no line before it
    /// has checked.
    fn first_touched(&self, edit: usize) -> usize {
        // Of a line that ends where the edit begins the last token may go on, unless that is the end of a physical line. The last
        // one of all may be an open comment.
        let mut first = self.lines.count_before(edit as u32).saturating_sub(1);
        if first + 1 < self.lines.len()
            && self.lines.line_start(first + 1) as usize == edit
            && self.lines()[first].text().ends_with('\n')
        {
            first += 1;
        }
        while first > 0 && (self.entry(first).mid_line || looks_ahead(&self.lines()[first - 1])) {
            first -= 1;
        }
        first
    }

    /// The state in which a line begins.
    fn entry(&self, line: usize) -> Entry {
        line.checked_sub(1)
            .map_or(Entry::START, |before| entry_after(&self.lines()[before]))
    }

    /// The line that starts at an offset.
    fn line_that_starts(&self, offset: usize) -> Option<usize> {
        let line = self.lines.count_before(offset as u32);
        (line < self.lines.len() && self.lines.line_start(line) as usize == offset).then_some(line)
    }
}

/// The next character boundary at or before an offset. (In two texts with one beginning it is the same for both.)
fn floor(text: &str, mut offset: usize) -> usize {
    while !text.is_char_boundary(offset) {
        offset -= 1;
    }
    offset
}

/// Bytes that are compared at once: whole stretches are what makes a comparison fast.
const STRETCH: usize = 1024;

fn common_prefix(a: &[u8], b: &[u8]) -> usize {
    let stretches = a.chunks_exact(STRETCH).zip(b.chunks_exact(STRETCH));
    let same = STRETCH * stretches.take_while(|(a, b)| a == b).count();
    let rest = a[same..].iter().zip(&b[same..]);
    same + rest.take_while(|(a, b)| a == b).count()
}

fn common_suffix(a: &[u8], b: &[u8]) -> usize {
    let stretches = a.rchunks_exact(STRETCH).zip(b.rchunks_exact(STRETCH));
    let same = STRETCH * stretches.take_while(|(a, b)| a == b).count();
    let rest = a[..a.len() - same]
        .iter()
        .rev()
        .zip(b[..b.len() - same].iter().rev());
    same + rest.take_while(|(a, b)| a == b).count()
}

/// Whether a line's parse may have checked lines after it: a declaration that lacks something was read on to see
/// whether the rest follows, over blank and comment lines.
fn looks_ahead(line: &Line) -> bool {
    line.mode_after.is_in_section()
        && match line.kind {
            LineKind::Declaration | LineKind::StructHeader | LineKind::StructEnd => !line.errors.is_empty(),
            LineKind::Blank | LineKind::Comment | LineKind::Conflict => true,
            _ => false,
        }
}

//! The logical lines of a file, in parts that texts before and after an edit share.

use crate::line_tree::{Line, LineTree};
use crate::lines::LineList;
use crate::part::{self, Part};
use rowan::TextSize;
use std::iter::FlatMap;
use std::ops::{Index, Range};
use std::slice;
use std::sync::Arc;

/// The logical lines of a file.
#[derive(Debug, Clone)]
pub struct FileLines {
    parts: Vec<Arc<Part>>,
    /// How many lines are before each part, and at the end how many there are.
    lines_before: Vec<u32>,
    /// How many bytes are before each part, and at the end the length of the text.
    bytes_before: Vec<u32>,
    /// How many physical lines end before each part, and at the end how many there are.
    ends_before: Vec<u32>,
}

impl FileLines {
    /// The lines of a text, from its first to its last.
    pub(crate) fn new(lines: impl Iterator<Item = Line>) -> FileLines {
        FileLines::of_parts(part::cut_file(lines))
    }

    fn of_parts(parts: Vec<Arc<Part>>) -> FileLines {
        let mut lines_before = Vec::with_capacity(parts.len() + 1);
        let mut bytes_before = Vec::with_capacity(parts.len() + 1);
        let mut ends_before = Vec::with_capacity(parts.len() + 1);
        let (mut lines, mut bytes, mut ends) = (0, 0, 0);
        for part in &parts {
            lines_before.push(lines);
            bytes_before.push(bytes);
            ends_before.push(ends);
            ends += part.line_ends();
            lines += part.lines.len() as u32;
            bytes += part.len();
        }
        lines_before.push(lines);
        bytes_before.push(bytes);
        ends_before.push(ends);
        FileLines {
            parts,
            lines_before,
            bytes_before,
            ends_before,
        }
    }

    /// These lines with `new` in the place of `old`. Parts without a changed line are taken over.
    pub(crate) fn spliced(&self, old: Range<usize>, new: Vec<Line>) -> FileLines {
        let first = self.part_of(old.start);
        // Lines that are put in after the last one of a part belong to the next; at the end of the text to the last.
        let mut last = if old.is_empty() {
            first
        } else {
            self.part_of(old.end - 1)
        };
        let above = &self.parts[first].lines[..old.start - self.first_line(first)];
        let below = &self.parts[last].lines[old.end - self.first_line(last)..];
        let mut lines = Vec::with_capacity(above.len() + new.len() + below.len());
        lines.extend_from_slice(above);
        lines.extend(new);
        lines.extend_from_slice(below);
        while !part::can_end(&lines) && last + 1 < self.parts.len() {
            last += 1;
            lines.extend_from_slice(&self.parts[last].lines);
        }
        let mut parts = Vec::with_capacity(self.parts.len() + 2);
        parts.extend_from_slice(&self.parts[..first]);
        parts.extend(part::cut(lines));
        parts.extend_from_slice(&self.parts[last + 1..]);
        FileLines::of_parts(parts)
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.lines_before[self.parts.len()] as usize
    }

    /// Whether the text is empty.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// A line, if there are that many.
    pub fn get(&self, line: usize) -> Option<&Line> {
        (line < self.len()).then(|| &self[line])
    }

    /// The first line.
    pub fn first(&self) -> Option<&Line> {
        self.parts.first()?.lines.first()
    }

    /// The last line.
    pub fn last(&self) -> Option<&Line> {
        self.parts.last()?.lines.last()
    }

    /// All lines, from top to bottom.
    pub fn iter(&self) -> AllLines<'_> {
        self.parts.iter().flat_map(|part| part.lines.iter())
    }

    /// The lines of some parts, with their numbers.
    pub fn of_parts_that(&self, wanted: impl Fn(&Part) -> bool) -> impl Iterator<Item = (usize, &Line)> {
        let parts = self.parts.iter().zip(&self.lines_before);
        let wanted = parts.filter(move |(part, _)| wanted(part));
        wanted.flat_map(|(part, &first)| (first as usize..).zip(&part.lines))
    }

    /// The lines of a range.
    pub fn range(&self, range: Range<usize>) -> impl Iterator<Item = &Line> {
        self.from(range.start).take(range.len())
    }

    /// The lines from one on.
    pub fn from(&self, line: usize) -> impl Iterator<Item = &Line> {
        let part = self.part_of(line);
        let parts = self.parts.get(part..).unwrap_or_default();
        let skipped = line - self.first_line(part).min(line);
        parts.iter().flat_map(|part| &part.lines).skip(skipped)
    }

    /// How many lines this text begins with as an earlier one does, and how many it ends with so, none counted twice:
    /// as [`Parse::edited`](crate::Parse::edited) keeps them.
    pub fn shared_with(&self, old: &FileLines) -> (usize, usize) {
        let is_same = |(new, old): &(&Line, &Line)| new.is(old);
        let parts = self.parts.iter().zip(&old.parts);
        let same = parts.take_while(|(new, old)| Arc::ptr_eq(new, old)).count();
        let above = self.first_line(same);
        let above = above + self.from(above).zip(old.from(above)).take_while(is_same).count();
        let most = self.len().min(old.len()) - above;
        let parts = self.parts.iter().rev().zip(old.parts.iter().rev());
        let same = parts.take_while(|(new, old)| Arc::ptr_eq(new, old)).count();
        let below = (self.len() - self.first_line(self.parts.len() - same)).min(most);
        let rest = |lines: &'_ FileLines| lines.len() - below;
        let lines = (0..rest(self)).rev().zip((0..rest(old)).rev()).take(most - below);
        let lines = lines.map(|(new, line)| (&self[new], &old[line]));
        (above, below + lines.take_while(is_same).count())
    }

    /// The parts that are not those of an earlier text: of this one, and of the earlier one.
    pub fn parts_changed_since(&self, old: &FileLines) -> (Range<usize>, Range<usize>) {
        let is_same = |(new, old): &(&Arc<Part>, &Arc<Part>)| Arc::ptr_eq(new, old);
        let above = self.parts.iter().zip(&old.parts).take_while(is_same).count();
        let (new, old) = (&self.parts[above..], &old.parts[above..]);
        let below = new.iter().rev().zip(old.iter().rev()).take_while(is_same).count();
        (above..above + new.len() - below, above..above + old.len() - below)
    }

    /// The first line of the first network.
    pub fn first_network(&self) -> Option<usize> {
        let mut parts = self.parts.iter().zip(&self.lines_before);
        parts.find_map(|(part, &before)| Some(before as usize + part.first_network()?))
    }

    /// How many physical lines end above a line.
    pub fn line_ends_above(&self, line: usize) -> u32 {
        let part = self.part_of(line);
        let within = line - self.first_line(part);
        let above = self.parts.get(part).map(|part| part.line_ends_above(within));
        self.ends_before[part] + above.unwrap_or_default()
    }

    /// The parts, from top to bottom.
    pub fn parts(&self) -> &[Arc<Part>] {
        &self.parts
    }

    /// The part that holds a line; the last one after the end.
    pub fn part_of(&self, line: usize) -> usize {
        let parts = self.parts.len();
        // Parts are of about one length, so it is mostly near to where its share of the lines leads.
        let near = (line as u64 * parts as u64)
            .checked_div(self.len() as u64)
            .unwrap_or_default() as usize;
        let first = near.saturating_sub(1).min(parts);
        let end = (near + 2).min(parts);
        let is_before = |&start: &u32| start as usize <= line;
        let is_after_first = self.lines_before[first..end].first().is_some_and(is_before);
        if is_after_first && !is_before(&self.lines_before[end]) {
            return first + self.lines_before[first..end].partition_point(is_before) - 1;
        }
        let starts = &self.lines_before[..parts];
        starts.partition_point(is_before).saturating_sub(1)
    }

    /// The first line of a part.
    pub fn first_line(&self, part: usize) -> usize {
        self.lines_before[part] as usize
    }

    /// Where a part starts, in bytes.
    pub fn first_byte(&self, part: usize) -> TextSize {
        TextSize::new(self.bytes_before[part])
    }

    /// The length of the text in bytes.
    pub(crate) fn text_len(&self) -> u32 {
        self.bytes_before[self.parts.len()]
    }

    /// Where a line starts, in bytes; after the last one the length of the text.
    pub(crate) fn line_start(&self, line: usize) -> u32 {
        if line == self.len() {
            return self.text_len();
        }
        let part = self.part_of(line);
        self.bytes_before[part] + self.parts[part].starts[line - self.first_line(part)]
    }

    /// How many lines start before an offset.
    pub(crate) fn count_before(&self, offset: u32) -> usize {
        let after = self.bytes_before[..self.parts.len()].partition_point(|&start| start < offset);
        let Some(part) = after.checked_sub(1) else {
            return 0;
        };
        let within = offset - self.bytes_before[part];
        let starts = &self.parts[part].starts[..self.parts[part].lines.len()];
        self.first_line(part) + starts.partition_point(|&start| start < within)
    }
}

/// All lines of a file.
pub type AllLines<'l> =
    FlatMap<slice::Iter<'l, Arc<Part>>, slice::Iter<'l, Line>, fn(&'l Arc<Part>) -> slice::Iter<'l, Line>>;

impl<'l> IntoIterator for &'l FileLines {
    type Item = &'l Line;
    type IntoIter = AllLines<'l>;

    fn into_iter(self) -> AllLines<'l> {
        self.iter()
    }
}

impl Index<usize> for FileLines {
    type Output = Line;

    fn index(&self, line: usize) -> &Line {
        let part = self.part_of(line);
        &self.parts[part].lines[line - self.first_line(part)]
    }
}

impl LineList for FileLines {
    type Node = LineTree;

    fn count(&self) -> usize {
        self.len()
    }

    fn line(&self, line: usize) -> &Line {
        &self[line]
    }

    fn start(&self, line: usize) -> u32 {
        self.line_start(line)
    }

    fn declarations_from(&self, line: usize) -> Option<(usize, Option<usize>)> {
        let part = self.part_of(line);
        let first = self.first_line(part);
        let last = self.parts.get(part)?.declares_to.filter(|_| line == first)? as usize;
        let after = self.lines_before[part + 1] as usize;
        Some((after, (last > 0).then_some(first + last)))
    }
}

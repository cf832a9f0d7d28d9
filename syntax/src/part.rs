//! A part of a file: the unit that an edit makes again. All that it knows counts from its own start, so that what is
//! above and below it may change.

use crate::line::LineKind;
use crate::line_tree::Line;
use crate::structure::{PartItem, group};
use std::ops::Range;
use std::sync::Arc;

/// Where nothing is open a part ends once it has this many lines. Edits let it grow to twice as many. So they take
/// no more than 10 KiB: pieces up to there come from small pages, longer ones from pages of half a megabyte, of which each
/// thread that has made some keeps its own.
const USUAL_LINES: usize = 112;

/// With fewer lines an edited part is joined to the next one.
const FEWEST_LINES: usize = 32;

/// Some consecutive logical lines of a file. No network reaches from one part into another.
#[derive(Debug)]
pub struct Part {
    pub(crate) lines: Vec<Line>,
    /// Where each line starts, and at the end the length of the part: in bytes, from its start.
    pub(crate) starts: Vec<u32>,
    /// Its networks, and the lines between them.
    pub(crate) items: Vec<PartItem>,
    /// The lines at which sections and block definitions begin, and at which the latter end.
    pub(crate) frame: Box<[u32]>,
    /// If it holds nothing but declarations, comments and blank lines: the line after the last declaration, or 0.
    pub(crate) declares_to: Option<u32>,
    /// The first line of its first network.
    first_network: Option<u32>,
    /// How many physical lines end in it.
    line_ends: u32,
    /// Whether one of them ends in each of its lines: comments that span lines are uncommon.
    one_end_each: bool,
    /// Whether a line has an error.
    faulty: bool,
    /// Whether a rung begins with a `/`.
    begins_with_up: bool,
    /// Whether a comment is on a line.
    commented: bool,
    /// Whether a line belongs to a merge's conflict.
    in_conflict: bool,
}

impl Part {
    fn new(lines: Vec<Line>) -> Part {
        let mut starts = Vec::with_capacity(lines.len() + 1);
        let mut at = 0;
        for line in &lines {
            starts.push(at);
            at += line.len;
        }
        starts.push(at);
        let items = group(&lines);
        let numbers = || (0..).zip(&lines);
        let is_frame = |line: &Line| {
            matches!(
                line.kind,
                LineKind::SectionHeader | LineKind::BlockHeader | LineKind::BlockEnd
            )
        };
        let frame = numbers().filter(|(_, line)| is_frame(line));
        let is_in_section = |line: &Line| {
            matches!(
                line.kind,
                LineKind::Declaration
                    | LineKind::StructHeader
                    | LineKind::StructEnd
                    | LineKind::Comment
                    | LineKind::Blank
                    | LineKind::Conflict
            )
        };
        let declares = |line: &Line| {
            !matches!(
                line.kind,
                LineKind::Comment | LineKind::Blank | LineKind::Conflict
            )
        };
        let declarations = || numbers().filter(|(_, line)| declares(line));
        Part {
            starts,
            frame: frame.map(|(number, _)| number).collect(),
            declares_to: lines
                .iter()
                .all(is_in_section)
                .then(|| declarations().last().map_or(0, |(number, _)| number + 1)),
            first_network: items.iter().find_map(|item| match *item {
                PartItem::Network(first, _) => Some(first),
                PartItem::Line(_) => None,
            }),
            items,
            line_ends: lines.iter().map(|line| line.line_ends).sum(),
            one_end_each: lines.iter().all(|line| line.line_ends == 1),
            faulty: lines
                .iter()
                .any(|line| !line.errors.is_empty() || line.kind == LineKind::Stray),
            begins_with_up: lines.iter().any(begins_with_up),
            commented: lines.iter().any(|line| line.commented),
            in_conflict: lines.iter().any(|line| line.in_conflict),
            lines,
        }
    }

    /// The lines.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Where a line starts, in bytes from the start of the part.
    pub fn line_start(&self, line: usize) -> u32 {
        self.starts[line]
    }

    /// Its length in bytes.
    pub(crate) fn len(&self) -> u32 {
        self.starts[self.lines.len()]
    }

    /// The lines of its networks, counted from its first line, from top to bottom.
    pub fn networks(&self) -> impl Iterator<Item = Range<usize>> {
        self.items.iter().filter_map(|item| match *item {
            PartItem::Network(first, end) => Some(first as usize..end as usize),
            PartItem::Line(_) => None,
        })
    }

    /// The first line of its first network, counted from its first line.
    pub(crate) fn first_network(&self) -> Option<usize> {
        self.first_network.map(|line| line as usize)
    }

    /// How many physical lines end in it.
    pub(crate) fn line_ends(&self) -> u32 {
        self.line_ends
    }

    /// How many physical lines end above one of its lines.
    pub(crate) fn line_ends_above(&self, line: usize) -> u32 {
        if self.one_end_each {
            return line as u32;
        }
        self.lines[..line].iter().map(|line| line.line_ends).sum()
    }

    /// Whether one of its rungs begins with a `/`: nearly all begin with a rail.
    pub fn begins_with_up(&self) -> bool {
        self.begins_with_up
    }

    /// Whether a comment is on one of its lines.
    pub fn is_commented(&self) -> bool {
        self.commented
    }

    /// Whether one of its lines belongs to a merge's conflict.
    pub fn is_in_conflict(&self) -> bool {
        self.in_conflict
    }

    /// Whether one of its lines has an error, or is one.
    pub fn is_faulty(&self) -> bool {
        self.faulty
    }
}

fn begins_with_up(line: &Line) -> bool {
    line.kind == LineKind::Rung && line.ups > 0 && line.text().trim_start().starts_with('/')
}

/// Cuts the lines of a whole file into parts, as they come.
pub(crate) fn cut_file(mut lines: impl Iterator<Item = Line>) -> Vec<Arc<Part>> {
    let first: Vec<Line> = lines.by_ref().take(2 * USUAL_LINES + 1).collect();
    if first.len() <= 2 * USUAL_LINES {
        return cut(first);
    }
    cut_at(USUAL_LINES, USUAL_LINES, first.into_iter().chain(lines))
}

/// Cuts lines into parts.
pub(crate) fn cut(lines: Vec<Line>) -> Vec<Arc<Part>> {
    // What an edit leaves of a part stays one.
    let usual = if lines.len() > 2 * USUAL_LINES {
        USUAL_LINES
    } else {
        2 * USUAL_LINES
    };
    cut_at(usual, usual.min(lines.len()), lines.into_iter())
}

/// Cuts lines into parts of about this many; there are at least `least` lines.
fn cut_at(usual: usize, least: usize, lines: impl Iterator<Item = Line>) -> Vec<Arc<Part>> {
    let mut parts = Vec::new();
    let mut part = Vec::with_capacity(least);
    let mut open = false;
    for line in lines {
        open = is_open_after(open, &line);
        let may_end = !open && line.has_line_end;
        part.push(line);
        if may_end && part.len() >= usual {
            let full = std::mem::replace(&mut part, Vec::with_capacity(usual));
            parts.push(Arc::new(Part::new(full)));
        }
    }
    if !part.is_empty() {
        parts.push(Arc::new(Part::new(part)));
    }
    parts
}

/// Whether lines that end a part so are whole: they are enough, and what follows joins none of their networks.
pub(crate) fn can_end(lines: &[Line]) -> bool {
    lines.len() >= FEWEST_LINES
        && lines.last().is_none_or(|line| line.has_line_end)
        && !lines.iter().fold(false, is_open_after)
}

/// Whether a network is open after a line, so that a rung below may join it.
fn is_open_after(open: bool, line: &Line) -> bool {
    match line.kind {
        LineKind::Rung => line.downs > 0,
        LineKind::Rail | LineKind::Comment | LineKind::Blank | LineKind::Conflict | LineKind::Stray => open,
        LineKind::SectionHeader
        | LineKind::Declaration
        | LineKind::SectionEnd
        | LineKind::StructHeader
        | LineKind::StructEnd
        | LineKind::BlockHeader
        | LineKind::BlockEnd => false,
    }
}

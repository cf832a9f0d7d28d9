//! What the lines of a file form together: networks, sections, block definitions (LANGUAGE §2, §4, §5.7).
//!
//! All of it is read off the lines' summaries: first the networks of each part, of which an edit makes few again, and
//! from these what the file holds.

use crate::error::{DeclarationProblem, SyntaxErrorKind};
use crate::file_lines::FileLines;
use crate::line::{LineKind, ReadLine};
use crate::lines::{LineList, Lines};
use std::ops::Range;

/// The networks, sections and block definitions of a file, and the order in which they are.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Structure {
    /// Everything at the file's outermost level of reading, from top to bottom.
    pub items: Vec<Item>,
    /// The networks, those in block bodies too, from top to bottom.
    pub networks: Vec<Network>,
    /// The sections, those in block definitions too.
    pub sections: Vec<Section>,
    /// The definitions of user-defined blocks.
    pub blocks: Vec<BlockDefinition>,
    /// Errors that need more than one line to be seen, with the line that they are shown at.
    pub(crate) problems: Vec<(usize, SyntaxErrorKind)>,
}

/// The sections and block definitions of a file: what of its [`Structure`] can be known without going through its networks.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Frame {
    /// As [`Structure::sections`].
    pub sections: Vec<Section>,
    /// As [`Structure::blocks`].
    pub blocks: Vec<BlockDefinition>,
    /// As [`Structure::problems`].
    pub(crate) problems: Vec<(usize, SyntaxErrorKind)>,
}

impl Frame {
    /// Whether sections and block definitions begin and end where they should.
    pub fn is_whole(&self) -> bool {
        self.problems.is_empty()
    }
}

/// One thing in a file. Numbers of networks, sections and blocks are indices into [`Structure`]'s lists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Item {
    /// A network.
    Network(usize),
    /// A section.
    Section(usize),
    /// The first line of a block definition.
    BlockHeader(usize),
    /// The last line of a block definition; the number is the line's.
    BlockEnd(usize),
    /// A rail, comment or blank line between the others, or one of a conflict; the number is the line's.
    Decoration(usize),
    /// A line that holds nothing but errors; the number is the line's.
    Stray(usize),
}

/// A maximal chain of rungs that connectors may join. The rungs are the lines of kind [`LineKind::Rung`] in
/// `lines`; what else is between them is decoration (or a stray line, which is an error).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Network {
    /// From the first rung to the last.
    pub lines: Range<usize>,
    /// The block definition whose body it belongs to.
    pub block: Option<usize>,
}

impl Network {
    /// The numbers of the lines that are its rungs.
    pub fn rungs<'l, L: LineList + ?Sized>(
        &self,
        lines: &'l L,
    ) -> impl DoubleEndedIterator<Item = usize> + use<'l, L> {
        let range = self.lines.clone();
        range.filter(move |&line| lines.line(line).kind == LineKind::Rung)
    }
}

/// A section of declarations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Section {
    /// From the header to END_VAR or END_TYPE.
    pub lines: Range<usize>,
    /// Whether that is there.
    pub closed: bool,
    /// The block definition that it belongs to.
    pub block: Option<usize>,
}

/// The definition of a user-defined block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BlockDefinition {
    /// From FUNCTION_BLOCK to END_FUNCTION_BLOCK, or to the end of the text.
    pub lines: Range<usize>,
    /// Whether END_FUNCTION_BLOCK is there.
    pub closed: bool,
}

/// A network, or a line between networks, of some lines that no network leaves. Lines count from their start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PartItem {
    /// The first line of a network, and the one after its last.
    Network(u32, u32),
    /// Any other line.
    Line(u32),
}

/// The networks of some lines, and the lines between them.
pub(crate) fn group<N>(lines: &[ReadLine<N>]) -> Vec<PartItem> {
    let mut items = Vec::with_capacity(lines.len());
    // The open network, and whether its last rung has a `\`.
    let mut network: Option<(u32, u32)> = None;
    let mut goes_on = false;
    // Where its rail, comment, blank and stray lines begin in `items`.
    let mut between = 0;
    for (index, line) in (0..).zip(lines) {
        if line.kind == LineKind::Rung {
            let joins = goes_on && line.ups > 0;
            goes_on = line.downs > 0;
            if let Some(network) = network.as_mut().filter(|_| joins) {
                network.1 = index + 1;
                items.truncate(between);
                continue;
            }
            end_network(&mut items, between, network.replace((index, index + 1)));
            // Its own place, which is filled when it is known how far it reaches.
            items.push(PartItem::Line(index));
            between = items.len();
            continue;
        }
        if !line.kind.is_decoration() && line.kind != LineKind::Stray {
            end_network(&mut items, between, network.take());
        }
        items.push(PartItem::Line(index));
    }
    end_network(&mut items, between, network);
    items
}

fn end_network(items: &mut [PartItem], between: usize, network: Option<(u32, u32)>) {
    if let Some((first, end)) = network {
        items[between - 1] = PartItem::Network(first, end);
    }
}

/// What of a file's lines is read so far.
#[derive(Default)]
struct Grouping {
    out: Structure,
    block: Option<usize>,
    /// Lines before this one are read: they belong to a section.
    read_to: usize,
}

impl Grouping {
    /// Adds the items of some lines, of which the first is line `base` of all `lines`.
    fn add<L: LineList + ?Sized>(&mut self, lines: &L, base: usize, items: &[PartItem]) {
        for item in items {
            match *item {
                PartItem::Network(first, end) => self.network(base + first as usize..base + end as usize),
                PartItem::Line(line) => {
                    let line = base + line as usize;
                    if line >= self.read_to {
                        self.line(lines, line);
                    }
                }
            }
        }
    }

    fn network(&mut self, lines: Range<usize>) {
        self.out.items.push(Item::Network(self.out.networks.len()));
        self.out.networks.push(Network {
            lines,
            block: self.block,
        });
    }

    fn line<L: LineList + ?Sized>(&mut self, lines: &L, index: usize) {
        let out = &mut self.out;
        match lines.line(index).kind {
            // Groups have made networks of them.
            LineKind::Rung => {}
            LineKind::Rail | LineKind::Comment | LineKind::Blank | LineKind::Conflict => {
                out.items.push(Item::Decoration(index));
            }
            // An END_VAR without a section; the parser reported it.
            LineKind::Stray
            | LineKind::Declaration
            | LineKind::SectionEnd
            | LineKind::StructHeader
            | LineKind::StructEnd => {
                out.items.push(Item::Stray(index));
            }
            LineKind::SectionHeader => {
                let (end, closed) = section_end(lines, index);
                let last_mode = lines
                    .count()
                    .checked_sub(1)
                    .map(|last| lines.line(last).mode_after);
                // Where a drawing or a block definition ends it, that line's parse has reported it.
                let open = last_mode.filter(|mode| mode.is_in_section() && !closed);
                if let Some(mode) = open
                    && (end..lines.count()).all(|line| lines.line(line).kind.is_decoration())
                {
                    out.problems.push((index, bad(mode.not_closed())));
                }
                out.items.push(Item::Section(out.sections.len()));
                out.sections.push(Section {
                    lines: index..end,
                    closed,
                    block: self.block,
                });
                self.read_to = end;
            }
            LineKind::BlockHeader => {
                if let Some(open) = self.block {
                    out.problems.push((index, bad(DeclarationProblem::NestedBlock)));
                    out.blocks[open].lines.end = index;
                }
                self.block = Some(out.blocks.len());
                out.items.push(Item::BlockHeader(out.blocks.len()));
                out.blocks.push(BlockDefinition {
                    lines: index..lines.count(),
                    closed: false,
                });
            }
            LineKind::BlockEnd => {
                match self.block.take() {
                    Some(open) => {
                        out.blocks[open].lines.end = index + 1;
                        out.blocks[open].closed = true;
                    }
                    None => out
                        .problems
                        .push((index, bad(DeclarationProblem::EndWithoutBlock))),
                }
                out.items.push(Item::BlockEnd(index));
            }
        }
    }

    fn finish(mut self) -> Structure {
        if let Some(open) = self.block {
            let header = self.out.blocks[open].lines.start;
            self.out
                .problems
                .push((header, bad(DeclarationProblem::BlockNotClosed)));
        }
        self.out
    }
}

/// Groups the lines of a text, or of a stretch of it that is by itself.
pub(crate) fn structure<N>(lines: &Lines<N>) -> Structure {
    let mut grouping = Grouping::default();
    grouping.add(lines, 0, &group(lines.lines()));
    grouping.finish()
}

/// Groups the lines of a file, from what its parts know of theirs.
pub(crate) fn structure_of_parts(lines: &FileLines) -> Structure {
    let mut grouping = Grouping::default();
    // Lists that grow are copied again and again, and each copy takes new memory.
    let networks = lines.parts().iter().map(|part| part.networks().count()).sum();
    let drawn = lines.parts().iter().filter(|part| part.declares_to.is_none());
    grouping.out.networks.reserve_exact(networks);
    grouping
        .out
        .items
        .reserve_exact(drawn.map(|part| part.items.len()).sum());
    for (number, part) in lines.parts().iter().enumerate() {
        grouping.add(lines, lines.first_line(number), &part.items);
    }
    grouping.finish()
}

/// The sections and block definitions of a file.
pub(crate) fn frame_of_parts(lines: &FileLines) -> Frame {
    let mut grouping = Grouping::default();
    for (number, part) in lines.parts().iter().enumerate() {
        let first = lines.first_line(number);
        for &line in &part.frame {
            grouping.line(lines, first + line as usize);
        }
    }
    let Structure {
        sections,
        blocks,
        problems,
        ..
    } = grouping.finish();
    Frame {
        sections,
        blocks,
        problems,
    }
}

fn bad(problem: DeclarationProblem) -> SyntaxErrorKind {
    SyntaxErrorKind::BadDeclaration(problem)
}

/// The line after the section that begins at `header`, and whether END_VAR closes it. One that is not closed
/// reaches to its last declaration: blank and comment lines after that may belong to what follows.
fn section_end<L: LineList + ?Sized>(lines: &L, header: usize) -> (usize, bool) {
    let mut end = header + 1;
    let mut index = header;
    while index + 1 < lines.count() {
        index += 1;
        if let Some((after, last)) = lines.declarations_from(index) {
            end = last.unwrap_or(end);
            index = after - 1;
            continue;
        }
        match lines.line(index).kind {
            LineKind::SectionEnd => return (index + 1, true),
            LineKind::Declaration | LineKind::StructHeader | LineKind::StructEnd => end = index + 1,
            LineKind::Comment | LineKind::Blank | LineKind::Conflict => {}
            _ => break,
        }
    }
    (end, false)
}

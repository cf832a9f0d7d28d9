//! What the lines of a file form together: networks, sections, block definitions (LANGUAGE §2, §4, §5.7).
//!
//! All of it is read off the lines' summaries, so that it is cheap to regroup after an edit.

use crate::line::{Line, LineKind, Mode};
use crate::{DeclarationProblem, SyntaxErrorKind};
use std::ops::Range;

/// The networks, sections and block definitions of a file, and the order in which they stand.
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
    /// Mistakes that need more than one line to be seen, with the line that they are shown at.
    pub(crate) problems: Vec<(usize, SyntaxErrorKind)>,
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
    /// A rail, comment or blank line between the others; the number is the line's.
    Decoration(usize),
    /// A line that holds nothing but mistakes; the number is the line's.
    Stray(usize),
}

/// A maximal chain of rungs that connectors may join. The rungs are the lines of kind [`LineKind::Rung`] in
/// `lines`; what else stands between them is decoration (or a stray line, which is a mistake).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Network {
    /// From the first rung to the last.
    pub lines: Range<usize>,
    /// The block definition whose body it belongs to.
    pub block: Option<usize>,
}

impl Network {
    /// The numbers of the lines that are its rungs.
    pub fn rungs<'l, N>(&self, lines: &'l [Line<N>]) -> impl DoubleEndedIterator<Item = usize> + use<'l, N> {
        let range = self.lines.clone();
        range.filter(move |&line| lines[line].kind == LineKind::Rung)
    }
}

/// A section of declarations.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Section {
    /// From the header to END_VAR.
    pub lines: Range<usize>,
    /// Whether END_VAR is there.
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

#[derive(Default)]
struct Grouping {
    out: Structure,
    network: Option<Network>,
    /// Whether the last rung of the open network has a `\`.
    goes_on: bool,
    /// Decoration and stray lines behind the open network's last rung.
    between: Vec<Item>,
    block: Option<usize>,
}

impl Grouping {
    fn end_network(&mut self) {
        if let Some(network) = self.network.take() {
            self.out.items.push(Item::Network(self.out.networks.len()));
            self.out.networks.push(network);
        }
        self.out.items.append(&mut self.between);
    }

    fn rung<N>(&mut self, index: usize, line: &Line<N>) {
        let joins = self.goes_on && line.ups > 0;
        self.goes_on = line.downs > 0;
        if let Some(network) = self.network.as_mut().filter(|_| joins) {
            network.lines.end = index + 1;
            self.between.clear();
            return;
        }
        self.end_network();
        self.network = Some(Network {
            lines: index..index + 1,
            block: self.block,
        });
    }
}

/// Groups the lines of a file.
pub(crate) fn structure<N>(lines: &[Line<N>]) -> Structure {
    let mut g = Grouping::default();
    let mut index = 0;
    while let Some(line) = lines.get(index) {
        match line.kind {
            LineKind::Rung => g.rung(index, line),
            LineKind::Rail | LineKind::Comment | LineKind::Blank => g.between.push(Item::Decoration(index)),
            LineKind::Stray => g.between.push(Item::Stray(index)),
            LineKind::SectionHeader => {
                g.end_network();
                let (end, closed) = section_end(lines, index);
                // Where a drawing or a block definition ends it, that line's parse has said so.
                if !closed && lines.last().is_some_and(|l| l.mode_after == Mode::Section) && {
                    lines[end..].iter().all(|l| l.kind.is_decoration())
                } {
                    g.out
                        .problems
                        .push((index, bad(DeclarationProblem::SectionNotClosed)));
                }
                g.out.items.push(Item::Section(g.out.sections.len()));
                g.out.sections.push(Section {
                    lines: index..end,
                    closed,
                    block: g.block,
                });
                index = end;
                continue;
            }
            // An END_VAR without a section; the parser said so.
            LineKind::Declaration | LineKind::SectionEnd => {
                g.end_network();
                g.out.items.push(Item::Stray(index));
            }
            LineKind::BlockHeader => {
                g.end_network();
                if let Some(open) = g.block {
                    g.out.problems.push((index, bad(DeclarationProblem::NestedBlock)));
                    g.out.blocks[open].lines.end = index;
                }
                g.block = Some(g.out.blocks.len());
                g.out.items.push(Item::BlockHeader(g.out.blocks.len()));
                g.out.blocks.push(BlockDefinition {
                    lines: index..lines.len(),
                    closed: false,
                });
            }
            LineKind::BlockEnd => {
                g.end_network();
                match g.block.take() {
                    Some(open) => {
                        g.out.blocks[open].lines.end = index + 1;
                        g.out.blocks[open].closed = true;
                    }
                    None => g
                        .out
                        .problems
                        .push((index, bad(DeclarationProblem::EndWithoutBlock))),
                }
                g.out.items.push(Item::BlockEnd(index));
            }
        }
        index += 1;
    }
    g.end_network();
    if let Some(open) = g.block {
        let header = g.out.blocks[open].lines.start;
        g.out
            .problems
            .push((header, bad(DeclarationProblem::BlockNotClosed)));
    }
    g.out
}

fn bad(problem: DeclarationProblem) -> SyntaxErrorKind {
    SyntaxErrorKind::BadDeclaration(problem)
}

/// The line behind the section that begins at `header`, and whether END_VAR closes it. One that is not closed
/// reaches to its last declaration: blank and comment lines behind that may belong to what follows.
fn section_end<N>(lines: &[Line<N>], header: usize) -> (usize, bool) {
    let mut end = header + 1;
    for (index, line) in lines.iter().enumerate().skip(header + 1) {
        match line.kind {
            LineKind::SectionEnd => return (index + 1, true),
            LineKind::Declaration => end = index + 1,
            LineKind::Comment | LineKind::Blank => {}
            _ => break,
        }
    }
    (end, false)
}

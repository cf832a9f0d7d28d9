//! The program as it is drawn: its lines, and where on them is what can be selected or carries power.
//!
//! All of it is found once, when the program is loaded; drawing a screen then costs what the screen shows.

use super::fold::{Band, Folding, Window};
use super::{bands, operands};
use crate::findings::Source;
use ladder_analysis::program::{ElementKind, Location, Network, Place, Program};
use ladder_instructions::Instruction;
use ladder_notations::Foreign;
use ladder_simulator::{Point, Simulation};
use ladder_syntax::{Parse, SyntaxKind, TextRange};
use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

/// A program on paper.
#[derive(Debug)]
pub(super) struct Sheet {
    /// The file as it was named.
    pub(super) file: String,
    /// The file, if it is of another system.
    foreign: Option<Arc<Foreign>>,
    text: String,
    lines: Vec<Line>,
    /// Every block of the drawing, in the order in which one reads.
    pub(super) blocks: Vec<Block>,
    marks: Vec<Mark>,
    /// Where comments are in the text.
    comments: Vec<Range<usize>>,
    /// The lines that are folded and scrolled together, from top to bottom.
    bands: Vec<Band>,
    /// What the world outside gives to the program.
    pub(super) inputs: Vec<Point>,
    /// Where each tag's blocks are: indices into `blocks`, by the point's name, or that of the array.
    uses: HashMap<String, Vec<usize>>,
}

/// One line of the file.
#[derive(Debug, Clone, Default)]
struct Line {
    /// Its bytes in the text, without the line end.
    text: Range<usize>,
    marks: Range<usize>,
    blocks: Range<usize>,
}

/// A part of the drawing that carries power.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    /// Its first byte in the text.
    pub(super) start: usize,
    /// After its last byte.
    pub(super) end: usize,
    pub(super) kind: ElementKind,
    /// Its number in the simulation's list of powers.
    pub(super) element: usize,
}

/// A block that can be selected.
#[derive(Debug)]
pub(super) struct Block {
    /// Its line, from 0.
    pub(super) line: usize,
    /// Its bytes in the text.
    pub(super) start: usize,
    pub(super) end: usize,
    /// Its network, as the program counts them.
    pub(super) network: usize,
    /// Its row of the instruction table; none for a user-defined block.
    pub(super) instruction: Option<&'static Instruction>,
    /// Its tags that are always the same, in the order of its operands.
    pub(super) operands: Vec<Operand>,
    /// Its operands with a computed index.
    pub(super) indexed: Vec<IndexedOperand>,
    /// What the end of its line shows of it.
    pub(super) shown: Vec<Shown>,
}

/// An operand that may be another tag with each scan.
#[derive(Debug)]
pub(super) struct IndexedOperand {
    /// Its bytes in the text.
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) place: Place,
    /// The block writes it.
    pub(super) written: bool,
}

/// A tag that a block names.
#[derive(Debug, Clone)]
pub(super) struct Operand {
    /// Its bytes in the text.
    pub(super) start: usize,
    pub(super) end: usize,
    pub(super) point: Point,
    /// The block writes it.
    pub(super) written: bool,
}

/// A value at the end of a line.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shown {
    /// A timer or counter: how far it is, and how far it goes.
    Progress {
        name: String,
        reached: Point,
        goal: Point,
        /// How many columns the goal probably takes.
        goal_width: usize,
    },
    /// A number, time or text.
    Value(Point),
    /// An element with a computed index: which one it is now, and what it holds.
    Indexed(Indexed),
}

/// An operand with a computed index.
#[derive(Debug, Clone)]
pub(super) struct Indexed {
    /// As it is written.
    pub(super) written: String,
    pub(super) place: Place,
    /// An element of the array, for the room that one takes.
    pub(super) sample: Point,
}

/// What is written in the same way is the same element.
impl PartialEq for Indexed {
    fn eq(&self, other: &Indexed) -> bool {
        self.written == other.written
    }
}

impl Sheet {
    /// Draws up a program that is about to run.
    pub(super) fn new(source: &Source, simulation: &Simulation) -> Sheet {
        let program = simulation.program();
        let parse = ladder_syntax::parse(&source.text);
        let lines = source.line_ranges().map(|range| Line {
            text: without_line_end(&source.text, range),
            ..Line::default()
        });
        let mut sheet = Sheet {
            file: source.file.clone(),
            foreign: source.foreign().cloned(),
            text: source.text.clone(),
            lines: lines.collect(),
            blocks: Vec::new(),
            marks: marks(simulation),
            comments: comments(&parse),
            bands: Vec::new(),
            inputs: inputs(simulation),
            uses: HashMap::new(),
        };
        // After the last line end there is no line.
        if sheet.lines.len() > 1 && sheet.lines.last().is_some_and(|last| last.text.is_empty()) {
            sheet.lines.pop();
        }
        for (index, network) in own_networks(program) {
            for block in &network.blocks {
                sheet.blocks.push(Block {
                    line: 0,
                    start: block.location.range.start().into(),
                    end: block.location.range.end().into(),
                    network: index,
                    instruction: operands::instruction(block),
                    operands: operands::named(&source.text, block, simulation),
                    indexed: operands::indexed(block),
                    shown: operands::shown(&source.text, block, simulation),
                });
            }
        }
        sheet.blocks.sort_by_key(|block| block.start);
        sheet.share_out();
        for (index, block) in sheet.blocks.iter().enumerate() {
            let points = block.operands.iter().map(|operand| operand.point.name.as_str());
            // Which element of an array it is shows while it runs: any of them may be.
            let arrays = block.shown.iter().filter_map(|shown| match shown {
                Shown::Indexed(indexed) => array_of(&indexed.sample),
                _ => None,
            });
            for name in points.chain(arrays) {
                let uses = sheet.uses.entry(name.to_owned()).or_default();
                // A block may name a tag twice.
                if uses.last() != Some(&index) {
                    uses.push(index);
                }
            }
        }
        sheet.bands = bands::of(&sheet, &parse);
        sheet
    }

    /// Assigns its blocks and marks to every line.
    fn share_out(&mut self) {
        let (mut block, mut mark) = (0, 0);
        for (number, line) in self.lines.iter_mut().enumerate() {
            let first = block;
            while block < self.blocks.len() && self.blocks[block].start < line.text.end {
                self.blocks[block].line = number;
                block += 1;
            }
            line.blocks = first..block;
            // A comment that joins two wires may begin lines above.
            let first = mark;
            let mut last = mark;
            while last < self.marks.len() && self.marks[last].start < line.text.end {
                last += 1;
            }
            mark = last;
            while mark > first && self.marks[mark - 1].end > line.text.end {
                mark -= 1;
            }
            line.marks = first..last;
        }
    }

    /// What a pane of this many columns asks of all lines.
    pub(super) fn folding(&self, pane: usize) -> Folding {
        Folding::new(&self.bands, pane)
    }

    /// What a line is folded and scrolled with.
    pub(super) fn band(&self, line: usize) -> &Band {
        let after = self.bands.partition_point(|band| band.lines.start <= line);
        // The bands cover all lines.
        &self.bands[after.saturating_sub(1)]
    }

    /// What is seen of a line in a pane that is scrolled by `left` columns.
    pub(super) fn window(&self, line: usize, folding: Folding, left: usize) -> Window {
        folding.window(self.band(line), left)
    }

    /// The line that a place in the text is on.
    pub(super) fn line_at(&self, offset: usize) -> usize {
        let after = self.lines.partition_point(|line| line.text.start <= offset);
        after.saturating_sub(1)
    }

    /// How many lines it has.
    pub(super) fn height(&self) -> usize {
        self.lines.len()
    }

    /// The text of a line, without its line end and the byte order mark.
    pub(super) fn line(&self, line: usize) -> &str {
        &self.text[self.lines[line].text.clone()]
    }

    /// Where a line begins in the text.
    pub(super) fn line_start(&self, line: usize) -> usize {
        self.lines[line].text.start
    }

    /// What carries power on a line, from left to right.
    pub(super) fn marks(&self, line: usize) -> &[Mark] {
        &self.marks[self.lines[line].marks.clone()]
    }

    /// The numbers of a line's blocks.
    pub(super) fn blocks_of(&self, line: usize) -> Range<usize> {
        self.lines[line].blocks.clone()
    }

    /// Whether a place in the text lies in a comment.
    pub(super) fn is_comment(&self, offset: usize) -> bool {
        let after = self.comments.partition_point(|comment| comment.start <= offset);
        after
            .checked_sub(1)
            .is_some_and(|index| offset < self.comments[index].end)
    }

    /// The values that are at the end of a line.
    pub(super) fn shown(&self, line: usize) -> impl Iterator<Item = &Shown> {
        let mut before: Vec<&Shown> = Vec::new();
        self.blocks[self.blocks_of(line)]
            .iter()
            .flat_map(|block| &block.shown)
            .filter(move |shown| {
                let new = !before.contains(shown);
                before.push(shown);
                new
            })
    }

    /// The blocks that name a tag, in the order in which one reads.
    pub(super) fn uses(&self, point: &Point) -> &[usize] {
        let of_array = || self.uses.get(array_of(point)?);
        let uses = self.uses.get(&point.name).or_else(of_array);
        uses.map_or(&[], Vec::as_slice)
    }

    /// The lines of a network's blocks, from first to last.
    pub(super) fn first_line_of_network(&self, block: usize) -> usize {
        let network = self.blocks[block].network;
        let first = self.blocks[..=block]
            .iter()
            .rev()
            .take_while(|other| other.network == network)
            .last();
        first.map_or(0, |first| first.line)
    }

    /// A block's text, as written.
    pub(super) fn block_text(&self, block: &Block) -> &str {
        &self.text[block.start..block.end]
    }

    /// The block that a place in the text belongs to.
    pub(super) fn block_at(&self, offset: usize) -> Option<usize> {
        let after = self.blocks.partition_point(|block| block.start <= offset);
        let index = after.checked_sub(1)?;
        (offset < self.blocks[index].end).then_some(index)
    }

    /// The block at a place in the text, or the first one after it.
    pub(super) fn block_from(&self, offset: usize) -> usize {
        self.block_at(offset)
            .unwrap_or_else(|| self.blocks.partition_point(|block| block.start < offset))
    }

    /// The line that a place in the program's own file is on, from 0, and its column in characters, from 1.
    pub(super) fn place(&self, location: Location) -> Option<(usize, usize)> {
        if location.file != 0 {
            return None;
        }
        let offset = usize::from(location.range.start());
        let line = self.line_at(offset);
        let before = self.text.get(self.lines[line].text.start..offset)?;
        Some((line, before.chars().count() + 1))
    }

    /// A place in the program's own file as messages have it: `motor.clad:3:12`.
    pub(super) fn place_name(&self, location: Location) -> Option<String> {
        let (line, column) = self.place(location)?;
        Some(match &self.foreign {
            Some(foreign) => format!("{}:{}", self.file, foreign.place(location.range)),
            None => format!("{}:{}:{column}", self.file, line + 1),
        })
    }
}

/// The networks of the program's own file.
fn own_networks(program: &Program) -> impl Iterator<Item = (usize, &Network)> {
    let all = program.networks.iter().enumerate();
    all.filter(|(_, network)| network.location.file == 0)
}

/// What carries power in the program's own file, in the order of the text.
fn marks(simulation: &Simulation) -> Vec<Mark> {
    let own = simulation.power().enumerate();
    let mut marks: Vec<Mark> = own
        .filter(|(_, (_, location, _))| location.file == 0)
        .map(|(element, (kind, location, _))| Mark {
            start: location.range.start().into(),
            end: location.range.end().into(),
            kind,
            element,
        })
        .collect();
    marks.sort_by_key(|mark| mark.start);
    marks
}

fn comments(parse: &Parse) -> Vec<Range<usize>> {
    let tokens = parse.syntax().descendants_with_tokens();
    tokens
        .filter(|token| token.kind() == SyntaxKind::COMMENT)
        .map(|token| usize::from(token.text_range().start())..usize::from(token.text_range().end()))
        .collect()
}

fn inputs(simulation: &Simulation) -> Vec<Point> {
    let inputs = simulation.points().iter();
    inputs.filter(|point| point.is_input).cloned().collect()
}

fn without_line_end(text: &str, range: TextRange) -> Range<usize> {
    let range = usize::from(range.start())..usize::from(range.end());
    let line = &text[range.clone()];
    let kept = line.trim_end_matches(['\r', '\n']).len();
    let mark = if line.starts_with('\u{feff}') {
        '\u{feff}'.len_utf8()
    } else {
        0
    };
    range.start + mark..range.start + kept.max(mark)
}

/// The array that a value is an element of, or its part: `a` of `a[3]`.
fn array_of(point: &Point) -> Option<&str> {
    let (array, _) = point.name.split_once('[')?;
    Some(array)
}

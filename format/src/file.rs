//! Writing a file: what stands between its networks, sections and comments, and the column of its right rail
//! (LANGUAGE §8 rules 4 and 7).

use crate::Options;
use crate::columns::{Outline, Placer};
use crate::draw::Rails;
use crate::edit::Sink;
use crate::flat::Source;
use crate::network::Drawing;
use crate::pen::Pen;
use crate::read::Reader;
use crate::section;
use crate::sketch::ElementKind;
use crate::stays::{Stays, item_lines};
use crate::width::display_width;
use ladder_syntax::SyntaxKind::COMMENT;
use ladder_syntax::{Item, LineKind, MAX_FILE_BYTES, TextRange};
use std::ops::Range;

/// The right rail stands in a multiple of this many columns, counted from 1.
const RAIL_STEP: u32 = 20;
/// Where the right rail stands at the least, counted from 1.
const LEAST_RAIL: u32 = 40;

/// Formats a text: all of it, or what one of the ranges of `only` reaches into.
pub(crate) fn format<S: Sink>(
    source: Source<'_>,
    options: &Options,
    only: Option<&[TextRange]>,
    sink: S,
) -> S {
    let mut stays = Stays::find(source);
    let networks = Networks::read(source, options, &mut stays);
    let mut rail = file_rail(&networks.placed, options);
    if let Some(ranges) = only {
        keep_all_but(source, ranges, &mut stays);
        rail = rail.map(|rail| networks.rail_as_drawn(source, options, &stays).unwrap_or(rail));
    }
    let mut file = File {
        source,
        options,
        stays,
        networks,
        rail,
        pen: Pen::new(source.text, sink),
        between: Vec::new(),
        begun: false,
    };
    if source.text.starts_with('\u{feff}') {
        file.pen.keep(0, '\u{feff}'.len_utf8());
    }
    for item in &source.lines.structure().items {
        file.item(*item);
    }
    file.pen.finish()
}

/// A network that is drawn anew: its rungs in the sketch, and its outline.
#[derive(Clone)]
struct Placed {
    rungs: Range<usize>,
    outline: Outline,
}

/// The networks of a file.
struct Networks {
    reader: Reader,
    columns: Vec<u32>,
    placer: Placer,
    /// For each network; none if it stays as it is.
    placed: Vec<Option<Placed>>,
}

impl Networks {
    /// Reads and places all networks. Those that turn out to stay are noted in `stays`.
    fn read(source: Source<'_>, options: &Options, stays: &mut Stays) -> Networks {
        let structure = source.lines.structure();
        let mut networks = Networks {
            reader: Reader::default(),
            columns: Vec::new(),
            placer: Placer::default(),
            placed: Vec::with_capacity(structure.networks.len()),
        };
        // A staircase of rungs takes a drawing that grows with their square. What is drawn must remain a file
        // that the tools read; a network for which there is no room stays as it is.
        let mut room = MAX_FILE_BYTES as u64;
        for network in &structure.networks {
            let first = networks.reader.sketch.rungs.len();
            if stays.line(network.lines.start) || networks.reader.network(source, network).is_err() {
                stays.keep(network.lines.clone());
                networks.placed.push(None);
                continue;
            }
            let sketch = &networks.reader.sketch;
            let rungs = first..sketch.rungs.len();
            networks.columns.resize(sketch.elements.len(), 0);
            let outline =
                networks
                    .placer
                    .place_left(sketch, rungs.clone(), options.spacing, &mut networks.columns);
            let size = u64::from(outline.rail) * network.lines.len() as u64;
            if size > room {
                networks.reader.forget(first);
                stays.keep(network.lines.clone());
                networks.placed.push(None);
                continue;
            }
            room -= size;
            networks.placed.push(Some(Placed { rungs, outline }));
        }
        networks
    }

    /// The column, from 0, in which all networks that stay have their right rail, if there is one and the
    /// others have room in it.
    fn rail_as_drawn(&self, source: Source<'_>, options: &Options, stays: &Stays) -> Option<u32> {
        let mut drawn = None;
        let mut needed = 0;
        for (network, placed) in source.lines.structure().networks.iter().zip(&self.placed) {
            let Some(Placed { rungs, outline }) = placed else {
                continue;
            };
            if !outline.railed_right || outline.rail >= options.width {
                continue;
            }
            if !stays.line(network.lines.start) {
                needed = needed.max(outline.rail);
                continue;
            }
            for (rung, line) in rungs.clone().zip(source.rungs(network)) {
                let last = self.reader.sketch.rungs[rung].end as usize - 1;
                if self.reader.sketch.elements[last].kind != ElementKind::RightRail {
                    continue;
                }
                let rail = source.node(self.reader.atoms[last].node).start();
                let before = &source.text[source.range(line).start..rail];
                let column = display_width(before.rsplit(['\n', '\r']).next().unwrap_or(before));
                if *drawn.get_or_insert(column) != column {
                    return None;
                }
            }
        }
        drawn.filter(|&column| column >= needed)
    }
}

/// The column, from 0, of the file's right rail; none if no network within the width has one.
fn file_rail(networks: &[Option<Placed>], options: &Options) -> Option<u32> {
    let widest = networks
        .iter()
        .flatten()
        .filter(|network| network.outline.railed_right)
        .map(|network| network.outline.rail)
        .filter(|&rail| rail < options.width)
        .max()?;
    Some(least_rail(widest))
}

/// The first column, from 0, that is good for a rail and not left of `rail`.
pub(crate) fn least_rail(rail: u32) -> u32 {
    (rail + 1).next_multiple_of(RAIL_STEP).max(LEAST_RAIL) - 1
}

/// Makes stay what none of the ranges reaches into.
fn keep_all_but(source: Source<'_>, ranges: &[TextRange], stays: &mut Stays) {
    let lines = source.lines;
    let items = &lines.structure().items;
    let is_touched = |item: &Range<usize>| {
        let place = TextRange::new(lines.line_start(item.start), lines.line_range(item.end - 1).end());
        ranges.iter().any(|range| {
            // A cursor is on the line that begins there; at the end of the text on the last one.
            let cursor = range.is_empty()
                && (place.contains(range.start())
                    || (place.end() == range.start() && place.end() == lines.text_len()));
            cursor || place.intersect(*range).is_some_and(|common| !common.is_empty())
        })
    };
    let mut index = 0;
    while index < items.len() {
        // Blank and rail lines in a row become one line or none, so they stay together.
        let run = items[index..]
            .iter()
            .take_while(|item| matches!(item, Item::Decoration(line) if !source.has_comment(*line)))
            .count()
            .max(1);
        let run = &items[index..index + run];
        if run.iter().any(|item| !is_touched(&item_lines(lines, *item))) {
            for item in run {
                stays.keep(item_lines(lines, *item));
            }
        }
        index += run.len();
    }
}

struct File<'f, S> {
    source: Source<'f>,
    options: &'f Options,
    stays: Stays,
    networks: Networks,
    rail: Option<u32>,
    pen: Pen<'f, S>,
    /// Blank and rail lines behind the last thing.
    between: Vec<usize>,
    /// Something was written.
    begun: bool,
}

impl<S: Sink> File<'_, S> {
    fn item(&mut self, item: Item) {
        let lines = item_lines(self.source.lines, item);
        let line = lines.start;
        if !self.begun && self.source.text[self.source.range(line).start..].starts_with('\u{feff}') {
            // At the start of the text this stray character would become a byte order mark.
            self.between.clear();
            self.keep(0..line);
        }
        if self.stays.line(line) {
            self.begin();
            self.keep(lines);
            return;
        }
        match item {
            Item::Decoration(_) if !self.source.has_comment(line) => self.between.push(line),
            Item::Decoration(_) => {
                self.begin();
                section::comment_line(self.source, line, &mut self.pen);
                self.keep_line_end(line);
            }
            Item::Network(number) => {
                self.begin();
                self.network(number);
            }
            Item::Section(_) => {
                self.begin();
                section::write(self.source, lines, &mut self.pen);
            }
            Item::BlockHeader(_) | Item::BlockEnd(_) => {
                self.begin();
                if !self.source.has_mistake(line) && !self.has_leading_comment(line) {
                    section::words(self.source, line, &mut self.pen);
                    self.keep_line_end(line);
                } else {
                    self.keep(lines);
                }
            }
            Item::Stray(_) => {
                self.begin();
                self.keep(lines);
            }
        }
    }

    fn network(&mut self, number: usize) {
        let Some(Placed { rungs, outline }) = self.networks.placed[number].clone() else {
            return;
        };
        let right = outline.railed_right.then_some(match self.rail {
            Some(rail) if outline.rail < self.options.width => rail,
            _ => outline.rail,
        });
        if let Some(rail) = right {
            self.networks.placer.place_right(
                &self.networks.reader.sketch,
                rungs.clone(),
                self.options.spacing,
                rail,
                &mut self.networks.columns,
            );
        }
        Drawing {
            source: self.source,
            network: &self.source.lines.structure().networks[number],
            reader: &self.networks.reader,
            columns: &self.networks.columns,
            first_rung: rungs.start,
            rails: Rails {
                left: outline.railed_left,
                right,
            },
            spacing: self.options.spacing,
        }
        .write(&mut self.pen);
    }

    /// Writes what belongs between the last thing and the one that comes: a blank line if one was blank, a
    /// rail line if only those stood there, else nothing. Before the first thing stands nothing.
    fn begin(&mut self) {
        let begun = std::mem::replace(&mut self.begun, true);
        let Some(&first) = self.between.first().filter(|_| begun) else {
            self.between.clear();
            return;
        };
        let is_blank = |line: &usize| self.source.kind(*line) == LineKind::Blank;
        let blank = self.between.iter().copied().find(is_blank);
        if blank.is_none() {
            self.pen.bar();
            if let Some(column) = self.rail {
                self.pen.blanks(column - 1);
                self.pen.bar();
            }
        }
        self.keep_line_end(blank.unwrap_or(first));
        self.between.clear();
    }

    /// Keeps lines to the letter.
    fn keep(&mut self, lines: Range<usize>) {
        if let Some(last) = lines.clone().next_back() {
            self.pen
                .keep(self.source.range(lines.start).start, self.source.range(last).end);
        }
    }

    fn keep_line_end(&mut self, line: usize) {
        if let Some(line_end) = self.source.line_end(line) {
            self.pen.keep(line_end, self.source.range(line).end);
        }
    }

    /// Whether a comment stands first on a line.
    fn has_leading_comment(&self, line: usize) -> bool {
        let mut words = self.source.line(line).children();
        let first = words.find(|child| !child.kind().is_trivia() || child.kind() == COMMENT);
        first.is_some_and(|child| child.kind() == COMMENT)
    }
}

//! Writing a file: what stands between its networks, sections and comments, and the column of its right rail
//! (LANGUAGE §8 rules 4 and 7).

use crate::Options;
use crate::columns::{Outline, Placer};
use crate::draw::Rails;
use crate::edit::Sink;
use crate::network::{Drawing, has_comment};
use crate::pen::Pen;
use crate::read;
use crate::section::{self, line_end_of};
use crate::sketch::{ElementKind, Sketch};
use crate::stays::{Stays, directive, item_lines};
use crate::width::display_width;
use ladder_syntax::SyntaxKind::COMMENT;
use ladder_syntax::{Item, LineKind, Parse, TextRange};
use std::ops::Range;

/// The right rail stands in a multiple of this many columns, counted from 1.
const RAIL_STEP: u32 = 20;
/// Where the right rail stands at the least, counted from 1.
const LEAST_RAIL: u32 = 40;

/// Formats a text: all of it, or what touches the ranges of `only`.
pub(crate) fn format<S: Sink>(
    text: &str,
    parse: &Parse,
    options: &Options,
    only: Option<&[TextRange]>,
    sink: S,
) -> S {
    let mut stays = Stays::find(parse, text);
    let mut networks = Networks::read(text, parse, options, &mut stays);
    let mut rail = file_rail(&networks.outlines, options);
    if let Some(ranges) = only {
        keep_all_but(parse, ranges, &mut stays);
        rail = rail.map(|rail| {
            networks
                .rail_as_drawn(text, parse, options, &stays)
                .unwrap_or(rail)
        });
    }
    let mut file = File {
        text,
        parse,
        options,
        stays: &stays,
        rail,
        pen: Pen::new(text, sink),
        between: Vec::new(),
        begun: false,
    };
    if text.starts_with('\u{feff}') {
        file.pen.keep(0, '\u{feff}'.len_utf8());
    }
    for item in &parse.structure().items {
        file.item(*item, &mut networks);
    }
    file.finish()
}

/// The networks of a file that are drawn anew.
struct Networks {
    sketch: Sketch,
    places: Vec<u32>,
    columns: Vec<u32>,
    /// For each network of the file its rungs in the sketch, and its outline; none if it stays as it is.
    rungs: Vec<Option<Range<usize>>>,
    outlines: Vec<Option<Outline>>,
    placer: Placer,
}

impl Networks {
    /// Reads and places all networks. Those that turn out to stay are noted in `stays`.
    fn read(text: &str, parse: &Parse, options: &Options, stays: &mut Stays) -> Networks {
        let structure = parse.structure();
        let mut sketch = Sketch::new();
        let mut places = Vec::new();
        let mut rungs = Vec::with_capacity(structure.networks.len());
        for network in &structure.networks {
            let first = sketch.rungs.len();
            let read = if stays.line(network.lines.start) {
                Err(read::Stays)
            } else {
                network.rungs(parse.lines()).try_for_each(|index| {
                    let line = &parse.lines()[index];
                    let start = usize::from(parse.line_start(index));
                    let elements = places.len();
                    let in_body = network.block.is_some();
                    read::rung(text, line, start, in_body, &mut sketch, &mut places)?;
                    comments_stay_comments(text, parse, index, places.get(elements).copied())
                })
            };
            if read.is_ok() {
                sketch.pair(first..sketch.rungs.len());
                rungs.push(Some(first..sketch.rungs.len()));
            } else {
                stays.keep(network.lines.clone());
                sketch.truncate(first);
                places.truncate(sketch.elements.len());
                rungs.push(None);
            }
        }
        let mut columns = vec![0; sketch.elements.len()];
        let mut placer = Placer::default();
        let outlines = rungs
            .iter()
            .map(|rungs| {
                let rungs = rungs.clone()?;
                Some(placer.place_left(&sketch, rungs, options.spacing, &mut columns))
            })
            .collect();
        Networks {
            sketch,
            places,
            columns,
            rungs,
            outlines,
            placer,
        }
    }

    /// The column, from 0, in which all networks that stay have their right rail, if there is one and the
    /// others have room in it.
    fn rail_as_drawn(&self, text: &str, parse: &Parse, options: &Options, stays: &Stays) -> Option<u32> {
        let mut drawn = None;
        let mut needed = 0;
        for (number, network) in parse.structure().networks.iter().enumerate() {
            let (Some(rungs), Some(outline)) = (&self.rungs[number], self.outlines[number]) else {
                continue;
            };
            if !outline.railed_right || outline.rail >= options.width {
                continue;
            }
            if !stays.line(network.lines.start) {
                needed = needed.max(outline.rail);
                continue;
            }
            for (rung, line) in rungs.clone().zip(network.rungs(parse.lines())) {
                let last = self.sketch.rungs[rung].end as usize - 1;
                if self.sketch.elements[last].kind != ElementKind::RightRail {
                    continue;
                }
                let start = usize::from(parse.line_start(line));
                let before = &text[start..start + self.places[last] as usize];
                let column = display_width(before.rsplit(['\n', '\r']).next().unwrap_or(before));
                if *drawn.get_or_insert(column) != column {
                    return None;
                }
            }
        }
        drawn.filter(|&column| column >= needed)
    }
}

/// A comment that goes onto a line of its own must not become a directive there.
fn comments_stay_comments(
    text: &str,
    parse: &Parse,
    line: usize,
    first_element: Option<u32>,
) -> Result<(), read::Stays> {
    let mut result = Ok(());
    let start = usize::from(parse.line_start(line));
    let first = start + first_element.unwrap_or(0) as usize;
    read::each_child(&parse.lines()[line], start, |kind, _, from, to| {
        if kind == COMMENT && from < first && directive(&text[from..to]).is_some() {
            result = Err(read::Stays);
        }
    });
    result
}

/// The column, from 0, of the file's right rail; none if no network within the width has one.
fn file_rail(outlines: &[Option<Outline>], options: &Options) -> Option<u32> {
    let widest = outlines
        .iter()
        .flatten()
        .filter(|outline| outline.railed_right)
        .map(|outline| outline.rail + 1)
        .filter(|&width| width <= options.width)
        .max()?;
    Some(widest.next_multiple_of(RAIL_STEP).max(LEAST_RAIL) - 1)
}

/// Makes stay what touches none of the ranges.
fn keep_all_but(parse: &Parse, ranges: &[TextRange], stays: &mut Stays) {
    let items = &parse.structure().items;
    let is_touched = |lines: &Range<usize>| {
        let place = TextRange::new(
            parse.line_start(lines.start),
            parse.line_range(lines.end - 1).end(),
        );
        ranges.iter().any(|range| {
            // A cursor is on the line that begins there; at the end of the text on the last one.
            let cursor = range.is_empty()
                && (place.contains(range.start())
                    || place.end() == range.start() && place.end() == parse.text_len());
            cursor || place.intersect(*range).is_some_and(|common| !common.is_empty())
        })
    };
    let mut index = 0;
    while index < items.len() {
        // Blank and rail lines in a row become one line or none, so they stay together.
        let run = items[index..]
            .iter()
            .take_while(|item| matches!(item, Item::Decoration(line) if !has_comment(&parse.lines()[*line])))
            .count()
            .max(1);
        let untouched = items[index..index + run]
            .iter()
            .any(|item| !is_touched(&item_lines(parse, *item)));
        if untouched {
            for item in &items[index..index + run] {
                stays.keep(item_lines(parse, *item));
            }
        }
        index += run;
    }
}

struct File<'f, S> {
    text: &'f str,
    parse: &'f Parse,
    options: &'f Options,
    stays: &'f Stays,
    rail: Option<u32>,
    pen: Pen<'f, S>,
    /// Blank and rail lines behind the last thing.
    between: Vec<usize>,
    /// Something was written.
    begun: bool,
}

impl<S: Sink> File<'_, S> {
    fn item(&mut self, item: Item, networks: &mut Networks) {
        let lines = item_lines(self.parse, item);
        let line = &self.parse.lines()[lines.start];
        let start = usize::from(self.parse.line_start(lines.start));
        if !self.begun && self.text[start..].starts_with('\u{feff}') {
            // At the start of the text this stray character would become a byte order mark.
            self.between.clear();
            self.keep(0..lines.start);
        }
        if self.stays.line(lines.start) || matches!(item, Item::Stray(_)) {
            self.begin();
            self.keep(lines);
            return;
        }
        match item {
            Item::Decoration(index) if !has_comment(line) => self.between.push(index),
            Item::Decoration(index) => {
                self.begin();
                section::comments(line, start, 0, &mut self.pen);
                self.keep_line_end(index);
            }
            Item::Network(number) => {
                self.begin();
                self.network(number, networks);
            }
            Item::Section(_) => {
                self.begin();
                section::write(self.text, self.parse, lines, &mut self.pen);
            }
            Item::BlockHeader(_) | Item::BlockEnd(_) => {
                self.begin();
                if line.errors.is_empty() && !has_leading_comment(self.parse, lines.start) {
                    section::words(self.text, line, start, &mut self.pen);
                    self.keep_line_end(lines.start);
                } else {
                    self.keep(lines);
                }
            }
            Item::Stray(_) => {}
        }
    }

    fn network(&mut self, number: usize, networks: &mut Networks) {
        let (Some(rungs), Some(outline)) = (networks.rungs[number].clone(), networks.outlines[number]) else {
            return;
        };
        let right = outline.railed_right.then_some(match self.rail {
            Some(rail) if outline.rail < self.options.width => rail,
            _ => outline.rail,
        });
        if let Some(rail) = right {
            networks.placer.place_right(
                &networks.sketch,
                rungs.clone(),
                self.options.spacing,
                rail,
                &mut networks.columns,
            );
        }
        Drawing {
            text: self.text,
            parse: self.parse,
            network: &self.parse.structure().networks[number],
            sketch: &networks.sketch,
            places: &networks.places,
            columns: &networks.columns,
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
        let between = std::mem::take(&mut self.between);
        let kind = |index: &usize| self.parse.lines()[*index].kind;
        if let Some(blank) = between.iter().find(|&index| kind(index) == LineKind::Blank) {
            if self.begun {
                self.keep_line_end(*blank);
            }
        } else if let Some(rail) = between.first().filter(|_| self.begun) {
            self.pen.bar();
            if let Some(column) = self.rail {
                self.pen.blanks(column - 1);
                self.pen.bar();
            }
            self.keep_line_end(*rail);
        }
        self.begun = true;
        self.between = between;
        self.between.clear();
    }

    /// Keeps lines to the letter.
    fn keep(&mut self, lines: Range<usize>) {
        let Some(last) = lines.clone().next_back() else {
            return;
        };
        let start = self.parse.line_start(lines.start).into();
        let end = self.parse.line_range(last).end().into();
        self.pen.keep(start, end);
    }

    fn keep_line_end(&mut self, line: usize) {
        let range = self.parse.line_range(line);
        let end = range.end().into();
        if let Some(line_end) = line_end_of(self.text, range.start().into(), end) {
            self.pen.keep(line_end, end);
        }
    }

    fn finish(self) -> S {
        self.pen.finish()
    }
}

/// Whether a comment stands first on a line.
fn has_leading_comment(parse: &Parse, line: usize) -> bool {
    let mut first = None;
    read::each_child(&parse.lines()[line], 0, |kind, _, _, _| {
        if !kind.is_trivia() || kind == COMMENT {
            first.get_or_insert(kind);
        }
    });
    first == Some(COMMENT)
}

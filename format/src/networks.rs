//! Reading and placing the networks of a file, and the column of its right rail (LANGUAGE §8 rule 4).

use crate::Options;
use crate::columns::{Outline, Placer};
use crate::flat::Source;
use crate::read::Reader;
use crate::sketch::ElementKind;
use crate::stays::Stays;
use crate::width::display_width;
use ladder_syntax::{MAX_FILE_BYTES, Network};
use std::ops::Range;

/// The right rail is in a multiple of this many columns, counted from 1.
const RAIL_STEP: u32 = 20;
/// Where the right rail is at the least, counted from 1.
const LEAST_RAIL: u32 = 40;

/// A network that is drawn anew: its rungs in the sketch, and its outline.
#[derive(Clone)]
pub(crate) struct Placed {
    pub(crate) rungs: Range<usize>,
    pub(crate) outline: Outline,
}

/// The networks of a part of a file.
#[derive(Default)]
pub(crate) struct Networks {
    pub(crate) reader: Reader,
    pub(crate) columns: Vec<u32>,
    pub(crate) placer: Placer,
    /// For each network; none if it stays as it is.
    pub(crate) placed: Vec<Option<Placed>>,
    /// How much was drawn of the file so far.
    drawn: u64,
}

impl Networks {
    /// Reads and places all networks of a part, in the place of those of the part before. Those that turn out to stay
    /// are noted in `stays`.
    pub(crate) fn read(&mut self, source: Source<'_>, options: &Options, stays: &mut Stays) {
        self.reader.clear();
        self.placed.clear();
        for network in &source.lines.structure().networks {
            let placed = if stays.line(network.lines.start) {
                None
            } else {
                self.place(source, options, network)
            };
            if placed.is_none() {
                stays.keep(network.lines.clone());
            }
            self.placed.push(placed);
        }
    }

    /// Begins to count anew how much is drawn.
    pub(crate) fn begin_file(&mut self) {
        self.drawn = 0;
    }

    fn place(&mut self, source: Source<'_>, options: &Options, network: &Network) -> Option<Placed> {
        let first = self.reader.sketch.rungs.len();
        self.reader.network(source, network).ok()?;
        let sketch = &self.reader.sketch;
        let rungs = first..sketch.rungs.len();
        self.columns.resize(sketch.elements.len(), 0);
        let outline = self
            .placer
            .place_left(sketch, rungs.clone(), options.spacing, &mut self.columns);
        // A staircase of rungs takes a drawing that grows with their square. What is drawn must remain a file
        // that the tools read; a network for which there is no room stays as it is.
        let size = u64::from(outline.rail) * network.lines.len() as u64;
        if self.drawn + size > MAX_FILE_BYTES as u64 {
            self.reader.forget(first);
            return None;
        }
        self.drawn += size;
        Some(Placed { rungs, outline })
    }

    /// The column, from 0, of the right rail that these networks ask for; none if none within the width has one.
    pub(crate) fn rail(&self, options: &Options) -> Option<u32> {
        let widest = self
            .placed
            .iter()
            .flatten()
            .filter(|network| network.outline.railed_right)
            .map(|network| network.outline.rail)
            .filter(|&rail| rail < options.width)
            .max()?;
        Some(rail_column(widest))
    }

    /// The column, from 0, in which all networks that stay have their right rail, if there is one and the
    /// others have room in it.
    pub(crate) fn rail_as_drawn(&self, source: Source<'_>, options: &Options, stays: &Stays) -> Option<u32> {
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

/// The column, from 0, of the right rail for networks that need it at `rail` at the least.
pub(crate) fn rail_column(rail: u32) -> u32 {
    (rail + 1).next_multiple_of(RAIL_STEP).max(LEAST_RAIL) - 1
}

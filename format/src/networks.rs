//! Reading and placing the networks of a file, and the column of the right rail of each (LANGUAGE §8 rule 4).

use crate::Options;
use crate::columns::{Outline, Placer};
use crate::flat::Source;
use crate::read::Reader;
use crate::stays::Stays;
use ladder_syntax::{MAX_FILE_BYTES, Network};
use std::ops::Range;

/// The right rail of a network that is wider than the setting is in a multiple of this many columns, counted from 1.
const RAIL_STEP: u32 = 20;

/// A network that is drawn again: its rungs in the sketch, and its outline.
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

    /// Begins to count again how much is drawn.
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
        let width = if outline.railed_right {
            rail_column(outline.rail, options) + 1
        } else {
            outline.rail
        };
        let size = u64::from(width) * network.lines.len() as u64;
        if self.drawn + size > MAX_FILE_BYTES as u64 {
            self.reader.forget(first);
            return None;
        }
        self.drawn += size;
        Some(Placed { rungs, outline })
    }
}

/// The column, from 0, of the right rail of a network that needs it at `least` at the least: that of the setting, or its own.
pub(crate) fn rail_column(least: u32, options: &Options) -> u32 {
    if least < options.width {
        options.width - 1
    } else {
        (least + 1).next_multiple_of(RAIL_STEP) - 1
    }
}

//! Drawing a network that has no text yet: for importers and refactorings.

use crate::Options;
use crate::columns::Placer;
use crate::draw::{self, Rails, Surface};
use crate::networks::rail_column;
use crate::sketch::{ElementKind, Sketch};

/// A sketch whose elements have their columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Layout {
    sketch: Sketch,
    columns: Vec<u32>,
    rails: Rails,
}

impl Sketch {
    /// Works out the columns of a network.
    pub fn lay_out(mut self, options: &Options) -> Layout {
        let options = options.checked();
        let rungs = 0..self.rungs.len();
        self.pair(rungs.clone());
        let mut columns = vec![0; self.elements.len()];
        let mut placer = Placer::default();
        let outline = placer.place_left(&self, rungs.clone(), options.spacing, &mut columns);
        let rail = rail_column(outline.rail, &options);
        let right = outline.railed_right.then_some(rail);
        if right.is_some() {
            placer.place_right(&self, rungs, options.spacing, rail, &mut columns);
        }
        Layout {
            sketch: self,
            columns,
            rails: Rails {
                left: outline.railed_left,
                right,
            },
        }
    }
}

impl Layout {
    /// The sketch, with its elements in the order of [`Layout::columns`].
    pub fn sketch(&self) -> &Sketch {
        &self.sketch
    }

    /// The column, from 0, in which each element of the sketch begins.
    pub fn columns(&self) -> &[u32] {
        &self.columns
    }

    /// The column, from 0, of the right rail, if the network ends at one.
    pub fn right_rail(&self) -> Option<u32> {
        self.rails.right
    }

    /// Draws the network after `out`, each rung with `line_end` after it. `text` returns the text of each block
    /// and comment by its number in the sketch; it must be as wide as the sketch says.
    pub fn draw<'t>(&self, text: impl Fn(usize) -> &'t str, line_end: &str, out: &mut String) {
        for rung in 0..self.sketch.rungs.len() {
            let mut surface = NewText {
                sketch: &self.sketch,
                text: &text,
                out,
            };
            draw::rung(&self.sketch, rung, &self.columns, self.rails, &mut surface);
            out.push_str(line_end);
        }
    }
}

struct NewText<'d, F> {
    sketch: &'d Sketch,
    text: &'d F,
    out: &'d mut String,
}

impl<'t, F: Fn(usize) -> &'t str> Surface for NewText<'_, F> {
    fn blanks(&mut self, count: u32) {
        self.out.extend(std::iter::repeat_n(' ', count as usize));
    }

    fn dashes(&mut self, count: u32) {
        self.out.extend(std::iter::repeat_n('-', count as usize));
    }

    fn bar(&mut self) {
        self.out.push('|');
    }

    fn element(&mut self, index: usize) {
        match self.sketch.elements[index].kind {
            ElementKind::LeftRail | ElementKind::RightRail => self.out.push('+'),
            ElementKind::Down => self.out.push('\\'),
            ElementKind::Up => self.out.push('/'),
            _ => self.out.push_str((self.text)(index)),
        }
    }
}

//! One network of a picture as a drawing of its own, with marks at some of its elements: for a page that has its own style
//! sheet, [`style_sheet`] among it.

use super::shapes::{Block, BlockKind, Picture, Placed};
use super::style::{MARGIN, Theme, sheet};
use super::svg::write;
use std::collections::{HashMap, HashSet};
use std::fmt::Write;

/// What a page needs that shows excerpts in these colours.
pub fn style_sheet(theme: Theme) -> String {
    sheet(theme)
}

/// The networks of a picture, for those who want some of them one by one.
#[derive(Debug)]
pub struct Excerpts<'s> {
    picture: &'s Picture,
    blocks: HashMap<usize, (&'s Block, usize)>,
    placed: HashMap<usize, Vec<&'s Placed>>,
}

impl<'s> Excerpts<'s> {
    /// Of a picture.
    pub fn new(picture: &'s Picture) -> Excerpts<'s> {
        let blocks = picture.blocks.iter().filter_map(|block| match block.kind {
            BlockKind::Network { index, line } => Some((index, (block, line))),
            _ => None,
        });
        let mut placed: HashMap<usize, Vec<&Placed>> = HashMap::new();
        for element in &picture.placed {
            placed.entry(element.element.network).or_default().push(element);
        }
        Excerpts {
            picture,
            blocks: blocks.collect(),
            placed,
        }
    }

    /// Draws a network by its index. An element (its rung, and which part of that it is) that is marked has a rectangle of the
    /// class `changed` below it. None: the picture has no such network.
    pub fn svg(&self, network: usize, marked: &[(usize, usize)]) -> Option<String> {
        let (block, line) = self.blocks.get(&network)?;
        let (top, height) = (block.rows.start, block.rows.end - block.rows.start);
        let width = block.right + MARGIN;
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 {top} {width} {height}\" role=\"img\"><title>Line {line}</title>\n"
        );
        let marked: HashSet<(usize, usize)> = marked.iter().copied().collect();
        let placed = self.placed.get(&network).into_iter().flatten();
        for placed in placed.filter(|placed| marked.contains(&(placed.element.rung, placed.element.part))) {
            let ((left, right), (above, below)) = (placed.columns, placed.rows);
            // Writing to a String does not fail.
            let _ = writeln!(
                out,
                "<rect class=\"changed\" x=\"{left}\" y=\"{above}\" width=\"{}\" height=\"{}\" rx=\"3\"/>",
                (right - left).max(1),
                (below - above).max(1),
            );
        }
        for shape in &self.picture.shapes[block.shapes.clone()] {
            write(shape, "", &mut out);
        }
        out.push_str("</svg>\n");
        Some(out)
    }
}

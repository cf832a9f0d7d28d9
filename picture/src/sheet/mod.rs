//! A drawn file as pages for a printer: title, declarations, the networks with their numbers, and the cross-reference.
//!
//! ```text
//! Picture, declarations --flow--> strips: a row of the table, a comment, a network or a piece of one
//!                               --pages--> strips at their places on sheets, with title and page number
//! ```
//!
//! A page breaks between networks. A network that is larger than a page is made smaller as long as it can be read, then
//! cut: below each other between rungs, next to each other through wires, which are then numbered at both ends.

mod cross_reference;
mod cut;
mod declarations;
mod flow;
mod pages;
mod table;

use super::shapes::{Extent, Picture, Shape};
use ladder_analysis::context::Context;

/// What is printed on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Size {
    /// 210 mm by 297 mm.
    #[default]
    A4,
    /// 8.5 by 11 inches.
    Letter,
}

/// Which way up a page is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// Higher than wide.
    #[default]
    Portrait,
    /// Wider than high.
    Landscape,
}

/// How pages are made.
#[derive(Debug, Clone, Copy)]
pub struct Options<'o> {
    /// The size of a page.
    pub size: Size,
    /// Which way up it is.
    pub orientation: Orientation,
    /// What is at the head of each page.
    pub title: &'o str,
    /// What is there besides, on the right.
    pub note: &'o str,
    /// The title block at the foot of each page, from left to right: what the project and the program are called, the version,
    /// the day. Without anything in it only the pages are numbered there.
    pub block: &'o [String],
}

impl Options<'_> {
    /// The column of the right rail at which a network takes the whole width of a page, in letters of full size.
    pub fn rail(&self) -> u32 {
        pages::Pages::new(self).columns().saturating_sub(2)
    }
}

/// A page. Lengths are in points: 72 to the inch.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// Its width.
    pub width: f32,
    /// Its height.
    pub height: f32,
    /// What is on it.
    pub pieces: Vec<Piece>,
}

/// A part of a drawing at its place on a page.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// The shapes.
    pub shapes: Vec<Shape>,
    /// The part of their plane that is seen, in pixels.
    pub window: Extent,
    /// Where its upper left corner is, from that of the page.
    pub at: (f32, f32),
    /// Points to a pixel.
    pub scale: f32,
}

impl Size {
    /// Width and height, upright.
    pub const fn points(self) -> (f32, f32) {
        match self {
            Size::A4 => (595.28, 841.89),
            Size::Letter => (612.0, 792.0),
        }
    }
}

/// The pages of a file.
pub fn sheets(context: &Context, picture: &Picture, options: &Options<'_>) -> Vec<Sheet> {
    let mut pages = pages::Pages::new(options);
    flow::fill(&mut pages, context, picture);
    cross_reference::fill(&mut pages, context);
    pages.finish(options)
}

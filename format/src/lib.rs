//! The canonical layout of ladder text.
//!
//! A drawing has one right form: wires as short as they can be, connectors of a pair in one column, coils at
//! the right rail, one blank between operands. This crate brings a text into that form
//! and says what changes as small edits.
//!
//! ```text
//! text --flat---> nodes and tokens as a list, straight from the grammar
//!      --stays--> which lines keep their form (errors, fmt off)
//!      --read---> Sketch: elements with widths, joined or not, rung by rung
//!                    --columns--> a column for each element, first left, then what acts to the right
//!                                     --draw--> rungs, rails, verticals
//!                                                   --pen--> edits, or the new text
//! ```
//!
//! A file goes through this part by part (`file`), so that its size takes neither memory nor the processor's cache.
//!
//! What holds for every text: formatting twice gives the same text; nothing is lost but blanks, dashes, `|` and
//! line ends; the wiring, and with it what the program does, stays the same. The [`Sketch`] and its columns
//! know nothing of text, so that code that makes new networks draws them with the same writer. A whole program is written
//! from a [`program::ProgramSketch`].

mod block;
mod circuit;
mod columns;
mod difference;
mod draw;
mod edit;
mod file;
mod flat;
mod layout;
pub mod names;
mod network;
mod networks;
mod pen;
mod pieces;
mod plain;
pub mod program;
mod ranges;
mod read;
mod section;
mod sketch;
mod stays;
mod width;

pub use circuit::{Circuit, Piece, PieceKind};
pub use difference::difference;
pub use edit::{Edit, apply};
pub use layout::Layout;
pub use sketch::{Element, ElementKind, Sketch};
pub use stays::is_switched_off;
pub use width::display_width;

use edit::{Edits, NewText};
use ladder_syntax::{Parse, TextRange};

/// How a text is laid out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// The column, from 1, of the right rail. A wider network has its own, in a multiple of 20: so its drawing depends on
    /// nothing else of the file.
    pub width: u32,
    /// The least number of columns between neighbours on a rung; at least 1.
    pub spacing: u32,
}

impl Default for Options {
    fn default() -> Self {
        Options {
            width: 80,
            spacing: 2,
        }
    }
}

impl Options {
    fn checked(&self) -> Options {
        Options {
            width: self.width.min(10_000),
            spacing: self.spacing.clamp(1, 40),
        }
    }
}

/// The edits that bring a text into its canonical layout: sorted, none touching another, none where nothing
/// changes.
pub fn format(parse: &Parse, options: &Options) -> Vec<Edit> {
    edits(parse, options, None)
}

/// As [`format()`], but only for the networks, sections and lines that one of the ranges reaches into.
pub fn format_ranges(parse: &Parse, options: &Options, ranges: &[TextRange]) -> Vec<Edit> {
    edits(parse, options, Some(ranges))
}

fn edits(parse: &Parse, options: &Options, only: Option<&[TextRange]>) -> Vec<Edit> {
    // To read the text once more into a list is quicker than to walk the tree.
    let text = parse.to_string();
    file::format(&text, &options.checked(), only, Edits::default()).0
}

/// The text in its canonical layout.
pub fn format_text(text: &str, options: &Options) -> String {
    reformat(text, options).unwrap_or_else(|| text.to_owned())
}

/// The text in its canonical layout; none if it is in that already, which takes no memory to find out.
pub fn reformat(text: &str, options: &Options) -> Option<String> {
    file::format(text, &options.checked(), None, NewText::new(text)).finish()
}

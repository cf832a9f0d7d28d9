//! The diagram as a picture.
//!
//! ```text
//! block --symbol--> what is drawn, and how much room it takes
//!       --place---> rows and columns of a network: the formatter's own layout, in other units
//!       --draw----> lines, arcs and texts on Paper
//!                       --svg--> the document
//! ```
//!
//! Columns come from the writer that aligns ladder text, so branches nest in the picture as they do there. One
//! unit is the width of a letter; what is drawn has its own width, not that of its text.

mod comment;
mod draw;
mod page;
mod paper;
mod place;
mod style;
mod symbol;

pub use style::Theme;

use ladder_analysis::context::Context;
use ladder_syntax::TextRange;
use std::collections::HashMap;

/// What is shown beside the program itself.
#[derive(Default)]
pub struct Options<'o> {
    /// The colours.
    pub theme: Theme,
    /// For each part of the drawing, by its place in the text, whether power leaves it. Without it the picture
    /// shows the program at rest, in one weight of line.
    pub power: Option<HashMap<TextRange, bool>>,
    /// The value of an operand, by its text, where there is one worth showing beside it.
    pub value: Option<&'o Values<'o>>,
}

/// The value of an operand by its text; none if it is not shown.
pub type Values<'v> = dyn Fn(&str) -> Option<String> + 'v;

/// A file's networks with their comments, as an SVG document. A network with a mistake in its drawing is shown as
/// text.
pub fn svg(context: &Context, options: &Options<'_>) -> String {
    page::draw(context, options)
}

//! The diagram as a picture.
//!
//! ```text
//! network --figure--> the elements of its rungs, each with its symbol and the room that it takes
//!         --nodes---> which connectors are one vertical line: points that only bare wire joins
//!         --grid----> things on rungs, a vertical line as one thing
//!         --columns-> where each thing is
//!         --draw----> shapes on Paper, each knowing which part of the program it shows: a Picture
//!                         --svg---> a document for screens
//!                         --sheet-> pages for a printer, still as shapes
//!                         --excerpt--> one network with marks, for a page
//!                         --live--> networks one by one, for a page that shows their power
//!         --letters--> the same drawn with characters, at rest or live
//! ```
//!
//! A [`Picture`] is all that a writer of documents needs to know: the same drawing is written as SVG, as pixels and as
//! PDF, and can be shown live. One unit of a column is the width of a letter.
//!
//! [`mod@scene`] is another kind of picture: that of the machine, which somebody else has drawn.

mod columns;
mod comment;
mod draw;
pub mod excerpt;
mod figure;
mod glyph;
mod grid;
pub mod letters;
pub mod live;
mod measure;
mod nodes;
mod page;
mod paper;
pub mod scene;
pub mod shapes;
pub mod sheet;
pub mod style;
mod svg;
mod symbol;
mod wrap;

pub use shapes::Picture;
pub use style::Theme;
pub use svg::svg;

use ladder_analysis::context::Context;
use ladder_syntax::TextRange;
use std::collections::HashMap;

/// What is shown next to the program itself.
#[derive(Default)]
pub struct Options<'o> {
    /// For each part of the drawing, by its place in the text, whether power leaves it. Without it the picture
    /// shows the program at rest, in one weight of line.
    pub power: Option<HashMap<TextRange, bool>>,
    /// The value of an operand, by its text, where there is one worth showing next to it.
    pub value: Option<&'o Values<'o>>,
    /// There is room for values above operands, and each shape knows whose power it shows: a user will write the
    /// state of a running program on the drawing.
    pub live: bool,
    /// The right rail is no further left than in this column: pages are filled so. Without it the picture is as small as its
    /// networks.
    pub rail: Option<u32>,
}

/// The value of an operand by its text; none if it is not shown.
pub type Values<'v> = dyn Fn(&str) -> Option<String> + 'v;

/// Draws a file's networks with their comments. A network with an error in its drawing is shown as text.
pub fn picture(context: &Context, options: &Options<'_>) -> Picture {
    page::draw(context, options)
}

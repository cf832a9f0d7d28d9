//! Changes of a drawing: in the text by a key, in the diagram by mouse and keys.
//!
//! Unlike a refactoring these change what a program does: a person draws.
//!
//! ```text
//! change, place --editable--> Drawing --crate::drawing--> Drawing --layout--> Piece: new text of a network
//! text that is put in --fragment--> parts of a network, new names --declaring--> Pieces of declarations
//! Pieces --piece--> Redrawn: small edits, what is selected then
//! ```
//!
//! Only the network that changes is laid out, and of the file nothing is asked but what the scope knows: it takes as long in a
//! large file as in a small one.

mod blocks;
mod change;
#[cfg(test)]
mod change_tests;
mod comments;
mod declarations;
mod declaring;
mod editable;
mod fragment;
mod keys;
mod layout;
mod lines;
mod networks;
mod offer;
mod piece;
#[cfg(test)]
mod properties;
#[cfg(test)]
mod tests;
mod words;

pub use change::{Change, change};
pub use declaring::Declared;
pub use editable::points_of;
pub use fragment::Given;
pub use keys::{Redraw, redraw};
pub use offer::{Asked, Neighbours, Offer, Offered, offer};
pub use piece::Redrawn;

//! Ladder programs in other forms than their own text.
//!
//! ```text
//! Context (parse, wiring, blocks) --picture--> SVG
//! foreign program --notation--> ladder text, and back
//! ```
//!
//! [`picture`] draws the networks of a file with the symbols of IEC 61131-3, and with the power of a running
//! program where it is given. It knows no files and no simulator: power and values come from the caller.
//! [`notation`] reads and writes programs as other systems have them.

pub mod notation;
pub mod picture;

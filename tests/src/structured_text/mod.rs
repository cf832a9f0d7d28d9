//! An interpreter of the Structured Text that Ladder writes, made from the standard alone, to compare what the text does with what
//! the simulator shows.
//!
//! It is strict where systems differ: a division by zero, an index outside its array, a conversion out of range or a mixture of types
//! is an error, both sides of AND are evaluated, and a whole number gets its width only where it is assigned.

mod functions;
mod memory;
mod parse;
mod run;
mod standard;
mod syntax;
mod tokens;
mod value;

pub use run::Machine;
pub use value::{Type, Value};

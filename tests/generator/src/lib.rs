//! Programs out of nothing ([`generator`]), and the language's definition of a network written down a second time
//! ([`mod@reference`]), for the tests of all crates.

pub mod generator;
pub mod reference;

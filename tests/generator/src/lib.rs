//! Programs out of nothing ([`generator`]), runs of them ([`runs`]), and the language's definition of a network written down a second time
//! ([`mod@reference`]), for the tests of all crates.

pub mod constants;
pub mod generator;
pub mod reference;
pub mod running;
pub mod runs;

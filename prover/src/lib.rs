//! Properties of ladder programs, decided for all inputs and all runs from a cold start.
pub mod graph;
pub mod number;

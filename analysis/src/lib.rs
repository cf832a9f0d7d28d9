//! Names, types, the program model and the diagnostics of ladder text.
//!
//! ```text
//! Parse --facts--> per network: wiring, blocks, operands (from its lines alone)
//!        --scope--> declarations  --infer--> the types of undeclared tags
//!        --resolve--> Program: names resolved, operands typed, elements in the order of evaluation
//!        --rules--> Diagnostics, with fixes as text edits
//! ```

pub mod program;
pub mod types;
pub mod value;

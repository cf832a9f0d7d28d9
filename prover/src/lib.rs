//! Properties of ladder programs, decided for all inputs and all runs from a cold start.
//!
//! ```text
//! Simulation --encode--> one scan over a graph of bits --model--> with the properties of a scenario file
//!     --decide--> induction, and a search for a run that violates them --replay--> in the simulator --answer
//! ```

mod answer;
mod causes;
mod concrete;
mod decide;
mod encode;
mod equal;
mod graph;
mod lanes;
mod lemmas;
mod limits;
mod model;
mod never;
mod number;
mod replay;
mod said;
mod scenario_text;
mod shown;
mod system;
mod unrolled;
mod wanted;

pub use answer::{Answer, Options, Refuted, Shown, Times, Verdict, prove};
pub use concrete::Concrete;
pub use equal::{Compared, Difference, Meaning};
pub use said::drawn;
pub use scenario_text::{found_scenario, scenario_file};
pub use wanted::while_wanted;

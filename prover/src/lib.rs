//! Properties of ladder programs, decided for all inputs and all runs from a cold start.
//!
//! ```text
//! Simulation --encode--> one scan over a graph of bits --model--> with the properties of a scenario file
//!     --decide--> induction, and a search for a run that violates them --replay--> in the simulator --answer
//! ```
//!
//! Of two programs [`compare_programs`] says whether they do the same in every run, and [`Compared`] whether two networks do.

mod answer;
mod beside;
mod body;
mod both;
mod causes;
mod clock;
mod concrete;
mod decide;
mod divergence;
mod encode;
mod equal;
mod graph;
mod induction;
mod lanes;
mod lemmas;
mod limits;
mod merged;
mod model;
mod never;
mod number;
mod programs;
mod progress;
mod replay;
mod resting;
mod scenario_text;
mod shown;
mod shown_tags;
mod sure;
mod system;
mod told;
mod unrolled;

pub use answer::{Answer, Options, Refuted, Shown, Times, Verdict, prove};
pub use beside::Basis;
pub use clock::Clock;
pub use concrete::Concrete;
pub use equal::{Compared, Difference, Meaning, other_tags};
pub use programs::{
    Differing, Divergence, Limits, NotReproduced, Row, Which, Whole, compare_programs,
    compare_programs_assuming, outputs_of_one,
};
pub use progress::{Listener, Progress};
pub use resting::resting_on_unread;
pub use scenario_text::{found_scenario, rows_of, scenario_file, scenario_of_difference};
pub use told::drawn;

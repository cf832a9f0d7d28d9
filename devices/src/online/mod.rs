//! Controllers that are watched: their values are read, and nothing is ever written.
//!
//! ```text
//! program --wanted--> Source (Logix, Modbus) --snapshot, snapshot--> Watch --newest--> who shows them
//!                        `-- socket behind a guard: reads, and nothing else
//! ```
//!
//! The values of a snapshot are not of one scan of the controller: they come by several requests, between which it goes on.

mod controller;
#[cfg(feature = "logix")]
pub mod logix;
mod watch;

pub use crate::source::Source;
pub use crate::wrong::Wrong;
pub use controller::{Controller, EVERY, PATIENCE};
pub use ladder_simulator::online::{Found, Wanted};
pub use watch::Watch;

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

pub use controller::{Controller, EVERY, PATIENCE, Wrong};
use ladder_analysis::values::value::Value;
pub use ladder_simulator::online::{Found, Wanted};
pub use watch::Watch;

/// A controller, as its protocol shows it. What it is asked for was said when it was made.
pub trait Source: Send {
    /// Connects, or connects again. What is there of what is wanted, in the order of that.
    ///
    /// # Errors
    /// Why there is no connection: a sentence without a full stop that follows the controller's address.
    fn connect(&mut self) -> Result<Vec<Found>, String>;

    /// Reads all that is there once. None: the controller did not tell this one.
    ///
    /// # Errors
    /// The connection is lost: why, as above.
    fn read(&mut self) -> Result<Vec<Option<Value>>, String>;
}

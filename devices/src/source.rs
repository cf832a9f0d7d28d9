//! What is read of a controller that is watched, whatever its protocol.

use ladder_analysis::values::value::Value;
use ladder_simulator::online::Found;

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

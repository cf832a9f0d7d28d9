//! Running controllers, for those who watch them.

use std::fmt;

use ladder_simulator::online::{Online, Watched};
use ladder_workspace::Online as Asked;

/// A controller that is watched, and what it is called.
pub type Connection = (String, Box<dyn Watched>);

/// The way to running controllers. A page has none.
pub trait Controllers: fmt::Debug + Send + Sync {
    /// Watches the controller that `[online]` names for a program, whose file is called `stem` without its extension. It is read,
    /// and never written.
    ///
    /// # Errors
    /// None is named, or what is asked for does not fit the program: what to do.
    fn watch(&self, asked: &Asked, stem: &str, program: &Online) -> Result<Connection, String>;
}

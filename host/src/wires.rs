//! What is at the other end of wires: running controllers, and clients that ask for tags.

use std::fmt;

use ladder_analysis::values::value::Value;
use ladder_simulator::online::{Online, Watched};
use ladder_simulator::{Point, Simulation};
use ladder_workspace::{Misfit, Online as Asked, ServeModbus, Settings};

/// A controller that is watched, and what it is called.
pub type Connection = (String, Box<dyn Watched>);

/// The way to what is outside of this computer, or of this program. A page has none.
pub trait Wires: fmt::Debug + Send + Sync {
    /// Watches the controller that `[online]` names for a program, whose file is called `stem` without its extension. It is read,
    /// and never written.
    ///
    /// # Errors
    /// None is named, or what is asked for does not fit the program: what to do.
    fn watch(&self, asked: &Asked, stem: &str, program: &Online) -> Result<Connection, String>;

    /// Serves tags of a simulation as `[serve.modbus]` has it, but to clients on this computer only.
    ///
    /// # Errors
    /// There is nothing to serve, what is asked for does not fit the program, or the port is taken: what to do.
    fn serve(&self, asked: &ServeModbus, simulation: &Simulation) -> Result<Box<dyn Served>, String>;

    /// What settings ask to be served or connected, and a program has not.
    fn misfits(&self, settings: &Settings, simulation: &Simulation) -> Vec<Misfit>;
}

/// Tags that are served until this is dropped.
pub trait Served: fmt::Debug + Send {
    /// Where, in words.
    fn about(&self) -> String;

    /// What clients have written since this was asked last.
    fn written(&self, simulation: &Simulation) -> Vec<(Point, Value)>;

    /// Clients see the values of now.
    fn show(&self, simulation: &Simulation);

    /// The same clients see another program.
    ///
    /// # Errors
    /// The settings do not fit it.
    fn replace(&self, simulation: &Simulation) -> Result<(), String>;
}

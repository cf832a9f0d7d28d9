//! What `[serve.modbus]` and the command line ask to be served.

use super::Arguments;
use crate::outcome::Failure;
use ladder_devices::modbus::{self, Map, NOTHING, ToServe, Wrong};
use ladder_simulator::Simulation;
use ladder_workspace::{Misfit, ServeModbus, Settings};
use std::path::Path;

/// What is to be served of a program, if anything.
///
/// # Errors
/// The settings do not fit the program.
pub(super) fn served(
    arguments: &Arguments,
    settings: &Settings,
    simulation: &Simulation,
) -> Result<Option<ToServe>, Failure> {
    let none = ServeModbus::default();
    let asked = match (&settings.modbus, &arguments.modbus) {
        (Some(asked), _) => asked,
        (None, Some(_)) => &none,
        (None, None) => return Ok(None),
    };
    let mut served = ToServe::of(asked, simulation).map_err(|wrong| failure(&arguments.file, wrong))?;
    if let Some(text) = arguments.modbus.as_deref().filter(|text| !text.is_empty()) {
        served.address = text.parse().map_err(|_| {
            Failure::new(format!(
                "--modbus {text}: write an address and a port, as in 127.0.0.1:1502"
            ))
        })?;
    }
    if arguments.read_only {
        served.map = served.map.read_only();
    }
    if served.map.is_empty() {
        return Err(Failure::new(NOTHING));
    }
    Ok(Some(served))
}

/// Which tags are where.
///
/// # Errors
/// The settings do not fit the program.
pub(crate) fn map(asked: &ServeModbus, file: &Path, simulation: &Simulation) -> Result<Map, Failure> {
    modbus::map(asked, simulation).map_err(|wrong| failure(file, wrong))
}

/// What is wrong with settings next to the program of a file.
pub(crate) fn failure(file: &Path, mut wrong: Vec<Wrong>) -> Failure {
    wrong.sort_by_key(|wrong| wrong.at.start);
    let found = wrong.iter().cloned().map(Misfit::from);
    match Settings::found_wrong(file, found.collect()) {
        Some(error) => error.into(),
        None => Failure::of_lines(wrong.into_iter().map(|wrong| wrong.message)),
    }
}

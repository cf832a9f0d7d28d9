//! What `[[device]]` asks to be connected.

use super::Arguments;
use super::served::failure;
use crate::outcome::Failure;
use ladder_devices::modbus::{ToServe, Wired, bind, devices};
use ladder_simulator::Simulation;
use ladder_workspace::Settings;

/// The devices of a program, if it has any.
///
/// # Errors
/// The settings do not fit the program.
pub(super) fn wired(
    arguments: &Arguments,
    settings: &Settings,
    served: Option<&ToServe>,
    simulation: &Simulation,
) -> Result<Vec<Wired>, Failure> {
    if arguments.no_devices {
        return Ok(Vec::new());
    }
    let devices = devices(settings);
    let served = served.map(|served| &served.map);
    bind(&devices, served, simulation).map_err(|wrong| failure(&arguments.file, wrong))
}

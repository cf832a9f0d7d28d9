//! What `[[device]]` asks to be connected.

use super::Arguments;
use super::served::{failure, nanoseconds};
use crate::outcome::Failure;
use ladder_devices::modbus::{Device, Named, ToServe, Wired, Words, bind};
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

pub(super) fn devices(settings: &Settings) -> Vec<Device> {
    settings.devices.iter().map(device).collect()
}

fn device(set: &ladder_workspace::Device) -> Device {
    let usual = Device::new(&set.name, &set.modbus);
    Device {
        unit: set.unit.unwrap_or(usual.unit),
        words: Words::of_setting(set.words),
        poll: set.poll.map_or(usual.poll, nanoseconds),
        repeat: set.repeat.map_or(usual.repeat, nanoseconds),
        timeout: set.timeout.map_or(usual.timeout, nanoseconds),
        gap: set.gap.unwrap_or(usual.gap),
        ok: set.ok.clone(),
        age: set.age.clone(),
        read: Named::of_settings(&set.read),
        write: Named::of_settings(&set.write),
        ..usual
    }
}

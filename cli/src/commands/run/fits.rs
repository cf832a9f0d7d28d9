//! Whether settings fit a program, without running it.

use super::wired;
use ladder_devices::modbus::{self, Wrong, bind};
use ladder_simulator::Simulation;
use ladder_workspace::Settings;

/// What `[serve.modbus]` and `[[device]]` ask for and a program has not.
pub(crate) fn misfits(settings: &Settings, simulation: &Simulation) -> Vec<Wrong> {
    let mut wrong = Vec::new();
    let mut map = None;
    if let Some(asked) = &settings.modbus {
        wrong.extend(modbus::allowed(asked).err());
        match modbus::map(asked, simulation) {
            Ok(own) => map = Some(own),
            Err(own) => wrong.extend(own),
        }
    }
    if let Err(own) = bind(&wired::devices(settings), map.as_ref(), simulation) {
        wrong.extend(own);
    }
    wrong
}

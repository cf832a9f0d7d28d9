//! Whether `[serve.modbus]` and `[[device]]` of a `ladder.toml` fit a program of its workspace.

use crate::commands::run::fits::misfits;
use crate::commands::run::served::failure;
use crate::findings::{Source, Workspaces};
use crate::outcome::Failure;
use ladder_devices::modbus::Wrong;
use ladder_simulator::Simulation;
use ladder_workspace::{SETTINGS_FILE, Settings, find_programs};
use std::path::{Path, PathBuf};

/// What fits no program of a workspace of `workspaces`; none where it fits one. It is told of the program that comes nearest: the settings are for
/// the one that is run, and do not say which that is.
pub(super) fn failure_in(folder: &Path, settings: &Settings, workspaces: &mut Workspaces) -> Option<Failure> {
    if settings.modbus.is_none() && settings.devices.is_empty() {
        return None;
    }
    let programs = if settings.simulate.tasks.is_empty() {
        find_programs(&[folder.to_owned()]).0
    } else {
        vec![folder.join(SETTINGS_FILE)]
    };
    let mut nearest: Option<(PathBuf, Vec<Wrong>)> = None;
    for program in programs {
        let wrong = misfits_of(&program, settings, workspaces)?;
        if wrong.is_empty() {
            return None;
        }
        if nearest
            .as_ref()
            .is_none_or(|(_, other)| wrong.len() < other.len())
        {
            nearest = Some((program, wrong));
        }
    }
    let (program, wrong) = nearest?;
    Some(failure(&program, wrong))
}

/// None: that is not known of a program with errors, which are told elsewhere.
fn misfits_of(program: &Path, settings: &Settings, workspaces: &mut Workspaces) -> Option<Vec<Wrong>> {
    let source = if program.ends_with(SETTINGS_FILE) {
        Source::read(program, None).ok()?
    } else {
        let bytes = ladder_workspace::read_bytes(program).ok()?;
        let workspace = workspaces.of(program).ok()??;
        Source::of_bytes(program, bytes, None).ok()?.within(workspace)
    };
    let whole = source.program().ok()?;
    let options = settings.simulate.options(&whole, program);
    let simulation = Simulation::new(whole, options).ok()?;
    Some(misfits(settings, &simulation))
}

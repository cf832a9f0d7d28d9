//! What settings ask of the programs of their workspace, and none of them has.

use std::path::{Path, PathBuf};

use ladder_simulator::scenario;
use ladder_workspace::{Misfit, SettingError, Settings};

use super::companions;
use crate::lsp::session::shared::Shared;

/// What fits none of the programs, as editors show them. `settings` are what the file says, in this text. For a blocking thread.
pub(crate) fn of(shared: &Shared, file: &Path, settings: &Settings, text: &str) -> Vec<SettingError> {
    if !settings.may_misfit() || shared.world().wires.is_none() {
        return Vec::new();
    }
    let programs: Vec<PathBuf> = if settings.simulate.tasks.is_empty() {
        shared
            .neighbours
            .on_disk(file)
            .files
            .into_iter()
            .map(|(path, _)| path)
            .collect()
    } else {
        vec![file.to_owned()]
    };
    let programs = programs.iter();
    Settings::fit_none(
        text,
        programs.map(|program| of_program(shared, settings, file, program)),
    )
}

/// None: that is not known of a program with errors, which shows them itself.
fn of_program(shared: &Shared, settings: &Settings, file: &Path, program: &Path) -> Option<Vec<Misfit>> {
    let wires = shared.world().wires.as_ref()?;
    let simulation = companions::compiled(shared, program, (file, &scenario::parse(""))).ok()?;
    Some(wires.misfits(settings, &simulation))
}

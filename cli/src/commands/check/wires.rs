//! Whether `[serve.modbus]` and `[[device]]` of a `ladder.toml` fit a program of its workspace.

use crate::findings::{Problem, Source, Workspaces, settings_source};
use annotate_snippets::Renderer;
use ladder_devices::modbus::misfits;
use ladder_simulator::Simulation;
use ladder_workspace::{Misfit, SETTINGS_FILE, Settings, find_programs};
use std::path::Path;

/// What fits no program of a workspace of `workspaces`.
pub(super) fn problems(
    folder: &Path,
    settings: &Settings,
    workspaces: &mut Workspaces,
    renderer: &Renderer,
) -> Vec<Problem> {
    let file = folder.join(SETTINGS_FILE);
    let source = settings_source(&file).filter(|_| settings.may_misfit());
    let Some(source) = source else {
        return Vec::new();
    };
    let programs = if settings.simulate.tasks.is_empty() {
        find_programs(&[folder.to_owned()]).0
    } else {
        vec![file]
    };
    let programs = programs.iter();
    let errors = Settings::fit_none(
        &source.text,
        programs.map(|program| misfits_of(program, settings, workspaces)),
    );
    let problems = errors.iter();
    problems
        .map(|error| Problem::in_settings(&source, error, renderer))
        .collect()
}

/// None: that is not known of a program with errors, which are told elsewhere.
fn misfits_of(program: &Path, settings: &Settings, workspaces: &mut Workspaces) -> Option<Vec<Misfit>> {
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

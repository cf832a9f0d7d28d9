//! `--pictures`: the machine as its scenes show it in the step that a scenario fails in.

use crate::commands::render::scene::{drawn, of_source};
use crate::findings::Source;
use crate::outcome::Failure;
use crate::output::{Existing, may_write};
use ladder_picture::scene::Scene;
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{self, Case, Ran, Suite, Watched};
use ladder_workspace::{Named, is_scene, scene_stem, shown};
use std::path::{Path, PathBuf};

/// Where they go.
pub(super) struct Pictures {
    pub(super) folder: PathBuf,
    pub(super) existing: Existing,
}

/// A scene, and what it is called.
pub(super) type NamedScene = (String, Scene);

/// The scenes next to a program, or next to its scenarios, that are about it.
pub(super) fn scenes_of(path: &Path, suite: &Suite) -> Vec<NamedScene> {
    let Some((name, _)) = &suite.program else {
        return Vec::new();
    };
    let program = Named::in_file(path, name).path();
    let Ok(program) = program.canonicalize() else {
        return Vec::new();
    };
    let entries = program.parent().and_then(|folder| folder.read_dir().ok());
    let mut files: Vec<PathBuf> = entries
        .into_iter()
        .flatten()
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|file| is_scene(file))
        .collect();
    files.sort();
    let scene = |file: PathBuf| {
        // One that is a link out of the workspace is not read.
        let text = ladder_workspace::read_own(&file).ok()?;
        let scene = of_source(&file, &Source::new(file.display().to_string(), text));
        let (of, _) = scene.program.as_ref()?;
        let is_of_it = Named::in_file(&file, of).path().canonicalize().ok()? == program;
        is_of_it.then(|| (scene_stem(&file).unwrap_or_default().to_owned(), scene))
    };
    files.into_iter().filter_map(scene).collect()
}

impl Pictures {
    /// Plays a scenario again up to where it fails, and draws the scenes there. Returns the files.
    pub(super) fn draw(
        &self,
        (file, number): (&Path, usize),
        scenes: &[NamedScene],
        (case, ran): (&Case, &Ran),
        (watched, simulation): (&mut Watched, &mut Simulation),
    ) -> Vec<String> {
        let wanted = fails_after(case, ran);
        let (mut scans, mut pictures) = (0, Vec::new());
        scenario::run(case, watched, simulation, |simulation| {
            let went = simulation.scan();
            scans += 1;
            if scans == wanted || (!went && pictures.is_empty()) {
                pictures = scenes.iter().map(|(_, scene)| drawn(scene, simulation)).collect();
            }
            went
        });
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let named = scenes.iter().zip(pictures).filter_map(|((scene, _), picture)| {
            let to = self.folder.join(format!("{stem}.{number}.{scene}.svg"));
            match self.write(&to, &picture) {
                Ok(()) => Some(to.display().to_string()),
                Err(failure) => {
                    failure.show();
                    None
                }
            }
        });
        named.collect()
    }

    fn write(&self, to: &Path, picture: &str) -> Result<(), Failure> {
        may_write(to, self.existing)?;
        std::fs::create_dir_all(&self.folder)
            .map_err(|error| Failure::new(format!("{}: {error}", shown::path(&self.folder))))?;
        Ok(ladder_workspace::write_made(to, picture.as_bytes())?)
    }
}

/// How many scans there are up to the first that is not as it is to be.
fn fails_after(case: &Case, ran: &Ran) -> u64 {
    let differs = ran.differences.iter().filter_map(|it| it.steps.first());
    let differs = differs.map(|step| case.scans_to(*step));
    let violates = ran.violations.iter().map(|violation| violation.scan + 1);
    let stops = ran.stopped.map(|step| case.scans_to(step));
    let all = differs.chain(violates).chain(stops);
    all.min().unwrap_or(ran.scans)
}

//! A scene as a picture: the drawing of the machine with the values of a program.

use super::{Arguments, Format, target, write};
use crate::findings::{Problem, Source, Workspaces};
use crate::form::Form;
use crate::outcome::{Failure, Outcome};
use crate::ready::prepared;
use crate::run::Run;
use crate::terminal::{self, stderr_has_colours};
use crate::values::Given;
use annotate_snippets::Renderer;
use ladder_picture::scene::{self, Scene, still};
use ladder_simulator::Simulation;
use ladder_workspace::{Named, scene_stem, shown};
use std::path::Path;
use std::sync::{Arc, Mutex};

/// A scene with the program that it is about.
struct Opened {
    scene: Scene,
    /// None: the program cannot run.
    ready: Option<(Simulation, Arc<Source>)>,
    problems: Vec<Problem>,
}

/// The scene that a text is, under the name of its file.
pub(crate) fn of_source(path: &Path, source: &Source) -> Scene {
    scene::of_file(scene_stem(path).unwrap_or_default(), &source.text)
}

fn open(path: &Path, source: &Source, renderer: &Renderer) -> Opened {
    let scene = of_source(path, source);
    let mut findings = scene.findings.clone();
    let mut problems = Vec::new();
    let mut ready = None;
    // One that cannot be read has nothing to bind.
    if !scene.nodes.is_empty() {
        match prepared(
            path,
            source,
            &scene.suite(),
            renderer,
            &Mutex::<Workspaces>::default(),
        ) {
            Ok((simulation, program)) => {
                findings.extend(scene.bind(&simulation).1);
                ready = Some((simulation, program));
            }
            Err((of_program, _)) => problems = of_program,
        }
    }
    findings.sort_by_key(|finding| finding.range.start());
    problems.extend(
        findings
            .iter()
            .map(|found| Problem::in_scene(source, found, renderer)),
    );
    Opened {
        scene,
        ready,
        problems,
    }
}

/// What there is to say about a scene.
pub(crate) fn problems(path: &Path, source: &Source, renderer: &Renderer) -> Vec<Problem> {
    open(path, source, renderer).problems
}

/// Draws it. What is wrong goes to stderr; the picture is drawn as far as it goes.
pub(super) fn run(arguments: &Arguments, format: Format) -> Result<Outcome, Failure> {
    if !matches!(format, Format::Svg | Format::Png) {
        return Err(Failure::new(
            "a scene is drawn as SVG or PNG; end the file's name in .svg or .png",
        ));
    }
    if arguments.tags.is_some() && arguments.scans.is_some() {
        return Err(Failure::new(
            "--tags and --scans are two ways to values; give one of the two",
        ));
    }
    let path = &arguments.file;
    let bytes = ladder_workspace::read_bytes(path)?;
    let source = Source::of_bytes(path, bytes, Some(Form::Ladder))?;
    let renderer = if stderr_has_colours() {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let Opened {
        scene,
        ready,
        problems,
    } = open(path, &source, &renderer);
    let mut outcome = Outcome::Fine;
    for problem in problems.iter().filter(|it| it.outcome != Outcome::Fine) {
        terminal::plain(&format_args!("{}\n", problem.shown));
        outcome = outcome.max(problem.outcome);
    }
    let Some((simulation, program)) = ready else {
        return Ok(outcome.max(Outcome::Findings));
    };
    let simulation = match arguments.scans {
        None => with_tags(arguments, simulation)?,
        Some(scans) => {
            let named = scene
                .program
                .as_ref()
                .map(|(name, _)| Named::in_file(path, name).path());
            let ran = after(arguments, (&named.unwrap_or_default(), &program), scans)?;
            outcome = outcome.max(ran.1);
            ran.0
        }
    };
    let picture = drawn(&scene, &simulation);
    let bytes = match format {
        #[cfg(feature = "png")]
        Format::Png => super::raster::png(&picture, arguments.scale.unwrap_or(2.0))
            .map_err(|problem| Failure::new(format!("{}: {problem}", shown::path(path))))?,
        #[cfg(not(feature = "png"))]
        Format::Png => return Err(crate::features::Feature::Png.left_out()),
        _ => picture.into_bytes(),
    };
    write(arguments, format, &bytes)?;
    let to = target(arguments).map(|file| format!(", in {}", shown::path(file)));
    if outcome != Outcome::Fine {
        terminal::error(&format_args!(
            "{}: drawn as far as it goes{}",
            shown::path(path),
            to.unwrap_or_default()
        ));
    }
    Ok(outcome)
}

/// The picture with the values of a program.
pub(crate) fn drawn(scene: &Scene, simulation: &Simulation) -> String {
    let (mut bound, _) = scene.bind(simulation);
    let values = bound.values(simulation);
    still(scene, &bound.slots, &values)
}

/// The program at the start, with the values of a table if there is one.
fn with_tags(arguments: &Arguments, mut simulation: Simulation) -> Result<Simulation, Failure> {
    let Some(file) = &arguments.tags else {
        return Ok(simulation);
    };
    let given = Given::read(file, &simulation)?;
    for (point, value) in given.values {
        simulation
            .set(&point, value)
            .map_err(|refused| Failure::new(format!("{}: {}", shown::path(file), refused.message)))?;
    }
    for (line, name) in given.unknown {
        terminal::note(&format_args!(
            "{}: line {line}: the program has no {}",
            shown::path(file),
            shown::line(&name)
        ));
    }
    Ok(simulation)
}

/// The program after so many scans.
fn after(
    arguments: &Arguments,
    (path, source): (&Path, &Source),
    scans: u64,
) -> Result<(Simulation, Outcome), Failure> {
    let not_whole = |_| Failure::new("the program has errors");
    let program = source.program().map_err(not_whole)?;
    let run = Run::whole(&arguments.stimulus, path, (source, program), scans)?;
    let outcome = run.outcome();
    Ok((run.simulation, outcome))
}

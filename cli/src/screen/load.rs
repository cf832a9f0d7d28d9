//! From a file to a program that runs, and again when the file has changed.

use super::plant::Plant;
use crate::findings::Source;
use crate::form::Form;
use crate::outcome::Failure;
use crate::run::{self, KeptIn, Plants, Retention, Stimulus};
use ladder_analysis::program::{Program, Role};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::{NotWhole, Severity};
use ladder_simulator::{HistoryLimits, Point, Session, Simulation};
#[cfg(feature = "run")]
use ladder_simulator::{Options, online::Watching};
use ladder_workspace::{Settings, Stamp};
use std::path::Path;
use std::sync::Arc;
#[cfg(feature = "run")]
use std::time::Duration;

/// This many tags are watched where none are asked for.
const WATCHED: usize = 4;

/// What is to be run.
pub(crate) struct Request<'a> {
    pub(crate) file: &'a Path,
    /// What it is written in; none: its content decides.
    pub(crate) from: Option<Form>,
    /// What runs beside it.
    pub(crate) plants: &'a Plants,
    pub(crate) stimulus: &'a Stimulus,
    /// The file that keeps retentive tags.
    pub(crate) retain: Option<&'a Path>,
    /// The tags to watch; none: those that show most.
    pub(crate) watch: &'a [String],
}

impl Request<'_> {
    pub(super) fn stamp(&self) -> Stamp {
        Stamp::of(self.file)
    }
}

/// Loads the program. None: it has errors, which were shown.
pub(super) fn first(request: &Request) -> Result<Option<Plant>, Failure> {
    let source = source(request)?;
    let Some(program) = run::program(&source) else {
        return Ok(None);
    };
    // A batch run keeps nothing unless asked to; here a person sits.
    let of_workspace = Settings::of(request.file)?.simulate.retain;
    let retain = request.retain.map(KeptIn::File);
    let retain = retain.or(of_workspace.as_ref().map(KeptIn::OfWorkspace));
    plant(request, &source, program, retain).map(Some)
}

/// Loads the program while the screen is up: what is wrong with it is shown in one line.
pub(super) fn again(request: &Request) -> Result<(Source, Arc<Program>), String> {
    let source = source(request).map_err(|failure| failure.to_string())?;
    match source.program() {
        Ok(program) => Ok((source, program)),
        Err(not_whole) => Err(format!(
            "{}; the old program goes on",
            problem(&source, &not_whole)
        )),
    }
}

fn problem(source: &Source, not_whole: &NotWhole) -> String {
    match not_whole {
        NotWhole::Missing(file) => format!("{file}, which this program uses, cannot be read any more"),
        NotWhole::Errors(file) => match source.other(file) {
            Some(other) if source.analyze().context.name != *file => first_error(&other),
            _ => first_error(source),
        },
    }
}

fn first_error(source: &Source) -> String {
    let remarks = source.remarks().into_iter();
    let remarks = remarks.filter(|remark| remark.severity == Severity::Error);
    let remarks = remarks.map(|remark| (remark.range, remark.message));
    let found = source.errors().into_iter();
    let mut errors = remarks.chain(found.map(|error| (error.range, error.message)));
    let first = errors.next().map_or(String::new(), |(range, message)| {
        let place = source.place(range.start());
        format!("{}:{}:{}: {message}", source.file, place.line, place.column)
    });
    match errors.count() {
        0 => first,
        more => format!("{first} (and {more} more)"),
    }
}

fn source(request: &Request) -> Result<Source, Failure> {
    request.plants.beside(Source::read(request.file, request.from)?)
}

fn plant(
    request: &Request,
    source: &Source,
    program: Arc<Program>,
    retain: Option<KeptIn>,
) -> Result<Plant, Failure> {
    let options = request.stimulus.options(request.file, &program)?;
    let history = Settings::of(request.file)?.simulate.history;
    let limits = history.map_or_else(HistoryLimits::default, |scans| {
        HistoryLimits::of_scans(usize::try_from(scans).unwrap_or(usize::MAX))
    });
    let mut simulation = run::simulation(source, program, options)?;
    let watched = watched(&simulation, request.watch)?;
    let retention = match retain {
        Some(file) => Some(Retention::begin(file, request.file, &mut simulation)?),
        None => None,
    };
    let inputs = request.stimulus.give(&mut simulation)?;
    let mut plant = Plant::new(source, Session::of(simulation, limits), inputs, retention);
    for point in &watched {
        plant.watch(point);
    }
    Ok(plant)
}

/// The program of a controller that is watched.
#[cfg(feature = "run")]
pub(super) fn of_controller(
    source: &Source,
    controller: String,
    watching: Watching,
    every: Duration,
) -> Result<Plant, Failure> {
    let program = watching.online().simulation().program().clone();
    let options = Options {
        interval: i64::try_from(every.as_nanos()).unwrap_or(i64::MAX),
        ..Options::default()
    };
    let simulation = run::simulation(source, program, options)?;
    let watched = watched(&simulation, &[])?;
    let session = Session::of(simulation, HistoryLimits::of_scans(0));
    let mut plant = Plant::of_controller(source, session, controller, watching);
    for point in &watched {
        plant.watch(point);
    }
    Ok(plant)
}

/// The tags that were asked for; else the first outputs, how far timers and counters are, and what else coils write.
fn watched(simulation: &Simulation, names: &[String]) -> Result<Vec<Point>, Failure> {
    if !names.is_empty() {
        let mut watched = Vec::new();
        for name in names {
            let found = simulation.resolve_all(name);
            watched.extend(found.map_err(|unknown| Failure::new(format!("--watch {name}: {unknown}")))?);
        }
        return Ok(watched);
    }
    let all = simulation.points();
    let outputs = all.iter().filter(|point| point.role == Role::Output);
    let progress = all
        .iter()
        .filter(|point| matches!(point.name.rsplit_once('.'), Some((_, "ET" | "CV"))));
    let mut watched: Vec<Point> = outputs.take(WATCHED - 1).cloned().collect();
    watched.extend(progress.take(WATCHED - watched.len()).cloned());
    let others = all.iter().filter(|point| {
        point.ty == Scalar::Bool
            && point.role == Role::Internal
            && !point.read_only
            && !point.name.contains('.')
    });
    watched.extend(others.take(WATCHED - watched.len()).cloned());
    Ok(watched)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_workspace_names_the_retentive_file() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("pump.clad");
        std::fs::write(&file, "VAR RETAIN n : INT; END_VAR\n+--[ADD]( n, n, 1 )--+\n").unwrap();
        std::fs::write(
            folder.path().join("ladder.toml"),
            "[simulate]\nretain = \"pump.retain\"\n",
        )
        .unwrap();
        let stimulus = Stimulus::default();
        let request = Request {
            file: &file,
            from: None,
            plants: &Plants::default(),
            stimulus: &stimulus,
            retain: None,
            watch: &[],
        };
        let mut plant = first(&request).unwrap().expect("a program without errors");
        plant.finish().unwrap();
        let kept = std::fs::read_to_string(folder.path().join("pump.retain")).unwrap();
        assert!(kept.contains("n\tINT\t0"), "{kept}");
    }
}

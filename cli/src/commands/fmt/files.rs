//! Files: which are meant, and aligning them all at once. Their messages come in their order.

use super::{Arguments, Task, diff, layout, would_change};
use crate::form::{self, Form};
use crate::outcome::{Failure, Outcome, unreadable};
use crate::settings::SettingsFiles;
use crate::terminal::{self, Stdout};
use ladder_format::Options;
use ladder_workspace::{Settings, is_scenario, shown};
use rayon::prelude::*;
use std::io::Write;
use std::path::{Path, PathBuf};

pub(super) fn format(arguments: &Arguments) -> Result<Outcome, Failure> {
    let config = arguments.config()?;
    let (mut files, errors) = ladder_workspace::find_ladder_text(&arguments.paths);
    files.retain(|file| !is_left_out(file, arguments, config.as_ref()));
    if arguments.range.is_some() && files.len() > 1 {
        return Err(Failure::new("--range needs exactly one file"));
    }
    let mut outcome = unreadable(&errors);
    let mut out = Stdout::new();
    let jobs = with_options(files, config.as_ref());
    // In batches, so that what a run has to say about a great many files need not wait in memory.
    for batch in jobs.chunks(256) {
        let done: Vec<_> = batch.par_iter().map(|job| job.run(arguments)).collect();
        for (job, done) in batch.iter().zip(done) {
            // One file that is bad does not keep the others from being aligned.
            match done {
                Ok(Done::Nothing) => {}
                Ok(Done::WouldChange) => {
                    would_change(&job.file);
                    outcome = outcome.max(Outcome::Findings);
                }
                Ok(Done::Differs(difference)) => {
                    out.write_all(&difference)?;
                    outcome = outcome.max(Outcome::Findings);
                }
                Err(failure) => {
                    if let Some(failure) = failure {
                        terminal::error(&failure);
                    }
                    outcome = Outcome::Failed;
                }
            }
        }
    }
    out.flush()?;
    Ok(outcome)
}

/// Whether a file is passed over. One that was found in a folder is not excluded by the settings above it; one that
/// was named is asked only if that is wanted.
fn is_left_out(file: &PathBuf, arguments: &Arguments, config: Option<&Settings>) -> bool {
    let named = arguments.paths.contains(file);
    if named && !arguments.force_exclude {
        return false;
    }
    let by_config =
        config.is_some_and(|config| std::path::absolute(file).is_ok_and(|file| !config.files.contain(&file)));
    by_config || named && ladder_workspace::is_excluded(file)
}

/// A file, and how it is to be laid out; or why that is not known (none: it was reported for another file).
struct Job {
    file: PathBuf,
    options: Result<Options, Option<String>>,
}

fn with_options(files: Vec<PathBuf>, config: Option<&Settings>) -> Vec<Job> {
    let mut settings = SettingsFiles::default();
    files
        .into_iter()
        .map(|file| {
            let options = match config {
                Some(config) => Ok(config.format.clone()),
                None => match settings.of(&file) {
                    Ok(Some(settings)) => Ok(settings.format.clone()),
                    Ok(None) => Err(None),
                    Err(failure) => Err(Some(failure.to_string())),
                },
            };
            Job { file, options }
        })
        .collect()
}

/// What came of a file.
enum Done {
    /// It is aligned.
    Nothing,
    WouldChange,
    /// The difference, to be shown.
    Differs(Vec<u8>),
}

impl Job {
    fn run(&self, arguments: &Arguments) -> Result<Done, Option<Failure>> {
        let options = match &self.options {
            Ok(options) => options,
            Err(told) => return Err(told.clone().map(Failure::new)),
        };
        run(&self.file, options, arguments).map_err(Some)
    }
}

fn run(file: &Path, options: &Options, arguments: &Arguments) -> Result<Done, Failure> {
    let bytes = ladder_workspace::read_bytes(file)?;
    if !is_scenario(file)
        && let Form::Foreign(notation) = form::of_program(file, &bytes)?
    {
        return Err(Failure::new(format!(
            "{}: only ladder text is aligned, and this file is in the notation `{}`",
            shown::path(file),
            notation.name()
        )));
    }
    let text = ladder_workspace::decode(file, bytes)?;
    let Some(formatted) = layout::formatted(file, &text, options, arguments.range)? else {
        return Ok(Done::Nothing);
    };
    Ok(match arguments.task() {
        Task::Rewrite => {
            ladder_workspace::write(file, formatted.as_bytes())?;
            Done::Nothing
        }
        Task::Report => Done::WouldChange,
        Task::ShowDifference => {
            let mut difference = Vec::new();
            diff::print(file, &text, &formatted, &mut difference)?;
            Done::Differs(difference)
        }
    })
}

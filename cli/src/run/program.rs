//! The program of a file, if it can run.

use super::unread;
use crate::findings::{Problem, Source, full};
use crate::outcome::Failure;
use crate::terminal::{self, stderr_has_colours};
use annotate_snippets::Renderer;
use ladder_analysis::program::{Location, Program};
use ladder_analysis::{NotWhole, Severity};
use ladder_simulator::{Options, Simulation};
use ladder_workspace::shown;
use std::sync::Arc;

/// `motor.clad:3:12`
pub(crate) fn place(source: &Source, location: Location) -> String {
    source.place_name(location)
}

/// The program with what it uses of other files, or the errors on stderr.
pub(crate) fn program(source: &Source) -> Option<Arc<Program>> {
    let not_whole = match source.program() {
        Ok(program) => {
            unread::note(&source.file, &program);
            return Some(program);
        }
        Err(not_whole) => not_whole,
    };
    match not_whole {
        NotWhole::Missing(file) => terminal::error(&format_args!(
            "{}: {}, which this program uses, cannot be read any more",
            shown::line(&source.file),
            shown::line(&file)
        )),
        NotWhole::Errors(file) => match source.other(&file) {
            Some(other) if source.analyze().context.name != file => {
                show_errors(&other);
                terminal::error(&format_args!(
                    "{}: this program uses {}; a program with errors is not run",
                    shown::line(&source.file),
                    shown::line(&file)
                ));
            }
            _ => {
                show_errors(source);
                terminal::error(&format_args!(
                    "{}: a program with errors is not run",
                    shown::line(&source.file)
                ));
            }
        },
    }
    None
}

/// The program before its first scan.
///
/// # Errors
/// It needs more memory than there is.
pub(crate) fn simulation(
    source: &Source,
    program: Arc<Program>,
    options: Options,
) -> Result<Simulation, Failure> {
    Simulation::new(program, options)
        .map_err(|error| Failure::new(format!("{}: {}", place(source, error.location), error.message)))
}

/// The errors of a program, on stderr. What is wrong with a program of another system comes first.
pub(crate) fn show_errors(source: &Source) {
    let renderer = if stderr_has_colours() {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let remarks = source.remarks().into_iter();
    for remark in remarks.filter(|remark| remark.severity == Severity::Error) {
        let problem = Problem::remark(source, remark, &renderer);
        terminal::plain(&format_args!("{}\n", problem.shown));
    }
    for error in source.errors() {
        terminal::plain(&format_args!("{}\n", full::render(source, &error, &renderer)));
    }
}

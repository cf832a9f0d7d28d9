//! The program of a file, if it can run.

use crate::findings::{Source, full};
use crate::terminal::{self, stderr_has_colours};
use annotate_snippets::Renderer;
use ladder_analysis::Severity;
use ladder_analysis::program::{Location, Program};
use std::sync::Arc;

/// `motor.clad:3:12`
pub(crate) fn place(source: &Source, location: Location) -> String {
    let place = source.place(location.range.start());
    format!("{}:{}:{}", source.file, place.line, place.column)
}

/// The program, or its errors on stderr.
pub(crate) fn program(source: &Source) -> Option<Arc<Program>> {
    let analysis = source.analyze();
    if analysis.program.is_none() {
        let renderer = if stderr_has_colours() {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        let errors = analysis
            .diagnostics
            .iter()
            .filter(|found| found.severity == Severity::Error);
        for error in errors {
            terminal::plain(&format_args!("{}\n", full::render(source, error, &renderer)));
        }
        terminal::error(&format_args!("{}: a program with errors is not run", source.file));
    }
    analysis.program
}

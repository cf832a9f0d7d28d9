//! Diagnostics of open texts that are no programs: settings files and scenarios.

use std::path::Path;
use std::sync::Arc;

use ladder_analysis::{Diagnostic as Finding, Severity};
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{self, Mistake};
use ladder_syntax::TextRange;
use ladder_workspace::{Named, SETTINGS_FILE, Settings, is_program, is_scenario};
use tower_lsp::ls_types::{Diagnostic, DiagnosticSeverity, NumberOrString};

use super::{diagnostics, settings_file};
use crate::busy::Work;
use crate::document::{Revision, address};
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, shared::Shared};

/// What stands where the name of a rule would.
pub(crate) const BAD_SETTING: &str = "bad-setting";
const BAD_SCENARIO: &str = "bad-scenario";

/// What an open text is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Ladder text. Whatever has another name but is not known to be something else.
    Program,
    /// `ladder.toml`.
    Settings,
    /// A file of scenarios.
    Scenarios,
    /// Something that the server knows nothing of: the client sends all files of a language.
    Other,
}

impl Kind {
    /// By the address, and by the language that the client says it is.
    pub(crate) fn of(uri: &str, language: &str) -> Kind {
        let name = Path::new(uri.rsplit('/').next().unwrap_or(uri));
        if name == Path::new(SETTINGS_FILE) {
            Kind::Settings
        } else if is_program(name) {
            Kind::Program
        } else if is_scenario(name) || matches!(language, "ladder-test" | "laddertest") {
            Kind::Scenarios
        } else if language == "toml" {
            Kind::Other
        } else {
            Kind::Program
        }
    }
}

/// Sees to it that the newest text gets its diagnostics.
pub(crate) fn refresh(shared: &Arc<Shared>, uri: &str) {
    if shared.agreed().pulls_diagnostics {
        return;
    }
    if let Some(revision) = shared.companions.begin_analysis(uri) {
        tokio::spawn(look_at(shared.clone(), revision, shared.busy.begin()));
    }
}

/// Looks once more at the open scenarios: a program has changed.
pub(crate) fn refresh_scenarios(shared: &Arc<Shared>) {
    for companion in shared.companions.all() {
        if Kind::of(&companion.uri, "") == Kind::Scenarios && shared.companions.touch(&companion.uri) {
            refresh(shared, &companion.uri);
        }
    }
}

async fn look_at(shared: Arc<Shared>, first: Arc<Revision>, _work: Work) {
    let mut next = Some(first);
    while let Some(revision) = next {
        if shared.companions.is_current(&revision) {
            let (beside, job) = (shared.clone(), revision.clone());
            match blocking(move |_| diagnostics_of(&beside, &job)).await {
                Ok(found) => shared
                    .outbox
                    .diagnostics(&shared.companions, revision.clone(), found),
                Err(error) => shared
                    .outbox
                    .log(format!("no diagnostics for {}: {}", revision.uri, error.message)),
            }
        }
        next = shared.companions.analysed(&revision);
    }
}

/// The text is gone from the editor. A settings file counts as it is on disk.
pub(crate) fn closed(shared: &Arc<Shared>, uri: &str) {
    if !shared.agreed().pulls_diagnostics {
        shared.outbox.no_diagnostics(uri);
    }
    if Kind::of(uri, "") == Kind::Settings {
        settings_file::tell_anew(shared, uri);
    }
}

/// What is wrong in an open text that is no program. For a blocking thread.
pub(crate) fn diagnostics_of(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    if !revision.fits() {
        return vec![diagnostics::too_large(revision)];
    }
    match Kind::of(&revision.uri, "") {
        Kind::Settings => settings(revision),
        Kind::Scenarios => scenarios(shared, revision),
        Kind::Program | Kind::Other => Vec::new(),
    }
}

fn settings(revision: &Revision) -> Vec<Diagnostic> {
    let path = address::path_of(&revision.uri);
    let (_, mistakes) = Settings::examine(path.as_deref().unwrap_or(Path::new("")), &revision.text());
    let mistakes = mistakes.into_iter();
    mistakes
        .map(|mistake| error(revision, mistake.range, BAD_SETTING, mistake.message))
        .collect()
}

fn scenarios(shared: &Shared, revision: &Revision) -> Vec<Diagnostic> {
    let suite = scenario::parse(&revision.text());
    let mut mistakes = suite.mistakes.clone();
    let mut found = Vec::new();
    if let (Some((name, range)), Some(path)) = (&suite.program, address::path_of(&revision.uri)) {
        let program = Named::in_file(&path, name).locate();
        let program = program.map_err(|error| NotReady::Missing(error.to_string()));
        match program
            .and_then(|program| compiled(shared, &program, suite.interval.map(|(interval, _)| interval)))
        {
            Ok(simulation) => mistakes.extend(scenario::bind(&suite, &simulation).1),
            Err(NotReady::Missing(message)) => {
                let help = "a program is named as it is seen from the folder of the scenario file";
                found.push(error(
                    revision,
                    *range,
                    BAD_SCENARIO,
                    format!("{message}\n{help}"),
                ));
            }
            // The program itself shows what is wrong with it.
            Err(NotReady::Errors(message)) => found.push(Diagnostic {
                severity: Some(DiagnosticSeverity::INFORMATION),
                ..error(revision, *range, BAD_SCENARIO, message)
            }),
        }
    }
    let said = |Mistake { range, message, help }| {
        let help = help.map(|help| format!("\n{help}"));
        error(revision, range, BAD_SCENARIO, message + &help.unwrap_or_default())
    };
    found.extend(mistakes.into_iter().map(said));
    found.sort_by_key(|it| (it.range.start.line, it.range.start.character));
    found
}

/// Why scenarios cannot be compared with their program.
enum NotReady {
    Missing(String),
    Errors(String),
}

/// The program of scenarios, ready to run: as the editor shows it if it is open, else as it is on disk.
fn compiled(shared: &Shared, path: &Path, interval: Option<i64>) -> Result<Simulation, NotReady> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let analysis = shared
        .neighbours
        .analysis_of(path)
        .map_err(|error| NotReady::Missing(error.to_string()))?;
    let errors = |of: &str| NotReady::Errors(format!("{of} has errors; its scenarios run when it has none"));
    if analysis.diagnostics.iter().any(is_error) {
        return Err(errors(&name));
    }
    let program = shared.neighbours.link(path, &analysis).map_err(|_| {
        NotReady::Errors(format!(
            "a file that {name} uses has errors; its scenarios run when that has none"
        ))
    })?;
    let mut options = shared.neighbours.simulate(path).options(&program);
    if let Some(interval) = interval {
        options.interval = interval;
    }
    Simulation::new(program, options).map_err(|_| errors(&name))
}

fn is_error(finding: &Finding) -> bool {
    finding.severity == Severity::Error
}

fn error(revision: &Revision, range: TextRange, code: &str, message: String) -> Diagnostic {
    Diagnostic {
        range: convert::range_in(revision, range),
        severity: Some(DiagnosticSeverity::ERROR),
        code: Some(NumberOrString::String(code.into())),
        source: Some("ladder".into()),
        message,
        ..Diagnostic::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_text_is() {
        for (uri, language, kind) in [
            ("file:///plant/motor.clad", "clad", Kind::Program),
            ("file:///plant/motor.clad", "", Kind::Program),
            ("untitled:Untitled-1", "clad", Kind::Program),
            ("file:///plant/ladder.toml", "toml", Kind::Settings),
            ("file:///plant/ladder.toml", "plaintext", Kind::Settings),
            ("file:///plant/Cargo.toml", "toml", Kind::Other),
            ("file:///plant/motor.ladder-test", "ladder-test", Kind::Scenarios),
            ("file:///plant/motor.ladder-test", "", Kind::Scenarios),
            ("untitled:Untitled-2", "laddertest", Kind::Scenarios),
        ] {
            assert_eq!(Kind::of(uri, language), kind, "{uri} {language}");
        }
    }
}

//! Errors in scenario files, shown like findings in programs.

use super::source::Source;
use crate::outcome::Failure;
use crate::terminal;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer};
use ladder_analysis::Severity;
use ladder_picture::scene::Finding;
use ladder_simulator::scenario::ScenarioError;
use ladder_workspace::{SettingError, Settings, SettingsError, shown};
use std::path::Path;

/// What is where the name of a rule would.
pub(crate) const NAME: &str = "bad-scenario";

/// What is there in a file of this name.
pub(crate) fn name_in(file: &str) -> &'static str {
    if ladder_workspace::is_scene(Path::new(file)) {
        Finding::NAME
    } else {
        NAME
    }
}

/// The same in `ladder.toml`.
pub(crate) const SETTING: &str = "bad-setting";

impl From<SettingsError> for Failure {
    fn from(error: SettingsError) -> Failure {
        let renderer = if terminal::stderr_has_colours() {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        Failure::of_lines(error.to_string().lines().map(str::to_owned))
            .with_excerpt(render_settings(&error, &renderer))
    }
}

/// What is wrong in a settings file, each with its excerpt; None if it is not about places in it.
fn render_settings(error: &SettingsError, renderer: &Renderer) -> Option<String> {
    let SettingsError::Content { file, errors } = error else {
        return None;
    };
    let source = settings_source(file)?;
    let shown = errors
        .iter()
        .map(|error| render_as((SETTING, Severity::Error), &source, &as_told(error), renderer));
    Some(shown.collect::<Vec<_>>().join("\n\n"))
}

/// A settings file, by its name from here; None if it cannot be read.
pub(crate) fn settings_source(file: &Path) -> Option<Source> {
    let text = Settings::own_text(file).ok()?;
    let here = std::env::current_dir().ok();
    let named = here.and_then(|here| file.strip_prefix(here).ok()).unwrap_or(file);
    Some(Source::new(named.display().to_string(), text))
}

/// As the errors of other files next to programs.
pub(crate) fn as_told(error: &SettingError) -> ScenarioError {
    ScenarioError {
        range: error.range,
        message: error.message.clone(),
        help: None,
    }
}

/// An error with its excerpt, without a line end after it.
pub(crate) fn render(source: &Source, error: &ScenarioError, renderer: &Renderer) -> String {
    render_as((name_in(&source.file), Severity::Error), source, error, renderer)
}

/// The same of what may be less than an error.
pub(crate) fn render_as(
    (name, severity): (&str, Severity),
    source: &Source,
    error: &ScenarioError,
    renderer: &Renderer,
) -> String {
    let excerpt = super::full::Excerpt::of(source, source.lines(error.range));
    let level = match severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Info => Level::INFO,
    };
    let mut group = Group::with_title(level.primary_title(shown::line(&error.message)).id(name)).element(
        excerpt
            .snippet(source)
            .annotation(AnnotationKind::Primary.span(excerpt.span(error.range))),
    );
    if let Some(help) = &error.help {
        group = group.element(Level::HELP.message(shown::line(help)));
    }
    renderer.render(&[group])
}

//! What is wrong next to the findings of the rules: an error in a file of scenarios, a remark on a program of another
//! system, or a file that cannot be read.

use super::concise::in_part;
use super::github::{self, data, property};
use super::source::Source;
use super::{full, sarif, scenario_error};
use crate::outcome::Outcome;
use annotate_snippets::Renderer;
use ladder_analysis::Severity;
use ladder_notations::Mark;
use ladder_picture::scene::Finding;
use ladder_simulator::scenario::ScenarioError;
use ladder_syntax::TextRange;
#[cfg(feature = "run")]
use ladder_workspace::SettingError;
use ladder_workspace::shown;
use serde::Serialize;
use serde_json::{Value, json};
use std::fmt::Display;

/// A place in a file: lines and columns from 1, columns in characters.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct FileRange {
    pub(crate) file: String,
    pub(crate) line: u32,
    pub(crate) column: u32,
    pub(crate) end_line: u32,
    pub(crate) end_column: u32,
}

impl FileRange {
    pub(crate) fn of(source: &Source, range: TextRange) -> FileRange {
        let (start, end) = (source.place(range.start()), source.place(range.end()));
        FileRange {
            file: source.file.clone(),
            line: start.line,
            column: start.column,
            end_line: end.line,
            end_column: end.column,
        }
    }

    /// The beginning of a file.
    pub(crate) fn start(file: &str) -> FileRange {
        FileRange {
            file: file.to_owned(),
            line: 1,
            column: 1,
            end_line: 1,
            end_column: 1,
        }
    }
}

/// What is wrong next to the findings of the rules. As JSON it has the members of a finding.
#[derive(Serialize)]
pub(crate) struct Problem {
    #[serde(flatten)]
    pub(crate) place: FileRange,
    /// The rule, or what stands for one.
    pub(crate) rule: &'static str,
    #[serde(serialize_with = "by_name")]
    pub(crate) severity: Severity,
    pub(crate) message: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) help: Option<String>,
    /// What another system calls the part of its file that it is in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) part: Option<String>,
    /// The same for people, with its excerpt.
    #[serde(skip)]
    pub(crate) shown: String,
    /// Whether it is a finding, or keeps the command from doing its work.
    #[serde(skip)]
    pub(crate) outcome: Outcome,
}

impl Problem {
    /// An error in a scenario file.
    pub(crate) fn of(source: &Source, found: &ScenarioError, renderer: &Renderer) -> Problem {
        Problem {
            place: FileRange::of(source, found.range),
            rule: scenario_error::name_in(&source.file),
            severity: Severity::Error,
            message: found.message.clone(),
            help: found.help.clone(),
            part: None,
            shown: scenario_error::render(source, found, renderer),
            outcome: Outcome::Findings,
        }
    }

    /// An error in a settings file.
    #[cfg(feature = "run")]
    pub(crate) fn in_settings(source: &Source, found: &SettingError, renderer: &Renderer) -> Problem {
        let as_error = scenario_error::as_told(found);
        let shown = (scenario_error::SETTING, Severity::Error);
        Problem {
            rule: scenario_error::SETTING,
            shown: scenario_error::render_as(shown, source, &as_error, renderer),
            ..Problem::of(source, &as_error, renderer)
        }
    }

    /// What there is to say about a scene.
    pub(crate) fn in_scene(source: &Source, found: &Finding, renderer: &Renderer) -> Problem {
        let as_error = ScenarioError {
            range: found.range,
            message: found.message.clone(),
            help: Some(found.help.to_owned()),
        };
        let shown = (Finding::NAME, found.severity);
        Problem {
            severity: found.severity,
            shown: scenario_error::render_as(shown, source, &as_error, renderer),
            outcome: of_severity(found.severity),
            ..Problem::of(source, &as_error, renderer)
        }
    }

    /// What there is to say about a program of another system.
    pub(crate) fn remark(source: &Source, remark: Mark, renderer: &Renderer) -> Problem {
        Problem {
            place: FileRange::of(source, remark.range),
            rule: remark.check,
            severity: remark.severity,
            shown: full::remark(source, &remark, renderer),
            message: remark.message,
            help: None,
            part: source.name_of(remark.range).map(str::to_owned),
            outcome: of_severity(remark.severity),
        }
    }

    /// Something that keeps the command from doing its work.
    pub(crate) fn unusable(place: FileRange, error: &impl Display) -> Problem {
        let message = error.to_string();
        Problem {
            place,
            rule: scenario_error::NAME,
            severity: Severity::Error,
            shown: format!("error: {}", shown::line(&message)),
            message,
            help: None,
            part: None,
            outcome: Outcome::Failed,
        }
    }

    /// `a.ladder-test:3:1: error[bad-scenario] message`
    pub(crate) fn concise(&self) -> String {
        let FileRange {
            file, line, column, ..
        } = &self.place;
        let (file, message) = (shown::line(file), shown::line(&self.message));
        format!(
            "{file}:{line}:{column}: {}[{}] {message}{}",
            self.severity.name(),
            self.rule,
            in_part(self.part.as_deref())
        )
    }

    /// A workflow command of GitHub Actions.
    pub(crate) fn github(&self) -> String {
        annotation(
            github::command(self.severity),
            &self.place,
            self.rule,
            &self.text(),
        )
    }

    /// A result of SARIF.
    pub(crate) fn sarif(&self) -> Value {
        let place = &self.place;
        let mut result = json!({
            "ruleId": self.rule,
            "level": sarif::level(self.severity),
            "message": { "text": self.text() },
            "locations": [{ "physicalLocation": {
                "artifactLocation": { "uri": sarif::uri(&place.file) },
                "region": {
                    "startLine": place.line,
                    "startColumn": place.column,
                    "endLine": place.end_line,
                    "endColumn": place.end_column,
                },
            }}],
        });
        if let Some(part) = &self.part {
            result["locations"][0]["logicalLocations"] = sarif::logical(part);
        }
        result
    }

    /// The message, and what to do on a line of its own.
    fn text(&self) -> String {
        let help = self.help.as_ref().map(|help| format!("\n{help}"));
        let part = in_part(self.part.as_deref());
        format!("{}{part}{}", self.message, help.unwrap_or_default())
    }
}

fn of_severity(severity: Severity) -> Outcome {
    match severity {
        Severity::Error => Outcome::Findings,
        Severity::Warning | Severity::Info => Outcome::Fine,
    }
}

#[allow(
    clippy::trivially_copy_pass_by_ref,
    reason = "serde calls it with a reference"
)]
fn by_name<S: serde::Serializer>(severity: &Severity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(severity.name())
}

/// A workflow command of GitHub Actions, which shows a message at a place in a change.
pub(crate) fn annotation(kind: &str, place: &FileRange, title: &str, message: &str) -> String {
    let FileRange {
        file,
        line,
        column,
        end_line,
        end_column,
    } = place;
    // Columns are understood only for a place on one line.
    let end = if line == end_line {
        format!("col={column},endColumn={end_column}")
    } else {
        format!("endLine={end_line}")
    };
    format!(
        "::{kind} file={},line={line},{end},title={}::{}",
        property(file),
        property(title),
        data(message)
    )
}

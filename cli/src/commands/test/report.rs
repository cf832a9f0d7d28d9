//! What came of the scenarios, for all forms of output.

use crate::findings::{FileRange, Problem, Source};
use crate::outcome::Outcome;
use ladder_simulator::coverage::Coverage;
use ladder_simulator::scenario::Line;
use ladder_workspace::shown;
use std::sync::Arc;

/// What came of one scenario file.
pub(super) struct FileReport {
    /// The file as it was named.
    pub(super) file: String,
    /// The program, if it could be read.
    pub(super) program: Option<Arc<Source>>,
    /// Its unread parts.
    pub(super) unread_parts: Vec<String>,
    /// Why none of its scenarios ran.
    pub(super) problems: Vec<Problem>,
    /// In the order of the file.
    pub(super) cases: Vec<CaseReport>,
    pub(super) seconds: f64,
    /// What the scenarios exercised, if that was asked for.
    pub(super) coverage: Option<Coverage>,
    /// How many properties it has, which are watched in each scenario.
    pub(super) properties: usize,
}

impl FileReport {
    pub(super) fn outcome(&self) -> Outcome {
        let problems = self.problems.iter().map(|problem| problem.outcome);
        let cases = self.cases.iter().map(|case| {
            if case.passed {
                Outcome::Fine
            } else {
                Outcome::Findings
            }
        });
        problems.chain(cases).max().unwrap_or(Outcome::Fine)
    }
}

/// What came of one scenario.
pub(super) struct CaseReport {
    pub(super) name: String,
    pub(super) place: FileRange,
    pub(super) passed: bool,
    pub(super) steps: usize,
    pub(super) scans: u64,
    pub(super) seconds: f64,
    /// What differs, drawn.
    pub(super) drawing: Vec<Line>,
    pub(super) differences: Vec<DifferenceReport>,
    pub(super) violations: Vec<ViolationReport>,
    /// Where it leaves what is assumed, in words.
    pub(super) outside: Option<String>,
    pub(super) faults: Vec<FaultReport>,
    /// The simulation was stopped in this step.
    pub(super) stopped: Option<usize>,
    /// The files with pictures of the machine in the step that failed.
    pub(super) pictures: Vec<String>,
}

impl CaseReport {
    /// What is wrong, in one sentence for each row and property.
    pub(super) fn sentences(&self) -> Vec<String> {
        let mut sentences: Vec<String> = self
            .differences
            .iter()
            .map(|difference| difference.sentence.clone())
            .chain(self.violations.iter().map(|violation| violation.sentence.clone()))
            .collect();
        if let Some(step) = self.stopped {
            sentences.push(format!("the simulation stopped in step {step}"));
        }
        sentences
    }

    /// The place of the first value that is not met, else of the scenario's name, whose run violates a property.
    pub(super) fn first_place(&self) -> &FileRange {
        self.differences
            .first()
            .map_or(&self.place, |difference| &difference.place)
    }

    /// The drawing as plain text.
    pub(super) fn drawn(&self) -> String {
        let lines: Vec<&str> = self.drawing.iter().map(|line| line.text.as_str()).collect();
        lines.join("\n")
    }
}

/// A row that is not as expected.
pub(super) struct DifferenceReport {
    pub(super) tag: String,
    pub(super) place: FileRange,
    pub(super) steps: Vec<usize>,
    /// Where the values are that differ.
    pub(super) places: Vec<FileRange>,
    pub(super) sentence: String,
}

/// A property that is violated.
pub(super) struct ViolationReport {
    pub(super) name: String,
    /// Of its name.
    pub(super) place: FileRange,
    pub(super) scan: u64,
    pub(super) steps: Vec<usize>,
    pub(super) sentence: String,
}

/// A fault that was recorded.
pub(super) struct FaultReport {
    pub(super) place: FileRange,
    pub(super) scan: u64,
    pub(super) message: String,
}

impl FaultReport {
    /// `motor.clad:3:12: fault in scan 4: division by zero ...`
    pub(super) fn line(&self) -> String {
        let FileRange {
            file, line, column, ..
        } = &self.place;
        format!(
            "{}:{line}:{column}: fault in scan {}: {}",
            shown::line(file),
            self.scan,
            shown::line(&self.message)
        )
    }
}

/// How many there are of everything.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tally {
    pub(super) files: usize,
    pub(super) passed: usize,
    pub(super) failed: usize,
    /// Files whose scenarios did not run.
    pub(super) broken: usize,
}

impl Tally {
    pub(super) fn count(&mut self, report: &FileReport) {
        self.files += 1;
        self.broken += usize::from(!report.problems.is_empty());
        let passed = report.cases.iter().filter(|case| case.passed).count();
        self.passed += passed;
        self.failed += report.cases.len() - passed;
    }

    pub(super) fn scenarios(self) -> usize {
        self.passed + self.failed
    }
}

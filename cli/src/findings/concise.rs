//! Findings on one line each: what editors' and terminals' pattern matchers read.

use super::source::Source;
use ladder_analysis::Diagnostic;
use ladder_workspace::shown;

/// `motor.clad:3:12: error[double-coil] message`
pub(crate) fn line(source: &Source, finding: &Diagnostic) -> String {
    let place = source.place(finding.range.start());
    format!(
        "{}:{}:{}: {}[{}] {}",
        shown::line(&source.file),
        place.line,
        place.column,
        finding.severity.name(),
        finding.rule,
        shown::line(&finding.message)
    )
}

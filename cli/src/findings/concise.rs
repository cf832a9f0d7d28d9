//! Findings on one line each: what editors' and terminals' pattern matchers read.

use super::source::Source;
use ladder_analysis::Diagnostic;
use ladder_workspace::shown;

/// `motor.clad:3:12: error[double-coil] message`
pub(crate) fn line(source: &Source, finding: &Diagnostic) -> String {
    let place = source.place(finding.range.start());
    let part = source.name_of(finding.range);
    let part = part.map_or_else(String::new, |name| format!(" ({})", shown::line(name)));
    format!(
        "{}:{}:{}: {}[{}] {}{part}",
        shown::line(&source.file),
        place.line,
        place.column,
        finding.severity.name(),
        finding.rule,
        shown::line(&finding.message)
    )
}

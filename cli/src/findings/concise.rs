//! Findings on one line each: what editors' and terminals' pattern matchers read.

use super::source::Source;
use ladder_analysis::Diagnostic;
use ladder_workspace::shown;

/// `motor.clad:3:12: error[double-coil] message`
pub(crate) fn line(source: &Source, finding: &Diagnostic) -> String {
    let place = source.place(finding.range.start());
    let part = in_part(source.name_of(finding.range));
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

/// After a message, what another system calls the place: ` (routine Main, rung 3)`.
pub(super) fn in_part(part: Option<&str>) -> String {
    part.map_or_else(String::new, |part| format!(" ({})", shown::line(part)))
}

//! Findings as workflow commands: a run of GitHub Actions shows them at their lines in the change.

use super::concise::in_part;
use super::source::Source;
use ladder_analysis::{Diagnostic, Severity};
use ladder_workspace::shown;
use std::fmt::Write;

/// `::error file=motor.clad,line=3,...::message`
pub(crate) fn line(source: &Source, finding: &Diagnostic) -> String {
    let command = command(finding.severity);
    let (start, end) = (
        source.place(finding.range.start()),
        source.place(finding.range.end()),
    );
    let mut line = format!("::{command} file={},line={}", property(&source.file), start.line);
    // Columns are understood only for a place on one line.
    if start.line == end.line {
        // Writing to a String does not fail.
        let _ = write!(line, ",col={},endColumn={}", start.column, end.column);
    } else {
        let _ = write!(line, ",endLine={}", end.line);
    }
    let help = finding.help.as_deref().map(|help| format!("\n{help}"));
    let part = in_part(source.name_of(finding.range));
    let message = format!("{}{part}{}", finding.message, help.unwrap_or_default());
    let _ = write!(
        line,
        ",title={}::{}",
        property(finding.rule.name()),
        data(&message)
    );
    line
}

/// The workflow command for a severity.
pub(super) fn command(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "notice",
    }
}

pub(crate) fn data(text: &str) -> String {
    shown::text(text)
        .replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

pub(crate) fn property(text: &str) -> String {
    data(&shown::line(text)).replace(':', "%3A").replace(',', "%2C")
}

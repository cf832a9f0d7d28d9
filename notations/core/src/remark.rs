//! What there is to say about a conversion, for a list of it.

use super::{Finding, LineColumn, Outcome, Report};

/// An element that did not become the same, or something that the other system itself would complain about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Remark<'r> {
    /// Where.
    pub place: LineColumn,
    /// `approximated`, `refused`, or the severity of what the other system says.
    pub outcome: &'static str,
    /// The element as it is written, or the name of the other system's check.
    pub element: &'r str,
    /// Why.
    pub reason: &'r str,
}

/// All remarks in the order of the file, each reported once.
pub fn remarks<'r>(report: &'r Report, findings: &'r [Finding]) -> Vec<Remark<'r>> {
    let elements = report.entries.iter().filter_map(|entry| {
        let (outcome, reason) = match &entry.outcome {
            Outcome::Translated => return None,
            Outcome::Approximated(why) => ("approximated", why),
            Outcome::Refused(why) => ("refused", why),
        };
        Some(Remark {
            place: entry.place,
            outcome,
            element: &entry.element,
            reason,
        })
    });
    let elements: Vec<Remark<'r>> = elements.collect();
    let told = report.told();
    let found = findings.iter().filter(|found| !told(found)).map(|found| Remark {
        place: found.place,
        outcome: found.severity.name(),
        element: found.check,
        reason: &found.message,
    });
    let mut all: Vec<Remark<'r>> = elements.iter().copied().chain(found).collect();
    all.sort_by_key(|remark| remark.place);
    all
}

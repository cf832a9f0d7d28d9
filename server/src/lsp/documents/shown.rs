//! Which findings of a file an editor is sent: it shows no more than so many, and each costs a message.

use ladder_analysis::{Finding, Severity};
use ladder_syntax::TextSize;
use ladder_syntax::numeral::counted;
use tower_lsp::ls_types::{Diagnostic, DiagnosticSeverity, NumberOrString, Range};

/// So many, which is also what VS Code keeps of one file.
const MOST: usize = 1_000;

/// What is shown of the findings of a file, in their order, and how many are left out: errors come before all others,
/// and then what is near to the place where the person works.
pub(crate) fn shown(all: &[Finding], edited: TextSize) -> (Vec<&Finding>, usize) {
    let weight = |found: &Finding| (found.severity == Severity::Error, found.range.start());
    chosen(all, edited, weight)
}

/// As [`shown`], of anything that is an error or not, and begins somewhere.
pub(crate) fn chosen<T>(
    all: &[T],
    edited: TextSize,
    weight: impl Fn(&T) -> (bool, TextSize),
) -> (Vec<&T>, usize) {
    let left_out = all.len().saturating_sub(MOST);
    if left_out == 0 {
        return (all.iter().collect(), 0);
    }
    let mut chosen: Vec<usize> = (0..all.len()).collect();
    chosen.select_nth_unstable_by_key(MOST - 1, |&at| {
        let (is_error, start) = weight(&all[at]);
        let away = u32::from(start).abs_diff(u32::from(edited));
        (!is_error, away, at)
    });
    chosen.truncate(MOST);
    chosen.sort_unstable();
    (chosen.into_iter().map(|at| &all[at]).collect(), left_out)
}

/// The finding that says how many there are beside those that are shown.
pub(crate) fn rest(left_out: usize) -> Option<Diagnostic> {
    (left_out > 0).then(|| Diagnostic {
        range: Range::default(),
        severity: Some(DiagnosticSeverity::INFORMATION),
        code: Some(NumberOrString::String("more-findings".into())),
        source: Some("ladder".into()),
        message: format!(
            "{} in this file: the {MOST} shown are the errors, and what is near to the last change. `ladder check` \
             shows all",
            counted(left_out, "more finding")
        ),
        ..Diagnostic::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use ladder_analysis::{Diagnostic, Rule};
    use ladder_syntax::TextRange;

    fn found(at: u32, severity: Severity) -> Finding {
        let place = TextRange::empty(TextSize::new(at));
        let mut found = Finding::from(Diagnostic::new(Rule::NoOutput, place, "nothing"));
        found.severity = severity;
        found
    }

    fn starts(all: &[Finding], edited: u32) -> (Vec<u32>, usize) {
        let (shown, left_out) = shown(all, TextSize::new(edited));
        (
            shown.iter().map(|found| found.range.start().into()).collect(),
            left_out,
        )
    }

    #[test]
    fn all_of_a_thousand() {
        let all: Vec<Finding> = (0..1_000).map(|at| found(at, Severity::Info)).collect();
        assert_eq!(starts(&all, 500), ((0..1_000).collect(), 0));
        assert!(rest(0).is_none());
    }

    #[test]
    fn errors_and_what_is_near() {
        let mut all: Vec<Finding> = (0..5_000).map(|at| found(at, Severity::Warning)).collect();
        all[7].severity = Severity::Error;
        all[4_999].severity = Severity::Error;
        let (shown, left_out) = starts(&all, 3_000);
        let mut expected: Vec<u32> = vec![7];
        expected.extend(2_501..=3_498);
        expected.push(4_999);
        assert_eq!((shown, left_out), (expected, 4_000));
        let said = rest(4_000).expect("some are left out").message;
        assert!(said.starts_with("4000 more findings"), "{said}");
    }
}

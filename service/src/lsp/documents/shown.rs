//! Which findings of a file an editor is sent: it shows only some, and each costs a message.

use ladder_analysis::{Finding, Severity, keep_nearest};
use ladder_documents::{Analysis, Revision};
use ladder_syntax::TextSize;
use ladder_syntax::numeral::counted;
use tower_lsp::ls_types::{Diagnostic, Range};

use crate::lsp::convert;

/// At most this many, which is also what VS Code keeps of one file.
const MOST: usize = 1_000;

/// What is shown of the findings of a file, in their order, and how many are left out: errors come before all others,
/// and then what is near to the place where the person works.
pub(crate) fn shown(analysis: &Analysis, revision: &Revision) -> (Vec<Finding>, usize) {
    let shown = analysis.whole().findings_near(MOST, revision.edited());
    let left_out = analysis.findings().len() - shown.len();
    (shown, left_out)
}

/// As [`shown`], of anything that is an error or not, and begins somewhere.
pub(crate) fn chosen<T>(
    all: &[T],
    edited: TextSize,
    weight: impl Fn(&T) -> (bool, TextSize),
) -> (Vec<&T>, usize) {
    let mut chosen: Vec<&T> = all.iter().collect();
    keep_nearest(&mut chosen, MOST, |one| {
        let (is_error, start) = weight(one);
        (!is_error, u32::from(start).abs_diff(u32::from(edited)))
    });
    let left_out = all.len() - chosen.len();
    (chosen, left_out)
}

/// The finding that says how many there are next to those that are shown.
pub(crate) fn rest(left_out: usize) -> Option<Diagnostic> {
    (left_out > 0).then(|| {
        let message = format!(
            "{} in this file: the {MOST} shown are the errors, and what is near to the last change. `ladder check` \
             shows all",
            counted(left_out, "more finding")
        );
        convert::diagnostic(Range::default(), Severity::Info, "more-findings", message)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn starts(errors: &[u32], count: u32, edited: u32) -> (Vec<u32>, usize) {
        let all: Vec<u32> = (0..count).collect();
        let weight = |at: &u32| (errors.contains(at), TextSize::new(*at));
        let (chosen, left_out) = chosen(&all, TextSize::new(edited), weight);
        (chosen.into_iter().copied().collect(), left_out)
    }

    #[test]
    fn all_of_a_thousand() {
        assert_eq!(starts(&[], 1_000, 500), ((0..1_000).collect(), 0));
        assert!(rest(0).is_none());
    }

    #[test]
    fn errors_and_what_is_near() {
        let (shown, left_out) = starts(&[7, 4_999], 5_000, 3_000);
        let mut expected: Vec<u32> = vec![7];
        expected.extend(2_501..=3_498);
        expected.push(4_999);
        assert_eq!((shown, left_out), (expected, 4_000));
        let told = rest(4_000).expect("some are left out").message;
        assert!(told.starts_with("4000 more findings"), "{told}");
    }
}

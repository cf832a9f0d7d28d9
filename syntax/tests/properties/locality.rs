//! An error never leaves its line, an open comment excepted.

use crate::invariants::check;
use crate::programs::PROGRAMS;
use ladder_syntax::LineKind;
use proptest::prelude::*;
use proptest::sample::Index;

/// The text of a line without `#` and line ends. Words that begin a section or block definition mean something to
/// the lines after them; declarations may go on over lines.
fn line() -> impl Strategy<Value = String> {
    crate::arbitrary::pieces()
        .prop_map(|text| text.replace(['#', '\n', '\r'], ""))
        .prop_filter("declares", |text| {
            ["var", "type", "end_", "function"]
                .iter()
                .all(|word| !text.to_lowercase().contains(word))
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Whatever a line of a drawing is replaced by, the other lines keep their nodes and their errors.
    #[test]
    fn other_lines_stay(program in 0..PROGRAMS.len(), at in any::<Index>(), new in line()) {
        let old = PROGRAMS[program];
        let before = check(old);
        let drawn: Vec<usize> = (0..before.lines().len())
            .filter(|&n| matches!(before.lines()[n].kind, LineKind::Rung | LineKind::Rail | LineKind::Blank))
            .filter(|&n| !old[before.line_range(n)].contains('#') && old[before.line_range(n)].ends_with('\n'))
            .collect();
        prop_assume!(!drawn.is_empty());
        let changed = drawn[at.index(drawn.len())];
        let range = std::ops::Range::<usize>::from(before.line_range(changed));
        let mut text = old.to_owned();
        text.replace_range(range.start..range.start + old[range].trim_end_matches(['\r', '\n']).len(), &new);
        let after = check(&text);
        prop_assert_eq!(before.lines().len(), after.lines().len());
        for (index, (b, a)) in before.lines().iter().zip(after.lines()).enumerate() {
            if index != changed {
                prop_assert_eq!(b.green(), a.green());
                prop_assert_eq!(&b.errors, &a.errors);
                prop_assert_eq!(b.kind, a.kind);
            }
        }
    }
}

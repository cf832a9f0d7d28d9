//! Fixes as they reach the text: with the drawing around them put straight.
//!
//! A fix changes widths, and what is in columns below it would no longer be there. So its raw edits are
//! made, the networks and sections that they touch are laid out again, and the difference to the text is what
//! an editor applies. This parses the whole text: it is done for the one fix that is wanted, not for each that
//! is offered.

use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use ladder_format::{Edit, Options, apply, difference, format_ranges};
use ladder_syntax::{TextRange, TextSize, parse};
use std::collections::BTreeMap;

/// The fixes that can be made together, each with its finding: the best of each finding that may be made, as far as none
/// touches another. The rest is for the next round. `most`: whether only safe ones may be made.
pub fn together(findings: &[Diagnostic], most: Applicability) -> Vec<(&Diagnostic, &Fix)> {
    let mut taken: BTreeMap<TextSize, TextRange> = BTreeMap::new();
    let mut together = Vec::new();
    for finding in findings {
        let mut fixes = finding.fixes.iter();
        let Some(fix) = fixes.find(|fix| fix.applicability <= most) else {
            continue;
        };
        // Those taken do not touch each other, so only the last one that begins before the end can touch. Edits that
        // touch might mean the same place.
        let touches = |new: &Edit| {
            let before = taken.range(..=new.range.end()).next_back();
            before.is_some_and(|(_, old)| new.range.start() <= old.end())
        };
        if !fix.edits.iter().any(touches) {
            taken.extend(fix.edits.iter().map(|edit| (edit.range.start(), edit.range)));
            together.push((finding, fix));
        }
    }
    together
}

/// Some fixes that do not touch each other, as one.
pub fn combined<'f>(fixes: impl Iterator<Item = &'f Fix>) -> Fix {
    let mut edits: Vec<Edit> = Vec::new();
    let mut applicability = Applicability::Safe;
    for fix in fixes {
        edits.extend(fix.edits.iter().cloned());
        applicability = applicability.max(fix.applicability);
    }
    edits.sort_by_key(|edit| edit.range.start());
    Fix::new(applicability, String::new(), edits)
}

/// The edits that make a fix in `text`, the text that it was found in: sorted, none touching another, none where
/// nothing changes.
pub fn aligned(text: &str, fix: &Fix, options: &Options) -> Vec<Edit> {
    let raw = apply(text, &fix.edits);
    let tidied = apply(&raw, &format_ranges(&parse(&raw), options, &moved(&fix.edits)));
    difference(text, &tidied)
}

/// Where the edits' texts appear once all are made. Sorted and disjoint edits are asked for.
fn moved(edits: &[Edit]) -> Vec<TextRange> {
    let mut shift = 0i64;
    edits
        .iter()
        .map(|edit| {
            let start = i64::from(u32::from(edit.range.start())) + shift;
            shift += edit.text.len() as i64 - i64::from(u32::from(edit.range.len()));
            TextRange::at(TextSize::new(start as u32), TextSize::of(edit.text.as_str()))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn applied(text: &str, from: &str, to: &str) -> String {
        let at = text.find(from).unwrap_or_default();
        let range = TextRange::at(TextSize::new(at as u32), TextSize::of(from));
        let to = to.to_owned();
        let edits = vec![Edit { range, text: to }];
        let fix = Fix::new(Applicability::Safe, "", edits);
        let edits = aligned(text, &fix, &Options::default());
        apply(text, &edits)
    }

    #[test]
    fn the_network_is_laid_out_again() {
        let text = "\
+--\\--[ ]( a )--\\----------------( )( y )--+
|  /--[ ]( b )--/                          |

+--[ ]( c )-( )( z )--+
";
        let fixed = applied(text, "( b )", "( longer_name )");
        assert_eq!(
            fixed,
            "\
+--\\--[ ]( a )------------\\------------------------------------------( )( y )--+
|  /--[ ]( longer_name )--/                                                    |

+--[ ]( c )-( )( z )--+
"
        );
    }

    /// The texts that are put in together for findings with these fixes, each an edit.
    fn all_fixes(most: Applicability, fixes: &[(u32, u32, &str)]) -> Vec<String> {
        let finding = |&(start, end, text): &(u32, u32, &str)| {
            let range = TextRange::new(start.into(), end.into());
            let applicability = if text == "guess" {
                Applicability::Unsafe
            } else {
                Applicability::Safe
            };
            Diagnostic::new(crate::rules::missing_wire::RULE, range, "").fix(applicability, "", range, text)
        };
        let findings: Vec<_> = fixes.iter().map(finding).collect();
        let fixes = together(&findings, most);
        let fix = combined(fixes.iter().map(|(_, fix)| *fix));
        fix.edits.into_iter().map(|edit| edit.text).collect()
    }

    #[test]
    fn fixes_that_touch_each_other_are_not_made_together() {
        let all = |fixes| all_fixes(Applicability::Safe, fixes);
        assert_eq!(all(&[(0, 2, "first"), (4, 6, "second")]), ["first", "second"]);
        assert_eq!(
            all(&[(4, 6, "second"), (0, 2, "first")]),
            ["first", "second"],
            "in the order of the text"
        );
        assert_eq!(
            all(&[(0, 4, "first"), (2, 6, "across"), (8, 9, "third")]),
            ["first", "third"]
        );
        assert_eq!(all(&[(3, 3, "first"), (3, 3, "same place")]), ["first"]);
        assert_eq!(all(&[(0, 3, "first"), (3, 5, "right after")]), ["first"]);
        assert_eq!(all(&[]), Vec::<String>::new());
    }

    #[test]
    fn guesses_wait_until_they_are_asked_for() {
        let fixes = [(0, 2, "guess"), (4, 6, "sure")];
        assert_eq!(all_fixes(Applicability::Safe, &fixes), ["sure"]);
        assert_eq!(all_fixes(Applicability::Unsafe, &fixes), ["guess", "sure"]);
    }
}

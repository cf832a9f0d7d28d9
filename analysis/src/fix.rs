//! Fixes as they reach the text: with the drawing around them put straight.
//!
//! A fix changes widths, and what stands in columns below it would no longer stand there. So its raw edits are
//! made, the networks and sections that they touch are laid out again, and the difference to the text is what
//! an editor applies. This parses the whole text: it is done for the one fix that is wanted, not for each that
//! is offered.

use crate::diagnostic::Fix;
use ladder_format::{Edit, Options, apply, format_ranges};
use ladder_syntax::{TextRange, TextSize, parse};

/// The edits that make a fix in `text`, the text that it was found in: at most one, whole lines, empty if it
/// changes nothing.
pub fn aligned(text: &str, fix: &Fix, options: &Options) -> Vec<Edit> {
    let raw = apply(text, &fix.edits);
    let parsed = parse(&raw);
    let tidied = apply(&raw, &format_ranges(&parsed, options, &moved(&fix.edits)));
    difference(text, &tidied).into_iter().collect()
}

/// Where the edits' texts stand once all are made. Sorted and disjoint edits are asked for.
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

/// The lines that differ, as one replacement.
fn difference(old: &str, new: &str) -> Option<Edit> {
    if old == new {
        return None;
    }
    let mut start = 0;
    for (a, b) in old.split_inclusive('\n').zip(new.split_inclusive('\n')) {
        if a != b {
            break;
        }
        start += a.len();
    }
    // Both rests begin at the same line start, so lines of theirs can be compared from behind.
    let mut behind = 0;
    let (old_rest, new_rest) = (&old[start..], &new[start..]);
    let (old_lines, new_lines) = (old_rest.split_inclusive('\n'), new_rest.split_inclusive('\n'));
    for (a, b) in old_lines.rev().zip(new_lines.rev()) {
        if a != b {
            break;
        }
        behind += a.len();
    }
    let (old_end, new_end) = (old.len() - behind, new.len() - behind);
    Some(Edit {
        range: TextRange::new(TextSize::new(start as u32), TextSize::new(old_end as u32)),
        text: new[start..new_end].to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn applied(text: &str, from: &str, to: &str) -> String {
        let at = text.find(from).unwrap_or_default();
        let range = TextRange::at(TextSize::new(at as u32), TextSize::of(from));
        let fix = Fix {
            title: String::new(),
            edits: vec![Edit {
                range,
                text: to.to_owned(),
            }],
        };
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
+--\\--[ ]( a )------------\\--( )( y )--+
|  /--[ ]( longer_name )--/            |

+--[ ]( c )-( )( z )--+
"
        );
    }

    #[test]
    fn nothing_to_do_is_no_edit() {
        assert_eq!(difference("a\nb\n", "a\nb\n"), None);
        let edit = difference("a\nb\nb\nc\n", "a\nb\nc\n").unwrap();
        assert_eq!(apply("a\nb\nb\nc\n", &[edit]), "a\nb\nc\n");
        let edit = difference("a\n", "a\nb").unwrap();
        assert_eq!(edit.text, "b");
    }
}

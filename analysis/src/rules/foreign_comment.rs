//! `unexpected-character`, for a comment as another language writes it: reported once, with what is written here.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::foreign_comment::ForeignComment;
use crate::names::context::Context;

/// One finding for each.
pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    out.extend(context.foreign_comments().0.iter().map(found));
}

fn found(comment: &ForeignComment) -> Diagnostic {
    let message = format!(
        "`{}` begins no comment: a comment is written # .. #",
        comment.opening
    );
    Diagnostic::new(super::unexpected_character::RULE, comment.range, message)
        .help("write the text between two `#`; it cannot hold a `#` itself")
        .fix(
            applicability(&comment.text),
            "Write it as a comment",
            comment.range,
            written(&comment.text),
        )
}

/// Words are no drawing. What looks like a rung may be one, with a slip before it.
fn applicability(text: &str) -> Applicability {
    if text.trim_start().starts_with(char::is_alphanumeric) {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

/// The comment as it is written here. A `#` would end it: `T#5s` becomes `5s`, and any other goes.
fn written(text: &str) -> String {
    let mut written = String::from("# ");
    for part in text.trim().split_inclusive('#') {
        let Some(before) = part.strip_suffix('#') else {
            written.push_str(part);
            continue;
        };
        let word = before.rfind(|c: char| !c.is_alphanumeric() && c != '_');
        let (ahead, word) = before.split_at(word.map_or(0, |at| at + 1));
        written.push_str(ahead);
        if !matches!(word.to_ascii_uppercase().as_str(), "T" | "TIME") {
            written.push_str(word);
        }
    }
    if written.len() > 2 {
        written.push(' ');
    }
    written.push('#');
    written
}

#[cfg(test)]
mod tests {
    use super::written;

    #[test]
    fn as_it_is_written_here() {
        for (text, expected) in [
            (" a note", "# a note #"),
            ("", "# #"),
            ("wait T#5s, then time#1h", "# wait 5s, then 1h #"),
            ("lamp #3 is 16#FF", "# lamp 3 is 16FF #"),
        ] {
            assert_eq!(written(text), expected, "{text}");
        }
    }
}

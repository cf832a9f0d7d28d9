//! What is wrong with the text of a `FORMATTED_STRING`.

use super::super::model::Leaf;
use super::error;
use crate::field;
use crate::text::{self, Piece};
use ladder_notation::Finding;

/// Its escapes, and whether they suit its variable.
pub(super) fn findings(leaf: &Leaf, out: &mut Vec<Finding>) {
    let fields = field::fields(&leaf.text);
    let text = text::spelled_out(&fields).unwrap_or_default();
    let mut complain = |message: String| out.push(error(leaf.line, "ldmicro-text", message));
    let mut numbers = 0;
    let mut rest = text.as_str();
    while let Some(at) = rest.find('\\') {
        rest = &rest[at + 1..];
        let length = match text::escape(rest) {
            Some((piece, length)) => {
                numbers += usize::from(matches!(piece, Piece::Number { .. }));
                length
            }
            None => {
                let shown: String = rest.chars().take(2).collect();
                complain(format!(
                    "Bad escape `\\{shown}` in the formatted string; a backslash itself is `\\\\`"
                ));
                rest.chars().next().map_or(0, char::len_utf8)
            }
        };
        rest = &rest[length..];
    }
    let has_variable = fields.first().is_some_and(|variable| *variable != "(none)");
    match (has_variable, numbers) {
        (true, 0) => complain(format!(
            "The formatted string has the variable `{}` and no escape such as `\\3` that says where it is written",
            fields[0]
        )),
        (false, 1..) => {
            complain(
                "The formatted string has an escape for a variable, and no variable is given".to_owned(),
            );
        }
        (_, 2..) => {
            complain(
                "The formatted string has more than one escape for its variable; one is possible".to_owned(),
            );
        }
        _ => {}
    }
}

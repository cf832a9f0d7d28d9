//! What is wrong with the text of a `FORMATTED_STRING`.

use super::super::model::{Leaf, Version};
use super::error;
use crate::field;
use ladder_notation::Finding;

/// Its escapes, and whether they suit its variable.
pub(super) fn findings(version: Version, leaf: &Leaf, out: &mut Vec<Finding>) {
    let fields = field::fields(&leaf.text);
    let text = text_of(&fields);
    let mut complain = |message: String| out.push(error(leaf.line, "ldmicro-text", message));
    let mut numbers = 0;
    let mut rest = text.as_str();
    while let Some(at) = rest.find('\\') {
        rest = &rest[at + 1..];
        let length = match escape(version, rest) {
            Some((length, is_number)) => {
                numbers += usize::from(is_number);
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

/// The text: character codes after their number, or the text itself in the fork's files.
fn text_of(fields: &[&str]) -> String {
    let codes = fields.get(2..).unwrap_or_default();
    let length = fields.get(1).and_then(|length| length.parse::<usize>().ok());
    let numbers: Option<String> = codes
        .iter()
        .map(|code| code.parse::<u8>().ok().map(char::from))
        .collect();
    match numbers {
        Some(text) if length == Some(codes.len()) => text,
        _ => fields.get(1..).unwrap_or_default().join(" "),
    }
}

/// How long the escape after a backslash is, and whether it stands for the variable.
fn escape(version: Version, rest: &str) -> Option<(usize, bool)> {
    let minus = usize::from(rest.starts_with('-'));
    let c = rest[minus..].chars().next()?;
    if ('1'..='5').contains(&c) {
        return Some((minus + 1, true));
    }
    if minus > 0 {
        return None;
    }
    let others = match version {
        Version::V01 => "rnbf\\",
        Version::V02 => "abefnrtv\\'\"?",
    };
    match c {
        'x' => {
            let digits = rest.get(1..3)?;
            digits
                .bytes()
                .all(|c| c.is_ascii_hexdigit())
                .then_some((3, false))
        }
        c if others.contains(c) => Some((1, false)),
        _ => None,
    }
}

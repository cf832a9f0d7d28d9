//! `unexpected-character`: characters that mean nothing where they are.

pub(super) mod named_in_head;
pub(super) mod sign_in_head;

use super::bad_arity::PLACEHOLDER;
use super::frame_keyword;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::{in_sentence, shortened};
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use ladder_instructions::{Instruction, Shape, known_elsewhere, lookup};
use ladder_syntax::{Many, Surroundings, TextRange, is_identifier};

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Text,
    "unexpected-character",
    Severity::Error,
));

pub(crate) fn unexpected(
    place: Surroundings,
    after_comment: bool,
    text: &str,
    range: TextRange,
) -> Diagnostic {
    let shown = shortened(text, 30);
    let message = match place {
        Surroundings::Rung if is_identifier(text) => format!("`{shown}` is outside of any block"),
        Surroundings::Rung => format!("`{shown}` means nothing on a rung"),
        Surroundings::Head => format!("`{shown}` means nothing in the first part of a block"),
        Surroundings::Operands if text == PLACEHOLDER => {
            "an operand is missing here: `?` holds its place".to_owned()
        }
        Surroundings::Operands => format!("`{shown}` means nothing among operands"),
        Surroundings::Declaration => format!("`{shown}` means nothing in a declaration"),
    };
    let found = Diagnostic::new(RULE, range, message);
    if after_comment {
        return found.help(
            "the `#` before it ended a comment: a comment ends at the very next `#`, so write 5s and not T#5s in it",
        );
    }
    if let Some(drawn) = drawn_with(text) {
        return found
            .help(format!("a drawing uses plain characters: write `{drawn}`"))
            .fix(
                Applicability::Safe,
                format!("Replace with `{drawn}`"),
                range,
                drawn,
            );
    }
    if let Some(keyword) = frame_keyword::misspelt(text) {
        return found.help(format!("did you mean {keyword}?")).fix(
            Applicability::Unsafe,
            format!("Replace with {keyword}"),
            range,
            keyword,
        );
    }
    match place {
        Surroundings::Rung if is_identifier(text) => found.help(match instruction(text) {
            // A word for an instruction is not a tag.
            Some(row) => format!("the {} is written {}", in_sentence(row.title), row.signature()),
            None => format!("a contact is written [ ]( {shown} ), a coil ( )( {shown} )"),
        }),
        Surroundings::Rung => {
            found.help("a rung is drawn with - + | \\ / and blocks; text is in # comments #")
        }
        Surroundings::Operands if text == PLACEHOLDER => {
            found.help("write the tag or the value instead of it")
        }
        _ => found,
    }
}

/// The instruction that goes by a name, here or elsewhere. One or two letters are rather a tag.
fn instruction(name: &str) -> Option<&'static Instruction> {
    let own = || lookup(Shape::Logical, name).next();
    (name.len() > 2).then(|| known_elsewhere(name).or_else(own))?
}

/// What is on a line after the last part that is read.
pub(crate) fn too_many(range: TextRange) -> Diagnostic {
    let most = Many::Parts.most();
    Diagnostic::new(
        RULE,
        range,
        format!("a line holds at most {most} wires, connectors and blocks: what follows is not read"),
    )
    .help("draw it on several lines, joined with \\ and /, or as several networks")
}

/// Whether all of the text can be drawn with plain characters.
pub(crate) fn is_typographic(text: &str) -> bool {
    drawn_with(text).is_some()
}

/// The plain characters for typographic ones, which word processors and terminals put in their place.
fn drawn_with(text: &str) -> Option<String> {
    let plain = |c: char| {
        Some(match c {
            '\u{2010}'..='\u{2015}' | '\u{2212}' | '─' | '━' | '═' => '-',
            '│' | '┃' | '║' | '¦' => '|',
            '┼' | '├' | '┤' | '╋' | '╬' => '+',
            '\u{2018}' | '\u{2019}' => '\'',
            '（' => '(',
            '）' => ')',
            '［' => '[',
            '］' => ']',
            _ => return None,
        })
    };
    text.chars().map(plain).collect()
}

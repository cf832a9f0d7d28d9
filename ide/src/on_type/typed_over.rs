//! What Enter has begun, typed once more: somebody who copies a drawing looks at the paper, not at the screen.
//!
//! `+--` is begun, and `+--[ ]( a )` is typed: without this it would become `+--+--[ ]( a )`.

use crate::body::line_text;
use ladder_analysis::context::Context;
use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};

/// The edits behind a character that repeats or rejects what its line was begun with; none if it does neither.
pub(super) fn typed_over(context: &Context, offset: TextSize, typed: char) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let line = parse.line_at(offset.checked_sub(TextSize::of(typed))?)?;
    let start = parse.line_start(line);
    let text = line_text(parse, line);
    // A comment that is just being opened has swallowed all lines below.
    let text = text.split(['\r', '\n']).next()?;
    if start + TextSize::of(text) != offset {
        return None;
    }
    let before = text.strip_suffix(typed)?;
    let (kept, instead) = match typed {
        // The rail of a rung that has its rail already.
        '+' if is_begun_rung(before) => (before.len(), ""),
        // A comment above the next rung.
        '#' if is_begun_rung(before) => (0, "#"),
        // The word that ends a block of one's own, or begins a section.
        'E' | 'F' | 'V' if is_begun_rung(before) => (0, &text[before.len()..]),
        '|' => {
            let begun = begun_branch(before)?;
            if begun.behind.is_empty() {
                // The left rail, which is there.
                (before.len(), "")
            } else {
                // No branch: the line only leads past this row.
                (begun.rail.len(), "|")
            }
        }
        // The beginning of the branch, which is there.
        '/' => {
            let begun = begun_branch(before)?;
            if begun.behind.is_empty() {
                return None;
            }
            (before.len() - begun.behind.len(), "")
        }
        _ => return None,
    };
    let range = TextRange::new(start + TextSize::try_from(kept).ok()?, offset);
    Some(vec![Edit {
        range,
        text: instead.to_owned(),
    }])
}

fn is_begun_rung(text: &str) -> bool {
    text == "+--"
}

struct BegunBranch<'a> {
    /// The rail and the blanks behind it.
    rail: &'a str,
    /// Blanks behind the beginning.
    behind: &'a str,
}

/// `|  /--` and blanks, in parts.
fn begun_branch(text: &str) -> Option<BegunBranch<'_>> {
    let at = text.find('/')?;
    let (rail, branch) = text.split_at(at);
    let behind = branch.strip_prefix("/--")?;
    let is_rail = rail.starts_with('|') && rail[1..].chars().all(|blank| blank == ' ' || blank == '|');
    (is_rail && behind.chars().all(|blank| blank == ' ')).then_some(BegunBranch { rail, behind })
}

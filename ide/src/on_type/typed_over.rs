//! What Enter has begun, typed once more: a user who copies a drawing looks at the paper, not at the screen.
//!
//! `+--` is begun, and `+--[ ]( a )` is typed: without this it would become `+--+--[ ]( a )`. What was begun goes, and what was
//! typed stays; also later in the line, for a fast typist is ahead of the answer.

use crate::body::line_text;
use ladder_analysis::context::Context;
use ladder_format::Edit;
use ladder_syntax::{TextRange, TextSize};

/// The edits after a line that was begun twice, or begun as what it is not; none if it is neither. The offset is at its end.
pub(super) fn typed_over(context: &Context, offset: TextSize) -> Option<Vec<Edit>> {
    let parse = &context.parse;
    let line = parse.line_at(offset.checked_sub(TextSize::new(1))?)?;
    let start = parse.line_start(line);
    let text = line_text(parse, line);
    // A comment that is just being opened has swallowed all lines below.
    let text = text.split(['\r', '\n']).next()?;
    if start + TextSize::of(text) != offset {
        return None;
    }
    let (from, to) = begun_rung(text)
        .or_else(|| begun_branch(text))
        .or_else(|| rail_again(text))?;
    let at = |place: usize| TextSize::try_from(place).ok().map(|place| start + place);
    let range = TextRange::new(at(from)?, at(to)?);
    Some(vec![Edit {
        range,
        text: String::new(),
    }])
}

/// Where `+--` is that another rail, a comment or a keyword follows: `END_FUNCTION_BLOCK`, `FUNCTION_BLOCK` or `VAR`.
fn begun_rung(text: &str) -> Option<(usize, usize)> {
    const BEGUN: &str = "+--";
    let typed = text.strip_prefix(BEGUN)?;
    typed
        .starts_with(['+', '#', 'E', 'F', 'V'])
        .then_some((0, BEGUN.len()))
}

/// Where after the right rail it is typed once more, with its wire: `( )( y )--+-+`.
fn rail_again(text: &str) -> Option<(usize, usize)> {
    let before = text.strip_suffix('+')?.trim_end_matches('-');
    let is_rung = before.starts_with(['+', '|']) && before.len() > 1;
    (is_rung && before.ends_with("-+")).then_some((before.len(), text.len()))
}

/// Where in `|  /--` is what is typed once more, from the rail or from the branch; or which only leads past this row.
fn begun_branch(text: &str) -> Option<(usize, usize)> {
    let at = text.find('/')?;
    let (rail, branch) = text.split_at(at);
    let typed = branch.strip_prefix("/--")?;
    let is_rail = rail.starts_with('|') && rail.chars().all(|letter| letter == ' ' || letter == '|');
    if !is_rail {
        return None;
    }
    let begun = text.len() - typed.len();
    let blanks = typed.len() - typed.trim_start_matches(' ').len();
    match typed[blanks..].chars().next()? {
        // All of it, from the rail on; or another rung, that a branch further to the right comes down to.
        '|' | '+' if blanks == 0 => Some((0, begun)),
        // The rail is there, and was not typed again.
        '|' | '/' if blanks > 0 => Some((at, begun + blanks)),
        _ => None,
    }
}

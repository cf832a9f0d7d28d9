//! A drawing in box-drawing characters, as other programs and books print them: drawn with the language's own.

use crate::diagnostic::{Applicability, Fix};
use crate::excerpt;
use ladder_format::Edit;
use ladder_syntax::{Parse, TextRange, TextSize};

/// A contact's first part is no longer than this: `┤ ├`, `┤/├`.
const LONGEST: usize = 3;

/// So many lines above and below a place are drawn anew at once.
const MOST: usize = 50;

/// What a box-drawing character stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stroke {
    Wire,
    Rail,
    /// Wire that a line leaves downward.
    Down,
    /// Wire that a line comes to from above.
    Up,
    /// A vertical line that wire leaves to the right.
    Right,
    /// A vertical line that wire comes to from the left.
    Left,
    Cross,
}

fn stroke(c: char) -> Option<Stroke> {
    Some(match c {
        '─' | '━' | '═' | '╌' | '┄' => Stroke::Wire,
        '│' | '┃' | '║' => Stroke::Rail,
        '┬' | '┳' | '╦' | '╤' | '┐' | '┓' | '╗' | '╮' | '┌' | '┏' | '╔' | '╭' => {
            Stroke::Down
        }
        '┴' | '┻' | '╩' | '╧' | '└' | '┗' | '╚' | '╰' | '┘' | '┛' | '╝' | '╯' => {
            Stroke::Up
        }
        '├' | '┣' | '╠' | '╟' => Stroke::Right,
        '┤' | '┫' | '╣' | '╢' => Stroke::Left,
        '┼' | '╋' | '╬' => Stroke::Cross,
        _ => return None,
    })
}

/// Whether a line is drawn with more than straight lines: what a corner means its neighbours say.
fn has_corners(line: &str) -> bool {
    line.chars()
        .filter_map(stroke)
        .any(|stroke| !matches!(stroke, Stroke::Wire | Stroke::Rail))
}

/// The fix of a drawing around a place: all lines above and below that have box-drawing characters. None if it has only
/// straight lines, or a line is no line of its own.
pub(crate) fn fix(parse: &Parse, at: TextSize) -> Option<Fix> {
    let drawn = |line: usize| {
        let range = parse.line_range(line);
        let text = excerpt::text(parse, range)
            .trim_end_matches(['\r', '\n'])
            .to_owned();
        let is_drawn = text.chars().any(|c| stroke(c).is_some()) && !text.contains(['\r', '\n']);
        is_drawn.then_some(text)
    };
    let line = parse.line_at(at)?;
    let mut first = line;
    drawn(line)?;
    while first > 0 && line - first < MOST && drawn(first - 1).is_some() {
        first -= 1;
    }
    let lines: Vec<String> = (first..parse.lines().len().min(line + MOST))
        .map_while(drawn)
        .collect();
    if !lines.iter().any(|line| has_corners(line)) {
        return None;
    }
    let edits = lines.iter().enumerate().map(|(number, text)| Edit {
        range: TextRange::at(parse.line_start(first + number), TextSize::of(text.as_str())),
        text: plain(text),
    });
    Some(Fix::new(
        Applicability::Unsafe,
        "Draw it with - + | \\ / and blocks",
        edits.collect(),
    ))
}

/// A line in the language's own characters. Connectors pair in their order, so columns need not be kept.
fn plain(line: &str) -> String {
    let characters: Vec<char> = line.trim_end().chars().collect();
    let is = |at: usize, wanted: Stroke| characters.get(at).copied().and_then(stroke) == Some(wanted);
    let drawn = |at: &usize| characters[*at] != ' ';
    let first = (0..characters.len()).find(drawn);
    let last = (0..characters.len()).rfind(drawn);
    let mut out = String::new();
    let mut at = 0;
    while let Some(&c) = characters.get(at) {
        let closing = (at + 2..=at + 1 + LONGEST).find(|&end| is(end, Stroke::Right));
        let inside = |end: usize| characters[at + 1..end].iter().all(|&c| stroke(c).is_none());
        match (stroke(c), closing) {
            (Some(Stroke::Left), Some(end)) if inside(end) => {
                out.push('[');
                out.extend(&characters[at + 1..end]);
                out.push(']');
                at = end;
            }
            (None, _) => out.push(c),
            (Some(Stroke::Wire), _) => out.push('-'),
            (Some(Stroke::Rail), _) => out.push('|'),
            (Some(Stroke::Down), _) => out.push('\\'),
            (Some(Stroke::Up), _) => out.push('/'),
            (Some(_), _) if Some(at) == first || Some(at) == last => out.push('+'),
            (Some(Stroke::Right | Stroke::Cross), _) => out.push_str("/--\\"),
            (Some(Stroke::Left), _) => out.push_str("\\--/"),
        }
        at += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::plain;

    #[test]
    fn what_is_drawn_with_boxes_is_drawn_plainly() {
        for (boxes, wanted) in [
            (
                "├──┬──[ ]( a )──┬──( )( y )──┤",
                "+--\\--[ ]( a )--\\--( )( y )--+",
            ),
            (
                "│  ├──[ ]( b )──┤            │",
                "|  /--\\--[ ]( b )--\\--/            |",
            ),
            ("│  └──[ ]( c )──┘            │", "|  /--[ ]( c )--/            |"),
            ("├──┤ ├──┤/├──( )──┤", "+--[ ]--[/]--( )--+"),
            ("╠══[ ]( a )══( )( y )══╣", "+--[ ]( a )--( )( y )--+"),
        ] {
            assert_eq!(plain(boxes), wanted);
        }
    }
}

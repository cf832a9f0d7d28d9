//! A drawing in box-drawing characters, as other programs and books print them: drawn with the language's own.

use crate::findings::diagnostic::{Applicability, Fix};
use crate::findings::excerpt;
use ladder_format::Edit;
use ladder_syntax::{Parse, TextRange, TextSize, is_identifier};

/// A contact's first part is no longer than this: `┤ ├`, `┤/├`.
const LONGEST: usize = 3;

/// This many lines above and below a place are drawn again at once.
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

/// The fix of a drawing around a place: all lines above and below that have box-drawing characters, or names above contacts and
/// coils. None if it has only straight lines, or a line is not a line of its own.
pub(crate) fn fix(parse: &Parse, at: TextSize) -> Option<Fix> {
    let own = |line: usize| {
        let range = (line < parse.lines().len()).then(|| parse.line_range(line))?;
        let text = excerpt::text(parse, range)
            .trim_end_matches(['\r', '\n'])
            .to_owned();
        (!text.contains(['\r', '\n'])).then_some(text)
    };
    let drawn = |line: usize| own(line).filter(|text| text.chars().any(|c| stroke(c).is_some()));
    let belongs = |line: usize| {
        let names = || names_above(&own(line)?, &drawn(line + 1)?);
        drawn(line).is_some() || names().is_some()
    };
    let line = parse.line_at(at)?;
    let mut first = line;
    drawn(line)?;
    while first > 0 && line - first < MOST && belongs(first - 1) {
        first -= 1;
    }
    let lines: Vec<String> = (first..line + MOST)
        .take_while(|&line| belongs(line))
        .map_while(own)
        .collect();
    if !lines.iter().any(|line| has_corners(line)) {
        return None;
    }
    let mut edits = Vec::new();
    let mut names = Vec::new();
    for (number, text) in lines.iter().enumerate() {
        let below = lines.get(number + 1);
        let start = parse.line_start(first + number);
        let mut range = TextRange::at(start, TextSize::of(text.as_str()));
        let found = below.and_then(|below| names_above(text, below));
        let new = match &found {
            Some(_) => plain(&without_names(text), &[]),
            None => plain(text, &names),
        };
        if found.is_some() && new.is_empty() {
            // Nothing else was on that line.
            range = TextRange::new(start, parse.line_start(first + number + 1));
        }
        names = found.unwrap_or_default();
        edits.push(Edit { range, text: new });
    }
    Some(Fix::new(
        Applicability::Unsafe,
        "Draw it with - + | \\ / and blocks",
        edits,
    ))
}

/// A name that is above a contact or coil.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Name {
    text: String,
    /// The column of what it is above.
    at: usize,
}

/// The names of a line that holds nothing else, but for rails, each above a contact or coil of the line below that has no operand.
fn names_above(line: &str, below: &str) -> Option<Vec<Name>> {
    let characters: Vec<char> = below.chars().collect();
    let mut bare = bare(&characters).into_iter();
    let mut names = Vec::new();
    let mut column = 0;
    for word in line.split_inclusive([' ', '\t']) {
        let (from, long) = (column, word.chars().count());
        column += long;
        let text = word.trim();
        let mut strokes = text.chars().map(stroke);
        if text.is_empty() || strokes.all(|it| it == Some(Stroke::Rail)) || text == "|" {
            continue;
        }
        let is_address = text
            .strip_prefix('%')
            .is_some_and(|rest| rest.chars().all(|c| c.is_ascii_alphanumeric() || c == '.'));
        if !is_identifier(text) && !is_address {
            return None;
        }
        let middle = from + text.chars().count() / 2;
        let reach = text.chars().count() / 2 + LONGEST;
        let (at, _) = bare.find(|(start, end)| middle.abs_diff(start.midpoint(*end)) <= reach)?;
        names.push(Name {
            text: text.to_owned(),
            at,
        });
    }
    (!names.is_empty()).then_some(names)
}

/// The rails of a line of names.
fn without_names(line: &str) -> String {
    let keep = |c: char| stroke(c).is_some() || c == '|';
    let blank = |c: char| if keep(c) { c } else { ' ' };
    line.chars().map(blank).collect()
}

/// The contacts and coils without an operand, each from its first column to its last.
fn bare(characters: &[char]) -> Vec<(usize, usize)> {
    let ends_block = |c: &char| matches!(c, ']' | ')') || stroke(*c) == Some(Stroke::Right);
    let mut found = Vec::new();
    let mut at = 0;
    while at < characters.len() {
        let is_list = at > 0 && ends_block(&characters[at - 1]);
        let end = contact(characters, at).or_else(|| coil(characters, at).filter(|_| !is_list));
        let Some(end) = end else {
            at += 1;
            continue;
        };
        let after = characters[end + 1..].iter().find(|&&c| c != ' ');
        if after != Some(&'(') {
            found.push((at, end));
        }
        at = end + 1;
    }
    found
}

/// Where a contact ends that begins in a column: `┤ ├`, `┤/├`.
fn contact(characters: &[char], at: usize) -> Option<usize> {
    let is = |at: usize, wanted: Stroke| characters.get(at).copied().and_then(stroke) == Some(wanted);
    let end = (at + 2..=at + 1 + LONGEST).find(|&end| is(end, Stroke::Right))?;
    let inside = &characters[at + 1..end];
    (is(at, Stroke::Left) && inside.iter().all(|&c| stroke(c).is_none())).then_some(end)
}

/// Where a coil ends that begins in a column: `( )`, `(S)`.
fn coil(characters: &[char], at: usize) -> Option<usize> {
    let end = (at + 1..=at + 2).find(|&end| characters.get(end) == Some(&')'))?;
    (characters[at] == '(').then_some(end)
}

/// A line in the language's own characters, with the names that be above it. Connectors pair in their order, so columns need
/// not be kept.
fn plain(line: &str, names: &[Name]) -> String {
    let characters: Vec<char> = line.trim_end().chars().collect();
    let drawn = |at: &usize| characters[*at] != ' ';
    let first = (0..characters.len()).find(drawn);
    let last = (0..characters.len()).rfind(drawn);
    let mut out = String::new();
    let mut at = 0;
    while let Some(&c) = characters.get(at) {
        let name = names.iter().find(|name| name.at == at);
        if let Some(end) = contact(&characters, at) {
            out.push('[');
            out.extend(&characters[at + 1..end]);
            out.push(']');
            at = end;
        } else if let Some(end) = coil(&characters, at).filter(|_| name.is_some()) {
            out.extend(&characters[at..=end]);
            at = end;
        } else {
            match stroke(c) {
                None => out.push(c),
                Some(Stroke::Wire) => out.push('-'),
                Some(Stroke::Rail) => out.push('|'),
                Some(Stroke::Down) => out.push('\\'),
                Some(Stroke::Up) => out.push('/'),
                Some(_) if Some(at) == first || Some(at) == last => out.push('+'),
                Some(Stroke::Right | Stroke::Cross) => out.push_str("/--\\"),
                Some(Stroke::Left) => out.push_str("\\--/"),
            }
        }
        if let Some(name) = name {
            out.push_str("( ");
            out.push_str(&name.text);
            out.push_str(" )");
        }
        at += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{names_above, plain};

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
            assert_eq!(plain(boxes, &[]), wanted);
        }
    }

    #[test]
    fn names_stand_above_contacts_and_coils() {
        let read = |above: &str, below: &str| {
            let names = names_above(above, below)?;
            Some(plain(below, &names))
        };
        for (above, below, wanted) in [
            (
                "   start     stop          run",
                "├───┤ ├───────┤/├──────────( )───┤",
                Some("+---[ ]( start )-------[/]( stop )----------( )( run )---+"),
            ),
            // One has an operand, and an address is a name.
            (
                "│                  %QX0.1  │",
                "├──┤ ├( a )─────────(S)────┤",
                Some("+--[ ]( a )---------(S)( %QX0.1 )----+"),
            ),
            // More names than contacts, too far away, and words that are not names.
            ("  a  b", "├──┤ ├──┤", None),
            ("                     a", "├──┤ ├──┤", None),
            ("  it's a", "├──┤ ├──┤", None),
            ("", "├──┤ ├──┤", None),
        ] {
            assert_eq!(read(above, below).as_deref(), wanted, "{above}");
        }
    }
}

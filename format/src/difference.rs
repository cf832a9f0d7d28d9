//! What differs between two texts of the same lines, as small edits: they leave an editor's cursors and marks where they are.

use crate::Edit;
use ladder_syntax::{TextRange, TextSize};

/// Lines of two texts are compared one with the other as long as there are no more pairs than this.
const MOST_PAIRS: usize = 250_000;

/// The edits that make one text of another: sorted, none touching another. Lines that differ in nothing but wires are taken
/// for the same.
pub fn difference(old: &str, new: &str) -> Vec<Edit> {
    let mut start = 0;
    for (a, b) in old.split_inclusive('\n').zip(new.split_inclusive('\n')) {
        if a != b {
            break;
        }
        start += a.len();
    }
    // Both rests begin at the same line start, so lines of theirs can be compared from the end.
    let mut after = 0;
    let (old_rest, new_rest) = (&old[start..], &new[start..]);
    let (old_lines, new_lines) = (old_rest.split_inclusive('\n'), new_rest.split_inclusive('\n'));
    for (a, b) in old_lines.rev().zip(new_lines.rev()) {
        if a != b {
            break;
        }
        after += a.len();
    }
    let old_lines: Vec<&str> = old[start..old.len() - after].split_inclusive('\n').collect();
    let new_lines: Vec<&str> = new[start..new.len() - after].split_inclusive('\n').collect();
    let mut edits: Vec<Edit> = Vec::new();
    let mut at = start;
    for (old, new) in pairs(&old_lines, &new_lines) {
        if let Some(edit) = replacement(at, old, new) {
            match edits
                .last_mut()
                .filter(|last| last.range.end() == edit.range.start())
            {
                Some(last) => {
                    last.range = last.range.cover(edit.range);
                    last.text.push_str(&edit.text);
                }
                None => edits.push(edit),
            }
        }
        at += old.len();
    }
    edits
}

/// Lines of the old text, each with what takes its place; nothing where one goes, and nothing old where one comes.
fn pairs<'t>(old: &[&'t str], new: &[&'t str]) -> Vec<(&'t str, &'t str)> {
    if old.len() == new.len() {
        return old.iter().copied().zip(new.iter().copied()).collect();
    }
    if old.len() * new.len() > MOST_PAIRS {
        let one = |lines: &[&'t str]| match (lines.first(), lines.last()) {
            (Some(_), Some(_)) => lines.to_vec(),
            _ => Vec::new(),
        };
        let (gone, come) = (one(old), one(new));
        let gone = gone.into_iter().map(|line| (line, ""));
        return gone.chain(come.into_iter().map(|line| ("", line))).collect();
    }
    let (old_keys, new_keys): (Vec<_>, Vec<_>) = (
        old.iter().map(|line| key(line)).collect(),
        new.iter().map(|line| key(line)).collect(),
    );
    // How many lines of the rests are the same.
    let width = new.len() + 1;
    let mut same = vec![0_u32; (old.len() + 1) * width];
    for a in (0..old.len()).rev() {
        for b in (0..new.len()).rev() {
            same[a * width + b] = if old_keys[a] == new_keys[b] {
                same[(a + 1) * width + b + 1] + 1
            } else {
                same[(a + 1) * width + b].max(same[a * width + b + 1])
            };
        }
    }
    let (mut a, mut b) = (0, 0);
    let mut found = Vec::new();
    while a < old.len() || b < new.len() {
        let is_pair = a < old.len() && b < new.len() && old_keys[a] == new_keys[b];
        if is_pair {
            found.push((old[a], new[b]));
            (a, b) = (a + 1, b + 1);
        } else if b == new.len() || (a < old.len() && same[(a + 1) * width + b] >= same[a * width + b + 1]) {
            found.push((old[a], ""));
            a += 1;
        } else {
            found.push(("", new[b]));
            b += 1;
        }
    }
    found
}

/// What of a line is not drawn.
fn key(line: &str) -> String {
    line.chars()
        .filter(|c| !matches!(c, '-' | ' ' | '\\' | '/' | '|' | '+' | '\r' | '\n'))
        .collect()
}

/// The edit that makes one text of another, without what they begin and end with.
fn replacement(start: usize, old: &str, new: &str) -> Option<Edit> {
    if old == new {
        return None;
    }
    let same = |(a, b): &(char, char)| a == b;
    let length = |pairs: &mut dyn Iterator<Item = (char, char)>| -> usize {
        pairs.take_while(same).map(|(c, _)| c.len_utf8()).sum()
    };
    let before = length(&mut old.chars().zip(new.chars()));
    let (old, new) = (&old[before..], &new[before..]);
    let after = length(&mut old.chars().rev().zip(new.chars().rev()));
    let range = TextRange::at(
        TextSize::new((start + before) as u32),
        TextSize::new((old.len() - after) as u32),
    );
    Some(Edit {
        range,
        text: new[..new.len() - after].to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::difference;
    use crate::apply;

    #[test]
    fn edits_are_small() {
        let check = |old: &str, new: &str, expected: &[(usize, usize, &str)]| {
            let edits = difference(old, new);
            assert_eq!(apply(old, &edits), new);
            let shown: Vec<_> = edits
                .iter()
                .map(|e| {
                    (
                        usize::from(e.range.start()),
                        usize::from(e.range.end()),
                        e.text.as_str(),
                    )
                })
                .collect();
            assert_eq!(shown, expected);
        };
        check("a\nb\n", "a\nb\n", &[]);
        check("a\nb\nb\nc\n", "a\nb\nc\n", &[(4, 6, "")]);
        check("a\n", "a\nb", &[(2, 2, "b")]);
        check(
            "+--a--+\n|     |\n+--b--+\n",
            "+--aa-+\n|     |\n+--bb-+\n",
            &[(4, 5, "a"), (20, 21, "b")],
        );
        check("é--\n", "è--\n", &[(0, 2, "è")]);
        check("--\r\n", "---\r\n", &[(2, 2, "-")]);
        // A line comes between others whose wires change.
        check(
            "+--a--+\n|  b  |\n",
            "+--\\--a--+\n|  /--c  |\n|  b--  |\n",
            &[(3, 3, "\\--"), (8, 8, "|  /--c  |\n"), (12, 12, "--")],
        );
        check("a\nb\n", "\n", &[(0, 4, "\n")]);
    }
}

//! The calls in a routine, and the tags that a structured text names.

use crate::model::Language;
use crate::operand::{Expr, Path, parse};
use crate::unit::Unit;
use ladder_drawings::neutral::instructions;

/// A path has no more characters.
const LONGEST_PATH: usize = 200;
/// A call has no more characters.
const LONGEST: usize = 10_000;

/// The names and operands of what a routine calls.
pub(crate) fn called(unit: &Unit<'_>) -> Vec<(String, Vec<String>)> {
    let mut all = Vec::new();
    for parts in unit.rungs.iter().filter_map(|rung| rung.as_ref().ok()) {
        instructions(parts, &mut |it| {
            let operands = it.operands.iter().map(|text| (*text).to_owned());
            all.push((it.name.to_owned(), operands.collect()));
        });
    }
    if let Some(foreign) = &unit.routine.foreign
        && foreign.language == Language::StructuredText
    {
        all.extend(calls_in(&foreign.text));
    }
    all
}

/// The calls in a text, `Motor(m1, start)`, in their order, each with its operands; those in comments and texts are none.
fn calls_in(text: &str) -> Vec<(String, Vec<String>)> {
    let text = without_comments(text);
    let is_in_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut calls = Vec::new();
    for (open, _) in text.match_indices('(') {
        let before = text[..open].trim_end();
        let begin = before
            .rfind(|c| !is_in_name(c))
            .map_or(0, |at| at + before[at..].chars().next().map_or(1, char::len_utf8));
        let name = &before[begin..];
        if name.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            calls.push((name.to_owned(), operands(&text[open + 1..])));
        }
    }
    calls
}

/// What is between commas, up to the parenthesis that closes.
fn operands(text: &str) -> Vec<String> {
    let mut operands = Vec::new();
    let (mut depth, mut begin) = (0usize, 0);
    for (at, c) in text.char_indices().take(LONGEST) {
        let is_end = c == ')' && depth == 0;
        if is_end || (c == ',' && depth == 0) {
            operands.push(text[begin..at].trim().to_owned());
            begin = at + 1;
        }
        match c {
            _ if is_end => break,
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            // A call of no end.
            ';' => return Vec::new(),
            _ => {}
        }
    }
    operands.retain(|operand| !operand.is_empty());
    operands
}

/// The tags and members that a text names, `t.PRE` and `lines[2].speed`, with constant and computed indices.
pub(crate) fn paths_in(text: &str) -> Vec<Path> {
    let text = without_comments(text);
    let is_in_name = |c: char| c.is_alphanumeric() || c == '_';
    let mut paths = Vec::new();
    let mut at = 0;
    while let Some(found) = text[at..].find(|c: char| c.is_alphabetic() || c == '_') {
        let begin = at + found;
        let mut depth = 0usize;
        let end = text[begin..].char_indices().take(LONGEST_PATH).find(|(_, c)| {
            match c {
                '[' => depth += 1,
                ']' => depth = depth.saturating_sub(1),
                _ => {}
            }
            !is_in_name(*c) && !matches!(c, '.' | '[' | ']') && depth == 0
        });
        let rest = &text[begin..];
        let length = end.map_or(rest.len(), |(length, _)| length);
        if (end.is_some() || rest.len() <= LONGEST_PATH)
            && let Ok(Expr::Path(path)) = parse(&rest[..length])
        {
            paths.push(path);
        }
        // The names in an index are paths, too.
        at = begin + rest.find(|c| !is_in_name(c)).unwrap_or(rest.len());
        if text[at..].starts_with('.') {
            let members = text[at..].find(|c| !is_in_name(c) && c != '.');
            at += members.unwrap_or(text.len() - at);
        }
    }
    paths
}

/// A text with blanks in the place of comments and texts in quotes.
fn without_comments(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = [("(*", "*)"), ("/*", "*/"), ("//", "\n"), ("'", "'")];
        let found = end.iter().find(|(begin, _)| rest.starts_with(begin));
        let length = match found {
            Some((begin, end)) => {
                let inside = &rest[begin.len()..];
                let closed = inside.find(end).map(|at| begin.len() + at + end.len());
                out.push(' ');
                closed.unwrap_or(rest.len())
            }
            None => {
                out.push(first);
                first.len_utf8()
            }
        };
        rest = &rest[length..];
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let calls = calls_in(text);
        let calls = calls
            .iter()
            .map(|(name, operands)| format!("{name}: {}", operands.join(" | ")));
        expected.assert_eq(&calls.collect::<Vec<_>>().join("\n"));
    }

    #[test]
    fn tags_and_their_members() {
        let paths = paths_in("t.PRE := 30; (* no.t *) list[i.k].m.3 := f(x.y); réel.w['");
        let shown = paths
            .iter()
            .map(|path| format!("{}{}", path.root, path.steps.len()));
        expect!["t1 list3 m1 f0 x1"].assert_eq(&shown.collect::<Vec<_>>().join(" "));
    }

    #[test]
    fn calls_and_their_operands() {
        check(
            "Motor(m1, list[f(2, i)], 'a,(b'); // Off(x)\nIF (a) THEN (* On(y) *) Réset (c.d); END_IF; Open(",
            expect![[r#"
                Motor: m1 | list[f(2, i)]
                f: 2 | i
                IF: a
                Réset: c.d
                Open: "#]],
        );
    }
}

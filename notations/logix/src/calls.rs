//! The calls in a structured text: what is called, and with what.

/// A call has no more characters.
const LONGEST: usize = 10_000;

/// The calls in a text, `Motor(m1, start)`, in their order, each with its operands; those in comments and texts are none.
pub(crate) fn calls_in(text: &str) -> Vec<(String, Vec<String>)> {
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

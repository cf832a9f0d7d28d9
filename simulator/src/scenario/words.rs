//! The words of a line. A comment goes from `#` to the end of the line; a `#` directly behind a letter or digit
//! belongs to a literal (`16#FF`, `T#5s`), one inside of quotes to the text.

use ladder_syntax::{TextRange, TextSize};

/// A word and where it stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Word<'t> {
    pub(super) text: &'t str,
    pub(super) start: usize,
    /// A text or name whose closing quote is missing.
    pub(super) unclosed: bool,
}

impl Word<'_> {
    pub(super) fn end(&self) -> usize {
        self.start + self.text.len()
    }

    pub(super) fn range(&self) -> TextRange {
        range(self.start, self.end())
    }
}

pub(super) fn range(start: usize, end: usize) -> TextRange {
    TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32))
}

/// The lines of a text, without their ends, and where they begin. LF, CRLF and a lone CR end a line.
pub(super) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    let mut at = start;
    text[start..].split_inclusive(['\n', '\r']).map(move |line| {
        let here = at;
        at += line.len();
        // The LF of a CRLF is an empty line of its own here, which means nothing.
        (here, line.trim_end_matches(['\n', '\r']))
    })
}

/// The words of a line that begins at `start`. `=>` is a word of its own, whatever touches it.
pub(super) fn words(line: &str, start: usize) -> Vec<Word<'_>> {
    let mut words = Vec::new();
    let mut at = 0;
    let last_closing = line.rfind(']');
    while let Some(next) = line[at..].find(|c: char| !c.is_whitespace()) {
        at += next;
        let rest = &line[at..];
        if rest.starts_with('#') {
            break;
        }
        let closing = last_closing.and_then(|closing| closing.checked_sub(at));
        let (length, unclosed) = length(rest, closing);
        words.push(Word {
            text: &rest[..length],
            start: start + at,
            unclosed,
        });
        at += length;
    }
    words
}

/// The length of the word that a rest begins with, in which the last `]` stands at `closing`.
fn length(rest: &str, closing: Option<usize>) -> (usize, bool) {
    if rest.starts_with("=>") {
        return (2, false);
    }
    if let Some(quote @ ('\'' | '"')) = rest.chars().next() {
        return quoted(rest, quote);
    }
    let mut before = ' ';
    let mut brackets = 0usize;
    for (at, c) in rest.char_indices() {
        let literal = before.is_alphanumeric();
        match c {
            '[' => brackets += 1,
            ']' => brackets = brackets.saturating_sub(1),
            // `T#5s`; `name'text'` is no word of any kind, and is split so that the text stays whole.
            '#' if !literal => return (at, false),
            '\'' if at > 0 && !rest[..at].ends_with('#') => return (at, false),
            '=' if rest[at..].starts_with("=>") => return (at, false),
            // `a[ 3 ]` is one name.
            c if c.is_whitespace() && (brackets == 0 || closing.is_none_or(|closing| closing < at)) => {
                return (at, false);
            }
            _ => {}
        }
        before = c;
    }
    (rest.len(), false)
}

/// The length of a text in quotes, where `$` takes the next character for itself in `'..'`.
fn quoted(rest: &str, quote: char) -> (usize, bool) {
    let mut escaped = false;
    for (at, c) in rest.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '$' if quote == '\'' => escaped = true,
            c if c == quote => return (at + c.len_utf8(), false),
            _ => {}
        }
    }
    (rest.trim_end().len(), true)
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(line: &str, expected: Expect) {
        let shown: Vec<String> = words(line, 0)
            .iter()
            .map(|word| format!("{}{}", word.text, if word.unclosed { " (unclosed)" } else { "" }))
            .collect();
        expected.assert_eq(&shown.join(" | "));
    }

    #[test]
    fn words_of_all_kinds() {
        check("run=>_-  # a comment", expect!["run | => | _-"]);
        check("a[ 3 ] 16#FF T#5s# c", expect!["a[ 3 ] | 16#FF | T#5s# | c"]);
        check("s => 'it$'s # 1' '' x", expect!["s | => | 'it$'s # 1' | '' | x"]);
        check("scenario \"a # b\" # c", expect![[r#"scenario | "a # b""#]]);
        check("s 'open # ", expect!["s | 'open # (unclosed)"]);
        check("\t \r", expect![""]);
        check("a[3 4", expect!["a[3 | 4"]);
    }

    #[test]
    fn lines_with_any_end() {
        let text = "\u{feff}a\r\nb\rc\n\nd";
        let found: Vec<(usize, &str)> = lines(text).filter(|(_, line)| !line.is_empty()).collect();
        assert_eq!(found, [(3, "a"), (6, "b"), (8, "c"), (11, "d")]);
    }
}

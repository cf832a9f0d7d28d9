//! The words of a line. A comment goes from `#` to the end of the line; a `#` directly after a letter or digit
//! belongs to a literal (`16#FF`, `T#5s`), one inside of quotes to the text.

use ladder_syntax::{TextRange, TextSize};

/// A word and where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Word<'t> {
    /// As it is written.
    pub text: &'t str,
    /// Where it begins, in bytes.
    pub start: usize,
    /// A text or name whose closing quote is missing.
    pub unclosed: bool,
}

impl Word<'_> {
    /// Where it ends, in bytes.
    pub(crate) fn end(&self) -> usize {
        self.start + self.text.len()
    }

    /// Where it is.
    pub fn range(&self) -> TextRange {
        range(self.start, self.end())
    }
}

pub(super) fn range(start: usize, end: usize) -> TextRange {
    TextRange::new(TextSize::new(start as u32), TextSize::new(end as u32))
}

/// A line of a scenario file, read into words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Line<'t> {
    /// Where it begins, in bytes.
    pub start: usize,
    /// What it says, without its end.
    pub text: &'t str,
    /// LF, CRLF or a lone CR; nothing after the last line.
    pub end: &'t str,
    /// Its words up to the comment.
    pub words: Vec<Word<'t>>,
    /// Where the comment begins, in bytes of the line.
    pub comment: Option<usize>,
}

impl<'t> Line<'t> {
    /// Reads a line that begins at `start`.
    pub fn read(text: &'t str, end: &'t str, start: usize) -> Line<'t> {
        let (words, comment) = words(text, start);
        Line {
            start,
            text,
            end,
            words,
            comment,
        }
    }

    /// What it says before the comment, and where that begins in the file.
    pub(super) fn before_comment(&self) -> (&'t str, usize) {
        (&self.text[..self.comment.unwrap_or(self.text.len())], self.start)
    }

    /// The comment with its `#`, if there is one.
    pub(crate) fn comment(&self) -> Option<&'t str> {
        Some(self.text[self.comment?..].trim_end())
    }
}

/// The lines of a text: nothing of it is left out but a byte order mark.
pub(super) fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut at = if text.starts_with('\u{feff}') { 3 } else { 0 };
    std::iter::from_fn(move || {
        let rest = text.get(at..).filter(|rest| !rest.is_empty())?;
        let length = rest.find(['\n', '\r']).unwrap_or(rest.len());
        let end = match &rest[length..] {
            after if after.starts_with("\r\n") => 2,
            after => after.len().min(1),
        };
        let line = Line::read(&rest[..length], &rest[length..length + end], at);
        at += length + end;
        Some(line)
    })
}

/// The words of a line that begins at `start`, and where its comment begins. `=>` is a word of its own, whatever touches
/// it.
fn words(line: &str, start: usize) -> (Vec<Word<'_>>, Option<usize>) {
    let mut words = Vec::new();
    let mut at = 0;
    let last_closing = line.rfind(']');
    while let Some(next) = line[at..].find(|c: char| !c.is_whitespace()) {
        at += next;
        let rest = &line[at..];
        if rest.starts_with('#') {
            return (words, Some(at));
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
    (words, None)
}

/// The length of the word that a rest begins with, in which the last `]` is at `closing`.
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
            // `T#5s`; `name'text'` is not a word of any kind, and is split so that the text stays whole.
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
            .0
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
        let found: Vec<(usize, &str, &str)> = lines(text)
            .map(|line| (line.start, line.text, line.end))
            .collect();
        let expected = [
            (3, "a", "\r\n"),
            (6, "b", "\r"),
            (8, "c", "\n"),
            (10, "", "\n"),
            (11, "d", ""),
        ];
        assert_eq!(found, expected);
    }
}

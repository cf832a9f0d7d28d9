//! The text of attributes: what an expression is, and where it is in the file.

use super::text_range;
use ladder_simulator::scenario::Written;
use std::ops::Range;

/// The text of an attribute in the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Raw<'t> {
    text: &'t str,
    start: usize,
}

/// An expression.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Expression {
    /// As long as in the file, so that what it names is where it says.
    pub(super) written: Written,
    /// What it means: without the escapes of XML.
    pub(super) text: String,
}

impl<'t> Raw<'t> {
    pub(super) fn new(text: &'t str, range: Range<usize>) -> Raw<'t> {
        Raw {
            text: &text[range.clone()],
            start: range.start,
        }
    }

    pub(super) fn range(self) -> ladder_syntax::TextRange {
        text_range(self.start..self.start + self.text.len())
    }

    fn part(self, range: Range<usize>) -> Raw<'t> {
        Raw {
            text: &self.text[range.clone()],
            start: self.start + range.start,
        }
    }

    /// Without blanks at its ends.
    pub(super) fn trimmed(self) -> Raw<'t> {
        let start = self.text.len() - self.text.trim_start().len();
        self.part(start..start + self.text.trim().len())
    }

    pub(super) fn is_empty(self) -> bool {
        self.text.is_empty()
    }

    /// What is between signs that are not in a text between quotes.
    pub(super) fn split(self, sign: char) -> Vec<Raw<'t>> {
        let plain = padded(self.text);
        let mut parts = Vec::new();
        let (mut from, mut quoted) = (0, false);
        for (at, c) in plain.char_indices() {
            quoted ^= c == '\'';
            if c == sign && !quoted {
                parts.push(self.part(from..at));
                from = at + c.len_utf8();
            }
        }
        parts.push(self.part(from..self.text.len()));
        parts
    }

    /// The parts before and after the first of these signs.
    pub(super) fn split_once(self, sign: &str) -> Option<(Raw<'t>, Raw<'t>)> {
        let at = padded(self.text).find(sign)?;
        Some((self.part(0..at), self.part(at + sign.len()..self.text.len())))
    }

    /// The parts before and after the last of these signs.
    pub(super) fn rsplit_once(self, sign: char) -> Option<(Raw<'t>, Raw<'t>)> {
        let at = padded(self.text).rfind(sign)?;
        Some((self.part(0..at), self.part(at + sign.len_utf8()..self.text.len())))
    }

    /// What it means.
    pub(super) fn value(self) -> String {
        decoded(self.text)
    }

    /// It as an expression.
    pub(super) fn expression(self) -> Expression {
        let trimmed = self.trimmed();
        Expression {
            written: Written {
                text: padded(trimmed.text),
                range: trimmed.range(),
            },
            text: decoded(trimmed.text),
        }
    }
}

/// The character that an escape such as `&lt;` or `&#60;` means.
fn escaped(text: &str) -> Option<(char, usize)> {
    let end = text.find(';').filter(|end| *end <= 10)?;
    let c = match &text[1..end] {
        "lt" => '<',
        "gt" => '>',
        "amp" => '&',
        "quot" => '"',
        "apos" => '\'',
        number => {
            let number = number.strip_prefix('#')?;
            let code = match number.strip_prefix('x') {
                Some(digits) => u32::from_str_radix(digits, 16).ok()?,
                None => number.parse().ok()?,
            };
            char::from_u32(code)?
        }
    };
    Some((c, end + 1))
}

/// With a blank for each line end and tab, as XML has it, and with what escapes mean.
fn decoded(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    each(text, |c, _| out.push(c));
    out
}

/// The same, as long as it is in the file: a run of escapes has blanks before what it means, so that `&gt;=` stays one operator.
fn padded(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let (mut run, mut missing) = (String::new(), 0);
    each(text, |c, length| {
        if length == c.len_utf8() {
            close(&mut out, &mut run, &mut missing);
            out.push(c);
        } else {
            run.push(c);
            missing += length.saturating_sub(c.len_utf8());
        }
    });
    close(&mut out, &mut run, &mut missing);
    out
}

fn close(out: &mut String, run: &mut String, missing: &mut usize) {
    out.extend(std::iter::repeat_n(' ', *missing));
    out.push_str(run);
    run.clear();
    *missing = 0;
}

/// Each character, with the bytes that it takes in the file.
fn each(text: &str, mut take: impl FnMut(char, usize)) {
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (c, length) = match c {
            '&' => escaped(rest).unwrap_or(('&', 1)),
            '\n' | '\r' | '\t' => (' ', 1),
            c => (c, c.len_utf8()),
        };
        take(c, length);
        rest = &rest[length..];
    }
}

/// The program that a text names that is perhaps not XML yet, while somebody types in it.
pub fn program_named(text: &str) -> Option<String> {
    let (_, rest) = text.split_once("l:program=")?;
    let quote = rest.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    let (name, _) = rest[1..].split_once(quote)?;
    Some(decoded(name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escapes_keep_their_places() {
        for (text, means, long) in [
            ("a &lt; 5", "a < 5", "a    < 5"),
            ("a &gt;= 5", "a >= 5", "a    >= 5"),
            ("a &lt;&gt; b", "a <> b", "a       <> b"),
            ("a\n&amp;", "a &", "a     &"),
            ("&#x3C; &nbsp;", "< &nbsp;", "     < &nbsp;"),
        ] {
            assert_eq!(decoded(text), means);
            assert_eq!(padded(text), long);
            assert_eq!(padded(text).len(), text.len(), "{text}");
        }
    }
}

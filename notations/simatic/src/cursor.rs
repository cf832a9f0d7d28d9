//! Reading a SIMATIC source document from left to right.

use ladder_notation::{LineColumn, Lines, ReadError};

/// A text and a place in it. Blanks and comments (`//`, `(* *)`) are passed over.
#[derive(Clone)]
pub(crate) struct Cursor<'t> {
    pub(crate) text: &'t str,
    pub(crate) at: usize,
    /// Nothing after it is read.
    pub(crate) end: usize,
    pub(crate) lines: &'t Lines,
}

pub(crate) type Result<T> = std::result::Result<T, ReadError>;

/// A letter of a name that needs no quotes.
fn is_letter(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Where what begins with a quote ends: with the same one that no `$` precedes, or with the line.
fn quote_end(text: &str, quote: char) -> usize {
    let mut is_escaped = false;
    let end = text.char_indices().skip(1).find(|(_, c)| {
        let ends = (*c == quote && !is_escaped) || *c == '\n';
        is_escaped = *c == '$' && quote == '\'' && !is_escaped;
        ends
    });
    end.map_or(text.len(), |(at, _)| at + 1)
}

/// A text without the comments at the ends of its lines, as one line.
pub(crate) fn without_comments(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = match c {
            '"' | '\'' => quote_end(rest, c),
            '/' if rest.starts_with("//") => {
                rest = &rest[rest.find('\n').unwrap_or(rest.len())..];
                continue;
            }
            c => c.len_utf8(),
        };
        out.push_str(if c == '\n' { " " } else { &rest[..length] });
        rest = &rest[length..];
    }
    out
}

impl<'t> Cursor<'t> {
    pub(crate) fn new(text: &'t str, lines: &'t Lines) -> Cursor<'t> {
        let at = if text.starts_with('\u{feff}') { 3 } else { 0 };
        let end = text.len();
        Cursor { text, at, end, lines }
    }

    pub(crate) fn rest(&self) -> &'t str {
        &self.text[self.at..self.end]
    }

    pub(crate) fn place(&self) -> LineColumn {
        self.lines.place(self.text, self.at)
    }

    pub(crate) fn error<T>(&self, message: impl Into<String>) -> Result<T> {
        Err(ReadError::at(self.place(), message))
    }

    /// What is there, in a message.
    fn shown(&self) -> String {
        let rest = self.rest();
        let word = rest.split(|c: char| c.is_whitespace() || c == '(').next();
        match word.unwrap_or_default() {
            "" => rest.chars().take(1).collect(),
            word => word.chars().take(40).collect(),
        }
    }

    /// Passes over blanks and comments. A comment that is passed on a line of its own is for nobody but people.
    pub(crate) fn blanks(&mut self) {
        loop {
            let rest = self.rest();
            self.at += rest.len() - rest.trim_start().len();
            let rest = self.rest();
            let length = if rest.starts_with("//") {
                rest.find('\n').unwrap_or(rest.len())
            } else if rest.starts_with("(*") {
                rest.find("*)").map_or(rest.len(), |end| end + 2)
            } else if rest.starts_with("(/*") {
                rest.find("*/)").map_or(rest.len(), |end| end + 3)
            } else if rest.starts_with("/*") {
                rest.find("*/").map_or(rest.len(), |end| end + 2)
            } else {
                return;
            };
            self.at += length;
        }
    }

    pub(crate) fn is_done(&mut self) -> bool {
        self.blanks();
        self.at >= self.end
    }

    /// Whether a sign is next.
    pub(crate) fn is(&mut self, sign: &str) -> bool {
        self.blanks();
        self.rest().starts_with(sign)
    }

    /// Takes a sign.
    pub(crate) fn eat(&mut self, sign: &str) -> bool {
        let is = self.is(sign);
        if is {
            self.at += sign.len();
        }
        is
    }

    pub(crate) fn expect(&mut self, sign: &str) -> Result<()> {
        if self.eat(sign) {
            return Ok(());
        }
        if self.is_done() {
            return self.error(format!("the file ends where `{sign}` is expected"));
        }
        self.error(format!("`{}` stands where `{sign}` is expected", self.shown()))
    }

    /// The word that is next; empty if none is.
    pub(crate) fn peek_word(&mut self) -> &'t str {
        self.blanks();
        let rest = self.rest();
        let end = rest.find(|c: char| !is_letter(c)).unwrap_or(rest.len());
        &rest[..end]
    }

    /// Takes a keyword.
    pub(crate) fn eat_word(&mut self, word: &str) -> bool {
        let is = self.peek_word().eq_ignore_ascii_case(word);
        if is {
            self.at += word.len();
        }
        is
    }

    /// A name, with or without quotes. One of the standard's name spaces (`_.`) stays away.
    pub(crate) fn name(&mut self) -> Result<String> {
        if self.is("\"") {
            return self.quoted();
        }
        let word = self.peek_word();
        if word.is_empty() {
            return self.error(format!("`{}` stands where a name is expected", self.shown()));
        }
        self.at += word.len();
        if word == "_" && self.rest().starts_with('.') {
            self.at += 1;
            return self.name();
        }
        Ok(word.to_owned())
    }

    /// A text in quotes; `""` is a quote in it.
    pub(crate) fn quoted(&mut self) -> Result<String> {
        self.expect("\"")?;
        let mut out = String::new();
        loop {
            let rest = self.rest();
            let Some(end) = rest.find(['"', '\n']).filter(|end| rest[*end..].starts_with('"')) else {
                return self.error("a quote `\"` is not closed on its line");
            };
            out.push_str(&rest[..end]);
            self.at += end + 1;
            if !self.rest().starts_with('"') {
                return Ok(out);
            }
            out.push('"');
            self.at += 1;
        }
    }

    /// Everything up to one of these signs outside of quotes, brackets and comments, without blanks at its ends.
    pub(crate) fn until(&mut self, signs: &str) -> Result<&'t str> {
        self.blanks();
        let start = self.at;
        let mut at = start;
        let mut open: Vec<char> = Vec::new();
        while let Some(c) = self.text[at..self.end].chars().next() {
            let rest = &self.text[at..self.end];
            if open.is_empty() && signs.contains(c) {
                self.at = at;
                return Ok(self.text[start..at].trim());
            }
            at += match c {
                '"' | '\'' => quote_end(rest, c),
                '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
                c => c.len_utf8(),
            };
            match c {
                '(' => open.push(')'),
                '[' => open.push(']'),
                ')' | ']' if open.pop() != Some(c) => break,
                _ => {}
            }
        }
        self.error(format!("one of `{signs}` is missing after `{}`", self.shown()))
    }

    /// Where a word is next, outside of quotes and comments.
    pub(crate) fn find_word(&self, word: &str) -> Option<usize> {
        let mut other = self.clone();
        while other.at < other.end {
            other.blanks();
            let rest = other.rest();
            let Some(c) = rest.chars().next() else { break };
            if is_letter(c) {
                let found = other.peek_word();
                if found.eq_ignore_ascii_case(word) {
                    return Some(other.at);
                }
                other.at += found.len();
            } else if c == '"' || c == '\'' {
                other.at += quote_end(rest, c);
            } else {
                other.at += c.len_utf8();
            }
        }
        None
    }
}

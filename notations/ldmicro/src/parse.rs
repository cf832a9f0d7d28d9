//! From the bytes of a file to the model, as tolerant as the fork's reader, with limits.

use super::element;
use super::head;
use super::model::{Encoding, File, Leaf, Node, Rung};
use ladder_notation::{LineColumn, ReadError};

/// A longer line is not read.
const LONGEST_LINE: usize = 64 << 10;
/// `SERIES` and `PARALLEL` nest no deeper.
const DEEPEST: usize = 64;
/// As many parts has a rung or a branch in LDmicro; each branch is a line of the drawing, and moves the next one right.
const MOST_PARTS: usize = 64;
/// A rung with more elements is not read.
const MOST_IN_RUNG: usize = 256;

/// Reads a file.
pub(super) fn parse(bytes: &[u8]) -> Result<File, ReadError> {
    let (text, latin1) = match std::str::from_utf8(bytes) {
        Ok(text) => (text.to_owned(), false),
        Err(_) => (bytes.iter().copied().map(char::from).collect(), true),
    };
    let crlf = text.find('\n').is_some_and(|at| text[..at].ends_with('\r'));
    let mut lines = Lines {
        lines: text.lines(),
        number: 0,
    };
    let mut file = File {
        encoding: Encoding { crlf, latin1 },
        ..File::default()
    };
    head::read(&mut file, &mut lines)?;
    while let Some(line) = lines.next()? {
        match line.split_whitespace().next() {
            None => {}
            Some(_) if line.starts_with(';') => {}
            Some("RUNG") => file.rungs.push(rung(&mut lines)?),
            Some(word) => {
                let message = format!("`RUNG` is expected here, not `{}`", shown(word));
                return Err(lines.error(message));
            }
        }
    }
    Ok(file)
}

/// As much of a word of the file as fits a message.
fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}

/// The lines of a file, trimmed.
pub(super) struct Lines<'t> {
    lines: std::str::Lines<'t>,
    number: u32,
}

impl<'t> Lines<'t> {
    pub(super) fn next(&mut self) -> Result<Option<&'t str>, ReadError> {
        let Some(line) = self.lines.next() else {
            return Ok(None);
        };
        self.number += 1;
        if line.len() > LONGEST_LINE {
            return Err(self.error(format!("the line is longer than {LONGEST_LINE} bytes")));
        }
        Ok(Some(line.trim()))
    }

    /// At the line that came last.
    pub(super) fn error(&self, message: impl Into<String>) -> ReadError {
        ReadError::at(LineColumn::line(self.number.max(1)), message)
    }

    /// The entries of a list, up to its `END`.
    pub(super) fn list(&mut self, title: &str) -> Result<Vec<(u32, &'t str)>, ReadError> {
        let begin = self.number;
        let mut entries = Vec::new();
        loop {
            match self.next()? {
                Some("END") => return Ok(entries),
                Some("") => {}
                Some("PROGRAM") | None => {
                    let message = format!("the `{title}` that begins on line {begin} has no `END`");
                    return Err(self.error(message));
                }
                Some(entry) => entries.push((self.number, entry)),
            }
        }
    }
}

/// A rung whose `RUNG` came last.
fn rung(lines: &mut Lines<'_>) -> Result<Rung, ReadError> {
    let begin = lines.number;
    // The innermost is last; the first is the rung itself.
    let mut open: Vec<(Wrap, Vec<Node>)> = vec![(Node::Series, Vec::new())];
    let mut count = 0;
    loop {
        let Some(line) = lines.next()? else {
            let message =
                format!("the file ends inside the rung that begins on line {begin}; an `END` is missing");
            return Err(lines.error(message));
        };
        let node = match line.split_whitespace().next() {
            None => continue,
            Some(_) if line.starts_with(';') => continue,
            Some(word @ ("SERIES" | "PARALLEL")) if line == word => {
                if open.len() >= DEEPEST {
                    return Err(lines.error(format!("branches are nested deeper than {DEEPEST}")));
                }
                let wrap: Wrap = if word == "SERIES" {
                    Node::Series
                } else {
                    Node::Parallel
                };
                open.push((wrap, Vec::new()));
                continue;
            }
            Some("END") if line == "END" => match open.pop() {
                Some((wrap, parts)) if !open.is_empty() => wrap(parts),
                inner => {
                    let parts = inner.map(|(_, parts)| parts).unwrap_or_default();
                    return Ok(Rung { line: begin, parts });
                }
            },
            Some("RUNG") => {
                let message = format!("a rung begins inside the one of line {begin}; an `END` is missing");
                return Err(lines.error(message));
            }
            Some(_) => {
                count += 1;
                if count > MOST_IN_RUNG {
                    let message =
                        format!("the rung has more than {MOST_IN_RUNG} elements: make several rungs of it");
                    return Err(lines.error(message));
                }
                Node::Leaf(leaf(line, lines)?)
            }
        };
        if let Some((_, parts)) = open.last_mut() {
            if parts.len() == MOST_PARTS {
                let message = format!(
                    "there are more than {MOST_PARTS} parts next to each other: make several rungs of it"
                );
                return Err(lines.error(message));
            }
            parts.push(node);
        }
    }
}

type Wrap = fn(Vec<Node>) -> Node;

fn leaf(line: &str, lines: &Lines<'_>) -> Result<Leaf, ReadError> {
    let text = element::normal_blanks(line);
    element::check(&text).map_err(|message| lines.error(message))?;
    Ok(Leaf {
        line: lines.number,
        text,
    })
}

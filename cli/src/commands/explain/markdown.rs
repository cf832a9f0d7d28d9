//! The reference's Markdown, as a terminal shows it.

use super::look::Look;
use super::wrap::{width, wrap};
use std::io::{self, Write};

/// Writes it: headings without their `#`, fenced blocks set in and without their fences, links as their text,
/// paragraphs and lists filled to the width of the terminal.
pub(super) fn print(markdown: &str, look: &Look, out: &mut impl Write) -> io::Result<()> {
    let Look {
        heading,
        code,
        columns,
    } = look;
    for part in parts(markdown) {
        match part {
            Piece::Blank => writeln!(out)?,
            Piece::Heading(title) => writeln!(out, "{heading}{title}{heading:#}")?,
            Piece::Text { marker, text } => {
                let rest = " ".repeat(width(&marker));
                out.write_all(wrap(&text, &marker, &rest, *columns).as_bytes())?;
            }
            Piece::Code("") => writeln!(out)?,
            Piece::Code(line) => writeln!(out, "    {code}{line}{code:#}")?,
            Piece::Table(rows) => print_table(&rows, *columns, out)?,
        }
    }
    Ok(())
}

/// A list of names and what they mean, of which the second column is filled.
pub(super) fn print_table(rows: &[(String, String)], columns: usize, out: &mut impl Write) -> io::Result<()> {
    // One long name does not push all the others' texts to the edge.
    let most = columns / 2;
    let names = rows
        .iter()
        .map(|(name, _)| width(name))
        .filter(|name| *name <= most);
    let edge = 2 + names.max().unwrap_or(0) + 2;
    let rest = " ".repeat(edge);
    for (name, text) in rows {
        let blanks = edge.saturating_sub(2 + width(name)).max(2);
        let first = format!("  {name}{}", " ".repeat(blanks));
        out.write_all(wrap(text, &first, &rest, columns).as_bytes())?;
    }
    Ok(())
}

/// A piece of a page.
enum Piece<'m> {
    Blank,
    Heading(String),
    /// A paragraph, or a point of a list with its marker.
    Text {
        marker: String,
        text: String,
    },
    /// A line of a fenced block.
    Code(&'m str),
    /// The rows of a table without its head: what is first, and what is after it.
    Table(Vec<(String, String)>),
}

fn parts(markdown: &str) -> Vec<Piece<'_>> {
    let mut parts = Vec::new();
    let mut fenced = false;
    // Whether the line before was text that this one may go on with.
    let mut goes_on = false;
    for line in markdown.lines() {
        let text_before = std::mem::replace(&mut goes_on, false);
        if line.starts_with("```") {
            fenced = !fenced;
        } else if fenced {
            parts.push(Piece::Code(line));
        } else if line.trim().is_empty() {
            parts.push(Piece::Blank);
        } else if let Some(title) = heading_of(line) {
            parts.push(Piece::Heading(title.replace('`', "")));
        } else if line.starts_with('|') {
            add_row(line, &mut parts);
        } else {
            goes_on = true;
            let (marker, text) = split_marker(line);
            match parts.last_mut() {
                Some(Piece::Text { text: before, .. }) if text_before && marker.is_empty() => {
                    before.push(' ');
                    before.push_str(text);
                }
                _ => parts.push(Piece::Text {
                    marker: marker.to_owned(),
                    text: text.to_owned(),
                }),
            }
        }
    }
    for part in &mut parts {
        if let Piece::Text { text, .. } = part {
            *text = plain(text);
        }
    }
    parts
}

/// The head of a table says nothing that its rows do not, and the line below it is not for people.
fn add_row(line: &str, parts: &mut Vec<Piece>) {
    let Some(Piece::Table(rows)) = parts.last_mut() else {
        parts.push(Piece::Table(Vec::new()));
        return;
    };
    // A bar that belongs to the text is written `\|`.
    let line = line.replace("\\|", "\0");
    let cells: Vec<String> = line
        .trim_matches(['|', ' '])
        .split('|')
        .map(|cell| plain(cell.trim()).replace('\0', "|"))
        .collect();
    if cells.iter().all(|cell| cell.chars().all(|c| c == '-')) {
        return;
    }
    let (first, others) = cells
        .split_first()
        .map_or(("", &[][..]), |(first, rest)| (first, rest));
    rows.push((first.to_owned(), others.join("  ")));
}

fn heading_of(line: &str) -> Option<&str> {
    let title = line.trim_start_matches('#');
    (title.len() < line.len())
        .then(|| title.strip_prefix(' '))
        .flatten()
}

/// `- ` or `1. ` before the text, with the blanks before it.
fn split_marker(line: &str) -> (&str, &str) {
    let text = line.trim_start();
    let indent = line.len() - text.len();
    let digits = text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let marker = match text {
        _ if text.starts_with("- ") => 2,
        _ if digits > 0 && text[digits..].starts_with(". ") => digits + 2,
        _ => return ("", text),
    };
    line.split_at(indent + marker)
}

/// Text without what Markdown says about its look.
pub(super) fn plain(text: &str) -> String {
    without_links(&text.replace("**", ""))
}

/// `[wrong-shape](wrong-shape.md)` becomes `wrong-shape`. Only pages are linked to; what else looks like a link
/// is a block with its operands.
fn without_links(line: &str) -> String {
    let mut shown = String::with_capacity(line.len());
    let mut rest = line;
    while let Some((before, text, after)) = next_link(rest) {
        shown.push_str(before);
        shown.push_str(text);
        rest = after;
    }
    shown + rest
}

fn next_link(line: &str) -> Option<(&str, &str, &str)> {
    let target = line
        .match_indices("](")
        .find(|(at, _)| {
            line[at + 2..]
                .split(')')
                .next()
                .is_some_and(|to| to.contains(".md"))
        })?
        .0;
    let start = line[..target].rfind('[')?;
    let (_, after) = line[target..].split_once(')')?;
    Some((&line[..start], &line[start + 1..target], after))
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(page: &str, columns: usize, expected: Expect) {
        let look = Look {
            heading: anstyle::Style::new(),
            code: anstyle::Style::new(),
            columns,
        };
        let mut out = Vec::new();
        print(page, &look, &mut out).unwrap();
        expected.assert_eq(&String::from_utf8(out).unwrap());
    }

    #[test]
    fn what_a_terminal_shows() {
        check(
            "# `a-rule`\n\nSee [`b`](b.md) and [c](../c.md#d); **not** `[ ]( x )`.\n\n## Wrong\n\n```clad wrong\n+--+\n\n```\n",
            100,
            expect![[r#"
                a-rule

                See `b` and c; not `[ ]( x )`.

                Wrong

                    +--+

            "#]],
        );
    }

    #[test]
    fn paragraphs_and_lists_are_filled() {
        check(
            "Counts one up each\ntime EN rises.\n\n- CV goes on counting past PV,\n  up to the largest DINT.\n- PV is read\n\n10. `+--[ ]( a )--( )( y )--+` is drawn\n    again\n",
            24,
            expect![[r#"
                Counts one up each time
                EN rises.

                - CV goes on counting
                  past PV, up to the
                  largest DINT.
                - PV is read

                10. `+--[ ]( a )--( )( y )--+`
                    is drawn again
            "#]],
        );
    }

    #[test]
    fn tables() {
        check(
            "So:\n\n| operators | meaning |\n| --- | --- |\n| `OR`, then `AND` | logical on BOOL, bitwise otherwise |\n| `a \\| b` | [sum](x.md) |\n",
            40,
            expect![[r#"
                So:

                  `OR`, then `AND`  logical on BOOL,
                                    bitwise otherwise
                  `a | b`           sum
            "#]],
        );
    }
}

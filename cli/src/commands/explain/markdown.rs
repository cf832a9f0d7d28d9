//! The reference's Markdown, as a terminal shows it.

use super::look::Look;
use std::io::{self, Write};

/// Writes it: headings without their `#`, fenced blocks set in and without their fences, links as their text.
pub(super) fn print(markdown: &str, look: &Look, out: &mut impl Write) -> io::Result<()> {
    let Look { heading, code } = look;
    let mut fenced = false;
    for line in markdown.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        } else if line.is_empty() {
            writeln!(out)?;
        } else if fenced {
            writeln!(out, "    {code}{line}{code:#}")?;
        } else if let Some(title) = heading_of(line) {
            writeln!(out, "{heading}{}{heading:#}", title.replace('`', ""))?;
        } else {
            writeln!(out, "{}", without_links(&line.replace("**", "")))?;
        }
    }
    Ok(())
}

fn heading_of(line: &str) -> Option<&str> {
    let title = line.trim_start_matches('#');
    (title.len() < line.len())
        .then(|| title.strip_prefix(' '))
        .flatten()
}

/// `[wrong-shape](wrong-shape.md)` becomes `wrong-shape`. Only pages are linked to; what else looks like a link
/// is a block with its operands.
fn without_links(line: &str) -> String {
    let mut shown = String::with_capacity(line.len());
    let mut rest = line;
    while let Some((before, text, behind)) = next_link(rest) {
        shown.push_str(before);
        shown.push_str(text);
        rest = behind;
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
    let (_, behind) = line[target..].split_once(')')?;
    Some((&line[..start], &line[start + 1..target], behind))
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect;

    #[test]
    fn what_a_terminal_shows() {
        let page = "# `a-rule`\n\nSee [`b`](b.md) and [c](../c.md#d); **not** `[ ]( x )`.\n\n## Wrong\n\n```clad wrong\n+--+\n\n```\n";
        let look = Look {
            heading: anstyle::Style::new(),
            code: anstyle::Style::new(),
        };
        let mut out = Vec::new();
        print(page, &look, &mut out).unwrap();
        expect![[r#"
            a-rule

            See `b` and c; not `[ ]( x )`.

            Wrong

                +--+

        "#]]
        .assert_eq(&String::from_utf8(out).unwrap());
    }
}

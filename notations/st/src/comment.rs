//! What the ladder text says in comments.

use ladder_notation::comments;
use ladder_syntax::{Parse, TextRange, TextSize};

/// Text inside `(* *)`.
pub(crate) fn comment(text: &str) -> String {
    let text: String = text
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    format!("(* {} *)", text.trim().replace("(*", "( *").replace("*)", "* )"))
}

/// The comments of a network: those above it, and those on its lines. A blank line comes first where the ladder text has one.
pub(crate) fn of_network(parse: &Parse, text: &str, range: TextRange) -> Vec<String> {
    let first = line_at(parse, range.start());
    let mut above = Vec::new();
    let mut is_apart = false;
    for line in (0..first).rev() {
        let all = comments::on_line(parse, line);
        let end = parse.line_start(line + 1);
        let own = &text[usize::from(parse.line_start(line))..usize::from(end)];
        let own = own.trim_start_matches('\u{feff}').trim();
        if own.starts_with('#') && own.ends_with('#') {
            above.push(all);
        } else if own.is_empty() || own == "|" || own.starts_with("| ") {
            is_apart = true;
            if !own.trim_matches(['|', ' ', '\t']).is_empty() {
                break;
            }
        } else if !own.trim_matches(['|', ' ', '\t']).is_empty() {
            break;
        }
    }
    above.reverse();
    let mut said: Vec<String> = above.concat();
    let mut line = first;
    while line < parse.lines().len() && parse.line_start(line) < range.end() {
        said.extend(comments::on_line(parse, line));
        line += 1;
    }
    let lines = said
        .iter()
        .flat_map(|one| comments::said(one).map(str::to_owned).collect::<Vec<_>>());
    let mut lines: Vec<String> = lines.map(|line| comment(&line)).collect();
    if is_apart || !lines.is_empty() {
        lines.insert(0, String::new());
    }
    lines
}

/// The comment after a declaration, on its line.
pub(crate) fn of_declaration(text: &str, range: TextRange) -> Option<String> {
    let rest = text.get(usize::from(range.end())..)?;
    let line = rest.lines().next()?;
    let (_, after) = line.rsplit_once(';')?;
    let said = after.trim().strip_prefix('#')?.strip_suffix('#')?.trim();
    (!said.is_empty() && !said.contains('#') && !said.starts_with("ladder:")).then(|| said.to_owned())
}

/// The line that holds a place.
fn line_at(parse: &Parse, at: TextSize) -> usize {
    let (mut low, mut high) = (0, parse.lines().len());
    while low + 1 < high {
        let middle = low.midpoint(high);
        if parse.line_start(middle) <= at {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

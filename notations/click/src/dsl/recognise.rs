//! Whether a file is a Click program in Python: `def main():` or `@sub` with a rung of the DSL.

use super::super::bank::Bank;
use super::arguments::is_instruction;

/// What lies further down in a file is not checked, in bytes.
const LOOKED_AT: usize = 64 * 1024;

/// See above. Most Python files are something else, so nothing is parsed.
pub(in super::super) fn recognises(bytes: &[u8]) -> bool {
    let beginning = &bytes[..bytes.len().min(LOOKED_AT)];
    let text = String::from_utf8_lossy(beginning);
    let lines: Vec<&str> = text.lines().map(code).filter(|line| !line.is_empty()).collect();
    let Some(start) = lines
        .iter()
        .position(|line| matches!(*line, "def main():" | "@sub"))
    else {
        return false;
    };
    // Of other Python a rung may look like one of Click, but hardly its actions; so one of them may be wrong.
    let rungs = rungs(&lines[start..]);
    let first = rungs.first();
    let is_rung = |(condition, action): &(&str, &str)| is_condition(condition) && is_action(action);
    first.is_some_and(is_rung) || rungs.iter().any(|(condition, action)| acts(condition, action))
}

/// The condition of each `if`, or of the innermost of several, and the first line below it.
fn rungs<'t>(lines: &[&'t str]) -> Vec<(&'t str, &'t str)> {
    let is_if = |line: &str| line.starts_with("if ") && line.ends_with(':');
    let pairs = lines.windows(2).filter(|pair| is_if(pair[0]) && !is_if(pair[1]));
    pairs.map(|pair| (pair[0], pair[1])).collect()
}

/// Whether a rung acts on an address of Click, or ends.
fn acts(condition: &str, action: &str) -> bool {
    let name = word(action);
    let Some(inside) = action[name.len()..].strip_prefix('(') else {
        return false;
    };
    match name {
        "end" | "next_loop" => condition == "if True:" && inside.starts_with(')'),
        // Another word is one that was mistyped, where its rung is one of Click.
        name if is_instruction(name) => begins_with_address(inside),
        name => name != "print" && is_condition(condition) && begins_with_address(inside),
    }
}

/// `y[1]`, `c.Run`
fn begins_with_address(text: &str) -> bool {
    let bank = word(text);
    Bank::of_dsl(bank).is_some() && text[bank.len()..].starts_with(['[', '.'])
}

/// A line without its comment.
fn code(line: &str) -> &str {
    let line = line.trim_start_matches('\u{feff}');
    line.split('#').next().unwrap_or(line).trim()
}

/// The word that a text begins with.
fn word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    &text[..end.unwrap_or(text.len())]
}

fn is_condition(line: &str) -> bool {
    let condition = line.trim_start_matches("if ").trim_start();
    let first = word(condition);
    let rest = &condition[first.len()..];
    match first {
        "True" => rest == ":",
        "all" | "any" | "nc" | "re" | "fe" => rest.starts_with('('),
        _ => begins_with_address(condition),
    }
}

fn is_action(line: &str) -> bool {
    let first = word(line);
    match first {
        "pass" | "return" => true,
        "for" => line.starts_with("for _ in range("),
        first => is_instruction(first) && line[first.len()..].starts_with('('),
    }
}

//! Whether a file is a Click program in Python: `def main():` whose first rung is one of the DSL.

use super::super::bank::Bank;
use super::arguments::is_instruction;

/// What lies further down in a file is not checked, in bytes.
const LOOKED_AT: usize = 64 * 1024;

/// See above. Most Python files are something else, so nothing is parsed.
pub(in super::super) fn recognises(bytes: &[u8]) -> bool {
    let beginning = &bytes[..bytes.len().min(LOOKED_AT)];
    let text = String::from_utf8_lossy(beginning);
    let mut lines = text.lines().skip_while(|line| code(line) != "def main():");
    if lines.next().is_none() {
        return false;
    }
    let mut rest = lines.map(code).filter(|line| !line.is_empty());
    rest.find(|line| line.starts_with("if ") && line.ends_with(':') && is_condition(line))
        .is_some_and(|_| rest.next().is_some_and(is_action))
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
        first => Bank::of_dsl(first).is_some() && rest.starts_with(['[', '.']),
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

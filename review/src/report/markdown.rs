//! A comparison for a pull request.

use super::{Compared, notes, of_whole, shown, summary, text};
use crate::words::{heading, reason};

/// The report of some files.
pub fn report(files: &[Compared<'_>]) -> String {
    let mut out = String::new();
    for file in files.iter().filter(|file| file.is_different()) {
        let renamed = match (file.old, file.new) {
            (Some(old), Some(new)) if path(old) != path(new) => format!(" (was {})", code(old)),
            (None, _) => " (new file)".to_owned(),
            (_, None) => " (gone)".to_owned(),
            _ => String::new(),
        };
        out.push_str(&format!(
            "### {}{renamed}\n\n{}\n",
            code(file.name()),
            summary(&file.comparison)
        ));
        for note in notes(&file.comparison) {
            out.push_str(&format!("\n{}\n", escaped(&note)));
        }
        for change in shown(&file.comparison) {
            out.push_str(&format!("\n{}\n", escaped(&heading(&file.comparison, change))));
            if let Some(reason) = reason(change) {
                out.push_str(&format!("\n{}\n", escaped(&reason)));
            }
            let mut lines = Vec::new();
            text::drawn(&file.comparison, change, &mut lines);
            if lines.is_empty() {
                continue;
            }
            let drawn: Vec<&str> = lines.iter().map(|line| line.text.as_str()).collect();
            out.push_str(&format!("\n{}", fenced(&drawn.join("\n"))));
        }
        if let Some((told, rows)) = of_whole(&file.comparison) {
            out.push_str(&format!("\n{}\n", escaped(&told)));
            if !rows.is_empty() {
                out.push_str(&format!("\n{}", fenced(&rows.join("\n"))));
            }
        }
        out.push('\n');
    }
    if out.is_empty() {
        out.push_str("No network, declaration or comment has changed.\n");
    }
    out
}

/// A name without the revision that it is of.
fn path(name: &str) -> &str {
    name.rsplit_once(':')
        .map_or(name, |(_, path)| path)
        .trim_start_matches("./")
}

/// The report of a file whose lines have their signs already.
pub fn lines(name: &str, lines: &[String]) -> String {
    format!("### {}\n\n{}\n", code(name), fenced(&lines.join("\n")))
}

/// A block of lines that nothing in them ends.
fn fenced(lines: &str) -> String {
    let fence = "`".repeat(longest_run(lines).max(2) + 1);
    format!("{fence}diff\n{lines}\n{fence}\n")
}

/// The longest run of backticks.
fn longest_run(text: &str) -> usize {
    let runs = text.split(|c| c != '`').map(str::len);
    runs.max().unwrap_or(0)
}

/// A text as it is, in the letters of code.
fn code(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    let ticks = "`".repeat(longest_run(&text) + 1);
    let blank = if text.starts_with('`') || text.ends_with('`') {
        " "
    } else {
        ""
    };
    format!("{ticks}{blank}{text}{blank}{ticks}")
}

/// A text in which nothing is markup.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars().filter(|c| !c.is_control()) {
        if letter.is_ascii_punctuation() && !matches!(letter, ',' | ':' | '.' | '(' | ')') {
            out.push('\\');
        }
        out.push(letter);
    }
    out
}

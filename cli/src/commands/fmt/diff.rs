//! `--diff`: what would change, as a unified diff.

use crate::terminal::stdout_has_colours;
use anstyle::{AnsiColor, Style};
use similar::{ChangeTag, TextDiff};
use std::io::{self, Write};
use std::path::Path;

const OLD: Style = AnsiColor::Red.on_default();
const NEW: Style = AnsiColor::Green.on_default();
const PLACE: Style = AnsiColor::Cyan.on_default();

/// Prints it, so that `patch` can read it.
pub(super) fn print(file: &Path, old: &str, new: &str, out: &mut impl Write) -> io::Result<()> {
    let (removed, added, place) = if stdout_has_colours() {
        (OLD, NEW, PLACE)
    } else {
        (Style::new(), Style::new(), Style::new())
    };
    let diff = TextDiff::from_lines(old, new);
    writeln!(out, "--- {}", file.display())?;
    writeln!(out, "+++ {}", file.display())?;
    for hunk in diff.unified_diff().iter_hunks() {
        writeln!(out, "{place}{}{place:#}", hunk.header())?;
        for change in hunk.iter_changes() {
            let (sign, style) = match change.tag() {
                ChangeTag::Delete => ('-', removed),
                ChangeTag::Insert => ('+', added),
                ChangeTag::Equal => (' ', Style::new()),
            };
            let line = change.value();
            let content = line.trim_end_matches(['\r', '\n']);
            write!(out, "{style}{sign}{content}{style:#}{}", &line[content.len()..])?;
            if change.missing_newline() {
                writeln!(out, "\n\\ No newline at end of file")?;
            }
        }
    }
    Ok(())
}

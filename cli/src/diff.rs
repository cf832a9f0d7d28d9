//! `--diff`: what would change, as a unified diff.

use crate::terminal::stdout_has_colours;
use anstyle::{AnsiColor, Style};
use ladder_workspace::shown;
use similar::{ChangeTag, TextDiff};
use std::io::{self, Write};
use std::path::Path;

const OLD: Style = AnsiColor::Red.on_default();
const NEW: Style = AnsiColor::Green.on_default();
const PLACE: Style = AnsiColor::Cyan.on_default();

/// Prints it, so that `patch` can read it; only what a terminal would interpret is escaped.
pub(crate) fn print(file: &Path, old: &str, new: &str, out: &mut impl Write) -> io::Result<()> {
    let (removed, added, place) = if stdout_has_colours() {
        (OLD, NEW, PLACE)
    } else {
        (Style::new(), Style::new(), Style::new())
    };
    let diff = TextDiff::from_lines(old, new);
    let file = shown::path(file);
    writeln!(out, "--- {file}\n+++ {file}")?;
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
            // A lone CR is the end of a line here; on a terminal it is the beginning of the same one.
            let end = match &line[content.len()..] {
                "\r" => "\\r\n",
                end => end,
            };
            let content = shown::text(content);
            write!(out, "{style}{sign}{content}{style:#}{end}")?;
            if change.missing_newline() {
                writeln!(out, "\n\\ No newline at end of file")?;
            }
        }
    }
    Ok(())
}

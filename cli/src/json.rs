//! JSON on its way to a terminal or a log.
//!
//! JSON itself writes out the control characters below 32 only. The others that a terminal interprets are in strings, too, and
//! only there: written as `\\u009b` they mean the same to any reader.

use ladder_workspace::shown;
use serde::Serialize;
use std::io::{self, Write};

/// Writes a value.
pub(crate) fn to_writer(out: &mut dyn Write, value: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(Safe(out), value).map_err(io::Error::from)
}

/// Writes a value, on lines of its own.
pub(crate) fn to_writer_pretty(out: &mut dyn Write, value: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer_pretty(Safe(out), value).map_err(io::Error::from)
}

/// The same for JSON that is written already.
pub(crate) fn safe(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for c in json.chars() {
        match c {
            // Between strings it is white space.
            '\n' => out.push(c),
            c if shown::is_obeyed(c) => out.push_str(&format!("\\u{:04x}", u32::from(c))),
            c => out.push(c),
        }
    }
    out
}

struct Safe<'w>(&'w mut dyn Write);

impl Write for Safe<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // Strings come in pieces that end between characters.
        match std::str::from_utf8(bytes) {
            Ok(text) if text.contains(shown::is_obeyed) => self.0.write_all(safe(text).as_bytes())?,
            _ => self.0.write_all(bytes)?,
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_a_terminal_obeys_and_the_same_value() {
        let text = "a\u{1b}[1m\n\u{7f}\u{9b}2J\u{202e}\u{2028}ö😀\\\"";
        let mut out = Vec::new();
        to_writer_pretty(&mut out, &[text]).unwrap();
        let json = String::from_utf8(out).unwrap();
        assert!(!json.contains(|c| shown::is_obeyed(c) && c != '\n'), "{json}");
        assert_eq!(serde_json::from_str::<Vec<String>>(&json).unwrap(), [text]);
    }
}

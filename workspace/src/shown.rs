//! Text that others wrote, on its way to a terminal or a log: of programs, of scenarios, the names of files.
//!
//! A terminal takes some characters as commands instead of showing them: it moves, erases, renames its window, or turns the order of
//! what follows. So these are written as what they are: `\u{1b}`. Everything that a program, a name or a message of
//! another holds goes through here before it is shown; what the tools themselves colour does not.

use std::borrow::Cow;
use std::path::Path;

/// A text on one line: its line ends and tabs, too, are written out.
pub fn line(text: &str) -> Cow<'_, str> {
    escaped(text, |c, _| is_obeyed(c))
}

/// A text that may have several lines: their ends (LF, CRLF) and tabs stay what they are.
pub fn text(text: &str) -> Cow<'_, str> {
    escaped(text, is_obeyed_in_text)
}

/// Whether a character of a text of several lines is such a command; `next` is the one after it.
pub fn is_obeyed_in_text(c: char, next: Option<char>) -> bool {
    match c {
        '\n' | '\t' => false,
        '\r' => next != Some('\n'),
        c => is_obeyed(c),
    }
}

/// The name of a file, on one line.
pub fn path(path: &Path) -> String {
    line(&path.display().to_string()).into_owned()
}

/// Whether a terminal does something else than to show it: control characters, line ends of any kind, and those that
/// turn the direction of writing.
pub fn is_obeyed(c: char) -> bool {
    c.is_control()
        || matches!(
            c,
            '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{206f}' | '\u{fff9}'..='\u{fffb}'
        )
}

/// What stands for such a character.
pub fn escape(c: char) -> String {
    match c {
        '\n' => "\\n".to_owned(),
        '\r' => "\\r".to_owned(),
        '\t' => "\\t".to_owned(),
        c => format!("\\u{{{:x}}}", u32::from(c)),
    }
}

fn escaped(text: &str, wanted: impl Fn(char, Option<char>) -> bool) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    let mut rest = text.chars();
    while let Some(c) = rest.next() {
        if wanted(c, rest.clone().next()) {
            shown.push_str(&escape(c));
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

/// A path as a person in the current folder names it.
pub(crate) fn from_here(path: &Path) -> &Path {
    let here = std::env::current_dir().ok();
    here.and_then(|here| path.strip_prefix(here).ok()).unwrap_or(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_obeys_is_written_out() {
        assert_eq!(
            line("\u{1b}[2Ja\r\n\tb\u{7f}\u{9b}1m"),
            "\\u{1b}[2Ja\\r\\n\\tb\\u{7f}\\u{9b}1m"
        );
        assert_eq!(
            text("a\n\tb\r\u{2028}\u{202e}c\u{2066}"),
            "a\n\tb\\r\\u{2028}\\u{202e}c\\u{2066}"
        );
        assert_eq!(path(Path::new("a\nb.clad")), "a\\nb.clad");
    }

    #[test]
    fn line_ends_of_a_text() {
        assert_eq!(text("a\r\n\tb\n\rc\r"), "a\r\n\tb\n\\rc\\r");
    }

    #[test]
    fn what_is_only_shown_stays() {
        for shown in ["+--[ ]( Öl_温度 )--\\", "\u{feff}a \u{a0}é 😀", ""] {
            assert!(matches!(line(shown), Cow::Borrowed(it) if it == shown));
        }
    }
}

//! Whether a text is in the first draft of the language (2019), which had `//` comments, headers such as
//! `IN = { DI start }`, and one `<..>` for each operand. Its files end in `.clad` too.

use ladder_instructions::{Shape, lookup};
use ladder_syntax::{LineKind, Parse, TextRange, TextSize};

/// This many lines are checked.
const LINES: usize = 200;

/// Whether a text is in the draft: it has a header of the draft, or draws a contact with `[ ]<tag>`.
pub fn is_cplc_draft(text: &str) -> bool {
    text.lines()
        .take(LINES)
        .any(|line| is_line(line.trim_start_matches(['\u{feff}', ' ', '\t'])))
}

/// The line in which a file of ladder text turns out to begin in the draft: its first line that is not a comment, if that is
/// a header of the draft, or draws a block of the draft. A slip in a program of our own looks alike only where it is in the
/// first line. So a file is in the draft if it has errors and such a line: one finding says so then.
pub(crate) fn beginning(parse: &Parse) -> Option<TextRange> {
    let mut in_comment = false;
    for (index, parsed) in parse.lines().iter().enumerate().take(LINES) {
        let text = parsed.text();
        let line = text.trim_start_matches('\u{feff}').trim();
        if in_comment || line.starts_with("/*") {
            in_comment = !line.ends_with("*/");
        } else if line.starts_with("//") {
            // Two connectors that touch may also be drawing.
            if parsed.kind == LineKind::Rung && parsed.errors.is_empty() {
                return None;
            }
        } else if !line.is_empty() && line != "|" {
            let blanks = text.len() - text.trim_start_matches(['\u{feff}', ' ', '\t']).len();
            let start = parse.line_start(index) + TextSize::new(blanks as u32);
            let line = text[blanks..].trim_end();
            return is_line(line).then(|| TextRange::at(start, TextSize::of(line)));
        }
    }
    None
}

/// Whether a line is one of the draft and none of ladder text.
fn is_line(line: &str) -> bool {
    is_header(line) || (line.starts_with(['+', '|', '\\', '/']) && has_draft_block(line))
}

/// `IN = {`
fn is_header(line: &str) -> bool {
    let word = line.len() - line.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
    let (word, after) = line.split_at(word);
    ["IN", "OUT", "VAR"]
        .iter()
        .any(|name| name.eq_ignore_ascii_case(word))
        && after
            .trim_start()
            .strip_prefix('=')
            .is_some_and(|after| after.trim_start().starts_with('{'))
}

/// `[ ]<a>`, `()<a>`: in ladder text a function block `<..>` is never followed by nothing but wire, and its name is one
/// of the table's.
fn has_draft_block(line: &str) -> bool {
    let mut before = ' ';
    let mut in_comment = false;
    for (at, c) in line.char_indices() {
        match c {
            '#' => in_comment = !in_comment,
            '<' if !in_comment && matches!(before, ']' | ')') && !is_function_block(&line[at + 1..]) => {
                return true;
            }
            _ => {}
        }
        before = c;
    }
    false
}

/// Whether what is after a `<` begins a block of ladder text, which may touch the one before it.
fn is_function_block(after: &str) -> bool {
    let word = after.split('>').next().unwrap_or_default().trim();
    word.starts_with('$') || lookup(Shape::Function, word).next().is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_draft_and_ladder_text() {
        for text in [
            "// a motor\nIN = {DI start}\n",
            "\u{feff}in={DI start}",
            "+---[]<start>---()<run>---+",
        ] {
            assert!(is_cplc_draft(text), "{text}");
        }
        for text in [
            "",
            "VAR_INPUT a : BOOL; END_VAR",
            "+--[ ]( a )--<JMP>( there )--+",
            "+--[ ]( a )--( )( b )--+  # was: [ ]<a> #",
            "# IN = { #",
            "+--[OSR]<JMP>( l )--+",
        ] {
            assert!(!is_cplc_draft(text), "{text}");
        }
    }

    #[test]
    fn what_begins_in_the_draft() {
        for (text, expected) in [
            ("// a motor\n\n  IN = {DI start}\n", Some("IN = {DI start}")),
            ("/* a\nmotor */\nOUT={DO a}\n", Some("OUT={DO a}")),
            ("\u{feff}+---[]<a>---()<b>---+\n", Some("+---[]<a>---()<b>---+")),
            // A slip in ladder text.
            ("+--[ ]( a )--( )( b )--+\n+--[ ]<a>--( )( c )--+\n", None),
            ("VAR a : BOOL; END_VAR\n+--[ ]<a>--( )( c )--+\n", None),
            ("# a motor #\n+--[ ]<a>--( )( c )--+\n", None),
            ("// IN = {\n+--[ ]( a )--( )( b )--+\n", None),
            ("// | /--\\--+\n+--[ ]<a>--( )( c )--+\n", None),
            ("// a motor\rIN = {DI start}\r", Some("IN = {DI start}")),
            ("", None),
        ] {
            let found = beginning(&ladder_syntax::parse(text)).map(|range| &text[range]);
            assert_eq!(found, expected, "{text}");
        }
    }
}

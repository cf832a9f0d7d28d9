//! Whether a text is in the first draft of the language (2019), which had `//` comments, headers such as
//! `IN = { DI start }`, and one `<..>` for each operand. Its files end in `.clad` too.

/// So many lines are looked at.
const LINES: usize = 200;

/// Whether a text is in the draft: it has a header of the draft, or draws a contact with `[ ]<tag>`.
pub fn is_cplc_draft(text: &str) -> bool {
    text.lines().take(LINES).any(|line| {
        let line = line.trim_start_matches(['\u{feff}', ' ', '\t']);
        is_header(line) || (line.starts_with(['+', '|', '\\', '/']) && has_draft_block(line))
    })
}

/// `IN = {`
fn is_header(line: &str) -> bool {
    let word = line.len() - line.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
    let (word, behind) = line.split_at(word);
    ["IN", "OUT", "VAR"]
        .iter()
        .any(|name| name.eq_ignore_ascii_case(word))
        && behind
            .trim_start()
            .strip_prefix('=')
            .is_some_and(|behind| behind.trim_start().starts_with('{'))
}

/// `[ ]<a>`, `()<a>`: in ladder text a function block `<..>` is never followed by nothing but wire, and its name is one
/// of the table's.
fn has_draft_block(line: &str) -> bool {
    let mut before = ' ';
    let mut in_comment = false;
    for c in line.chars() {
        match c {
            '#' => in_comment = !in_comment,
            '<' if !in_comment && matches!(before, ']' | ')') => return true,
            _ => {}
        }
        before = c;
    }
    false
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
        ] {
            assert!(!is_cplc_draft(text), "{text}");
        }
    }
}

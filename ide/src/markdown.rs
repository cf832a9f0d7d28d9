//! What others wrote, in Markdown: the names of files, values, comments. None of it is Markdown itself: an image in it would be
//! loaded by the editor that shows it.

use std::borrow::Cow;

/// A text as it is, in the line of a sentence.
pub fn escaped(text: &str) -> Cow<'_, str> {
    let is_plain = |c: char| !c.is_ascii_punctuation() && !c.is_control();
    if text.chars().all(is_plain) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        // The dot of `motor.clad` and the like begin nothing, but for a web address.
        let begins_something = c.is_ascii_punctuation()
            && !matches!(c, '.' | ',' | '-' | '\'' | '"' | ';' | '%' | '/' | '(' | ')');
        if begins_something {
            out.push('\\');
        }
        out.push(if c.is_control() { ' ' } else { c });
    }
    Cow::Owned(out.replace("www.", "www\\."))
}

/// A text as code: whatever is in it, its end is not.
pub fn code(text: &str) -> String {
    let longest = text.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let ticks = "`".repeat(longest + 1);
    let pad = if longest > 0 { " " } else { "" };
    let line = text.replace(|c: char| c.is_control(), " ");
    format!("{ticks}{pad}{line}{pad}{ticks}")
}

/// Lines as a drawing, in a language.
pub fn drawing(language: &str, lines: &str) -> String {
    let longest = lines.split(|c| c != '`').map(str::len).max().unwrap_or(0);
    let fence = "`".repeat(longest.max(2) + 1);
    format!("{fence}{language}\n{lines}\n{fence}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_ends_what_is_around_it() {
        assert_eq!(code("5"), "`5`");
        assert_eq!(code("'`![x](http://y)``'"), "``` '`![x](http://y)``' ```");
        assert_eq!(code("a\n\nb"), "`a  b`");
        assert_eq!(drawing("text", "+--+"), "```text\n+--+\n```");
        assert_eq!(drawing("text", "```\n"), "````text\n```\n\n````");
    }

    #[test]
    fn a_sentence_holds_no_markdown() {
        assert_eq!(escaped("sub/motor-2.clad"), "sub/motor-2.clad");
        assert_eq!(
            escaped("![x](http://y) <b> *a* _b_"),
            "\\!\\[x\\](http\\://y) \\<b\\> \\*a\\* \\_b\\_"
        );
        assert_eq!(escaped("www.y.z\nb"), "www\\.y.z b");
    }
}

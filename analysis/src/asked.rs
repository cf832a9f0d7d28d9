//! What a directive, a comment for the tools, asks for: `# ladder: profile ldmicro #`. Code that looks for one kind of it
//! reads it here.

/// A word, and what is after it without the blanks around it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Asked<'c> {
    /// The word.
    pub word: &'c str,
    /// What is after it.
    pub after: &'c str,
}

/// What is before the word.
const PREFIX: &str = "ladder:";

/// Whether a text may hold a directive.
pub(crate) fn may_ask(text: &str) -> bool {
    text.contains(PREFIX)
}

/// Reads a comment with its signs. None: it is not a directive.
pub fn asked(comment: &str) -> Option<Asked<'_>> {
    let words = comment.trim_matches('#').trim().strip_prefix(PREFIX)?.trim();
    let end = words.find(|c: char| !is_word(c)).unwrap_or(words.len());
    let (word, after) = words.split_at(end);
    Some(Asked {
        word,
        after: after.trim(),
    })
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '-' || c == '_'
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_and_the_rest() {
        for (comment, expected) in [
            ("# ladder: profile iot #", Some(("profile", "iot"))),
            ("#ladder:cycle  5ms#", Some(("cycle", "5ms"))),
            (
                "# ladder: allow-file(a, b): why #",
                Some(("allow-file", "(a, b): why")),
            ),
            ("# ladder: #", Some(("", ""))),
            ("# the ladder: it leans #", None),
        ] {
            let found = asked(comment).map(|asked| (asked.word, asked.after));
            assert_eq!(found, expected, "{comment}");
        }
    }
}

//! Text in lines that are not wider than the terminal.

use ladder_format::display_width;

/// A code span of more columns than this is broken like any other text.
const LONGEST_SPAN: usize = 40;

/// The text in lines of at most this many columns, each with its line end. The first line begins with `first`, the others
/// with `rest`. Code between backticks stays together where it can; a word that is wider than a line is out.
pub(super) fn wrap(text: &str, first: &str, rest: &str, columns: usize) -> String {
    let mut wrapped = first.to_owned();
    let mut used = width(first);
    let mut fresh = true;
    for word in words(text) {
        let needed = width(word);
        if !fresh && used + 1 + needed > columns {
            wrapped.push('\n');
            wrapped.push_str(rest);
            used = width(rest);
            fresh = true;
        }
        if !fresh {
            wrapped.push(' ');
            used += 1;
        }
        wrapped.push_str(word);
        used += needed;
        fresh = false;
    }
    wrapped.push('\n');
    wrapped
}

/// How many columns a text takes.
pub(super) fn width(text: &str) -> usize {
    display_width(text) as usize
}

/// The parts between which a line may end.
fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = text.trim();
    while !rest.is_empty() {
        let (word, after) = rest.split_at(end_of_word(rest));
        words.push(word);
        rest = after.trim_start();
    }
    words
}

fn end_of_word(text: &str) -> usize {
    let mut from = 0;
    loop {
        let blank = text[from..].find(' ').map_or(text.len(), |at| from + at);
        let open = text[from..blank].matches('`').count() % 2 == 1;
        let Some(close) = text[blank..].find('`').filter(|_| open) else {
            return blank;
        };
        if close > LONGEST_SPAN {
            return blank;
        }
        // The span ends there; what follows without a blank belongs to it.
        from = blank + close + 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(text: &str, columns: usize, expected: Expect) {
        expected.assert_eq(&wrap(text, "- ", "  ", columns));
    }

    #[test]
    fn lines_are_filled() {
        check(
            "Counting goes past the preset PV, up to the limits of a DINT.",
            30,
            expect![[r#"
                - Counting goes past the
                  preset PV, up to the limits
                  of a DINT.
            "#]],
        );
    }

    #[test]
    fn code_stays_together() {
        check(
            "join them with `[ ]( stop )`, or `+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+` instead",
            24,
            expect![[r#"
                - join them with
                  `[ ]( stop )`, or
                  `+--\--[ ]( start
                  )--\--[/]( stop )--(
                  )( run )--+` instead
            "#]],
        );
    }

    #[test]
    fn wide_words_and_wide_characters() {
        check(
            "温度温度温度 a_name_that_is_wider_than_the_line x",
            16,
            expect![[r#"
                - 温度温度温度
                  a_name_that_is_wider_than_the_line
                  x
            "#]],
        );
        check("", 10, expect!["- \n"]);
    }
}

//! Breaking texts into lines.

use super::measure::columns;

/// A text in lines of at most this many columns. Words that are longer are broken.
pub(super) fn wrap(text: &str, width: u32) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    let mut line = String::new();
    let mut used = 0;
    for word in text.split(' ') {
        let wide = columns(word);
        if used > 0 && used + 1 + wide > width {
            lines.push(std::mem::take(&mut line));
            used = 0;
        }
        if used > 0 {
            line.push(' ');
            used += 1;
        }
        if wide <= width {
            line.push_str(word);
            used += wide;
            continue;
        }
        for letter in word.chars() {
            let wide = columns(letter.encode_utf8(&mut [0; 4]));
            if used + wide > width && used > 0 {
                lines.push(std::mem::take(&mut line));
                used = 0;
            }
            line.push(letter);
            used += wide;
        }
    }
    lines.push(line);
    lines
}

/// Lines of text as lines of at most this many columns. What does not fit on a line goes before the next one, as far as
/// that goes on with the same sentence.
pub(super) fn paragraph(lines: &[String], width: u32) -> Vec<String> {
    let mut out = Vec::new();
    let mut rest = String::new();
    for line in lines {
        let goes_on = line.starts_with(char::is_alphabetic);
        if !rest.is_empty() && !goes_on {
            out.push(std::mem::take(&mut rest));
        }
        if !rest.is_empty() {
            rest.push(' ');
        }
        rest.push_str(line);
        let mut wrapped = wrap(&rest, width);
        rest = match wrapped.len() {
            0 | 1 => String::new(),
            _ => wrapped.pop().unwrap_or_default(),
        };
        out.append(&mut wrapped);
    }
    if !rest.is_empty() {
        out.push(rest);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{paragraph, wrap};

    #[test]
    fn what_does_not_fit_goes_before_the_next_line() {
        let lines = ["one two three", "four", "", "- five six seven", "- eight"].map(str::to_owned);
        let wrapped = paragraph(&lines, 9);
        assert_eq!(
            wrapped,
            ["one two", "three", "four", "", "- five", "six seven", "- eight"]
        );
        assert_eq!(paragraph(&lines, 20), lines);
    }

    #[test]
    fn lines_are_no_longer_than_asked_for() {
        assert_eq!(wrap("", 10), [""]);
        assert_eq!(wrap("one two three", 7), ["one two", "three"]);
        assert_eq!(wrap("one  two", 20), ["one  two"]);
        assert_eq!(wrap("a_very_long_name x", 6), ["a_very", "_long_", "name x"]);
        assert_eq!(wrap("液位液位", 4), ["液位", "液位"]);
    }
}

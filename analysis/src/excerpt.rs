//! Pieces of the text for messages. Rules read them only when they have found something.

use ladder_format::display_width;
use ladder_syntax::{Parse, TextRange, TextSize};

/// The text of a range that lies on one logical line.
pub(crate) fn text(parse: &Parse, range: TextRange) -> String {
    let Some(line) = parse.line_at(range.start()) else {
        return String::new();
    };
    let start = parse.line_start(line);
    let node = parse.lines()[line].syntax();
    let within = TextRange::new(
        range.start() - start,
        (range.end() - start).min(node.text_range().end()),
    );
    node.text().slice(within).to_string()
}

/// At most `most` characters of a text, on one line.
pub(crate) fn shortened(text: &str, most: usize) -> String {
    let line = text.lines().next().unwrap_or("").trim_end();
    if line.chars().count() <= most {
        return line.to_owned();
    }
    let kept: String = line.chars().take(most.saturating_sub(3)).collect();
    format!("{}...", kept.trim_end())
}

/// A logical line without the white space around it and its line end.
pub(crate) fn trimmed_line(parse: &Parse, line: usize) -> TextRange {
    let text = parse.lines()[line].syntax().text().to_string();
    let before = text.len() - text.trim_start().len();
    TextRange::at(
        parse.line_start(line) + TextSize::new(before as u32),
        TextSize::of(text.trim()),
    )
}

/// The blanks directly behind an offset, if the line goes on behind them.
pub(crate) fn blanks_behind(parse: &Parse, offset: TextSize) -> TextRange {
    let Some(line) = parse.line_at(offset) else {
        return TextRange::empty(offset);
    };
    let rest = text(parse, TextRange::new(offset, parse.line_range(line).end()));
    let blanks = rest.len() - rest.trim_start_matches([' ', '\t']).len();
    let goes_on = !rest[blanks..].is_empty() && !rest[blanks..].starts_with(['\n', '\r', '|']);
    TextRange::at(offset, TextSize::new(if goes_on { blanks as u32 } else { 0 }))
}

/// The title of an instruction inside a sentence: "on-delay timer".
pub(crate) fn in_sentence(title: &str) -> String {
    let mut letters = title.chars();
    match (letters.next(), letters.next()) {
        (Some(first), Some(second)) if second.is_lowercase() || second == '-' => {
            first.to_lowercase().chain(title.chars().skip(1)).collect()
        }
        _ => title.to_owned(),
    }
}

/// The column of an offset in a logical line, in display width from 0.
pub(crate) fn column(parse: &Parse, line: usize, offset: TextSize) -> usize {
    let before = parse.lines()[line].syntax().text().slice(..offset).to_string();
    // A comment may have brought line ends onto the line.
    let last = before.rsplit(['\n', '\r']).next().unwrap_or("");
    display_width(last) as usize
}

/// `1st`, `2nd`, `3rd`, `4th`; `ordinal` counts from 0.
pub(crate) fn nth(ordinal: usize) -> String {
    let n = ordinal + 1;
    let suffix = match (n % 100, n % 10) {
        (11..=13, _) => "th",
        (_, 1) => "st",
        (_, 2) => "nd",
        (_, 3) => "rd",
        _ => "th",
    };
    format!("{n}{suffix}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinals() {
        let spelled: Vec<String> = [0, 1, 2, 3, 10, 11, 12, 20, 110, 121].map(nth).to_vec();
        assert_eq!(
            spelled,
            [
                "1st", "2nd", "3rd", "4th", "11th", "12th", "13th", "21st", "111th", "122nd"
            ]
        );
    }

    #[test]
    fn long_texts_are_cut() {
        assert_eq!(shortened("[TON", 20), "[TON");
        assert_eq!(shortened("( a_very_long_tag, another", 12), "( a_very_...");
        assert_eq!(shortened("one\ntwo", 20), "one");
    }
}

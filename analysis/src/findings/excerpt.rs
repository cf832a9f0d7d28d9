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

/// Texts of places that come in the order of the file: each line is put together once.
pub(crate) struct Excerpts<'p> {
    parse: &'p Parse,
    line: Option<(usize, String)>,
}

impl<'p> Excerpts<'p> {
    pub(crate) fn new(parse: &'p Parse) -> Excerpts<'p> {
        Excerpts { parse, line: None }
    }

    /// The text of a range that lies on one logical line, and what follows it there.
    pub(crate) fn text(&mut self, range: TextRange) -> (&str, &str) {
        let Some(line) = self.parse.line_at(range.start()) else {
            return ("", "");
        };
        if self.line.as_ref().is_none_or(|(known, _)| *known != line) {
            self.line = Some((line, self.parse.lines()[line].text().to_owned()));
        }
        let text = self.line.as_ref().map_or("", |(_, text)| text.as_str());
        let start = self.parse.line_start(line);
        let (from, to) = (
            usize::from(range.start() - start),
            usize::from(range.end() - start),
        );
        let to = to.min(text.len());
        (&text[from..to], &text[to..])
    }
}

/// At most `most` characters of a text, on one line.
pub(crate) fn shortened(text: &str, most: usize) -> String {
    let line = text.lines().next().unwrap_or("").trim_end();
    if line.chars().nth(most).is_none() {
        return line.to_owned();
    }
    let kept: String = line.chars().take(most.saturating_sub(3)).collect();
    format!("{}...", kept.trim_end())
}

/// A logical line without the white space around it and its line end.
pub(crate) fn trimmed_line(parse: &Parse, line: usize) -> TextRange {
    let text = parse.lines()[line].text().to_owned();
    let before = text.len() - text.trim_start().len();
    TextRange::at(
        parse.line_start(line) + TextSize::new(before as u32),
        TextSize::of(text.trim()),
    )
}

/// The length of the blanks that a rest of a line begins with, if the line goes on after them.
pub(crate) fn blanks_before_drawing(rest: &str) -> TextSize {
    let blanks = rest.len() - rest.trim_start_matches([' ', '\t']).len();
    let goes_on = !rest[blanks..].is_empty() && !rest[blanks..].starts_with(['\n', '\r', '|']);
    TextSize::new(if goes_on { blanks as u32 } else { 0 })
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

/// The columns of some offsets in a logical line, in display width from 0. The offsets ascend.
pub(crate) fn columns(parse: &Parse, line: usize, offsets: impl Iterator<Item = TextSize>) -> Vec<usize> {
    let text = parse.lines()[line].text().to_owned();
    let (mut at, mut column) = (0, 0);
    offsets
        .map(|offset| {
            let between = &text[at..usize::from(offset)];
            at = offset.into();
            // A comment may have brought line ends onto the line.
            match between.rsplit_once(['\n', '\r']) {
                Some((_, last)) => column = display_width(last) as usize,
                None => column += display_width(between) as usize,
            }
            column
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_cut() {
        assert_eq!(shortened("[TON", 20), "[TON");
        assert_eq!(shortened("( a_very_long_tag, another", 12), "( a_very_...");
        assert_eq!(shortened("one\ntwo", 20), "one");
    }
}

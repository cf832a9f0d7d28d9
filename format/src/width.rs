//! How wide text is on the screen (LANGUAGE §8 rule 9).

use unicode_width::UnicodeWidthStr;

/// The display width of a text in columns: East Asian Wide characters and emoji take two, ambiguous ones and a
/// tab one. For a text with line ends it means nothing.
pub fn display_width(text: &str) -> u32 {
    // Nearly all text is ASCII, where every byte takes one column.
    if text.is_ascii() {
        return text.len() as u32;
    }
    text.width() as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns() {
        for (text, columns) in [
            ("", 0),
            ("abc", 3),
            ("a\tb", 3),
            ("é", 1),
            ("e\u{301}", 1),
            ("温度", 4),
            ("한글", 4),
            ("🙂", 2),
            ("§±α", 3),
            ("é\tb", 3),
        ] {
            assert_eq!(display_width(text), columns, "{text:?}");
        }
    }
}

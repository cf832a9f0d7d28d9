//! Text inside of XML: pictures, and reports for other programs.

use std::fmt::{self, Display, Write};

/// A text as an element or an attribute in double quotes takes it. Characters that XML 1.0 cannot hold, and those that
/// would control a terminal, become U+FFFD; tabs and line ends stay.
#[derive(Debug, Clone, Copy)]
pub struct Escaped<'t>(pub &'t str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for c in self.0.chars() {
            match c {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\t' | '\n' | '\r' => f.write_char(c)?,
                '\u{fffe}' | '\u{ffff}' => f.write_char('\u{fffd}')?,
                c if c.is_control() => f.write_char('\u{fffd}')?,
                c => f.write_char(c)?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_means_something_to_xml_is_written_out() {
        let escaped = Escaped("a < b && \"c\" > d\t\u{1b}[0m\u{ffff}\n").to_string();
        assert_eq!(
            escaped,
            "a &lt; b &amp;&amp; &quot;c&quot; &gt; d\t\u{fffd}[0m\u{fffd}\n"
        );
    }
}

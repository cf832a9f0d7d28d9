//! Text inside of XML: pictures, and reports for other programs. And a bound for what is read of it.

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

/// No element of a project or a drawing has as many attributes as this.
pub const MOST_ATTRIBUTES: usize = 256;

/// Whether an element has more attributes than [`MOST_ATTRIBUTES`]. A reader of XML compares each with all others of its element, so
/// that a file of a few megabytes would keep it busy for hours.
pub fn is_crowded(xml: &str) -> bool {
    let mut rest = xml;
    while let Some((_, tag)) = rest.split_once('<') {
        let end = [("!--", "-->"), ("![CDATA[", "]]>"), ("?", "?>")];
        let passed = end.iter().find(|(begin, _)| tag.starts_with(begin));
        if let Some((_, end)) = passed {
            rest = tag.split_once(end).map_or("", |(_, rest)| rest);
            continue;
        }
        let (mut quote, mut attributes) = (None, 0);
        let end = tag.bytes().position(|byte| {
            match (quote, byte) {
                (None, b'"' | b'\'') => quote = Some(byte),
                (None, b'=') => attributes += 1,
                (Some(open), _) if open == byte => quote = None,
                _ => {}
            }
            (quote.is_none() && byte == b'>') || attributes > MOST_ATTRIBUTES
        });
        if attributes > MOST_ATTRIBUTES {
            return true;
        }
        rest = end.map_or("", |end| &tag[end + 1..]);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attributes_are_counted_in_each_element() {
        let many = |name: &str, count: usize| format!("<{name} {}>", "a='<=\">' ".repeat(count));
        assert!(!is_crowded(&many("a", MOST_ATTRIBUTES)));
        assert!(is_crowded(&many("a", MOST_ATTRIBUTES + 1)));
        let (one, other) = (many("a", 200), many("b", 200));
        assert!(!is_crowded(&format!("<?xml version='1.0'?>{one}{other}</b></a>")));
        assert!(is_crowded(&format!("{one}<!-- '\" > -->{}", many("c", 300))));
        let inside = many("c", 300);
        assert!(!is_crowded(&format!(
            "<a><!-- {inside} --><![CDATA[{inside}]]></a>"
        )));
        for cut in ["", "<", "<a b='", "<!-- x", "<![CDATA[", "<?xml", "a = b > c"] {
            assert!(!is_crowded(cut), "{cut}");
        }
    }

    #[test]
    fn what_means_something_to_xml_is_written_out() {
        let escaped = Escaped("a < b && \"c\" > d\t\u{1b}[0m\u{ffff}\n").to_string();
        assert_eq!(
            escaped,
            "a &lt; b &amp;&amp; &quot;c&quot; &gt; d\t\u{fffd}[0m\u{fffd}\n"
        );
    }
}

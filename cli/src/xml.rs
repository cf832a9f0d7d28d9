//! Texts in XML that other programs read.

use ladder_syntax::xml::Escaped;
use ladder_workspace::shown;

/// A text in an attribute, on one line.
pub(crate) fn attribute(text: &str) -> String {
    escaped(&shown::line(text))
}

/// Text inside of XML. What a terminal would interpret, including the control characters that are no part of XML, is escaped.
pub(crate) fn escaped(text: &str) -> String {
    Escaped(&shown::text(text)).to_string()
}

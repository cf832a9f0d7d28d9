//! What can be expressed of text that could not be read.

use ladder_syntax::{Line, LineKind, is_identifier};

/// The identifiers of a text.
pub(crate) fn identifiers(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_')
        .filter(|word| is_identifier(word))
}

/// Whether a line that could not be read may have been meant as declarations.
pub(crate) fn looks_like_declaration(line: &Line) -> bool {
    let not_read = line.kind == LineKind::Stray || !line.errors.is_empty();
    not_read && line.text().contains(';')
}

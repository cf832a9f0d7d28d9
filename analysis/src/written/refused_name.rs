//! Which names nothing may have.

use ladder_syntax::{is_declaration_keyword, is_reserved, is_type_keyword};

/// What would have the name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Place {
    Tag,
    /// A tag of a block's body.
    BlockTag,
    Type,
    /// Of an enumeration.
    Value,
    /// Of a structure: it comes after a point, where no type can be meant.
    Member,
}

/// Why a name may not be declared.
pub(crate) fn refused_name(text: &str, place: Place) -> Option<String> {
    let is_word = is_reserved(text) || is_declaration_keyword(text);
    if is_word && !(place == Place::Member && is_type_keyword(text)) {
        return Some(format!("`{text}` is a word of the language: choose another name"));
    }
    if place == Place::BlockTag && (text.eq_ignore_ascii_case("EN") || text.eq_ignore_ascii_case("ENO")) {
        return Some(format!("a block has `{text}` of its own: choose another name"));
    }
    None
}

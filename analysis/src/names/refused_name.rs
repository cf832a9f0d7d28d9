//! Which names nothing may have.

use ladder_syntax::{is_declaration_keyword, is_reserved};

/// Why a name may not be declared.
pub(super) fn refused_name(text: &str, in_block: bool) -> Option<String> {
    if is_reserved(text) || is_declaration_keyword(text) {
        return Some(format!("`{text}` is a word of the language: choose another name"));
    }
    if in_block && (text.eq_ignore_ascii_case("EN") || text.eq_ignore_ascii_case("ENO")) {
        return Some(format!("a block has `{text}` of its own: choose another name"));
    }
    None
}

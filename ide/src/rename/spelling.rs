//! Which spellings are names.

use super::RenameRefused;
use crate::symbol::Symbol;
use ladder_analysis::context::Context;
use ladder_syntax::{is_declaration_keyword, is_identifier, is_reserved, is_type_keyword, parse};

/// The new name as it will be written. A block's name may be given without its `$`.
pub(super) fn checked(context: &Context, symbol: &Symbol, new: &str) -> Result<String, RenameRefused> {
    let new = new.trim();
    if new.is_empty() {
        return Err(RenameRefused("a name is needed".to_owned()));
    }
    if let Symbol::Block { .. } = symbol {
        let name = if new.starts_with('$') {
            new.to_owned()
        } else {
            format!("${new}")
        };
        let header = parse(&format!("FUNCTION_BLOCK [{name}]\nEND_FUNCTION_BLOCK\n"));
        if new.contains(['\n', '\r', '#']) || !header.errors().is_empty() {
            return Err(RenameRefused(format!(
                "`{new}` cannot name a block: write `$`, a letter, then letters, digits and `_` (not last, not two together)"
            )));
        }
        return Ok(name);
    }
    if !is_identifier(new) {
        return Err(RenameRefused(format!(
            "`{new}` is not a name: write a letter or `_`, then letters, digits and `_`"
        )));
    }
    let tag = matches!(
        symbol,
        Symbol::Tag { .. } | Symbol::Global(_) | Symbol::Type { .. } | Symbol::Part { .. }
    );
    // A member comes after a point, where no type can be meant.
    let is_member =
        matches!(symbol, Symbol::Part { ty, .. } if context.types.enumeration(ty.as_str()).is_none());
    let may_be = is_member && is_type_keyword(new);
    if is_reserved(new) || (tag && is_declaration_keyword(new) && !may_be) {
        return Err(RenameRefused(format!(
            "`{new}` is a word of the language: choose another name"
        )));
    }
    let in_block = matches!(symbol, Symbol::Tag { scope, .. } if *scope > 0);
    if in_block && ["EN", "ENO"].iter().any(|word| word.eq_ignore_ascii_case(new)) {
        return Err(RenameRefused(format!(
            "a block has `{new}` of its own: choose another name"
        )));
    }
    Ok(new.to_owned())
}

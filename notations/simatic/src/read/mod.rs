//! SIMATIC source documents, `.s7dcl` with the texts of its `.s7res`, and sources in SCL, `.scl`.

mod declarations;
mod networks;
mod pragma;
pub(crate) mod resource;

use crate::cursor::{Cursor, Result};
use crate::model::{Kind, Unit};
pub(crate) use declarations::type_of;
use ladder_notation::Lines;
use pragma::Pragma;
use resource::Texts;

/// Whether a text is such a document, from what it begins with.
pub(crate) fn recognises(head: &str) -> bool {
    let lines = Lines::of(head);
    let mut cursor = Cursor::new(head, &lines);
    let pragma = pragma::pragma(&mut cursor).unwrap_or_default();
    let word = cursor.peek_word();
    let begins = Kind::ALL.iter().any(|kind| kind.keyword() == word);
    begins && (pragma.has_own() || head.contains("S7_Language"))
}

/// Reads a document.
///
/// # Errors
///
/// If it is not a block, or its frame is broken. A network that is broken stays as a text.
pub(crate) fn unit(text: &str, texts: &Texts) -> Result<Unit> {
    let lines = Lines::of(text);
    let mut cursor = Cursor::new(text, &lines);
    let mut unit = block(&mut cursor, texts)?;
    if !cursor.is_done() {
        let why = "a file has one block: the rest of it is not read";
        let place = cursor.place();
        unit.report.refused(place, "what stands after the end", why);
    }
    Ok(unit)
}

/// Reads a source in SCL: several blocks.
///
/// # Errors
///
/// If one of them is not a block, or its frame is broken.
pub(crate) fn source(text: &str) -> Result<Vec<Unit>> {
    let lines = Lines::of(text);
    let mut cursor = Cursor::new(text, &lines);
    let mut units = Vec::new();
    while units.is_empty() || !cursor.is_done() {
        units.push(block(&mut cursor, &Texts::default())?);
    }
    Ok(units)
}

fn block(cursor: &mut Cursor<'_>, texts: &Texts) -> Result<Unit> {
    let pragma = pragma::pragma(cursor)?;
    cursor.blanks();
    let place = cursor.place();
    let kinds = Kind::ALL;
    let Some(kind) = kinds.into_iter().find(|kind| cursor.eat_word(kind.keyword())) else {
        return cursor.error(
            "a block of SIMATIC begins with FUNCTION_BLOCK, FUNCTION, ORGANIZATION_BLOCK, DATA_BLOCK or TYPE",
        );
    };
    let mut unit = Unit {
        place,
        kind,
        name: cursor.name()?,
        told: texts.told(&pragma, ["S7_BlockTitle", "S7_BlockComment"]),
        ..Unit::default()
    };
    // A data block of a type has it here.
    if matches!(kind, Kind::Function | Kind::Data) && cursor.eat(":") {
        unit.returns = Some(type_of(cursor, texts, 0)?).filter(|ty| !declarations::is_void(ty));
    }
    body(cursor, &mut unit, texts)?;
    Ok(unit)
}

/// Sections and networks, up to the end of the block.
fn body(cursor: &mut Cursor<'_>, unit: &mut Unit, texts: &Texts) -> Result<()> {
    let end = format!("END_{}", unit.kind.keyword());
    if unit.kind == Kind::Type {
        cursor.eat(":");
    }
    loop {
        if cursor.is_done() {
            return cursor.error(format!("the file ends without `{end}`"));
        }
        let before = cursor.clone();
        let pragma = pragma::pragma(cursor)?;
        if cursor.eat_word(&end) {
            break;
        } else if cursor.eat_word("NETWORK") {
            let network = networks::network(cursor, &pragma, texts)?;
            unit.networks.push(network);
        } else if let Some(section) = declarations::section(cursor) {
            declarations::variables(cursor, section, texts, &mut unit.variables)?;
        } else if unit.kind.is_code() && cursor.eat_word("BEGIN") {
            if let Some(network) = networks::statements(cursor, &end) {
                unit.networks.push(network);
            }
        } else if matches!(unit.kind, Kind::Type | Kind::Data)
            && cursor.peek_word().eq_ignore_ascii_case("STRUCT")
        {
            let ty = type_of(cursor, texts, 0)?;
            cursor.eat(";");
            if let crate::model::Type::Structure(members) = ty {
                unit.variables.extend(members);
            }
        } else {
            declarations::other(cursor, before, unit)?;
        }
    }
    Ok(())
}

/// The pragma of something.
pub(crate) fn pragma_of(cursor: &mut Cursor<'_>) -> Result<Pragma> {
    pragma::pragma(cursor)
}

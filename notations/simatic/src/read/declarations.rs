//! Sections of variables, and types.

use super::resource::Texts;
use crate::cursor::{Cursor, Result};
use crate::model::{Kind, Role, Type, Unit, Variable};

/// Structures and arrays nest no deeper.
const DEEPEST: usize = 16;

/// The role of a section's variables, and whether they are retentive, if a section begins here.
pub(super) fn section(cursor: &mut Cursor<'_>) -> Option<(Role, bool)> {
    let role = match cursor.peek_word().to_ascii_uppercase().as_str() {
        "VAR_INPUT" => Role::Input,
        "VAR_OUTPUT" => Role::Output,
        "VAR_IN_OUT" => Role::InOut,
        "VAR_TEMP" => Role::Temp,
        "VAR" | "VAR_STAT" => Role::Static,
        _ => return None,
    };
    cursor.at += cursor.peek_word().len();
    let mut found = (role, false);
    loop {
        // A variable may have such a name.
        let is_word = |cursor: &Cursor<'_>, length: usize| {
            let mut after = cursor.clone();
            after.at += length;
            !after.is(":") && !after.is(",")
        };
        let word = cursor.peek_word();
        match word.to_ascii_uppercase().as_str() {
            "RETAIN" if is_word(cursor, word.len()) => found.1 = true,
            "NON_RETAIN" if is_word(cursor, word.len()) => {}
            "CONSTANT" if is_word(cursor, word.len()) => found.0 = Role::Constant,
            _ => return Some(found),
        }
        cursor.at += word.len();
    }
}

/// The variables of a section, with the end of it.
pub(super) fn variables(
    cursor: &mut Cursor<'_>,
    (role, retain): (Role, bool),
    texts: &Texts,
    out: &mut Vec<Variable>,
) -> Result<()> {
    while !cursor.eat_word("END_VAR") {
        declaration(cursor, (role, retain), texts, out, 0)?;
    }
    Ok(())
}

/// `[pragma] name {, name} : type [:= value];`
fn declaration(
    cursor: &mut Cursor<'_>,
    (role, retain): (Role, bool),
    texts: &Texts,
    out: &mut Vec<Variable>,
    depth: usize,
) -> Result<()> {
    let pragma = super::pragma_of(cursor)?;
    cursor.blanks();
    let place = cursor.place();
    let mut names = vec![cursor.name()?];
    while cursor.eat(",") {
        names.push(cursor.name()?);
    }
    if cursor.is("{") {
        super::pragma_of(cursor)?;
    }
    cursor.expect(":")?;
    let ty = type_of(cursor, texts, depth)?;
    let initial = if cursor.eat(":=") {
        Some(cursor.until(";")?.to_owned())
    } else {
        None
    };
    cursor.expect(";")?;
    let comment = comment_after(cursor)
        .map(str::to_owned)
        .or_else(|| texts.told(&pragma, ["S7_MLC"]).into_iter().next());
    out.extend(names.into_iter().map(|name| Variable {
        place,
        name,
        role,
        retain,
        ty: ty.clone(),
        initial: initial.clone(),
        comment: comment.clone(),
    }));
    Ok(())
}

/// A comment on what is left of a line.
fn comment_after<'t>(cursor: &Cursor<'t>) -> Option<&'t str> {
    let line = cursor.rest().lines().next()?;
    let told = line.trim().strip_prefix("//")?.trim();
    (!told.is_empty()).then_some(told)
}

/// A type. `texts`: the comments on the members of a structure.
pub(crate) fn type_of(cursor: &mut Cursor<'_>, texts: &Texts, depth: usize) -> Result<Type> {
    if depth > DEEPEST {
        return cursor.error(format!("types nest deeper than {DEEPEST}"));
    }
    if cursor.eat_word("ARRAY") {
        cursor.expect("[")?;
        let mut bounds = Vec::new();
        for part in cursor.until("]")?.split(',') {
            let Some((low, high)) = part.split_once("..") else {
                return cursor.error(format!("`{}` is no range of an array", part.trim()));
            };
            bounds.push((low.trim().to_owned(), high.trim().to_owned()));
        }
        cursor.expect("]")?;
        if !cursor.eat_word("OF") {
            return cursor.error("an array says OF what it is");
        }
        return Ok(Type::Array(bounds, Box::new(type_of(cursor, texts, depth + 1)?)));
    }
    if cursor.eat_word("STRUCT") {
        let mut members = Vec::new();
        while !cursor.eat_word("END_STRUCT") {
            declaration(cursor, (Role::Static, false), texts, &mut members, depth + 1)?;
        }
        return Ok(Type::Structure(members));
    }
    let is_quoted = cursor.is("\"");
    let name = cursor.name()?;
    let is_text = ["STRING", "WSTRING"]
        .iter()
        .any(|text| name.eq_ignore_ascii_case(text));
    if is_text && !is_quoted {
        if !cursor.eat("[") {
            return Ok(Type::Text(None));
        }
        let length = cursor.until("]")?.parse().ok();
        cursor.expect("]")?;
        return Ok(Type::Text(length));
    }
    Ok(Type::Named(name))
}

pub(super) fn is_void(ty: &Type) -> bool {
    matches!(ty, Type::Named(name) if name.eq_ignore_ascii_case("VOID"))
}

/// What else is in a block: `BEGIN`, `VERSION : 0.1`, values of a data block, the block that one is an instance of.
pub(super) fn other<'t>(cursor: &mut Cursor<'t>, before: Cursor<'t>, unit: &mut Unit) -> Result<()> {
    if cursor.eat_word("BEGIN") || cursor.eat_word("NON_RETAIN") {
        return Ok(());
    }
    if cursor.eat_word("TITLE") {
        cursor.expect("=")?;
        let title = cursor.rest().lines().next().unwrap_or_default();
        cursor.at += title.len();
        unit.told.extend(
            Some(title.trim().trim_matches(['\'', '"']).to_owned()).filter(|title| !title.is_empty()),
        );
        return Ok(());
    }
    if ["VERSION", "AUTHOR", "FAMILY", "NAME"]
        .iter()
        .any(|word| cursor.eat_word(word))
    {
        cursor.expect(":")?;
        let rest = cursor.rest().trim_start();
        let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
        cursor.at = cursor.end - rest.len() + length;
        return Ok(());
    }
    if unit.kind != Kind::Data {
        *cursor = before;
        let word = cursor.peek_word().to_owned();
        return cursor.error(format!("`{word}` does not belong into a block"));
    }
    cursor.blanks();
    let place = cursor.place();
    let start = cursor.at;
    if cursor.is("\"") || !cursor.peek_word().is_empty() {
        cursor.name()?;
        if !cursor.is(".") && !cursor.is("[") && !cursor.is(":=") {
            // The block that it is an instance of.
            let name = cursor.text[start..cursor.at].trim().trim_matches('"').to_owned();
            unit.returns = Some(Type::Named(name));
            return Ok(());
        }
    }
    cursor.until(";")?;
    let shown = cursor.text[start..cursor.at].trim().to_owned();
    cursor.expect(";")?;
    let Some((path, value)) = shown.split_once(":=") else {
        return Ok(());
    };
    let plain = path.trim().trim_matches('"');
    match unit.variables.iter_mut().find(|variable| variable.name == plain) {
        Some(variable) => variable.initial = Some(value.trim().to_owned()),
        None => {
            let why = "a value of a part of a variable is left out: the part has the value of its type";
            unit.report.approximated(place, shown, why);
        }
    }
    Ok(())
}

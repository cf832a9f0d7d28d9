//! `{ S7_Language := "LAD"; S7_Templates := "SrcType := Int" }`

use crate::cursor::{Cursor, Result};

/// The texts in one.
#[derive(Debug, Clone, Default)]
pub(crate) struct Pragma(Vec<(String, String)>);

impl Pragma {
    pub(crate) fn get(&self, name: &str) -> Option<&str> {
        let mut all = self.0.iter().rev();
        all.find(|(own, _)| own.eq_ignore_ascii_case(name))
            .map(|(_, value)| value.as_str())
    }

    /// Whether it is one of this system.
    pub(crate) fn has_own(&self) -> bool {
        self.0.iter().any(|(name, _)| name.starts_with("S7_"))
    }

    /// `SrcType := Int`, `[SrcType := Int, DestType := Real]`
    pub(crate) fn templates(&self) -> Vec<(String, String)> {
        templates(self.get("S7_Templates").unwrap_or_default())
    }
}

/// The templates in a text.
pub(super) fn templates(text: &str) -> Vec<(String, String)> {
    let inner = text.trim().trim_start_matches('[').trim_end_matches(']');
    let parts = inner.split([',', ';']);
    let pairs = parts.filter_map(|part| part.split_once(":="));
    pairs
        .map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()))
        .collect()
}

/// A pragma, if one is next; else an empty one. Several in a row are one.
pub(super) fn pragma(cursor: &mut Cursor<'_>) -> Result<Pragma> {
    let mut pragma = Pragma::default();
    while cursor.eat("{") {
        while !cursor.eat("}") {
            let name = cursor.name()?;
            cursor.expect(":=")?;
            let value = if cursor.is("\"") {
                cursor.quoted()?
            } else {
                let value = cursor.until(";}")?;
                if value.contains(['\n', '(']) {
                    return cursor.error("a value of a pragma stands in quotes");
                }
                value.to_owned()
            };
            pragma.0.push((name, value));
            if !cursor.eat(";") && !cursor.is("}") {
                cursor.expect(";")?;
            }
        }
    }
    Ok(pragma)
}

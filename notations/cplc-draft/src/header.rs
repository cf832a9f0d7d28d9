//! The headers of the draft: `IN = { DI start, AI weight }`.

use ladder_format::program::SectionKind;
use ladder_notation::{LineColumn, ReadError};

/// One entry of a header.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Entry {
    pub(super) section: SectionKind,
    /// The type as ladder text has it.
    pub(super) ty: String,
    pub(super) name: String,
    pub(super) place: LineColumn,
    /// As it is written.
    pub(super) text: String,
}

/// The section that a header names, with what is after its `=`, if a line begins one.
pub(super) fn begins(line: &str) -> Option<(SectionKind, &str)> {
    let line = line.trim_start();
    let length = line.find(|c: char| !c.is_ascii_alphabetic())?;
    let section = match &line[..length] {
        word if word.eq_ignore_ascii_case("IN") => SectionKind::VarInput,
        word if word.eq_ignore_ascii_case("OUT") => SectionKind::VarOutput,
        word if word.eq_ignore_ascii_case("VAR") => SectionKind::Var,
        _ => return None,
    };
    let after = line[length..].trim_start().strip_prefix('=')?;
    Some((section, after))
}

/// An entry such as `DI start` or `INT[32] a`; none for an empty one.
pub(super) fn entry(section: SectionKind, text: &str, place: LineColumn) -> Result<Option<Entry>, ReadError> {
    let text = text.trim();
    let Some((_, name)) = text.rsplit_once([' ', '\t', ']']) else {
        return match text {
            "" => Ok(None),
            _ => Err(ReadError::at(
                place,
                format!("`{text}` has no type before its name, as in `DI start`"),
            )),
        };
    };
    // `DI[4]a` needs no blank; the bracket belongs to the type.
    let types = text[..text.len() - name.len()].trim_end();
    let (word, length) = match types.split_once('[') {
        None => (types.trim(), None),
        Some((word, rest)) => {
            let number = rest.split(']').next().unwrap_or_default().trim();
            let length = number.parse::<u32>().ok().filter(|length| *length > 0);
            let length = length.ok_or_else(|| {
                ReadError::at(
                    place,
                    format!("`{number}` is not a number of elements; it is 1 or more"),
                )
            })?;
            (word.trim(), Some(length))
        }
    };
    let element = match word.to_ascii_uppercase().as_str() {
        "DI" | "DO" | "BOOL" => "BOOL",
        "AI" | "AO" | "FLOAT" => "REAL",
        "SI" | "SO" | "STRING" => "STRING",
        // The draft does not say how wide it is; counters count to the limits of DINT.
        "INT" => "DINT",
        _ => {
            return Err(ReadError::at(
                place,
                format!("`{word}` is not a type of the draft: DI DO AI AO SI SO INT FLOAT STRING BOOL are"),
            ));
        }
    };
    let ty = match length {
        None => element.to_owned(),
        Some(length) => format!("ARRAY[0..{}] OF {element}", length - 1),
    };
    Ok(Some(Entry {
        section,
        ty,
        name: name.trim().to_owned(),
        place,
        text: text.to_owned(),
    }))
}

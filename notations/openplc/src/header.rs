//! Where the rungs of a file are, and what is above them.

use ladder_notation::{Lines, ReadError, Report};
use ladder_notation_plcopen::declarations;
use ladder_notation_plcopen::model::Unit;
use std::ops::Range;

/// How many bytes are checked for rungs.
const HEAD: usize = 1 << 16;

/// Whether a file is such a program: it begins as one in IEC 61131-3 does, and has rungs in JSON.
pub(super) fn recognises(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(HEAD)]);
    declarations::begins_unit(&head) && head.contains("\"rungs\"")
}

/// The unit that a file declares, and where its JSON is.
///
/// # Errors
///
/// If it begins otherwise, or has no JSON.
pub(super) fn read(text: &str, report: &mut Report) -> Result<(Unit, Range<usize>), ReadError> {
    let lines = Lines::of(text);
    // Comments may have braces in them.
    let plain = declarations::without_comments(text);
    let whole = |message: &str| ReadError::whole(message);
    let start = plain
        .find('{')
        .ok_or_else(|| whole("the file has no rungs: a JSON object comes after the variables"))?;
    let end = plain
        .rfind('}')
        .ok_or_else(|| whole("the rungs do not end: a `}` is missing"))?;
    if end < start {
        return Err(whole("the rungs do not end: a `}` is missing"));
    }
    let declared = declarations::Declared {
        text: &text[..start],
        plain: &plain[..start],
        place: &|offset| lines.place(text, offset),
    };
    let unit = declared.unit(report)?;
    Ok((unit, start..end + 1))
}

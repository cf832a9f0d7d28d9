//! The conversion as a fix, for ladder text that is a program in the draft.

use super::super::{Converted, ReadError, Source, convert};
use super::CplcDraft;
use ladder_analysis::{Applicability, Fix};
use ladder_format::{Edit, Options};
use ladder_syntax::{TextRange, TextSize};

/// The conversion of a text in the first draft. It may be made unasked if every element says the same afterwards.
/// `options` are those that the file is laid out by.
///
/// # Errors
///
/// Returns what cannot be read in the text.
pub fn conversion(text: &str, options: &Options) -> Result<Fix, ReadError> {
    let converted = convert(&CplcDraft, &Source::alone("", text.as_bytes()), options)?;
    let applicability = applicability(&converted);
    let edit = Edit {
        range: TextRange::up_to(TextSize::of(text)),
        text: converted.written.text,
    };
    Ok(Fix::new(applicability, "Convert to ladder text", vec![edit]))
}

fn applicability(converted: &Converted) -> Applicability {
    if converted.report.remarks().next().is_none() && converted.findings.is_empty() {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

//! The conversion as a fix, for ladder text that is a program in the first draft of the language.

use crate::by_name;
use ladder_analysis::{Applicability, Fix};
use ladder_format::{Edit, Options};
use ladder_notation::{Converted, ReadError, Source, convert};
use ladder_syntax::{TextRange, TextSize};

/// The conversion of a text in the first draft, if this build reads it. It may be made unasked if every element says the
/// same afterwards. `options` are those that the file is laid out by.
///
/// # Errors
///
/// Returns what cannot be read in the text.
pub fn conversion_of_cplc_draft(text: &str, options: &Options) -> Option<Result<Fix, ReadError>> {
    let source = Source::alone("", text.as_bytes());
    let converted = convert(by_name("cplc-draft")?, &source, options);
    Some(converted.map(|converted| fix(text, converted)))
}

fn fix(text: &str, converted: Converted) -> Fix {
    let applicability = applicability(&converted);
    let edit = Edit {
        range: TextRange::up_to(TextSize::of(text)),
        text: converted.written.text,
    };
    Fix::new(applicability, "Convert to ladder text", vec![edit])
}

fn applicability(converted: &Converted) -> Applicability {
    if converted.report.remarks().next().is_none() && converted.findings.is_empty() {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

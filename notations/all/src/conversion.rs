//! The conversion as a fix, for ladder text that is a program in the first draft of the language.

use crate::by_name;
use ladder_analysis::{Applicability, Fix};
use ladder_format::{Edit, Options};
use ladder_notation::{Converted, Source, convert};
use ladder_syntax::{TextRange, TextSize};

/// What the conversion is called where it is offered.
pub const CONVERSION: &str = "Convert to ladder text";

/// The conversion of a text in the first draft, if this build reads it. It may be made unasked if every element says the
/// same afterwards. `options` are those that the file is laid out by.
///
/// # Errors
///
/// Says that it cannot be converted yet, and what cannot be read in it.
pub fn conversion_of_cplc_draft(text: &str, options: &Options) -> Option<Result<Fix, String>> {
    let source = Source::alone("", text.as_bytes());
    let converted = convert(by_name("cplc-draft")?, &source, options);
    let converted = converted.map_err(|error| format!("it cannot be converted yet: {error}"));
    Some(converted.map(|converted| fix(text, converted)))
}

fn fix(text: &str, converted: Converted) -> Fix {
    let applicability = applicability(&converted);
    let edit = Edit {
        range: TextRange::up_to(TextSize::of(text)),
        text: converted.written.text,
    };
    Fix::new(applicability, CONVERSION, vec![edit])
}

fn applicability(converted: &Converted) -> Applicability {
    if converted.report.remarks().next().is_none() && converted.findings.is_empty() {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

//! The conversion as a fix, for ladder text that is a program of another system.

use crate::NOTATIONS;
use ladder_analysis::{Applicability, Diagnostic, Fix};
use ladder_format::{Edit, Options};
use ladder_notation::{Converted, Source, convert};
use ladder_syntax::{TextRange, TextSize};

/// Adds the conversion to the finding that a file is in a notation, if there is such a finding. It may be made unasked if
/// every element says the same afterwards. `text` is the file's, `options` are those that it is laid out by.
pub fn offer_conversion(findings: &mut [Diagnostic], text: &str, options: &Options) {
    let reported = findings.iter_mut().find_map(|found| {
        let mut notations = NOTATIONS.iter().copied();
        let notation = notations.find(|notation| notation.is_reported_by(found))?;
        Some((found, notation))
    });
    let Some((found, notation)) = reported else {
        return;
    };
    let source = Source::alone("", text.as_bytes());
    match convert(notation, &source, options) {
        Ok(converted) => {
            let whole = TextRange::up_to(TextSize::of(text));
            found.fixes.push(Fix::new(
                applicability(&converted),
                "Convert to ladder text",
                vec![Edit {
                    range: whole,
                    text: converted.written.text,
                }],
            ));
        }
        Err(error) => found.help = Some(format!("it cannot be converted yet: {error}").into()),
    }
}

fn applicability(converted: &Converted) -> Applicability {
    if converted.report.remarks().next().is_none() && converted.findings.is_empty() {
        Applicability::Safe
    } else {
        Applicability::Unsafe
    }
}

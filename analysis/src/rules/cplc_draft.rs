//! `unexpected-character`, for a file in the first draft of the language: reported once, for the file as a whole.
//!
//! The conversion is the fix, but what reads the draft is above the analysis and adds it: see [`is_reported`].

use crate::cplc_draft::beginning;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Severity;
use ladder_syntax::Parse;

const MESSAGE: &str = "this is a program in the first draft of CPLC-LD, which ladder text has moved on from";

/// Puts the one finding in the place of all others, if a file with errors begins in the draft.
pub(crate) fn hide_all_else(parse: &Parse, diagnostics: &mut Vec<Diagnostic>) {
    if !diagnostics.iter().any(|found| found.severity == Severity::Error) {
        return;
    }
    if let Some(range) = beginning(parse) {
        let found = Diagnostic::new(super::unexpected_character::RULE, range, MESSAGE)
            .help("`ladder convert --from cplc-draft` writes it as ladder text, and says what becomes of each element");
        *diagnostics = vec![found];
    }
}

/// Whether a text begins as one in the draft does.
pub(crate) fn is_it(parse: &Parse) -> bool {
    beginning(parse).is_some()
}

/// Whether a finding is the one that says that a file is in the draft.
pub fn is_reported(found: &Diagnostic) -> bool {
    found.rule == super::unexpected_character::RULE && found.message == MESSAGE
}

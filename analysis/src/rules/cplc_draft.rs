//! `unexpected-character`, for a file in the first draft of the language: reported once, for the file as a whole.
//!
//! What reads the draft is above the analysis: the finding says what to do, and `ladder check` and the language server offer
//! the conversion.

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

//! A finding as a diagnostic of the protocol.

use std::cell::{Cell, OnceCell};
use std::fmt::Write;

use ladder_analysis::{Diagnostic as Finding, Rule};
use ladder_documents::positions::Positions;
use ladder_documents::{OtherPlaces, Revision};
use ladder_syntax::TextRange;
use serde_json::json;
use tower_lsp::ls_types::{
    CodeDescription, Diagnostic, DiagnosticRelatedInformation, DiagnosticTag, Location, Range,
};

use crate::lsp::convert;
use crate::lsp::session::agreed::Agreed;

/// This many places are looked up one by one; for more a table of all lines costs less.
const FEW: usize = 100;

/// What the findings of one text have in common: the places of its lines, and the files next to it.
pub(crate) struct Findings<'r> {
    agreed: Agreed,
    revision: &'r Revision,
    next_to: OtherPlaces<'r>,
    asked: Cell<usize>,
    positions: OnceCell<Positions>,
}

impl<'r> Findings<'r> {
    /// Those of this text, for a client with which this was agreed.
    pub(crate) fn of(agreed: Agreed, revision: &'r Revision) -> Self {
        Findings {
            agreed,
            revision,
            next_to: OtherPlaces::new(revision),
            asked: Cell::new(0),
            positions: OnceCell::new(),
        }
    }

    /// One of them as the client is sent it.
    pub(crate) fn diagnostic(&mut self, found: &Finding) -> Diagnostic {
        let name = found.rule.name();
        let mut message = found.message.clone();
        if let Some(help) = &found.help {
            let _ = write!(message, "\n{help}");
        }
        let mut related = Vec::new();
        for other in &found.related {
            let place = match &other.file {
                None => Some((self.revision.uri.to_string(), self.range(other.range))),
                Some(file) => self
                    .next_to
                    .range(file, other.range)
                    .map(|(uri, range)| (uri, convert::range(range))),
            };
            let Some((uri, range)) = place else { continue };
            if self.agreed.related_information {
                related.extend(convert::uri(&uri).map(|uri| DiagnosticRelatedInformation {
                    location: Location { uri, range },
                    message: other.message.to_string(),
                }));
                continue;
            }
            // A client that cannot link other places still gets to know of them: by the numbers of their lines, which
            // people count from 1.
            let file = other
                .file
                .as_ref()
                .map_or(String::new(), |file| format!("{file}, "));
            let _ = write!(
                message,
                "\n{file}line {}: {}",
                range.start.line + 1,
                other.message
            );
        }
        let fixes: Vec<&str> = found.fixes.iter().map(|fix| &*fix.title).collect();
        Diagnostic {
            related_information: (!related.is_empty()).then_some(related),
            tags: (self.agreed.unnecessary_tag && found.rule.is_about_no_effect())
                .then(|| vec![DiagnosticTag::UNNECESSARY]),
            code_description: (self.agreed.rule_pages)
                .then(|| convert::uri(&address(found.rule)))
                .flatten()
                .map(|href| CodeDescription { href }),
            data: (self.agreed.diagnostic_data && !fixes.is_empty()).then(|| json!({ "fixes": fixes })),
            ..convert::diagnostic(self.range(found.range), found.severity, name, message)
        }
    }

    /// The lines and columns of a stretch.
    fn range(&self, place: TextRange) -> Range {
        self.asked.update(|asked| asked + 1);
        if self.asked.get() <= FEW {
            return convert::range_in(self.revision, place);
        }
        let positions = self.positions.get_or_init(|| self.revision.positions());
        convert::range(positions.range(place))
    }
}

/// The scheme of the addresses that findings link: they are no files, and the server has their text.
const SCHEME: &str = "ladder-rule";

/// The address of a rule's page. Links between pages, which are relative, lead from one such address to another.
fn address(rule: Rule) -> String {
    format!("{SCHEME}:/{}.md", rule.name())
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use ladder_documents::Documents;
    use ladder_documents::position::Encoding;

    /// Findings with a fix, with a related place, and about text without effect.
    const TEXT: &str = "VAR x, y : BOOL; END_VAR\n\n+--[ ]( ö )--( )( y )--+\n\n+--[ ]( y )--( )( y )--+\n\n\
        +--[ ]( y )--( )( x )--+\n\n+--<END>()--+\n\n+--[ ]( y )--( )( x )--+\n";

    /// What a client gets that takes all of this, or nothing of it: a diagnostic a line.
    fn check(can: bool, expected: &Expect) {
        let agreed = Agreed {
            related_information: can,
            unnecessary_tag: can,
            diagnostic_data: can,
            rule_pages: can,
            ..Agreed::default()
        };
        let revision = Documents::default().open("file:///a.clad", 1, Encoding::Utf16, TEXT);
        let analysis = revision.analysis().expect("the text is not too large");
        let mut findings = Findings::of(agreed, &revision);
        let mut all = String::new();
        for finding in analysis.findings() {
            let diagnostic = findings.diagnostic(&finding.diagnostic());
            all.push_str(&serde_json::to_string(&diagnostic).expect("a diagnostic can be written"));
            all.push('\n');
        }
        expected.assert_eq(&all);
    }

    #[test]
    fn all_that_a_diagnostic_consists_of() {
        check(
            true,
            &expect![[r#"
                {"range":{"start":{"line":2,"character":8},"end":{"line":2,"character":9}},"severity":2,"code":"undeclared-tag","codeDescription":{"href":"ladder-rule:/undeclared-tag.md"},"source":"ladder","message":"`ö` is not declared\ndeclare it, so that a typing error cannot make a new tag","data":{"fixes":["Declare `ö : BOOL` in VAR_INPUT"]}}
                {"range":{"start":{"line":4,"character":18},"end":{"line":4,"character":19}},"severity":2,"code":"double-coil","codeDescription":{"href":"ladder-rule:/double-coil.md"},"source":"ladder","message":"`y` is written by 2 coils: the last one alone decides\ncombine all conditions into one coil, joined with \\ and /; or use (S) and (R)","relatedInformation":[{"location":{"uri":"file:///a.clad","range":{"start":{"line":2,"character":18},"end":{"line":2,"character":19}}},"message":"`y` is written here as well"}]}
                {"range":{"start":{"line":8,"character":3},"end":{"line":8,"character":10}},"severity":2,"code":"unconditional-end","codeDescription":{"href":"ladder-rule:/unconditional-end.md"},"source":"ladder","message":"<END> stops the program for good, and no condition is before it: only one scan runs\na program needs no end; <RET> ends the scan, as END does in other controllers","data":{"fixes":["End the scan only: <RET>"]}}
                {"range":{"start":{"line":10,"character":0},"end":{"line":10,"character":24}},"severity":2,"code":"unreachable","codeDescription":{"href":"ladder-rule:/unreachable.md"},"source":"ladder","message":"no scan ever comes to this rung\nput a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it","relatedInformation":[{"location":{"uri":"file:///a.clad","range":{"start":{"line":8,"character":3},"end":{"line":8,"character":10}}},"message":"this always ends the program"}],"tags":[1]}
            "#]],
        );
    }

    #[test]
    fn related_places_in_words() {
        check(
            false,
            &expect![[r#"
            {"range":{"start":{"line":2,"character":8},"end":{"line":2,"character":9}},"severity":2,"code":"undeclared-tag","source":"ladder","message":"`ö` is not declared\ndeclare it, so that a typing error cannot make a new tag"}
            {"range":{"start":{"line":4,"character":18},"end":{"line":4,"character":19}},"severity":2,"code":"double-coil","source":"ladder","message":"`y` is written by 2 coils: the last one alone decides\ncombine all conditions into one coil, joined with \\ and /; or use (S) and (R)\nline 3: `y` is written here as well"}
            {"range":{"start":{"line":8,"character":3},"end":{"line":8,"character":10}},"severity":2,"code":"unconditional-end","source":"ladder","message":"<END> stops the program for good, and no condition is before it: only one scan runs\na program needs no end; <RET> ends the scan, as END does in other controllers"}
            {"range":{"start":{"line":10,"character":0},"end":{"line":10,"character":24}},"severity":2,"code":"unreachable","source":"ladder","message":"no scan ever comes to this rung\nput a condition before what leaves above it, mark it with a <LBL> that is jumped to, or remove it\nline 9: this always ends the program"}
        "#]],
        );
    }
}

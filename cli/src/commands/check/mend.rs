//! `--fix`: what can be mended is mended, and the drawing stays aligned.

use super::Checked;
use crate::findings::Source;
use ladder_analysis::{Diagnostic, Fix, Severity, fix};
use ladder_format::apply;
use ladder_syntax::TextSize;
use ladder_workspace::FileError;
use std::path::Path;

/// A fix may bring out what another mistake hid; so many rounds are enough for all that was seen.
const ROUNDS: usize = 16;

/// Mends a file. It is written once, at the end, and only if something was mended.
pub(super) fn mend(mut source: Source) -> Result<Checked, FileError> {
    let options = source.format_options();
    let mut findings = source.analyze().diagnostics.clone();
    let mut mended = 0;
    for _ in 0..ROUNDS {
        let (fixes, count) = together(&findings);
        if count == 0 {
            break;
        }
        let edits = fix::aligned(&source.text, &fixes, &options);
        let next = source.with_text(apply(&source.text, &edits));
        let left = next.analyze().diagnostics.clone();
        // A fix that brings new errors is none.
        if errors(&left) > errors(&findings) {
            break;
        }
        (source, findings) = (next, left);
        mended += count;
    }
    if mended > 0 {
        ladder_workspace::write(Path::new(&source.file), source.text.as_bytes())?;
    }
    Ok(Checked {
        source,
        findings,
        problems: Vec::new(),
        mended,
    })
}

fn errors(findings: &[Diagnostic]) -> usize {
    findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .count()
}

/// The fixes that can be made together, as one, and how many they are. Where there is more than one way, a person
/// must choose.
fn together(findings: &[Diagnostic]) -> (Fix, usize) {
    let mut edits = Vec::new();
    let mut count = 0;
    let mut free_from = TextSize::new(0);
    let mut first = true;
    for finding in findings {
        let [fix] = finding.fixes.as_slice() else {
            continue;
        };
        let (Some(start), Some(end)) = (fix.edits.first(), fix.edits.last()) else {
            continue;
        };
        // Edits that touch might mean the same place.
        if !first && start.range.start() <= free_from {
            continue;
        }
        first = false;
        free_from = end.range.end();
        edits.extend(fix.edits.iter().cloned());
        count += 1;
    }
    let title = String::new();
    (Fix { title, edits }, count)
}

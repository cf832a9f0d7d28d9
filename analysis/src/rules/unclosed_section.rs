//! The fix of a section, a structure or a block definition that is not closed: its last line, where it ends.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::names::declaring::line_end;
use ladder_syntax::{DeclarationProblem, LineKind, Parse, TextRange};

/// Has a fix write what is missing.
pub(crate) fn with_end(parse: &Parse, problem: DeclarationProblem, found: Diagnostic) -> Diagnostic {
    let keyword = match problem {
        DeclarationProblem::SectionNotClosed => "END_VAR",
        DeclarationProblem::TypesNotClosed => "END_TYPE",
        DeclarationProblem::StructNotClosed => "    END_STRUCT;",
        DeclarationProblem::BlockNotClosed => "END_FUNCTION_BLOCK",
        _ => return found,
    };
    let Some(line) = parse.line_at(found.range.start()) else {
        return found;
    };
    let is_in_block = problem == DeclarationProblem::BlockNotClosed;
    let end = end_of_what_begins(parse, line, is_in_block).unwrap_or(line);
    // What is above a rung belongs to the rung; blank lines stay between them.
    let lines = parse.lines();
    let is_space = |line: usize| match lines[line].kind {
        LineKind::Blank | LineKind::Rail => true,
        LineKind::Comment => !is_in_block,
        _ => false,
    };
    let mut after = end;
    while after > 0 && is_space(after - 1) {
        after -= 1;
    }
    let Some(last) = after.checked_sub(1) else {
        return found;
    };
    let at = parse.line_range(last).end();
    let line_end = line_end(parse);
    let text = if lines[last].text().ends_with(['\n', '\r']) {
        format!("{keyword}{line_end}")
    } else {
        format!("{line_end}{keyword}")
    };
    found.fix(
        Applicability::Unsafe,
        format!("Insert {}", keyword.trim()),
        TextRange::empty(at),
        text,
    )
}

/// Where a section or definition ends that begins in a line and is not closed: a text ends with it, and the finding is at its
/// beginning. None if nothing such begins there, or it is closed.
fn end_of_what_begins(parse: &Parse, line: usize, is_block: bool) -> Option<usize> {
    let frame = parse.frame();
    if is_block {
        let block = frame
            .blocks
            .iter()
            .find(|block| block.lines.start == line && !block.closed)?;
        return Some(block.lines.end);
    }
    let sections = &frame.sections;
    let is_ended = sections
        .iter()
        .any(|section| section.lines.end == line && !section.closed);
    let begun = sections
        .iter()
        .find(|section| section.lines.start == line && !section.closed);
    begun.filter(|_| !is_ended).map(|section| section.lines.end)
}

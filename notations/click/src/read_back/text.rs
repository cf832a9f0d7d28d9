//! What is in the text of a ladder program next to its networks: comments, and what they keep.

use super::Back;
use ladder_analysis::Analysis;
use ladder_analysis::program::{Block, Program, TagId};
use ladder_notation::{WriteError, no_program};
use std::collections::HashMap;
use std::sync::Arc;

/// The program, also of a text that keeps instructions without a counterpart in comments: coils stand in for them, with
/// every byte at its place.
pub(super) fn program(analysis: &Analysis, text: &str) -> Result<Arc<Program>, WriteError> {
    let stood_in = with_stand_ins(text);
    if stood_in == text
        && let Some(program) = analysis.program()
    {
        return Ok(Arc::clone(program));
    }
    let again = ladder_analysis::analyze(&ladder_syntax::parse(&stood_in).into(), &analysis.context.name);
    if let Some(program) = again.program().or(analysis.program()) {
        return Ok(Arc::clone(program));
    }
    let reason = if stood_in == text { analysis } else { &again };
    Err(no_program(reason, text))
}

/// What holds the place of an instruction without a counterpart; a parenthesis closes it.
const STAND_IN: &str = "( )(_K";

/// What a comment begins with that keeps an instruction.
pub(super) const KEPT: &str = "# click:";

/// The text with a coil for each comment in a wire that keeps an instruction, so that its branch is known.
fn with_stand_ins(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let mut rest = line;
        let in_rung = line.starts_with(['+', '|', '/', '\\']);
        while let Some(start) = rest.find('#') {
            let Some(length) = rest[start + 1..].find('#').map(|at| at + 2) else {
                break;
            };
            let (before, comment) = (&rest[..start], &rest[start..start + length]);
            out.push_str(before);
            let is_kept = in_rung && before.ends_with('-') && comment.starts_with(KEPT);
            if is_kept && comment.len() > STAND_IN.len() {
                let blanks = comment.len() - STAND_IN.len() - 1;
                out.push_str(&format!("{STAND_IN}{:blanks$})", ""));
            } else {
                out.push_str(comment);
            }
            rest = &rest[start + length..];
        }
        out.push_str(rest);
    }
    out
}

/// The comments after declarations, by tag.
pub(super) fn declared(program: &Program, text: &str) -> HashMap<TagId, String> {
    let mut out = HashMap::new();
    for (number, tag) in program
        .tags
        .iter()
        .enumerate()
        .filter(|(_, tag)| tag.location.file == 0)
    {
        let at = usize::from(tag.location.range.start());
        let rest = text.get(at..).unwrap_or("");
        let line = rest.lines().next().unwrap_or("");
        if let Some((_, after)) = line.split_once(';')
            && let Some(told) = inside(after.trim())
        {
            out.insert(TagId(number as u32), told);
        }
    }
    out
}

/// What a comment says: `# .. #` with a `#` given by its code.
fn inside(comment: &str) -> Option<String> {
    let text = comment.strip_prefix('#')?.strip_suffix('#')?;
    Some(as_said(&text.trim().replace("\\x23", "#")).to_owned())
}

/// Comments between networks, in groups that blank lines part. Declarations and directives to the tools are left out.
pub(super) fn between(text: &str) -> Vec<Vec<String>> {
    let mut groups: Vec<Vec<String>> = vec![Vec::new()];
    let mut in_section = false;
    let mut in_block = false;
    let mut open: Option<String> = None;
    for line in text.lines().map(str::trim) {
        if let Some(before) = &mut open {
            // A comment that goes on over lines.
            before.push('\n');
            before.push_str(line);
            if line.contains('#') {
                let whole = open.take().unwrap_or_default();
                push(&mut groups, &whole);
            }
            continue;
        }
        if in_block {
            in_block = !line.to_ascii_uppercase().starts_with("END_FUNCTION_BLOCK");
            continue;
        }
        if in_section {
            in_section = !line.to_ascii_uppercase().starts_with("END_VAR");
            if !in_section {
                groups.push(Vec::new());
            }
            continue;
        }
        if line.to_ascii_uppercase().starts_with("FUNCTION_BLOCK") {
            in_block = true;
            groups.push(Vec::new());
        } else if line.to_ascii_uppercase().starts_with("VAR") {
            in_section = !line.to_ascii_uppercase().contains("END_VAR");
            groups.push(Vec::new());
        } else if line.is_empty() || line == "|" {
            groups.push(Vec::new());
        } else if line.starts_with('#') {
            match line.matches('#').count() % 2 {
                0 => push(&mut groups, line),
                _ => open = Some(line.to_owned()),
            }
        }
    }
    groups.retain(|group| !group.is_empty());
    groups
}

fn push(groups: &mut [Vec<String>], comment: &str) {
    let Some(group) = groups.last_mut() else { return };
    for told in comment.split('#').filter(|part| !part.trim().is_empty()) {
        let told = told.trim().replace("\\x23", "#");
        if !told.starts_with("ladder:") {
            group.push(as_said(&told).to_owned());
        }
    }
}

/// A comment without what keeps it from speaking to the tools.
fn as_said(comment: &str) -> &str {
    match comment.strip_prefix("text: ") {
        Some(told) if told.starts_with("ladder:") => told,
        _ => comment,
    }
}

/// Where the comments about the program as a whole end: at its directives, or at its declarations.
pub(super) fn head_end(text: &str) -> usize {
    let directive = text.find("# ladder:");
    let section = text.find("VAR");
    let first = [directive, section].into_iter().flatten().min();
    first.unwrap_or(0)
}

impl Back<'_> {
    /// The comment in the wire right after a block.
    pub(super) fn comment_after(&self, block: &Block) -> Option<String> {
        self.comment_from(block.location.range.end().into())
    }

    /// The comment in the wire right after an offset.
    pub(super) fn comment_from(&self, end: usize) -> Option<String> {
        let rest = self.text.get(end..)?.trim_start_matches(['-', ' ', '+']);
        let length = rest.strip_prefix('#')?.find('#')? + 2;
        let told = inside(&rest[..length])?;
        (!told.starts_with("click:") && !told.contains('\n')).then_some(told)
    }
}

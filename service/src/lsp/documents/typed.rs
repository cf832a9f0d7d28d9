//! What a person is typing: the findings of a rung wait until the cursor has left it, or the person saves the file.
//!
//! A client that says where its cursor is (`ladder.cursor`) has its changes taken for typing. What is found in the network
//! of the last change is held back, since half a rung is full of errors that nobody has made yet; so are half a section of
//! declarations and half a comment. A client that says nothing gets all findings at once.
//!
//! What is found of tags is about the rest of the program too, which is still to come: it waits until the cursor has been elsewhere and
//! has come back to where the tags were written.
//!
//! An editor that saves by itself after a while does so in the middle of a rung: that ends nothing.

use std::sync::Arc;

use ladder_analysis::Finding;
use ladder_analysis::context::Context;
use ladder_documents::Revision;
use ladder_documents::position::Position;
use ladder_live::argument_of;
use ladder_syntax::{LineKind, Parse, TextRange, TextSize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::{diagnostics, pull};
use crate::lsp::answers::error;
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::typing_messages::Cursor;

/// The command by which a client says where its cursor is.
pub(crate) const CURSOR: &str = "ladder.cursor";

/// A comment that is open for this many lines was forgotten.
const LONGEST_COMMENT: u32 = 20;

/// What is found about uses that are still to come.
const RULES_ABOUT_USES: [&str; 9] = [
    "never-read",
    "never-written",
    "never-reset",
    "read-before-write",
    "set-without-reset",
    "reset-without-set",
    "unused-type",
    "unused-label",
    "unused-function",
];

/// What is found in a program that does not have all its declarations yet.
const RULE_ABOUT_DECLARATIONS: &str = "undeclared-tag";

/// The comment or the section that goes on in a line: where it begins, and where it ends if something that is not closed ends there, with
/// what is found about that.
fn begun_above(revision: &Revision, parse: &Parse, line: u32) -> Option<(TextSize, TextSize)> {
    let start = revision.line_start(line);
    if let Some(open) = parse.unclosed_comment()
        && open.start() <= start
        && line - revision.line_of(open.start()) < LONGEST_COMMENT
    {
        return Some((open.start(), start));
    }
    let line = parse.line_at(start)?;
    let section = parse
        .frame()
        .sections
        .iter()
        .rev()
        .find(|section| section.lines.start <= line)?;
    // What follows a section that is not closed is where that is noticed.
    let lines = parse.lines();
    let is_space = |line: &usize| matches!(lines[*line].kind, LineKind::Blank | LineKind::Comment);
    let next = (section.lines.end..lines.len()).find(|line| !is_space(line));
    let (last, after) = match next {
        _ if section.closed => (section.lines.end, start),
        Some(next) => (next, parse.line_start(next) + TextSize::new(1)),
        None => (lines.len(), start),
    };
    (line < last).then(|| (parse.line_start(section.lines.start), after))
}

/// The part of a text whose findings wait: the network of a line, what is begun above it, or else the line.
fn part(revision: &Revision, context: &Context, number: u32) -> TextRange {
    let start = revision.offset(Position {
        line: number,
        character: 0,
    });
    let end = revision.offset(Position {
        line: number + 1,
        character: 0,
    });
    let line = TextRange::new(start, end.max(start));
    if let Some((begun, end)) = begun_above(revision, &context.parse, number) {
        return TextRange::new(begun, line.end().max(end));
    }
    let networks = &context.networks;
    let after = networks.partition_point(|network| network.range.end() <= start);
    match networks.get(after) {
        Some(network) if network.range.start() <= start => network.range.cover(line),
        _ => line,
    }
}

/// Leaves out what is found in the part of a text that is being typed.
pub(crate) fn without_waiting(shared: &Shared, revision: &Revision, found: &mut Vec<Finding>) {
    let (written, began_empty) = shared.typed.written(&revision.uri);
    if !written.is_empty() {
        found.retain(|finding| {
            let rule = finding.rule.name();
            let waits = RULES_ABOUT_USES.contains(&rule) || began_empty && rule == RULE_ABOUT_DECLARATIONS;
            let line = || revision.line_of(finding.range.start());
            !waits || !written.contains(&line())
        });
    }
    let Some(line) = shared.typed.waiting(&revision.uri) else {
        return;
    };
    let Some((context, _)) = revision.first_context() else {
        return;
    };
    let part = part(revision, context, line);
    let is_last = part.end() == TextSize::new(revision.len() as u32);
    found.retain(|finding| {
        let at = finding.range.start();
        !(part.contains(at) || is_last && at == part.end())
    });
}

/// A document was saved: what waits is shown, if the person saved it.
pub(crate) fn saved(shared: &Arc<Shared>, uri: &str) {
    if !shared.typed.saved_itself(uri) && shared.typed.saved(uri) {
        show(shared, uri);
    }
}

fn show(shared: &Arc<Shared>, uri: &str) {
    diagnostics::look_again(shared, uri);
    pull::refresh(shared);
}

/// `ladder.cursor`: the cursor is somewhere else. What a change finds is recorded before anything is waited for, so
/// that the next change is typed too.
pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let Cursor { uri, line } = argument_of(CURSOR, params.arguments).map_err(error)?;
    let Some(line) = line else {
        if shared.typed.forget(&uri) {
            show(shared, &uri);
        }
        return Ok(LSPAny::Null);
    };
    let Some(revision) = shared.documents.get(&uri) else {
        return Ok(LSPAny::Null);
    };
    let waiting = shared.typed.follow(&revision);
    let is_back = shared.typed.came_to(&uri, line);
    let Some(waiting) = waiting else {
        if is_back {
            show(shared, &uri);
        }
        return Ok(LSPAny::Null);
    };
    let next_to = shared.clone();
    blocking(&*shared.host, move |_| {
        let stays = next_to.documents.get(&uri).is_some_and(|revision| {
            let at = TextRange::empty(revision.offset(Position { line, character: 0 }));
            let context = revision.first_context();
            context.is_some_and(|(context, _)| part(&revision, context, waiting).contains_range(at))
        });
        if !stays && next_to.typed.release(&uri) || is_back {
            show(&next_to, &uri);
        }
    })
    .await?;
    Ok(LSPAny::Null)
}

//! What a person is typing: the findings of a rung wait until the cursor has left it, or the file is saved.
//!
//! A client that says where its cursor is (`ladder.cursor`) has its changes taken for typing. What is found in the network
//! of the last change is held back, since half a rung is full of mistakes that nobody has made yet. A client that says
//! nothing gets all findings at once.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use ladder_analysis::Finding;
use ladder_analysis::context::Context;
use ladder_syntax::{TextRange, TextSize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::{diagnostics, pull};
use crate::document::Revision;
use crate::document::position::Position;
use crate::lsp::features::simulate::error;
use crate::lsp::shared::Shared;
use crate::lsp::transport::blocking::blocking;
use crate::simulation::argument_of;
use crate::typing_messages::Cursor;

/// The command by which a client says where its cursor is.
pub(crate) const CURSOR: &str = "ladder.cursor";

/// The documents whose client says where its cursor is, and the line of the change that waits to be looked at.
#[derive(Debug, Default)]
pub(crate) struct Typed(Mutex<HashMap<String, Option<u32>>>);

impl Typed {
    fn with<T>(&self, job: impl FnOnce(&mut HashMap<String, Option<u32>>) -> T) -> T {
        job(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// A document was changed.
    pub(crate) fn changed(&self, revision: &Revision) {
        let line = revision.line_of(revision.edited());
        self.with(|typed| {
            if let Some(waiting) = typed.get_mut(&*revision.uri) {
                *waiting = Some(line);
            }
        });
    }

    /// A client says where its cursor is in a document. Gives the line of the change that waits there.
    fn follow(&self, uri: &str) -> Option<u32> {
        self.with(|typed| *typed.entry(uri.to_owned()).or_default())
    }

    /// The line of the change that waits.
    fn waiting(&self, uri: &str) -> Option<u32> {
        self.with(|typed| typed.get(uri).copied().flatten())
    }

    /// Nothing waits any longer; whether something did.
    fn release(&self, uri: &str) -> bool {
        self.with(|typed| typed.get_mut(uri).is_some_and(|waiting| waiting.take().is_some()))
    }

    /// A document was closed.
    pub(crate) fn forget(&self, uri: &str) {
        self.with(|typed| typed.remove(uri));
    }
}

/// The part of a text whose findings wait: the network of a line, or else the line.
fn part(revision: &Revision, context: &Context, line: u32) -> TextRange {
    let start = revision.offset(Position { line, character: 0 });
    let end = revision.offset(Position {
        line: line + 1,
        character: 0,
    });
    let line = TextRange::new(start, end.max(start));
    let networks = &context.networks;
    let number = networks.partition_point(|network| network.range.end() <= start);
    match networks.get(number) {
        Some(network) if network.range.start() <= start => network.range.cover(line),
        _ => line,
    }
}

/// Leaves out what is found in the part of a text that is being typed.
pub(crate) fn without_waiting(shared: &Shared, revision: &Revision, found: &mut Vec<Finding>) {
    let Some(line) = shared.typed.waiting(&revision.uri) else {
        return;
    };
    let Some(names) = revision.names() else { return };
    let part = part(revision, names.context(), line);
    let is_last = part.end() == TextSize::new(revision.len() as u32);
    found.retain(|finding| {
        let at = finding.range.start();
        !(part.contains(at) || is_last && at == part.end())
    });
}

/// A document was saved: what waits is shown.
pub(crate) fn saved(shared: &Arc<Shared>, uri: &str) {
    if shared.typed.release(uri) {
        show(shared, uri);
    }
}

fn show(shared: &Arc<Shared>, uri: &str) {
    diagnostics::look_again(shared, uri);
    pull::refresh(shared);
}

/// `ladder.cursor`: the cursor is somewhere else. What a change finds is recorded before anything is waited for, so
/// that the next change is one of somebody who types.
pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let Cursor { uri, line } = argument_of(CURSOR, params.arguments).map_err(error)?;
    let Some(line) = line else {
        if shared.typed.release(&uri) {
            show(shared, &uri);
        }
        shared.typed.forget(&uri);
        return Ok(LSPAny::Null);
    };
    let Some(waiting) = shared.typed.follow(&uri) else {
        return Ok(LSPAny::Null);
    };
    let beside = shared.clone();
    blocking(move |_| {
        let stays = beside.documents.get(&uri).is_some_and(|revision| {
            let at = TextRange::empty(revision.offset(Position { line, character: 0 }));
            let names = revision.names();
            names.is_some_and(|names| part(&revision, names.context(), waiting).contains_range(at))
        });
        if !stays && beside.typed.release(&uri) {
            show(&beside, &uri);
        }
    })
    .await?;
    Ok(LSPAny::Null)
}

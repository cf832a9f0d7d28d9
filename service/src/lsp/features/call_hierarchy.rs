//! `textDocument/prepareCallHierarchy`, `callHierarchy/incomingCalls` and `outgoingCalls`.

use std::str::FromStr;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    CallHierarchyIncomingCall, CallHierarchyIncomingCallsParams, CallHierarchyItem,
    CallHierarchyOutgoingCall, CallHierarchyOutgoingCallsParams, CallHierarchyPrepareParams, SymbolKind, Uri,
};

use super::asked::{Asked, Places, about, about_place};
use crate::lsp::session::shared::Shared;
use ladder_ide::{Caller, CallerKind, Calls, Target, callers_at, incoming_calls, outgoing_calls};
use ladder_syntax::TextRange;

/// What an item carries back to the server: the file may not be open, so that its address alone says little.
#[derive(Debug, Serialize, Deserialize)]
struct Origin {
    /// The document that was asked first.
    asked: String,
    /// The item's file, by its name in the workspace.
    file: String,
}

pub(crate) async fn prepare(
    shared: &Arc<Shared>,
    params: CallHierarchyPrepareParams,
) -> Result<Option<Vec<CallHierarchyItem>>> {
    about_place(shared, params.text_document_position_params, |asked, offset| {
        let found = callers_at(&asked.context, offset, &asked.elsewhere);
        let mut places = Places::of(asked);
        let items: Vec<_> = found
            .iter()
            .filter_map(|it| item(asked, &mut places, it))
            .collect();
        (!items.is_empty()).then_some(items)
    })
    .await
}

pub(crate) async fn incoming(
    shared: &Arc<Shared>,
    params: CallHierarchyIncomingCallsParams,
) -> Result<Option<Vec<CallHierarchyIncomingCall>>> {
    of_item(shared, params.item, |asked, caller| {
        let mut places = Places::of(asked);
        let call = |calls: Calls| {
            let ranges = calls.places.iter();
            let file = &calls.other.target.file;
            Some(CallHierarchyIncomingCall {
                from_ranges: ranges.filter_map(|it| places.range(file, *it)).collect(),
                from: item(asked, &mut places, &calls.other)?,
            })
        };
        let calls = incoming_calls(&asked.context, caller, &asked.elsewhere);
        calls.into_iter().filter_map(call).collect()
    })
    .await
}

pub(crate) async fn outgoing(
    shared: &Arc<Shared>,
    params: CallHierarchyOutgoingCallsParams,
) -> Result<Option<Vec<CallHierarchyOutgoingCall>>> {
    of_item(shared, params.item, |asked, caller| {
        let mut places = Places::of(asked);
        let call = |calls: Calls| {
            let ranges = calls.places.iter();
            let file = &caller.target.file;
            Some(CallHierarchyOutgoingCall {
                from_ranges: ranges.filter_map(|it| places.range(file, *it)).collect(),
                to: item(asked, &mut places, &calls.other)?,
            })
        };
        let calls = outgoing_calls(&asked.context, caller, &asked.elsewhere);
        calls.into_iter().filter_map(call).collect()
    })
    .await
}

/// Does a job about an item that the client sends back.
async fn of_item<T: Send + 'static>(
    shared: &Arc<Shared>,
    item: CallHierarchyItem,
    job: impl FnOnce(&Asked, &Caller) -> Vec<T> + Send + 'static,
) -> Result<Option<Vec<T>>> {
    let Some(origin) = item.data.and_then(|data| Origin::deserialize(data).ok()) else {
        return Ok(None);
    };
    let Ok(uri) = Uri::from_str(&origin.asked) else {
        return Ok(None);
    };
    let caller = Caller {
        kind: match item.kind {
            SymbolKind::FUNCTION => CallerKind::Function,
            SymbolKind::CLASS => CallerKind::Block,
            _ => CallerKind::Program,
        },
        name: item.name,
        // Only the file counts: the text may have moved since.
        target: Target {
            file: Arc::from(origin.file),
            range: TextRange::default(),
            focus: TextRange::default(),
        },
    };
    about(shared, &uri, move |asked| Some(job(asked, &caller))).await
}

fn item(asked: &Asked, places: &mut Places<'_>, caller: &Caller) -> Option<CallHierarchyItem> {
    let target = &caller.target;
    let place = places.location(&target.file, target.range)?;
    let origin = Origin {
        asked: asked.revision.uri.to_string(),
        file: target.file.to_string(),
    };
    Some(CallHierarchyItem {
        name: caller.name.clone(),
        kind: match caller.kind {
            CallerKind::Program => SymbolKind::MODULE,
            CallerKind::Function => SymbolKind::FUNCTION,
            CallerKind::Block => SymbolKind::CLASS,
        },
        tags: None,
        detail: Some(target.file.to_string()),
        uri: place.uri,
        range: place.range,
        selection_range: places.range(&target.file, target.focus)?,
        data: serde_json::to_value(origin).ok(),
    })
}

//! `textDocument/documentSymbol` and `workspace/symbol`.

use std::collections::HashSet;
use std::sync::Arc;

use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, SymbolInformation, SymbolKind,
    Uri, WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

use super::asked::{Asked, Places, about};
use crate::document::Revision;
use crate::document::elsewhere::Elsewhere;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, shared::Shared};
use ladder_ide::{OutlineKind, Outlined, outline, workspace_symbols};

pub(crate) async fn document_symbols(
    shared: &Arc<Shared>,
    params: DocumentSymbolParams,
) -> Result<Option<DocumentSymbolResponse>> {
    let nested = shared.agreed().nested_symbols;
    about(shared, &params.text_document.uri, move |asked| {
        let found = outline(&asked.context);
        Some(if nested {
            DocumentSymbolResponse::Nested(found.iter().map(|it| symbol(&asked.revision, it)).collect())
        } else {
            let mut flat = Vec::new();
            let uri = convert::uri(&asked.revision.uri)?;
            flatten(&asked.revision, &uri, &found, None, &mut flat);
            DocumentSymbolResponse::Flat(flat)
        })
    })
    .await
}

/// The names of all workspaces that have an open document.
pub(crate) async fn symbols(
    shared: &Arc<Shared>,
    params: WorkspaceSymbolParams,
) -> Result<Option<WorkspaceSymbolResponse>> {
    let (documents, companions) = (Arc::clone(&shared.documents), Arc::clone(&shared.companions));
    blocking(move |cancel| {
        let mut found = Vec::new();
        let mut seen: HashSet<Arc<str>> = HashSet::new();
        for revision in documents.all() {
            if cancel.is_cancelled() {
                break;
            }
            let elsewhere = Elsewhere::of(&revision, &documents, &companions, cancel);
            if seen.contains(&revision.uri) {
                continue;
            }
            seen.insert(Arc::clone(&revision.uri));
            seen.extend(elsewhere.open().map(|other| Arc::clone(&other.uri)));
            let Some(names) = revision.names() else {
                continue;
            };
            let asked = Asked {
                context: Arc::clone(names.context()),
                revision,
                elsewhere,
            };
            let mut places = Places::of(&asked);
            for named in workspace_symbols(&params.query, &asked.context, &asked.elsewhere) {
                if let Some(location) = places.location(&named.file, named.range) {
                    found.push(information(named.name, named.kind, location, named.container));
                }
            }
        }
        Some(WorkspaceSymbolResponse::Flat(found))
    })
    .await
}

fn symbol(revision: &Revision, item: &Outlined) -> DocumentSymbol {
    let children: Vec<_> = item.children.iter().map(|it| symbol(revision, it)).collect();
    #[allow(deprecated)]
    DocumentSymbol {
        name: item.name.clone(),
        detail: item.detail.clone(),
        kind: kind(item.kind),
        tags: None,
        deprecated: None,
        range: convert::range_in(revision, item.range),
        selection_range: convert::range_in(revision, item.focus),
        children: (!children.is_empty()).then_some(children),
    }
}

fn flatten(
    revision: &Revision,
    uri: &Uri,
    items: &[Outlined],
    container: Option<&str>,
    out: &mut Vec<SymbolInformation>,
) {
    for item in items {
        let location = Location {
            uri: uri.clone(),
            range: convert::range_in(revision, item.range),
        };
        let of = container.map(str::to_owned);
        out.push(information(item.name.clone(), item.kind, location, of));
        flatten(revision, uri, &item.children, Some(&item.name), out);
    }
}

fn information(
    name: String,
    what: OutlineKind,
    location: Location,
    container_name: Option<String>,
) -> SymbolInformation {
    #[allow(deprecated)]
    SymbolInformation {
        name,
        kind: kind(what),
        tags: None,
        deprecated: None,
        location,
        container_name,
    }
}

fn kind(kind: OutlineKind) -> SymbolKind {
    match kind {
        OutlineKind::Section => SymbolKind::NAMESPACE,
        OutlineKind::Tag => SymbolKind::VARIABLE,
        OutlineKind::Constant => SymbolKind::CONSTANT,
        OutlineKind::Parameter => SymbolKind::PROPERTY,
        OutlineKind::Network => SymbolKind::OBJECT,
        OutlineKind::Label => SymbolKind::KEY,
        OutlineKind::Function => SymbolKind::FUNCTION,
        OutlineKind::Block => SymbolKind::CLASS,
    }
}

//! `textDocument/documentSymbol` and `workspace/symbol`.

use std::collections::HashSet;
use std::sync::Arc;

use serde::{Serialize, Serializer};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, SymbolInformation, SymbolKind,
    WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

use super::asked::{Asked, Places, about};
use super::of_scenarios::{about_scenarios, scenarios_at};
use crate::document::Revision;
use crate::document::elsewhere::Elsewhere;
use crate::document::positions::Positions;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::transport::prepared;
use crate::lsp::{convert, shared::Shared};
use ladder_ide::{OutlineKind, Outlined, ScenarioPart, outline, workspace_symbols};

pub(crate) async fn document_symbols(
    shared: &Arc<Shared>,
    params: DocumentSymbolParams,
) -> Result<Option<DocumentSymbolResponse>> {
    let nested = shared.agreed().nested_symbols;
    if let Some(revision) = scenarios_at(shared, &params.text_document.uri) {
        return about_scenarios(shared, revision, move |scenarios| {
            let parts = ladder_ide::scenario_outline(&scenarios.read());
            of_scenarios(&scenarios.revision, parts, nested)
        })
        .await;
    }
    let text = about(shared, &params.text_document.uri, move |asked| {
        let found = outline(&asked.context);
        let positions = asked.revision.positions();
        if nested {
            // Two or three times as long as the program: not to be moved again and again while it grows.
            let mut json = Vec::with_capacity(asked.revision.len() * 3);
            serde_json::to_writer(&mut json, &Symbols(&found, &positions)).ok()?;
            return String::from_utf8(json).ok();
        }
        let mut flat = Vec::new();
        flatten(&found, None, &mut flat);
        let uri = &asked.revision.uri;
        let flat = flat.into_iter().map(|(item, container_name)| FlatSymbol {
            name: &item.name,
            kind: kind(item.kind),
            location: FlatLocation {
                uri,
                range: positions.range(item.range),
            },
            container_name,
        });
        let mut json = Vec::with_capacity(asked.revision.len() * 3);
        serde_json::Serializer::new(&mut json).collect_seq(flat).ok()?;
        String::from_utf8(json).ok()
    });
    match text.await? {
        Some(text) => prepared::answer(text),
        None => Ok(None),
    }
}

/// The scenarios of a file with their rows, or flat.
fn of_scenarios(
    revision: &Revision,
    parts: Vec<ScenarioPart>,
    nested: bool,
) -> Option<DocumentSymbolResponse> {
    if nested {
        let symbols = parts
            .into_iter()
            .map(|part| scenario_symbol(revision, part, SymbolKind::METHOD));
        return Some(DocumentSymbolResponse::Nested(symbols.collect()));
    }
    let uri = convert::uri(&revision.uri)?;
    let flat = parts.into_iter().map(|part| {
        #[allow(deprecated)]
        SymbolInformation {
            name: part.name,
            kind: SymbolKind::METHOD,
            tags: None,
            deprecated: None,
            location: Location {
                uri: uri.clone(),
                range: convert::range_in(revision, part.range),
            },
            container_name: None,
        }
    });
    Some(DocumentSymbolResponse::Flat(flat.collect()))
}

fn scenario_symbol(revision: &Revision, part: ScenarioPart, kind: SymbolKind) -> DocumentSymbol {
    let children = part.children.into_iter();
    let children: Vec<_> = children
        .map(|row| scenario_symbol(revision, row, SymbolKind::VARIABLE))
        .collect();
    #[allow(deprecated)]
    DocumentSymbol {
        name: part.name,
        detail: Some(part.detail),
        kind,
        tags: None,
        deprecated: None,
        range: convert::range_in(revision, part.range),
        selection_range: convert::range_in(revision, part.focus),
        children: (!children.is_empty()).then_some(children),
    }
}

/// As [`DocumentSymbol`]s.
struct Symbols<'s>(&'s [Outlined], &'s Positions);

impl Serialize for Symbols<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let Symbols(items, positions) = *self;
        serializer.collect_seq(items.iter().map(|item| Symbol {
            name: &item.name,
            detail: item.detail.as_deref(),
            kind: kind(item.kind),
            range: positions.range(item.range),
            selection_range: positions.range(item.focus),
            children: (!item.children.is_empty()).then_some(Symbols(&item.children, positions)),
        }))
    }
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Symbol<'s> {
    name: &'s str,
    #[serde(skip_serializing_if = "Option::is_none")]
    detail: Option<&'s str>,
    kind: SymbolKind,
    range: crate::Range,
    selection_range: crate::Range,
    #[serde(skip_serializing_if = "Option::is_none")]
    children: Option<Symbols<'s>>,
}

/// As [`SymbolInformation`], for clients that know no tree.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct FlatSymbol<'s> {
    name: &'s str,
    kind: SymbolKind,
    location: FlatLocation<'s>,
    #[serde(skip_serializing_if = "Option::is_none")]
    container_name: Option<&'s str>,
}

#[derive(Serialize)]
struct FlatLocation<'s> {
    uri: &'s str,
    range: crate::Range,
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

/// Each item with the name of the one that holds it.
fn flatten<'o>(
    items: &'o [Outlined],
    container: Option<&'o str>,
    out: &mut Vec<(&'o Outlined, Option<&'o str>)>,
) {
    for item in items {
        out.push((item, container));
        flatten(&item.children, Some(&item.name), out);
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

//! `textDocument/documentSymbol` and `workspace/symbol`.

use std::collections::HashSet;
use std::sync::Arc;

use ladder_documents::Revision;
use ladder_documents::other_files::OtherFiles;
use ladder_documents::positions::Positions;
use ladder_ide::{OutlineKind, Outlined, ScenarioPart, outline, workspace_symbols};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, SymbolInformation, SymbolKind,
    Uri, WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

use super::asked::{Asked, Places, about};
use super::of_scenarios::{about_scenarios, scenarios_at};
use crate::lsp::transport::answered::as_text;
use crate::lsp::transport::blocking::blocking;
use crate::lsp::{convert, session::shared::Shared};

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
    about(shared, &params.text_document.uri, move |asked| {
        let found = outline(&asked.context);
        let positions = asked.revision.positions();
        if nested {
            return Some(DocumentSymbolResponse::Nested(tree(found, &positions)));
        }
        let mut flat = Vec::new();
        flatten(
            found,
            None,
            &convert::uri(&asked.revision.uri)?,
            &positions,
            &mut flat,
        );
        Some(DocumentSymbolResponse::Flat(flat))
    })
    .await
    .map(as_text)
}

/// The scenarios of a file with their rows and its properties, or flat.
fn of_scenarios(
    revision: &Revision,
    parts: Vec<ScenarioPart>,
    nested: bool,
) -> Option<DocumentSymbolResponse> {
    if nested {
        let symbols = parts.into_iter().map(|part| scenario_symbol(revision, part));
        return Some(DocumentSymbolResponse::Nested(symbols.collect()));
    }
    let uri = convert::uri(&revision.uri)?;
    let flat = parts.into_iter().map(|part| {
        #[allow(deprecated)]
        SymbolInformation {
            kind: kind_of_part(&part),
            name: part.name,
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

const fn kind_of_part(part: &ScenarioPart) -> SymbolKind {
    if part.is_property {
        SymbolKind::PROPERTY
    } else {
        SymbolKind::METHOD
    }
}

fn scenario_symbol(revision: &Revision, part: ScenarioPart) -> DocumentSymbol {
    let kind = kind_of_part(&part);
    let children = part.children.into_iter().map(|row| DocumentSymbol {
        kind: SymbolKind::VARIABLE,
        ..scenario_symbol(revision, row)
    });
    let children: Vec<_> = children.collect();
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

fn tree(items: Vec<Outlined>, positions: &Positions) -> Vec<DocumentSymbol> {
    let symbol = |item: Outlined| {
        let children = tree(item.children, positions);
        #[allow(deprecated)]
        DocumentSymbol {
            name: item.name.into(),
            detail: item.detail.map(Into::into),
            kind: kind(item.kind),
            tags: None,
            deprecated: None,
            range: convert::range(positions.range(item.range)),
            selection_range: convert::range(positions.range(item.focus)),
            children: (!children.is_empty()).then_some(children),
        }
    };
    items.into_iter().map(symbol).collect()
}

/// The names of all workspaces that have an open document.
pub(crate) async fn symbols(
    shared: &Arc<Shared>,
    params: WorkspaceSymbolParams,
) -> Result<Option<WorkspaceSymbolResponse>> {
    let (documents, companions) = (Arc::clone(&shared.documents), Arc::clone(&shared.companions));
    blocking(&*shared.host, move |cancel| {
        let mut found = Vec::new();
        let mut seen: HashSet<Arc<str>> = HashSet::new();
        for revision in documents.all() {
            if cancel.is_cancelled() {
                break;
            }
            let elsewhere = OtherFiles::of(&revision, &documents, &companions, cancel);
            if seen.contains(&revision.uri) {
                continue;
            }
            seen.insert(Arc::clone(&revision.uri));
            seen.extend(elsewhere.open().map(|other| Arc::clone(&other.uri)));
            let Some(context) = revision.context() else {
                continue;
            };
            let asked = Asked {
                context: Arc::clone(context),
                revision,
                elsewhere,
                knows_others: true,
                // Names of the workspace are no blocks of the library.
                opens_library: false,
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

/// For clients that know no tree: each item with the name of the one that holds it.
fn flatten(
    items: Vec<Outlined>,
    container: Option<&str>,
    uri: &Uri,
    positions: &Positions,
    out: &mut Vec<SymbolInformation>,
) {
    for item in items {
        let location = Location {
            uri: uri.clone(),
            range: convert::range(positions.range(item.range)),
        };
        out.push(information(
            item.name.to_string(),
            item.kind,
            location,
            container.map(str::to_owned),
        ));
        flatten(item.children, Some(&item.name), uri, positions, out);
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
        OutlineKind::Type => SymbolKind::STRUCT,
        OutlineKind::Enumeration => SymbolKind::ENUM,
        OutlineKind::Member => SymbolKind::FIELD,
        OutlineKind::Value => SymbolKind::ENUM_MEMBER,
        OutlineKind::Network => SymbolKind::OBJECT,
        OutlineKind::Label => SymbolKind::KEY,
        OutlineKind::Function => SymbolKind::FUNCTION,
        OutlineKind::Block => SymbolKind::CLASS,
    }
}

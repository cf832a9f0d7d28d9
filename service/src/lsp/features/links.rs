//! `textDocument/documentLink`: what comments name on the web, and the files next to the document that there are.

use std::sync::Arc;

use ladder_documents::address;
use ladder_ide::{LinkTarget, links};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{DocumentLink, DocumentLinkParams};

use super::asked::about;
use crate::lsp::{convert, session::shared::Shared};

pub(crate) async fn document_links(
    shared: &Arc<Shared>,
    params: DocumentLinkParams,
) -> Result<Option<Vec<DocumentLink>>> {
    about(shared, &params.text_document.uri, |asked| {
        let place = asked.revision.place();
        let found = links(&asked.context).into_iter().filter_map(|link| {
            let address = match &link.to {
                LinkTarget::Web(address) => address.clone(),
                LinkTarget::File(name) => {
                    let place = place?;
                    let disk = place.neighbours.disk();
                    let file = disk.locate(&disk.named_in(&place.path, name)).ok()?;
                    disk.is_file(&file).then(|| address::uri_of(&file))?
                }
            };
            Some(DocumentLink {
                range: convert::range_in(&asked.revision, link.range),
                target: Some(convert::uri(&address)?),
                tooltip: None,
                data: None,
            })
        });
        Some(found.collect())
    })
    .await
}

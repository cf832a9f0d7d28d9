//! `ladder.crossReference`: where each tag of an open program is read and written. `docs/protocol.md` shows the messages.

use std::sync::Arc;

use ladder_analysis::{TagEntry, TagPlace, cross_reference};
use ladder_documents::Revision;
use ladder_documents::position::Range;
use ladder_documents::positions::Positions;
use ladder_live::{Failure, argument_of};
use serde::{Deserialize, Serialize};
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use crate::lsp::answers::{error, json};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const CROSS_REFERENCE: &str = "ladder.crossReference";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let asked: CrossReference = argument_of(CROSS_REFERENCE, params.arguments).map_err(error)?;
    let failed = |message: String| error(Failure::Failed(message));
    let revision = shared.documents.get(&asked.uri);
    let revision = revision.ok_or_else(|| failed(format!("{} is not open in the editor", asked.uri)))?;
    let name = revision.name().to_owned();
    let listed = blocking(&*shared.host, move |_| list(&revision, &asked)).await?;
    json(&listed.ok_or_else(|| failed(format!("{name} is too large for a cross-reference")))?)
}

/// The argument of `ladder.crossReference`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct CrossReference {
    /// The program, which must be open.
    pub uri: String,
}

/// The answer to `ladder.crossReference`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct CrossReferenced {
    /// The program.
    pub uri: String,
    /// The version of its text.
    pub version: i32,
    /// Its tags, by their names; those of blocks after them.
    pub tags: Vec<ReferencedTag>,
}

/// A tag.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ReferencedTag {
    /// As declared, or as first written.
    pub name: String,
    /// The user-defined block in whose body it is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub block: Option<String>,
    /// Its type.
    #[serde(rename = "type")]
    pub ty: String,
    /// `input`, `output`, `internal` or `constant`.
    pub kind: String,
    /// Its direct address.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub address: Option<String>,
    /// What the comment at its declaration says.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub comment: String,
    /// Whether it is declared.
    pub declared: bool,
    /// Its declaration, or where it is used first.
    pub range: Range,
    /// Where it is used, from top to bottom.
    pub places: Vec<ReferencedPlace>,
}

/// A place where a tag is used.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ReferencedPlace {
    /// `read`, `write`, `set`, `reset` or `read and write`.
    pub does: String,
    /// The number of the network, from 1.
    pub network: usize,
    /// The tag's name there.
    pub range: Range,
}

/// The tags of a program; none of one that is too large.
pub(crate) fn list(revision: &Revision, asked: &CrossReference) -> Option<CrossReferenced> {
    let entries = cross_reference(revision.context()?);
    let positions = revision.positions();
    Some(CrossReferenced {
        uri: asked.uri.clone(),
        version: revision.version,
        tags: entries.into_iter().map(|entry| tag(entry, &positions)).collect(),
    })
}

fn tag(entry: TagEntry, positions: &Positions) -> ReferencedTag {
    let place = |place: &TagPlace| ReferencedPlace {
        does: place.access.words().to_owned(),
        network: place.network,
        range: positions.range(place.range),
    };
    ReferencedTag {
        name: entry.name,
        block: entry.block,
        ty: entry.ty,
        kind: entry.kind.word().to_owned(),
        address: entry.address,
        comment: entry.comment,
        declared: entry.declared.is_some(),
        range: positions.range(entry.range),
        places: entry.places.iter().map(place).collect(),
    }
}

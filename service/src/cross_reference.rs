//! The cross-reference of an open program: each tag, with the places that read, write, set and reset it. `docs/protocol.md`
//! shows the messages.

use ladder_analysis::{TagEntry, TagPlace, cross_reference};
use serde::{Deserialize, Serialize};

use crate::document::Revision;
use crate::document::position::Range;
use crate::document::positions::Positions;

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

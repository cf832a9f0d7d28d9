//! Why a tag holds what it holds: a tree that leads from the tag to what was given from outside.

use ladder_documents::position::Range;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::shortest;

/// The answer of `ladder.simulate.why`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Why {
    /// The tag, as declared.
    pub tag: String,
    /// The reasons, a line for each tag; what lies deeper is indented.
    pub text: String,
    /// The blocks that the first line is about: the one that wrote the tag, then those that passed power on to it
    /// or blocked it.
    pub blocks: Vec<Range>,
    /// The same as a tree.
    pub reason: TagReason,
}

/// Why a tag holds its value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct TagReason {
    /// The tag, or the member or element of one.
    pub tag: String,
    /// Its type.
    #[serde(rename = "type")]
    pub kind: String,
    /// What it held at that moment.
    pub value: Value,
    /// Since when.
    pub since: Since,
    /// Through what.
    pub cause: CauseKind,
    /// The same as one sentence, without what lies deeper.
    pub text: String,
    /// The block that wrote it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub write: Option<WriteReason>,
    /// For what is off since an earlier scan: what keeps it off now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub now: Option<WriteReason>,
}

/// Since when a tag holds its value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "camelCase", deny_unknown_fields)]
pub enum Since {
    /// It has held no other.
    Start {},
    /// Since before the scans that are kept.
    Longer {},
    /// Since this scan.
    #[serde(rename_all = "camelCase")]
    Scan {
        /// Its number, from 0.
        scan: u64,
        /// Its clock, in milliseconds.
        #[serde(serialize_with = "shortest")]
        time_ms: f64,
    },
}

/// What made a tag hold its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum CauseKind {
    /// Nothing has written it.
    Initial,
    /// It was given from outside.
    Given,
    /// It is forced.
    Forced,
    /// The simulation itself keeps it.
    System,
    /// What wrote it is not known any more.
    Unknown,
    /// A block wrote it: `write`.
    Block,
}

/// A block that wrote a tag.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct WriteReason {
    /// The scan in which it did, from 0.
    pub scan: u64,
    /// The file, where it is not the document itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uri: Option<String>,
    /// Where the block is.
    pub range: Range,
    /// The block as it is drawn.
    pub block: String,
    /// Whether power reached it.
    pub power: bool,
    /// With power: one list, of the blocks that passed it on, from left to right. Without: each list is one way in
    /// which power would reach the block, if all blocks of that list let it pass.
    pub ways: Vec<Vec<PassOrStop>>,
    /// What it made its result of, where it writes more than its power.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub read: Vec<Reading>,
    /// Why that was so.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub because: Vec<TagReason>,
}

/// A block that passes power on, or stops it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PassOrStop {
    /// The file, where it is not the document itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uri: Option<String>,
    /// Where it is; of a rail the network.
    pub range: Range,
    /// The block as it is drawn; nothing for a rail.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub block: Option<String>,
    /// Whether it stops power, or else passes it on.
    pub stops: bool,
    /// The block, its place and what it checked, for people.
    pub text: String,
    /// What it checked, with the values of that moment.
    pub values: Vec<Reading>,
    /// Why these were so, as far as that was followed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub because: Vec<TagReason>,
}

/// A value that a block checked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Reading {
    /// The tag, or the member or element of one.
    pub tag: String,
    /// Its type.
    #[serde(rename = "type")]
    pub kind: String,
    /// What it held.
    pub value: Value,
}

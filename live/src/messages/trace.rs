//! The trace of chosen tags, as a client draws it.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::shortest;

/// The argument of `ladder.simulate.goTo`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct GoTo {
    /// The session.
    pub session: String,
    /// The scan, as a state counts them.
    pub scan: u64,
}

/// The argument of `ladder.simulate.trace`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Trace {
    /// The session.
    pub session: String,
    /// The tags that are recorded from now on, and no others.
    pub tags: Vec<String>,
    /// How many scans are drawn; all that are recorded unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub span: Option<u64>,
    /// The last of them; the newest unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub last: Option<u64>,
    /// In no more columns than this many; 1000 unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub columns: Option<u64>,
    /// Only the columns from that of this scan on; all of them unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub since: Option<u64>,
    /// This many ticks for the time, more or less; 8 unless given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ticks: Option<u64>,
    /// Scans whose values are to be read, two at most.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cursors: Vec<u64>,
}

/// The answer of `ladder.simulate.trace`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Traced {
    /// Changes whenever columns that were given before are not so any more.
    pub revision: u64,
    /// The time from scan to scan, in milliseconds.
    #[serde(serialize_with = "shortest")]
    pub interval_ms: f64,
    /// The first scan that is drawn.
    pub first: u64,
    /// The last scan that is drawn; it may lie after the newest.
    pub last: u64,
    /// How many scans a column stands for.
    pub per: u64,
    /// The oldest scan that is recorded.
    pub oldest: u64,
    /// The newest scan that is recorded.
    pub newest: u64,
    /// The scan that the simulation is after.
    pub here: u64,
    /// The scans that one can go to.
    pub reach: Reach,
    /// Of the time.
    pub ticks: Vec<Tick>,
    /// The cursors that were asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cursors: Option<Cursors>,
    /// The tags, in the order in which they were asked for.
    pub tags: Vec<TraceTag>,
}

/// Scans that follow one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Reach {
    /// The first of them.
    pub first: u64,
    /// The last of them.
    pub last: u64,
}

/// A tick of an axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Tick {
    /// Where: the scan, or a part of one; the value.
    #[serde(serialize_with = "shortest")]
    pub at: f64,
    /// What it says.
    pub text: String,
}

/// The times of the cursors.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Cursors {
    /// Of each its time, as in `1s500ms`.
    pub times: Vec<String>,
    /// From the first to the second, with its sign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub difference: Option<String>,
}

/// What is drawn of a tag.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct TraceTag {
    /// Its name, as declared.
    pub name: String,
    /// Its type.
    #[serde(rename = "type", default, skip_serializing_if = "String::is_empty")]
    pub type_name: String,
    /// How it is drawn.
    pub kind: TracedKind,
    /// What it holds now.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub now: Option<String>,
    /// The first scan that is known of it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub oldest: Option<u64>,
    /// The least and the greatest number that is recorded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<[Value; 2]>,
    /// Of its scale.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub ticks: Vec<Tick>,
    /// What is drawn, from the column with that number on.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<TraceColumn>,
    /// What it held at the cursors, in words; null where that is not known.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub readings: Vec<Option<String>>,
    /// How much more it held at the second cursor than at the first, with its sign.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub difference: Option<String>,
}

/// How a tag is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum TracedKind {
    /// As a waveform.
    Bit,
    /// As a line over a scale.
    Number,
    /// As words in a band.
    Text,
    /// Not at all: the program has no such tag.
    Unknown,
}

/// The number of a column, and what is drawn there and in those after it up to the next that is listed: of a BOOL 0, 1, or 2
/// where it was both; of a number the least, the greatest and the last value; of a text the last one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum TraceColumn {
    /// A number.
    Number(u64, Value, Value, Value),
    /// A BOOL, or a text.
    Single(u64, Value),
}

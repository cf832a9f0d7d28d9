//! What travels between editor and simulator. `docs/protocol.md` shows each message.

mod debug;
mod scene;
mod shown;
mod state;
mod trace;
mod why;

use std::collections::BTreeMap;

use ladder_documents::position::Range;
use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

pub use debug::{Debug, Debugged, DebuggerMessage};
pub use ladder_documents::Lines;
pub use scene::{
    SceneAct, SceneActKind, SceneAsked, SceneNode, SceneRow, SceneShown, SceneSlot, SceneValues,
};
pub use shown::{Contact, Found, Label, Operand, Search, Show, Shown, Side};
pub use state::{Breakpoint, Controller, Fault, Hit, Lost, Power, ProgramChange, Role, State, Status, Tag};
pub use trace::{Cursors, GoTo, Reach, Tick, Trace, TraceColumn, TraceTag, Traced, TracedKind};
pub use why::{CauseKind, PassOrStop, Reading, Since, TagReason, Why, WriteReason};

/// The argument of `ladder.simulate.start`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Start {
    /// The document to run, which must be open.
    pub uri: String,
    /// How to run it.
    #[serde(default)]
    pub options: Options,
}

/// How a simulation runs.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Options {
    /// The time that one scan stands for, in milliseconds; 10 unless given.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        serialize_with = "shortest_if_any"
    )]
    pub interval_ms: Option<f64>,
    /// Values of inputs from the first scan on.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub inputs: BTreeMap<String, Value>,
    /// In the place of a simulation the controller is shown that `[online]` in `ladder.toml` names.
    #[serde(default, skip_serializing_if = "is_false")]
    pub online: bool,
    /// How many blocks a scan may evaluate before it counts as hung.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub watchdog: Option<u64>,
    /// How many scans can be stepped back.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub history: Option<u64>,
    /// The client takes notifications with only what has changed.
    #[serde(default, skip_serializing_if = "is_false")]
    pub deltas: bool,
    /// The client shows only this, and says when it has shown it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub show: Option<Shown>,
}

/// The argument of the commands that need nothing but the session.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct OfSession {
    /// The session, as `start` named it.
    pub session: String,
}

/// The argument of `ladder.simulate.step`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct StepBy {
    /// The session.
    pub session: String,
    /// How many scans; one unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scans: Option<u64>,
}

/// The argument of `ladder.simulate.breakpoints`: all of them, in the place of those before.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Breakpoints {
    /// The session.
    pub session: String,
    /// Lines of rungs, from 0. A line without a rung means the next one below.
    #[serde(default)]
    pub lines: Vec<u32>,
    /// Tags whose change stops a run.
    #[serde(default)]
    pub tags: Vec<String>,
}

/// The argument of `ladder.simulate.why` and `ladder.simulate.pulse`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct OfTag {
    /// The session.
    pub session: String,
    /// The tag, or a member as in `t1.ET`.
    pub tag: String,
}

/// The argument of `ladder.simulate.history`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Past {
    /// The session.
    pub session: String,
    /// The tags.
    pub tags: Vec<String>,
    /// Of how many scans; 100 unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scans: Option<u64>,
}

/// The argument of `ladder.simulate.run`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Run {
    /// The session.
    pub session: String,
    /// How many scans; until it is paused unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scans: Option<u64>,
    /// One scan in each interval of real time, or as fast as it goes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub real_time: Option<bool>,
    /// How many times as fast as real time: 0.1 is slow motion. Without it and `real_time` it is as fast as before.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        serialize_with = "shortest_if_any"
    )]
    pub speed: Option<f64>,
}

/// The argument of `ladder.simulate.speed`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Speed {
    /// The session.
    pub session: String,
    /// One scan in each interval of real time, or as fast as it goes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub real_time: Option<bool>,
    /// How many times as fast as real time.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        serialize_with = "shortest_if_any"
    )]
    pub speed: Option<f64>,
}

/// The argument of `ladder.simulate.serve`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Serve {
    /// The session.
    pub session: String,
    /// Whether tags are served from now on.
    pub on: bool,
}

/// The argument of `ladder.simulate.set` and `ladder.simulate.force`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Assign {
    /// The session.
    pub session: String,
    /// The tag, or a member as in `t1.ET`.
    pub tag: String,
    /// The value, as the tag's type writes it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<Value>,
    /// Or what a person typed for it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// The argument of `ladder.simulate.unforce`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Unforce {
    /// The session.
    pub session: String,
    /// The tag; all tags unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tag: Option<String>,
}

/// The answer of `ladder.simulate.start`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Started {
    /// The session's name, for all later commands.
    pub session: String,
    /// How things are before the first scan.
    pub state: State,
    /// Where the first rung is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<Range>,
    /// What a person should know, as that the retentive file was damaged.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// The argument of `ladder.simulate.record`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Record {
    /// The session.
    pub session: String,
    /// What the scenario is called; "recorded" unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The tags of which is expected what they hold; the outputs, and a few other BOOLs that change, unless given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outputs: Option<Vec<String>>,
}

/// The answer of `ladder.simulate.record`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Recorded {
    /// How a file of scenarios next to the program may be called.
    pub file: String,
    /// What it holds: one scenario.
    pub text: String,
    /// The tags of which something is expected.
    pub outputs: Vec<String>,
    /// All tags that `outputs` may have.
    pub offered: Vec<Offered>,
    /// What a person should know of it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// A tag of which a scenario can expect something.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Offered {
    /// The tag.
    pub name: String,
    /// Its type.
    #[serde(rename = "type")]
    pub kind: String,
    /// Whether it is an output of the program.
    pub output: bool,
}

/// The answer of `ladder.simulate.history`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct History {
    /// The scan of the first values.
    pub first_scan: u64,
    /// Of each tag its values after that scan and those after it, up to the last.
    pub tags: Vec<PastValues>,
}

/// What a tag held.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PastValues {
    /// Its name, as declared.
    pub name: String,
    /// Its type.
    #[serde(rename = "type")]
    pub kind: String,
    /// Its values.
    pub values: Vec<Value>,
}

/// The answer of `ladder.simulate.stop`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Stopped {
    /// The session that is no more.
    pub session: String,
    /// Always true.
    pub stopped: bool,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_false(it: &bool) -> bool {
    !it
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_zero(it: &u64) -> bool {
    *it == 0
}

#[expect(clippy::ref_option, reason = "serde asks for it")]
fn shortest_if_any<S: Serializer>(number: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    match number {
        Some(number) => shortest(number, serializer),
        None => serializer.serialize_none(),
    }
}

/// A whole number is written without a point.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn shortest<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    if number.fract() == 0.0 && number.abs() < 9e15 {
        serializer.serialize_i64(*number as i64)
    } else {
        serializer.serialize_f64(*number)
    }
}

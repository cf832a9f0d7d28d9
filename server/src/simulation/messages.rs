//! What travels between editor and simulator. `docs/protocol.md` shows each message.

mod shown;
mod trace;
mod why;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize, Serializer};
use serde_json::Value;

use crate::document::position::Range;
pub use shown::{Contact, Found, Lines, Operand, Search, Show, Shown};
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
    /// One scan in each interval of real time (which is what `true`, the default, asks for), or as fast as it goes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub real_time: Option<bool>,
    /// So many times as fast as real time: 0.1 is slow motion; 1 unless given.
    #[serde(
        default,
        skip_serializing_if = "Option::is_none",
        serialize_with = "shortest_if_any"
    )]
    pub speed: Option<f64>,
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
    pub value: Value,
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
    /// How things stand before the first scan.
    pub state: State,
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
}

/// The answer of `ladder.simulate.record`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Recorded {
    /// How a file of scenarios beside the program may be called.
    pub file: String,
    /// What it holds: one scenario.
    pub text: String,
    /// What a person should know of it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
}

/// The answer of `ladder.simulate.history`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct History {
    /// The scan of the first values.
    pub first_scan: u64,
    /// Of each tag its values after that scan and those behind it, up to the last.
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

/// How a simulation stands: the answer of every other command, and the parameters of
/// `ladder/simulationState`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct State {
    /// The session.
    pub session: String,
    /// The document it runs.
    pub uri: String,
    /// The version of the text that all ranges belong to.
    pub version: i32,
    /// That text has errors: the last program without any runs on, and is shown in the lines that are still the same.
    pub stale: bool,
    /// The last change of the program while it ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub change: Option<ProgramChange>,
    /// What it is doing.
    pub status: Status,
    /// How many scans are done.
    pub scan: u64,
    /// The simulation's clock, in milliseconds.
    #[serde(serialize_with = "shortest")]
    pub time_ms: f64,
    /// How many scans can be stepped back.
    pub behind: usize,
    /// How many scans were stepped back from and are run again by the next steps.
    pub ahead: usize,
    /// The block or rung that runs next, in the midst of a scan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub next: Option<Range>,
    /// The breakpoint that stopped the last run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hit: Option<Hit>,
    /// The breakpoints.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub breakpoints: Vec<Breakpoint>,
    /// How many tags are forced.
    pub forced: usize,
    /// `tags` and `power` hold only what has changed since the notification before.
    #[serde(default, skip_serializing_if = "is_false")]
    pub delta: bool,
    /// How many answers were given before; not sent.
    #[serde(skip)]
    pub answers: u64,
    /// For a client that says what it shows: how many commands have taken effect, this answer's own among them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub commands: Option<u64>,
    /// For a client that says what it shows: the operands in lines that it had not shown before.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub operands: Vec<Operand>,
    /// Every tag, in the order of first appearance; timers and counters as their members.
    pub tags: Vec<Tag>,
    /// Every wire, block and connector, and whether power flowed there in the last scan.
    pub power: Vec<Power>,
    /// What went wrong while it ran.
    pub faults: Vec<Fault>,
}

impl State {
    /// What has changed since an earlier state.
    pub(crate) fn since(&self, earlier: &State) -> State {
        let tags = self.tags.iter().filter(|tag| !earlier.tags.contains(tag));
        let power = self.power.iter().zip(&earlier.power);
        State {
            delta: true,
            tags: tags.cloned().collect(),
            power: power
                .filter(|(new, old)| new != old)
                .map(|(new, _)| *new)
                .collect(),
            ..self.clone()
        }
    }
}

/// A change of the program while it ran.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ProgramChange {
    /// How many changes there were, this one among them.
    pub number: u64,
    /// The first scan that ran the new program.
    pub scan: u64,
    /// What the new program could not go on with.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub lost: Vec<Lost>,
}

/// Something that was lost when the program was changed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Lost {
    /// What, and what happens instead, for people.
    pub message: String,
    /// Where, as the text was then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<Range>,
}

/// A breakpoint that stopped a run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Hit {
    /// Why, for people.
    pub message: String,
    /// The rung that runs next, or the block that changed the tag.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<Range>,
}

/// A breakpoint: on a rung or on a tag.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Breakpoint {
    /// The network.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<Range>,
    /// The tag.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tag: Option<String>,
}

/// What a simulation is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Status {
    /// Waiting for a command.
    Paused,
    /// Scanning.
    Running,
    /// The program came to its end, or the session was stopped.
    Ended,
    /// A fault stopped it: the watchdog, or calls nested too deep.
    Faulted,
}

/// One tag.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Tag {
    /// Its name, as declared or first written.
    pub name: String,
    /// Its type, as in `DINT`.
    #[serde(rename = "type")]
    pub kind: String,
    /// Its value.
    pub value: Value,
    /// Who writes it.
    pub role: Role,
    /// Whether it is held at this value.
    pub forced: bool,
    /// It can be neither set nor forced: a constant or a system tag.
    #[serde(default, skip_serializing_if = "is_false")]
    pub read_only: bool,
}

/// Who writes a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Role {
    /// The plant.
    Input,
    /// The program, for the plant.
    Output,
    /// The program, for itself.
    Internal,
}

/// Power on one element of the drawing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Power {
    /// Where the element stands.
    pub range: Range,
    /// Whether power flowed there: for a block, whether it left it.
    pub on: bool,
    /// What a contact does. Only for a client that says what it shows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact: Option<Contact>,
}

/// One thing that went wrong while the program ran.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Fault {
    /// What, and what to do.
    pub message: String,
    /// The file of the block, where that is not the document itself.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub uri: Option<String>,
    /// The block.
    pub range: Range,
    /// The scan it happened in, from 0.
    pub scan: u64,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde asks for it")]
fn is_false(it: &bool) -> bool {
    !it
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

//! How a simulation is, and what belongs to that.

use ladder_documents::position::Range;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::{Contact, Label, Operand, SceneValues, is_false, is_zero, shortest};

/// How a simulation is: the answer of every other command, and the parameters of
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
    /// The number of the change that brought the program which runs: 0 for the first one, and another one than that of the
    /// last change where it was stepped back over that.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub program: u64,
    /// What it is doing.
    pub status: Status,
    /// How it is, in words: `running, scan 12, 1.2s, 0.1x speed, 2 forced`.
    pub text: String,
    /// The controller that is watched, if it is not a simulation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub controller: Option<Controller>,
    /// Where clients on this computer are served, in words.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub served: Option<String>,
    /// How many scans are done; of a controller how many readings there were.
    pub scan: u64,
    /// The simulation's clock, in milliseconds.
    #[serde(serialize_with = "shortest")]
    pub time_ms: f64,
    /// How many scans can be stepped back.
    pub behind: usize,
    /// How many scans were stepped back from and are run again by the next steps.
    pub ahead: usize,
    /// The block or rung that runs next, within a scan.
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
    /// For a client that says what it shows: where values are shown. All of them, whenever one is at another place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labels: Option<Vec<Label>>,
    /// The scenes that are shown of it, those of which something has changed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub scenes: Vec<SceneValues>,
    /// Every tag, in the order of first appearance; timers and counters as their members.
    pub tags: Vec<Tag>,
    /// Every wire, block and connector, and whether power flowed there in the last scan.
    pub power: Vec<Power>,
    /// What went wrong while it ran.
    pub faults: Vec<Fault>,
}

impl State {
    /// What has changed since an earlier state.
    #[must_use]
    pub fn since(&self, earlier: &State) -> State {
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

/// A running controller that is watched. It is read, and never written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Controller {
    /// What it is called: `logix:192.168.1.10/0`.
    pub name: String,
    /// Whether it answers.
    pub answers: bool,
    /// How old its values are, in milliseconds; nothing before there are any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub age_ms: Option<f64>,
    /// How it is, in words.
    pub text: String,
    /// What it has not, or has otherwise than the program: a sentence each.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub differences: Vec<String>,
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
    /// Which hit of the session it is, from 1 on: a notification that comes late may repeat one that is over.
    pub number: u64,
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
    /// Its value; of one that opens an empty text.
    pub value: Value,
    /// Its value as people read it: `1`, `1.5s`, `'text'`.
    pub text: String,
    /// Who writes it.
    pub role: Role,
    /// Whether it is held at this value.
    pub forced: bool,
    /// It can be neither set nor forced: a constant or a system tag.
    #[serde(default, skip_serializing_if = "is_false")]
    pub read_only: bool,
    /// It has no value of its own, but opens into this many tags.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parts: Option<u64>,
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
    /// Where the element is.
    pub range: Range,
    /// Whether power flowed there: for a block, whether it left it.
    pub on: bool,
    /// Of a controller: that is not known, for what decides it was not read, or is over before the next reading, as an edge.
    #[serde(default, skip_serializing_if = "is_false")]
    pub unknown: bool,
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

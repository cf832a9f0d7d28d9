//! Properties that are decided for an editor: what is known of each, and the run that was found. `docs/protocol.md` shows the messages.

use serde::{Deserialize, Serialize};

#[cfg(feature = "prove")]
pub(crate) use deciding::run;
use ladder_documents::position::Range;

#[cfg(feature = "prove")]
mod deciding;

/// The argument of `ladder.proveProperties`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ProveProperties {
    /// The file of the properties.
    pub uri: String,
    /// The only property that is decided.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

/// The answer to `ladder.proveProperties`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PropertiesProved {
    /// The file of the properties.
    pub uri: String,
    /// The version of its text; none of a file that is not open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub version: Option<i32>,
    /// The program.
    pub program: String,
    /// The plants that run beside it: what is proved is about these.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub plants: Vec<String>,
    /// The outputs of those that never change.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unchanging: Vec<String>,
    /// What came of each, in the order of the file.
    pub properties: Vec<PropertyProved>,
}

/// What is known of a property.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PropertyProved {
    /// Its name.
    pub name: String,
    /// Where that is.
    pub range: Range,
    /// `proved`, `violated`, `possible`, `impossible`, `unknown` or `vacuous`.
    pub verdict: String,
    /// The sentence for people.
    pub message: String,
    /// The scan that violates or has it, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scan: Option<usize>,
    /// For which times it is proved: `any` or `exact`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub times: Option<String>,
    /// What is on its left side never happens.
    pub never_triggered: bool,
    /// Of what is proved beside a plant and is not about that: whether it was not proved without.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub needs_plant: Option<bool>,
    /// Why it is not decided, or what was left open.
    pub open: Vec<LeftOpen>,
    /// The rows of the run that was found.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub diagram: String,
    /// That run as a file of scenarios.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub scenario: String,
}

impl PropertyProved {
    /// Whether it is decided that it is not as it is to be.
    pub(crate) fn is_refuted(&self) -> bool {
        matches!(&*self.verdict, "violated" | "impossible" | "vacuous")
    }
}

/// What was left open, with its place where that is in the program's own file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct LeftOpen {
    /// The words for people.
    pub message: String,
    /// The place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<Range>,
}

/// What came of the properties of a file, and what that rests on.
#[cfg_attr(
    not(feature = "prove"),
    allow(dead_code, reason = "without the prover nothing is found")
)]
pub(crate) struct Found {
    pub(crate) properties: Vec<PropertyProved>,
    pub(crate) plants: Vec<String>,
    pub(crate) unchanging: Vec<String>,
}

/// Without the prover nothing is decided.
#[cfg(not(feature = "prove"))]
pub(crate) fn run(
    _: &crate::scenario_run::Files<'_>,
    _: &ladder_simulator::scenario::Suite,
    _: &mut ladder_simulator::Simulation,
    _: Option<&str>,
    _: ladder_host::Clock,
    _: ladder_analysis::Cancel,
) -> Result<Found, String> {
    Err("nothing is proved here; `ladder prove` does it".to_owned())
}

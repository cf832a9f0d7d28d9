//! Scenarios that are run for a client that can start no program: what came of each, and what they exercised of the program.
//! `docs/protocol.md` shows the messages.

use std::time::Duration;

use ladder_analysis::program::Location;
use ladder_simulator::coverage::{Coverage, CoverageItemKind};
use ladder_simulator::scenario::{self, Case, Ran, ScenarioError, Suite};
use ladder_simulator::{Fault, Simulation};
use serde::{Deserialize, Serialize};

use ladder_analysis::Cancel;
use ladder_documents::Revision;
use ladder_documents::position::Range;
use ladder_host::Clock;

/// An editor waits no longer for its scenarios. One that takes longer is for the command line.
const LONGEST: Duration = Duration::from_secs(10);
/// The clock is asked once for so many scans.
const SCANS_BETWEEN: u64 = 256;
/// Drawings are as wide as those of `ladder test` that go into a file.
const WIDTH: usize = 100;

/// The argument of `ladder.runScenarios`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct RunScenarios {
    /// The file of scenarios, which must be open.
    pub uri: String,
    /// Whether what they exercise is recorded.
    #[serde(default)]
    pub coverage: bool,
}

/// The answer to `ladder.runScenarios`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ScenariosRun {
    /// The file of scenarios.
    pub uri: String,
    /// The version of its text.
    pub version: i32,
    /// The program.
    pub program: String,
    /// What came of each, in the order of the file.
    pub scenarios: Vec<ScenarioRun>,
    /// What they exercised.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coverage: Option<Exercised>,
}

/// What came of one scenario.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct ScenarioRun {
    /// Its name.
    pub name: String,
    /// Where it is.
    pub range: Range,
    /// Whether all is as expected.
    pub passed: bool,
    /// How many scans it took.
    pub scans: u64,
    /// Rows that are not as expected.
    pub differences: Vec<RowDiffers>,
    /// Properties that it violates.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub violations: Vec<PropertyViolated>,
    /// Where it leaves what is assumed, in words: the properties are not watched from there on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outside: Option<String>,
    /// What went wrong in the program.
    pub faults: Vec<FaultOfScenario>,
    /// Both waveforms, with what differs.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub diagram: String,
}

/// A row that is not as expected.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct RowDiffers {
    /// The tag.
    pub tag: String,
    /// Where the values are that differ.
    pub ranges: Vec<Range>,
    /// The sentence for people.
    pub message: String,
}

/// A property that a scenario violates.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PropertyViolated {
    /// Its name.
    pub name: String,
    /// Where that is.
    pub range: Range,
    /// The first scan that violates it, counted from 0.
    pub scan: u64,
    /// The sentence for people.
    pub message: String,
}

/// A fault, with its place where that is in the program's own file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct FaultOfScenario {
    /// The sentence for people.
    pub message: String,
    /// The scan, counted from 0.
    pub scan: u64,
    /// The place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub range: Option<Range>,
}

/// What scenarios exercised of the program's own file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct Exercised {
    /// The networks, in the order of the program.
    pub networks: Vec<NetworkReached>,
    /// The contacts, comparisons and coils.
    pub parts: Vec<PartSeen>,
}

/// A network, and how many scans reached it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct NetworkReached {
    /// From its first rung to its last.
    pub range: Range,
    /// How many scans.
    pub scans: u64,
}

/// A contact, comparison or coil, and how it was seen.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct PartSeen {
    /// `contact`, `comparison` or `coil`.
    pub kind: String,
    /// Where it is.
    pub range: Range,
    /// It was seen closed; a coil with power.
    pub on: bool,
    /// It was seen open; a coil without power.
    pub off: bool,
}

/// A file of scenarios and its program.
pub(crate) struct Files<'a> {
    pub(crate) scenarios: &'a Revision,
    pub(crate) program: &'a Revision,
}

impl Files<'_> {
    /// The place of something that is in the program's own file.
    pub(crate) fn own(&self, location: Location) -> Option<Range> {
        (location.file == 0).then(|| self.program.range(location.range))
    }

    /// Nothing is run or proved where the file of scenarios has an error: the first of them, in words.
    pub(crate) fn without_errors<'e>(
        &self,
        errors: impl Iterator<Item = &'e ScenarioError>,
    ) -> Result<(), String> {
        let Some(ScenarioError { range, message, .. }) = errors.min_by_key(|error| error.range.start())
        else {
            return Ok(());
        };
        let line = self.scenarios.range(*range).start.line + 1;
        Err(format!("line {line}: {message}"))
    }
}

/// Runs the scenarios of a file, one after the other.
///
/// # Errors
///
/// A sentence for the person where one has an error, or takes longer than an editor waits.
pub(crate) fn run(
    files: &Files<'_>,
    suite: &Suite,
    mut simulation: Simulation,
    with_coverage: bool,
    clock: &Clock,
    cancel: &Cancel,
) -> Result<ScenariosRun, String> {
    let (cases, found) = scenario::bind(suite, &simulation);
    let (mut watched, of_properties) = scenario::bind_properties(suite, &simulation);
    files.without_errors(suite.errors.iter().chain(&found).chain(&of_properties))?;
    let mut coverage = with_coverage.then(|| Coverage::of(&mut simulation));
    let until = clock.now() + LONGEST;
    let mut scenarios = Vec::with_capacity(cases.len());
    for case in &cases {
        let mut scans: u64 = 0;
        let mut is_late = false;
        let ran = scenario::run(case, &mut watched, &mut simulation, |simulation| {
            scans += 1;
            is_late |= scans.is_multiple_of(SCANS_BETWEEN) && (cancel.is_cancelled() || clock.now() > until);
            !is_late
                && match &mut coverage {
                    Some(coverage) => coverage.scan(simulation),
                    None => simulation.scan(),
                }
        });
        if is_late {
            return Err(format!(
                "the scenarios take longer than {} seconds, up to \"{}\"; run them with `ladder test`",
                LONGEST.as_secs(),
                case.name
            ));
        }
        scenarios.push(scenario_run(
            files,
            (suite, case),
            &ran,
            simulation.options().interval,
        ));
    }
    if let Some(coverage) = &mut coverage {
        coverage.finish(&simulation);
    }
    Ok(ScenariosRun {
        uri: files.scenarios.uri.to_string(),
        version: files.scenarios.version,
        program: files.program.uri.to_string(),
        scenarios,
        coverage: coverage.map(|coverage| exercised(files, &coverage)),
    })
}

fn scenario_run(files: &Files<'_>, (suite, case): (&Suite, &Case), ran: &Ran, interval: i64) -> ScenarioRun {
    let lines = if ran.passed() {
        Vec::new()
    } else {
        scenario::draw(case, ran, interval, WIDTH)
    };
    let lines: Vec<String> = lines.into_iter().map(|line| line.text).collect();
    let differences = ran.differences.iter().map(|difference| RowDiffers {
        tag: difference.tag.clone(),
        ranges: difference
            .places
            .iter()
            .map(|&place| files.scenarios.range(place))
            .collect(),
        message: scenario::sentence(case, ran, difference, interval),
    });
    let violations = ran.violations.iter().map(|violation| PropertyViolated {
        name: violation.name.clone(),
        range: files.scenarios.range(violation.range),
        scan: violation.scan,
        message: scenario::violation_sentence(case, violation, interval),
    });
    let outside = ran.outside.as_ref();
    let faults = ran.faults.iter().map(
        |Fault {
             message,
             scan,
             location,
             ..
         }| FaultOfScenario {
            message: message.clone(),
            scan: *scan,
            range: files.own(*location),
        },
    );
    ScenarioRun {
        name: case.name.clone(),
        range: files.scenarios.range(case.range),
        passed: ran.passed(),
        scans: ran.scans,
        differences: differences.collect(),
        violations: violations.collect(),
        outside: outside.map(|outside| scenario::outside_sentence(suite, outside, interval)),
        faults: faults.collect(),
        diagram: lines.join("\n"),
    }
}

fn exercised(files: &Files<'_>, coverage: &Coverage) -> Exercised {
    let networks = coverage.networks.iter().filter_map(|network| {
        Some(NetworkReached {
            range: files.own(network.location)?,
            scans: network.scans,
        })
    });
    let parts = coverage.parts.iter().filter_map(|part| {
        let kind = match part.kind {
            CoverageItemKind::Contact => "contact",
            CoverageItemKind::Comparison => "comparison",
            CoverageItemKind::Coil => "coil",
        };
        Some(PartSeen {
            kind: kind.to_owned(),
            range: files.own(part.location)?,
            on: part.on,
            off: part.off,
        })
    });
    Exercised {
        networks: networks.collect(),
        parts: parts.collect(),
    }
}

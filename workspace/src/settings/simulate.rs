//! `[simulate]`: how programs are run.

use super::reader::{Reader, Table};
use ladder_analysis::types::Scalar;
use ladder_analysis::value::Value;
use ladder_simulator::{Options, value_text};
use std::path::{Path, PathBuf};

/// How programs are run. What is absent is left to whoever runs them.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Simulate {
    /// The time from one scan to the next, in nanoseconds.
    pub interval: Option<i64>,
    /// How many blocks a scan may evaluate.
    pub watchdog: Option<u64>,
    /// How many scans can be stepped back.
    pub history: Option<u64>,
    /// The file that keeps retentive tags, seen from the settings file's folder.
    pub retain: Option<PathBuf>,
}

impl Simulate {
    /// The simulator's own options, with what is set here in their place.
    pub fn options(&self) -> Options {
        let defaults = Options::default();
        Options {
            interval: self.interval.unwrap_or(defaults.interval),
            watchdog: self.watchdog.unwrap_or(defaults.watchdog),
        }
    }
}

pub(super) fn read<'t>(mut table: Table<'t>, folder: &Path, reader: &mut Reader<'t>) -> Simulate {
    let mut simulate = Simulate::default();
    if let Some(given) = table.take("interval")
        && let Some(text) = reader.string(&given, "\"10ms\"")
    {
        match value_text::parse(&text, Scalar::Time) {
            Ok(Value::Int(nanoseconds)) if nanoseconds > 0 => simulate.interval = Some(nanoseconds),
            Ok(_) => reader.wrong(
                given.span(),
                "the time from one scan to the next must be longer than 0",
            ),
            Err(problem) => reader.wrong(given.span(), problem),
        }
    }
    simulate.watchdog = table
        .take("watchdog")
        .and_then(|given| reader.number(&given, 1, i64::MAX))
        .map(|blocks| blocks as u64);
    simulate.history = table
        .take("history")
        .and_then(|given| reader.number(&given, 0, i64::MAX))
        .map(|scans| scans as u64);
    if let Some(given) = table.take("retain")
        && let Some(file) = reader.string(&given, "\"plant.retain\"")
    {
        if file.is_empty() {
            reader.wrong(given.span(), "name a file, or leave `retain` out");
        } else {
            simulate.retain = Some(folder.join(file.as_ref()));
        }
    }
    table.finish(reader);
    simulate
}

//! `[simulate]`: how programs are run.

use super::reader::{Reader, Table};
use super::table::{HISTORY, INTERVAL, RETAIN, WATCHDOG};
use crate::named::Named;
use ladder_analysis::program::Program;
use ladder_simulator::Options;
use std::path::Path;

/// How programs are run. What is absent is left to the caller.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Simulate {
    /// The time from one scan to the next, in nanoseconds.
    pub interval: Option<i64>,
    /// How many blocks a scan may evaluate.
    pub watchdog: Option<u64>,
    /// How many scans can be stepped back.
    pub history: Option<u64>,
    /// The file that keeps retentive tags.
    pub retain: Option<Named>,
}

impl Simulate {
    /// How a program is run: as is set here, else as the program itself says, else with the simulator's own options.
    pub fn options(&self, program: &Program) -> Options {
        let defaults = Options::default();
        Options {
            interval: self.interval.or(program.cycle).unwrap_or(defaults.interval),
            watchdog: self.watchdog.unwrap_or(defaults.watchdog),
        }
    }
}

pub(super) fn read(mut table: Table, folder: &Path, reader: &mut Reader) -> Simulate {
    let mut simulate = Simulate {
        interval: reader.duration(&mut table, &INTERVAL),
        watchdog: reader.whole(&mut table, &WATCHDOG).map(|blocks| blocks as u64),
        history: reader.whole(&mut table, &HISTORY).map(|scans| scans as u64),
        retain: None,
    };
    if let Some(given) = reader.take(&mut table, &RETAIN)
        && let Some(file) = reader.text(&given, RETAIN.example)
    {
        let named = Named::in_settings(folder, &file);
        if file.is_empty() {
            reader.wrong(given.range, "name a file, or leave `retain` out");
        } else if let Some(problem) = named.error() {
            reader.wrong(given.range, format!("`retain` cannot be used: {problem}"));
        } else {
            simulate.retain = Some(named);
        }
    }
    table.finish(reader);
    simulate
}

//! `[simulate]`: how programs are run.

use super::reader::{Reader, Table};
use super::table::{CONNECT, HISTORY, INTERVAL, PLANT, RETAIN, WATCHDOG};
use super::tasks::Task;
use crate::named::Named;
use crate::root::without_parents;
use ladder_analysis::Connect;
use ladder_analysis::program::Program;
use ladder_simulator::Options;
use ladder_simulator::scenario::{connected, plant_named};
use std::ops::Range;
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
    /// The models of the machine that run beside programs.
    pub plants: Vec<Plant>,
    /// Tags that are connected though their names differ.
    pub connects: Vec<Connect>,
    /// `[[task]]`: what runs at which rate, in the order in which those run that are due together.
    pub tasks: Vec<Task>,
}

/// A model of the machine.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plant {
    /// Its file.
    pub file: Named,
    /// What is before the names of its tags.
    pub name: String,
    /// Where it is named.
    pub range: Range<usize>,
}

impl Simulate {
    /// The models of the machine that run beside the program of a file: none beside one of themselves.
    pub fn plants_of(&self, file: &Path) -> &[Plant] {
        if self.plants.iter().any(|plant| is_same(&plant.file.path(), file)) {
            return &[];
        }
        &self.plants
    }

    /// The time from one scan to the next that is set for the program of a file, in nanoseconds: that of its task, else the one
    /// that holds for all.
    pub fn interval_of(&self, file: &Path) -> Option<i64> {
        let runs = |task: &&Task| {
            task.programs
                .iter()
                .any(|(program, _)| is_same(&program.path(), file))
        };
        let task = self.tasks.iter().find(runs);
        task.map(|task| task.interval).or(self.interval)
    }

    /// How the program of a file is run: as is set here, else as the program itself says, else with the simulator's own options.
    pub fn options(&self, program: &Program, file: &Path) -> Options {
        let defaults = Options::default();
        let set = if program.has_tasks() {
            None
        } else {
            self.interval_of(file)
        };
        Options {
            interval: set.or(program.cycle).unwrap_or(defaults.interval),
            watchdog: self.watchdog.unwrap_or(defaults.watchdog),
        }
    }
}

/// Whether two paths name one file. Both may be relative, as a settings file is named.
fn is_same(one: &Path, other: &Path) -> bool {
    let whole = |path: &Path| {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let folder = path.parent().map(without_parents);
        folder.map(|folder| folder.join(path.file_name().unwrap_or_default()))
    };
    one.file_name() == other.file_name() && whole(one) == whole(other)
}

pub(super) fn read(mut table: Table, folder: &Path, reader: &mut Reader) -> Simulate {
    let mut simulate = Simulate {
        interval: reader.duration(&mut table, &INTERVAL),
        watchdog: reader.whole(&mut table, &WATCHDOG).map(|blocks| blocks as u64),
        history: reader.whole(&mut table, &HISTORY).map(|scans| scans as u64),
        retain: None,
        plants: Vec::new(),
        connects: Vec::new(),
        tasks: Vec::new(),
    };
    if let Some(given) = reader.take(&mut table, &PLANT) {
        for (range, text) in reader.text_or_texts(&given, PLANT.example) {
            let (file, name) = plant_named(&text);
            let named = Named::in_settings(folder, file);
            if let Some(problem) = named.error() {
                reader.wrong(range, format!("`plant` cannot be used: {problem}"));
            } else {
                simulate.plants.push(Plant {
                    file: named,
                    name: name.to_owned(),
                    range,
                });
            }
        }
    }
    if let Some(given) = reader.take(&mut table, &CONNECT) {
        for (range, text) in reader.text_or_texts(&given, CONNECT.example) {
            match connected(&text) {
                Some((one, other)) => simulate.connects.push((one.to_owned(), other.to_owned())),
                None => reader.wrong(
                    range,
                    format!(
                        "a connection is between two tags, for example {}",
                        CONNECT.example
                    ),
                ),
            }
        }
    }
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

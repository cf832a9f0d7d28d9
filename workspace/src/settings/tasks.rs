//! `[[task]]`: which programs a project runs, and how often.

use super::reader::{Reader, Table};
use super::table::{PRIORITY, PROGRAMS, TASK, TASK_INTERVAL, TASK_NAME};
use crate::named::Named;
use crate::root::is_program;
use std::ops::Range;
use std::path::Path;

/// Programs that run one after the other, at one interval.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Task {
    /// What it is called.
    pub name: String,
    /// The time from one run to the next, in nanoseconds.
    pub interval: i64,
    /// Of tasks that are due in one scan the one with the smallest number runs first.
    pub priority: i64,
    /// Its programs in their order, each with the place where it is named.
    pub programs: Vec<(Named, Range<usize>)>,
}

/// No scan of a project is shorter, in nanoseconds: the intervals of its tasks are multiples of it.
const SHORTEST: i64 = 1_000;

/// A task is due once in at most so many scans.
const MOST_SCANS: i64 = 1_000_000;

/// The tasks in the order in which those run that are due in one scan.
pub(super) fn read(tables: Vec<Table>, folder: &Path, reader: &mut Reader) -> Vec<Task> {
    let mut tasks: Vec<Task> = Vec::new();
    for table in tables {
        let range = table.range();
        let Some(task) = task(table, folder, reader) else {
            continue;
        };
        if tasks
            .iter()
            .any(|other| other.name.eq_ignore_ascii_case(&task.name))
        {
            reader.wrong(range, format!("there are two tasks `{}`", task.name));
            continue;
        }
        for (program, at) in &task.programs {
            let mut others = tasks.iter().flat_map(|task| &task.programs).chain(&task.programs);
            // `./motor.clad` is `motor.clad`.
            let file = program.locate_without_links().ok();
            let is_it = |other: &Named| file.is_some() && other.locate_without_links().ok() == file;
            if others.any(|(other, before)| before.start < at.start && is_it(other)) {
                let path = program.path();
                let name = path.file_name().unwrap_or_default().to_string_lossy();
                reader.wrong(
                    at.clone(),
                    format!("a task runs `{name}` already: a program has one"),
                );
            }
        }
        tasks.push(task);
    }
    tasks.sort_by_key(|task| task.priority);
    let scan = scan_of(&tasks);
    let longest = tasks.iter().map(|task| task.interval).max().unwrap_or(0);
    if let Some(first) = tasks
        .first()
        .filter(|_| scan < SHORTEST || longest / scan.max(1) > MOST_SCANS)
    {
        let at = first.programs.first().map_or(0..0, |(_, at)| at.clone());
        let message = "the intervals of the tasks have no common scan of at least a microsecond, a millionth of the longest: round them";
        reader.wrong(at, message);
    }
    tasks
}

fn task(mut table: Table, folder: &Path, reader: &mut Reader) -> Option<Task> {
    reader.needs(&table, &TASK);
    let name = reader.take(&mut table, &TASK_NAME);
    let name = name.and_then(|given| reader.text(&given, TASK_NAME.example));
    let interval = reader.duration(&mut table, &TASK_INTERVAL);
    let priority = reader.whole(&mut table, &PRIORITY).unwrap_or(0);
    let given = reader.take(&mut table, &PROGRAMS);
    let mut programs = Vec::new();
    for (range, name) in given.map_or_else(Vec::new, |given| reader.texts(&given, "\"motor.clad\"")) {
        let named = Named::in_settings(folder, &name);
        if let Some(problem) = named.error() {
            reader.wrong(range, format!("`{name}` cannot be used: {problem}"));
        } else if !is_program(Path::new(&name)) {
            let message = format!("`{name}` is not a program: a task runs files that end in .clad or .st");
            reader.wrong(range, message);
        } else {
            programs.push((named, range));
        }
    }
    table.finish(reader);
    // What is there and wrong has been reported.
    if programs.is_empty() {
        return None;
    }
    Some(Task {
        name: name?,
        interval: interval?,
        priority,
        programs,
    })
}

/// The time of a scan of a project with these tasks, in nanoseconds: each interval is a multiple of it.
pub(crate) fn scan_of(tasks: &[Task]) -> i64 {
    let gcd = |mut a: i64, mut b: i64| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a
    };
    tasks.iter().map(|task| task.interval).fold(0, gcd)
}

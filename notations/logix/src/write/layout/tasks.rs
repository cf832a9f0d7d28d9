//! The tasks of a controller.

use super::Layout;
use crate::model::{Task, TaskKind};
use crate::names::Originals;
use crate::write::names::{Kind, Names};
use ladder_notation::{Project, ProjectTask};
use std::collections::HashSet;

/// The priorities of tasks with a rate.
const FIRST: i64 = 1;
const LAST: i64 = 15;

impl Layout {
    /// The tasks of a new controller. `programs_of`: the programs that a file is or runs.
    pub(super) fn add_tasks(
        &mut self,
        project: &Project,
        programs_of: impl Fn(&Layout, usize) -> Vec<usize>,
    ) {
        let all = project.tasks();
        if all.is_empty() {
            return;
        }
        let mut numbers: Vec<i64> = all.iter().map(|task| task.priority).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let fits = numbers.iter().all(|number| (FIRST..=LAST).contains(number));
        let mut names = Names::default();
        let mut tasks = Vec::new();
        for own in all {
            let task = ProjectTask {
                name: names.spell(Kind::Tag, &own.name),
                priority: match numbers.iter().position(|number| *number == own.priority) {
                    Some(place) if !fits => FIRST + place as i64,
                    _ => own.priority,
                },
                ..own.clone()
            };
            if task.name != own.name {
                self.tell(&own.name, format!("its name is {} there", task.name));
            }
            let programs = self.names_in(project, own, &programs_of);
            tasks.push(self.timed(&task, programs));
        }
        if let Some(last) = tasks.iter().filter_map(|task| task.priority).max() {
            for task in tasks.iter().filter(|task| task.priority < Some(last)) {
                let why = "there it interrupts tasks with a larger priority between any two instructions";
                self.tell(&task.name, why.to_owned());
            }
        }
        self.runs.tasks = Some(tasks);
    }

    /// The tasks of the file that the programs come from, with what of them is otherwise now.
    pub(super) fn add_tasks_again(
        &mut self,
        project: &Project,
        before: &Project,
        originals: &Originals,
        programs_of: impl Fn(&Layout, &Project, usize) -> Vec<usize>,
    ) {
        let mut tasks = self.tasks_as_they_were(originals);
        if project.tasks() == before.tasks() {
            self.runs.tasks = Some(tasks);
            return;
        }
        let find = |tasks: &[ProjectTask], name: &str| -> Option<ProjectTask> {
            let mut tasks = tasks.iter();
            tasks.find(|task| task.name.eq_ignore_ascii_case(name)).cloned()
        };
        tasks.retain(|task| {
            find(before.tasks(), &task.name).is_none() || find(project.tasks(), &task.name).is_some()
        });
        // What runs elsewhere now.
        let mut moved: HashSet<String> = HashSet::new();
        for now in project.tasks() {
            let programs = self.names_in(project, now, |layout, file| programs_of(layout, project, file));
            let was = find(before.tasks(), &now.name);
            let known = tasks
                .iter()
                .position(|task| task.name.eq_ignore_ascii_case(&now.name));
            let known = known.unwrap_or_else(|| {
                tasks.push(Task {
                    name: Names::default().spell(Kind::Tag, &now.name),
                    ..Task::default()
                });
                tasks.len() - 1
            });
            let is_other = was
                .as_ref()
                .is_none_or(|was| (was.interval, was.priority) != (now.interval, now.priority));
            let other_programs = was.as_ref().is_none_or(|was| was.programs != now.programs);
            if is_other {
                let timed = self.timed(now, Vec::new());
                let task = &mut tasks[known];
                (task.kind, task.inhibited) = (timed.kind, false);
                (task.rate, task.priority) = (timed.rate, timed.priority);
            }
            if other_programs {
                let own = was
                    .as_ref()
                    .map(|was| self.names_in(before, was, |layout, file| programs_of(layout, before, file)));
                let own = own.unwrap_or_default();
                moved.extend(programs.iter().map(|name| name.to_ascii_uppercase()));
                let task = &mut tasks[known];
                // Those that are no files stay.
                let rest = task
                    .programs
                    .drain(..)
                    .filter(|name| !own.contains(name) && !programs.contains(name));
                let rest: Vec<String> = rest.collect();
                task.programs = programs;
                task.programs.extend(rest);
            }
        }
        for task in &mut tasks {
            let own = find(project.tasks(), &task.name);
            let own = own
                .map(|own| self.names_in(project, &own, |layout, file| programs_of(layout, project, file)));
            let own = own.unwrap_or_default();
            task.programs
                .retain(|name| own.contains(name) || !moved.contains(&name.to_ascii_uppercase()));
        }
        self.runs.tasks = Some(tasks);
    }

    fn tell(&mut self, task: &str, why: String) {
        self.runs.told.push((task.to_owned(), why));
    }

    /// The names of the programs that a task runs.
    fn names_in(
        &self,
        project: &Project,
        task: &ProjectTask,
        programs_of: impl Fn(&Layout, usize) -> Vec<usize>,
    ) -> Vec<String> {
        let files = task.programs.iter().filter_map(|name| project.number_of(name));
        let mut programs: Vec<usize> = Vec::new();
        for program in files.flat_map(|file| programs_of(self, file)) {
            if !programs.contains(&program) {
                programs.push(program);
            }
        }
        programs
            .into_iter()
            .map(|program| self.programs[program].name.clone())
            .collect()
    }

    /// A task with a rate.
    fn timed(&mut self, task: &ProjectTask, programs: Vec<String>) -> Task {
        let priority = task.priority.clamp(FIRST, LAST);
        if priority != task.priority {
            let why = format!("its priority is {priority} there: those of tasks are {FIRST} to {LAST}");
            self.tell(&task.name, why);
        }
        Task {
            name: task.name.clone(),
            kind: TaskKind::Periodic,
            rate: Some(rate(task.interval)),
            priority: Some(priority),
            programs,
            ..Task::default()
        }
    }

    /// The tasks as they were, with what runs now: what is new is run by the one that is the scan.
    fn tasks_as_they_were(&self, originals: &Originals) -> Vec<Task> {
        let mut tasks = originals.tasks.clone();
        let known: HashSet<String> = originals
            .programs
            .iter()
            .map(|(name, _)| name.to_ascii_uppercase())
            .collect();
        let is_there = |name: &String| {
            let mut programs = self.programs.iter().enumerate();
            programs.any(|(number, program)| {
                let has_routines = self.functions.values().any(|(of, _)| *of == number);
                program.name.eq_ignore_ascii_case(name) && (has_routines || !program.begins.is_empty())
            })
        };
        for task in &mut tasks {
            task.programs
                .retain(|name| !known.contains(&name.to_ascii_uppercase()) || is_there(name));
        }
        let scan = tasks
            .iter()
            .position(|task| task.kind == TaskKind::Continuous && !task.inhibited);
        let scan = scan.or((!tasks.is_empty()).then_some(0));
        if let Some(scan) = scan {
            let new = self
                .run()
                .filter(|program| !known.contains(&program.name.to_ascii_uppercase()));
            tasks[scan]
                .programs
                .extend(new.map(|program| program.name.clone()));
        }
        tasks
    }
}

/// Nanoseconds as a rate, which is in milliseconds.
pub(crate) fn rate(nanoseconds: i64) -> String {
    let milliseconds = nanoseconds as f64 / 1e6;
    format!("{milliseconds}")
}

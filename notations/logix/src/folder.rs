//! A project of several programs as the files of a folder.
//!
//! ```text
//! Cell.clad     the controller: its tags, for all files, and the main program of the only program that runs
//! Pump.clad     a program: its tags, its routines as functions, and a main program that calls the main routine
//! types.clad    the types
//! blocks.clad   Add-On Instructions, and the blocks that the programs bring along
//! ladder.toml   the tasks, and what the checks need not say
//! ```

use crate::model::{Project, TaskKind};
use crate::plan::Plan;
use crate::scope::CONTROLLER;
use crate::sketch::Sketcher;
use ladder_format::program::{Item, ProgramSketch, SectionKind};
use ladder_notation::names::Names;
use ladder_notation::{Content, ProjectFile, ProjectTask};

/// The parts of a program.
pub(crate) struct Parts {
    pub(crate) types: Vec<Item>,
    /// What runs first, and the main program, if there is only one.
    pub(crate) begin: Vec<Item>,
    /// The calls of all programs, where there are several.
    pub(crate) calls: Vec<Item>,
    /// The calls of each program.
    pub(crate) mains: Vec<Vec<Item>>,
    /// The functions of each program.
    pub(crate) functions: Vec<(usize, Vec<Item>)>,
    pub(crate) blocks: Vec<Item>,
}

/// What the files are called, without their ending.
pub(crate) struct Stems {
    types: String,
    blocks: String,
    pub(crate) controller: String,
    /// Those of the programs.
    pub(crate) programs: Vec<String>,
}

impl Stems {
    pub(crate) fn of(project: &Project) -> Stems {
        let mut names = Names::default();
        let [types, blocks] = ["types", "blocks"].map(|name| names.fresh(name));
        let controller = if project.name.is_empty() {
            "controller"
        } else {
            &project.name
        };
        Stems {
            types,
            blocks,
            controller: names.fresh(controller),
            programs: project
                .programs
                .iter()
                .map(|program| names.fresh(&program.name))
                .collect(),
        }
    }
}

impl Sketcher<'_> {
    pub(crate) fn files(&mut self, parts: Parts, plan: &Plan) -> Vec<ProjectFile> {
        let project = self.translator.project;
        let Stems {
            types,
            blocks,
            controller,
            programs,
        } = Stems::of(project);
        let mut files = Vec::new();
        let mut add = |name: &str, mut items: Vec<Item>| {
            if items.is_empty() {
                return;
            }
            items.insert(0, Item::Directive("profile logix".to_owned()));
            files.push(ProjectFile {
                name: format!("{name}.clad"),
                content: Content::Program(ProgramSketch { items }),
            });
        };
        let is_one = plan.main.is_some();
        let mut items = if is_one { self.cycle() } else { Vec::new() };
        for mut item in self.declarations(|scope| scope == CONTROLLER) {
            if let Item::Section(section) = &mut item {
                section.kind = SectionKind::VarGlobal;
            }
            items.push(item);
        }
        let mut own: Vec<Vec<Item>> = Vec::new();
        for (number, main) in parts.mains.into_iter().enumerate() {
            let mut items = self.declarations(|scope| scope == CONTROLLER + 1 + number);
            if !is_one {
                items.extend(main);
            }
            let functions = parts.functions.iter().filter(|(program, _)| *program == number);
            items.extend(functions.flat_map(|(_, items)| items.clone()));
            own.push(items);
        }
        let begins = is_one || !parts.begin.is_empty();
        items.extend(parts.begin);
        add(&controller, items);
        let mut runs: Vec<(&str, String)> = Vec::new();
        for ((name, items), program) in programs.iter().zip(own).zip(&project.programs) {
            if !items.is_empty() {
                runs.push((&program.name, format!("{name}.clad")));
            }
            add(name, items);
        }
        let first = begins.then(|| format!("{controller}.clad"));
        let tasks = tasks(project, &runs, first, is_one);
        add(&types, parts.types);
        add(&blocks, parts.blocks);
        files.push(ProjectFile {
            name: "ladder.toml".to_owned(),
            content: Content::Settings(SETTINGS.to_owned(), tasks),
        });
        files
    }
}

/// The tasks with the files of their programs; `first` is a file that runs before all others. Without tasks, as in the export of a
/// part, all programs run in one.
fn tasks(
    project: &Project,
    runs: &[(&str, String)],
    first: Option<String>,
    is_one: bool,
) -> Vec<ProjectTask> {
    let runs_program = |name: &str| {
        let mut programs = project.programs.iter();
        programs.any(|program| program.name.eq_ignore_ascii_case(name) && !program.inhibited)
    };
    let file_of = |name: &String| {
        let run = runs
            .iter()
            .find(|(program, _)| program.eq_ignore_ascii_case(name));
        run.filter(|_| runs_program(name)).map(|(_, file)| file.clone())
    };
    // A continuous task runs whenever no other does.
    let shortest = project
        .rate
        .as_deref()
        .and_then(nanoseconds)
        .unwrap_or(10_000_000);
    let planned = project
        .tasks
        .iter()
        .filter(|task| !task.inhibited && task.kind != TaskKind::Event);
    let mut tasks: Vec<ProjectTask> = planned
        .map(|task| {
            let rate = task.rate.as_deref().and_then(nanoseconds);
            let is_periodic = task.kind == TaskKind::Periodic;
            ProjectTask {
                name: task.name.clone(),
                interval: rate.filter(|_| is_periodic).unwrap_or(shortest),
                priority: task.priority.filter(|_| is_periodic).unwrap_or(LAST),
                programs: task.programs.iter().filter_map(file_of).collect(),
            }
        })
        .filter(|task| !task.programs.is_empty())
        .collect();
    if tasks.is_empty() {
        tasks.push(ProjectTask {
            name: "MainTask".to_owned(),
            interval: shortest,
            priority: 0,
            programs: runs
                .iter()
                .filter_map(|(name, _)| file_of(&(*name).to_owned()))
                .collect(),
        });
    }
    let Some(first) = first else { return tasks };
    // That of the only program runs alone.
    if let Some(task) = tasks.iter_mut().min_by_key(|task| task.priority) {
        if is_one {
            task.programs.clear();
        }
        task.programs.insert(0, first);
    }
    tasks.retain(|task| !is_one || task.programs.len() == 1);
    tasks
}

/// A rate, which is in milliseconds. None: there is no time between two runs, or it is longer than some months.
fn nanoseconds(rate: &str) -> Option<i64> {
    let nanoseconds = rate.parse::<f64>().ok()? * 1e6;
    (1.0..1e16)
        .contains(&nanoseconds)
        .then_some(nanoseconds.round() as i64)
}

/// The priority of a continuous task: after all others.
const LAST: i64 = 16;

/// Other devices reach the tags of a controller too, and its rungs go on after a coil.
const SETTINGS: &str = "[lint]\nnever-written = \"off\"\nnever-read = \"off\"\nset-without-reset = \"off\"\nreset-without-set = \"off\"\ncontact-after-coil = \"off\"\n";

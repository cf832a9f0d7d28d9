//! What of ladder text is where in a controller: which functions are the routines of which program, and whose the tags are.
//!
//! A program alone is one program of the controller. The files of a folder are programs: what a file runs first says with which routine it
//! begins, or is that routine; and the networks of a file that runs the others are the order of the task. What was read from a file is
//! what it was there.

mod again;
mod files;
mod orders;
mod tasks;

use crate::model::Task;
use crate::names::Originals;
use ladder_syntax::Name;
use orders::Orders;
use std::collections::HashMap;
pub(super) use tasks::rate;

/// The name of the first program, and of its first routine.
pub(super) const PROGRAM: &str = "MainProgram";
pub(super) const MAIN: &str = "MainRoutine";

/// Where everything is.
#[derive(Debug, Default)]
pub(super) struct Layout {
    pub(super) controller: Option<String>,
    /// The programs. None: there is one, which everything is in.
    pub(super) programs: Vec<ProgramAt>,
    /// The program and the routine of each function.
    functions: HashMap<Name, (usize, String)>,
    /// Where the networks outside of functions are. None: in no program.
    pub(super) main: Option<(usize, String)>,
    /// Tags, each with the program whose tag it is, and what it is called there.
    tags: HashMap<Name, TagAt>,
    pub(super) runs: Runs,
    /// What was called how in the file that it comes from.
    pub(super) originals: Option<Originals>,
}

/// What runs when.
#[derive(Debug, Default)]
pub(super) struct Runs {
    /// The networks that only say what runs: these are no rungs.
    pub(super) orders: Orders,
    /// The programs in the order in which they run.
    order: Vec<usize>,
    pub(super) tasks: Option<Vec<Task>>,
    /// What is otherwise there of a task, each with its name.
    pub(super) told: Vec<(String, String)>,
}

/// Where a tag is.
#[derive(Debug, Clone)]
pub(super) struct TagAt {
    /// None: it is the controller's.
    pub(super) program: Option<usize>,
    pub(super) name: String,
    /// Whether that is what it was called in the file that it comes from. Else it is spelled so that it can be.
    pub(super) is_original: bool,
}

/// A program of the controller.
#[derive(Debug, Clone, Default)]
pub(super) struct ProgramAt {
    pub(super) name: String,
    /// The routines with which it begins, in their order.
    pub(super) begins: Vec<String>,
    pub(super) is_run: bool,
}

impl ProgramAt {
    /// The program that a file is, if there was none before.
    fn of_file(stem: &str) -> ProgramAt {
        ProgramAt {
            name: super::names::Names::default().spell(super::names::Kind::Type, stem),
            ..ProgramAt::default()
        }
    }
}

impl Layout {
    fn begin(&mut self, function: &str, is_run: bool) {
        if let Some((program, routine)) = self.functions.get(&Name::new(function)) {
            if !self.runs.order.contains(program) {
                self.runs.order.push(*program);
            }
            let program = &mut self.programs[*program];
            program.begins.push(routine.clone());
            program.is_run |= is_run;
        }
    }

    /// The networks outside of functions are a routine of a program, which begins with it.
    fn begin_with_main(&mut self, program: usize, routine: String) {
        let at = &mut self.programs[program];
        at.begins.insert(0, routine.clone());
        at.is_run = true;
        if !self.runs.order.contains(&program) {
            self.runs.order.insert(0, program);
        }
        self.main = Some((program, routine));
    }

    /// The program and the routine of a function. None: all is one program.
    pub(super) fn routine(&self, function: &str) -> Option<&(usize, String)> {
        self.functions.get(&Name::new(function))
    }

    /// All functions, each with its routine.
    pub(super) fn routines(&self) -> impl Iterator<Item = (&Name, &str)> {
        self.functions
            .iter()
            .map(|(name, (_, routine))| (name, routine.as_str()))
    }

    /// Where a tag is. None: it is called as it is.
    pub(super) fn tag(&self, tag: &str) -> Option<&TagAt> {
        self.tags.get(&Name::new(tag))
    }

    /// The programs that run, in their order.
    pub(super) fn run(&self) -> impl Iterator<Item = &ProgramAt> {
        let run = self.runs.order.iter().map(|program| &self.programs[*program]);
        run.filter(|program| program.is_run)
    }
}

/// A function without the name of its program before it.
fn bare<'f>(program: &str, function: &'f str) -> &'f str {
    let begin = function.get(..program.len());
    let rest = begin
        .filter(|begin| begin.eq_ignore_ascii_case(program))
        .and_then(|_| function[program.len()..].strip_prefix('_'));
    rest.filter(|rest| rest.starts_with(|c: char| c.is_ascii_alphabetic()))
        .unwrap_or(function)
}

/// A name for the routine with which a program begins.
fn free_main(is_taken: impl Fn(&str) -> bool) -> String {
    let numbered = (2..).map(|number| format!("{MAIN}_{number}"));
    let mut names = std::iter::once(MAIN.to_owned()).chain(numbered);
    names
        .find(|name| !is_taken(name))
        .unwrap_or_else(|| MAIN.to_owned())
}

//! The files of a folder as one project: each that runs is a program, and what they share is there once.

use super::compiler::Compiler;
use crate::emit;
use crate::model::{Project, Task, Unit, UnitKind};
use ladder_analysis::context::Body;
use ladder_analysis::names::scope::{Origin, SectionKind};
use ladder_notation::{LineColumn, Project as Files, ProjectTask, Report, Target, WriteError, Writing};
use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

/// The project, and a report for each file. `name` is what the program of a file is called.
pub(crate) fn project(
    files: &Files,
    name: impl Fn(usize) -> String,
) -> Result<(Project, Vec<Report>), WriteError> {
    let mut joined = Joined::default();
    let mut reports = Vec::new();
    // What is shared comes from the files that declare it.
    let (mut order, mut programs) = (Vec::new(), Vec::new());
    for number in 0..files.count() {
        let analysis = files.linked(number)?;
        let context = &analysis.context;
        let runs =
            context.bodies.contains(&Body::Main) || context.networks.is_empty() && declares_own(&analysis);
        if runs {
            programs.push((number, analysis));
        } else {
            order.push((number, analysis));
        }
    }
    let mut programs_of: HashMap<usize, String> = HashMap::new();
    let first_program = order.len();
    order.append(&mut programs);
    reports.resize(files.count(), Report::default());
    for (at, (number, mut analysis)) in order.into_iter().enumerate() {
        let is_program = at >= first_program;
        if !is_program && !analysis.context.functions.is_empty() {
            continue;
        }
        let own: Vec<String> = declared(&analysis);
        // What is only shared leaves its name to what is in it.
        let own_name = if is_program {
            name(number)
        } else {
            format!("{}_file", name(number))
        };
        Arc::make_mut(&mut analysis.context).name = own_name.as_str().into();
        let made = RefCell::new(Project::default());
        let writing = Target::BLOCKS_ALONE.write(&analysis, |analysis, unwritable| {
            let (project, report) = super::project(analysis, unwritable, Compiler::Matiec)?;
            *made.borrow_mut() = project;
            Ok(Writing {
                report,
                ..Writing::default()
            })
        })?;
        reports[number] = writing.report;
        let program = joined.add(made.into_inner(), &own, is_program, files.file(number))?;
        programs_of.extend(program.map(|program| (number, program)));
    }
    if !files.tasks().is_empty() {
        let tasks = files.tasks().iter();
        joined.project.tasks = tasks.map(|task| scheduled(files, task, &programs_of)).collect();
    }
    super::texts::put_back(files, &mut joined.project, &programs_of, &mut reports)?;
    Ok((joined.project, reports))
}

/// A task with the programs that its files are.
fn scheduled(files: &Files, task: &ProjectTask, programs_of: &HashMap<usize, String>) -> Task {
    let programs = task
        .programs
        .iter()
        .filter_map(|file| programs_of.get(&files.number_of(file)?));
    Task {
        place: LineColumn::START,
        name: super::names::identifier(&task.name),
        interval: Some(super::text::time(task.interval)),
        event: None,
        priority: task.priority,
        programs: programs
            .map(|program| (LineColumn::START, program.clone()))
            .collect(),
    }
}

/// Whether a file has tags of its own, which are a program's.
fn declares_own(analysis: &ladder_analysis::Analysis) -> bool {
    let mut tags = analysis.context.scopes[0].tags.iter();
    tags.any(|tag| {
        matches!(
            tag.origin,
            Origin::Declared(SectionKind::Var | SectionKind::Input | SectionKind::Output)
        )
    })
}

/// The globals that a file declares, in small letters.
fn declared(analysis: &ladder_analysis::Analysis) -> Vec<String> {
    let tags = analysis.context.scopes[0].tags.iter();
    let own =
        tags.filter(|tag| tag.origin == Origin::Declared(SectionKind::Global) && tag.cold.foreign.is_none());
    own.map(|tag| super::names::identifier(&tag.name).to_lowercase())
        .collect()
}

/// A project out of several.
#[derive(Default)]
struct Joined {
    project: Project,
    /// The units and types, by their names in small letters: how they are written, and of which file.
    known: HashMap<String, (String, String)>,
}

impl Joined {
    /// Comes back with the program that a file is.
    fn add(
        &mut self,
        more: Project,
        own: &[String],
        is_program: bool,
        file: &str,
    ) -> Result<Option<String>, WriteError> {
        let Project {
            types,
            globals,
            mut units,
            tasks,
            ..
        } = more;
        for ty in types {
            let text = emit::type_text(&ty);
            if self.is_new("type", &ty.name, text, file)? {
                self.project.types.push(ty);
            }
        }
        for global in globals {
            let name = global.name.to_lowercase();
            let mut all = self.project.globals.iter_mut();
            match all.find(|known| known.name.to_lowercase() == name) {
                None => self.project.globals.push(global),
                Some(known) if own.contains(&name) => *known = global,
                Some(_) => {}
            }
        }
        if !is_program {
            units.pop();
        }
        let program = units.pop_if(|unit| is_program && unit.kind == UnitKind::Program);
        for unit in units {
            let text = emit::unit_text(unit.clone());
            if self.is_new("unit", &unit.name, text, file)? {
                // Programs come last.
                let programs = self
                    .project
                    .units
                    .iter()
                    .filter(|unit| unit.kind == UnitKind::Program);
                let at = self.project.units.len() - programs.count();
                self.project.units.insert(at, unit);
            }
        }
        let Some(program) = program else { return Ok(None) };
        let name = program.name.clone();
        let text = emit::unit_text(program.clone());
        if self.is_new("program", &program.name, text, file)? {
            self.schedule(&program, tasks);
            self.project.units.push(program);
        }
        Ok(Some(name))
    }

    fn schedule(&mut self, program: &Unit, mut tasks: Vec<Task>) {
        match (self.project.tasks.first_mut(), tasks.pop()) {
            (Some(task), _) => task.programs.push((LineColumn::START, program.name.clone())),
            (None, Some(task)) => self.project.tasks.push(task),
            (None, None) => {}
        }
    }

    /// Whether nothing of that name is there.
    ///
    /// # Errors
    ///
    /// If something else has the name.
    fn is_new(&mut self, what: &str, name: &str, text: String, file: &str) -> Result<bool, WriteError> {
        match self.known.get(&name.to_lowercase()) {
            Some((known, _)) if *known == text => Ok(false),
            Some((_, first)) => Err(WriteError::new(format!(
                "the {what} {name} of {file} is another one in {first}, and a project has one of a name: rename one of them"
            ))),
            None => {
                self.known.insert(name.to_lowercase(), (text, file.to_owned()));
                Ok(true)
            }
        }
    }
}

//! What a unit uses of the other files of its project: units, types, globals.

use crate::model::{Body, Evaluation, Project, Role, Type, TypeDeclaration, Unit, UnitKind, Variable};
use ladder_notation::{Companion, LineColumn, Outcome, ReadError, Report, Source};
use std::collections::HashSet;
use std::sync::Arc;

/// What a file holds that units of other files may use.
#[derive(Debug, Default)]
pub struct Held {
    /// Functions and function blocks, and programs, which others may call in CODESYS.
    pub units: Vec<Unit>,
    /// Types.
    pub types: Vec<TypeDeclaration>,
    /// Variables that all units see.
    pub globals: Vec<Variable>,
}

/// Adds a unit to a project, after what it uses of other files, and what that uses itself. `text` is that of its file; `read` is
/// how another one is read, by its name and text, which is done once for all units.
pub fn add_with_used(
    project: &mut Project,
    own: Unit,
    text: &str,
    source: &Source<'_>,
    read: impl Fn(&str, &str, &mut Report) -> Result<Held, ReadError>,
) {
    project.units.push(own);
    let mut names = HashSet::new();
    add_names(&mut names, text);
    let files = source.companions.iter().map(|file| File::of(file, &read));
    let mut files: Vec<File<'_>> = files.collect();
    loop {
        let before = names.len();
        for file in &mut files {
            file.take(project, &mut names);
        }
        if names.len() == before {
            break;
        }
    }
    project.units.rotate_left(1);
}

/// Adds all names of a text, in small letters, and those that are called once more with a parenthesis.
fn add_names(names: &mut HashSet<String>, text: &str) {
    let words = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    let mut end = 0;
    for word in words {
        // What comes after a word is one character further.
        let after = &text[(end + word.len()).min(text.len())..];
        if after.trim_start().starts_with('(') {
            names.insert(called(word));
        }
        end = text.len() - after.len() + after.chars().next().map_or(0, char::len_utf8);
        names.insert(word.to_lowercase());
    }
}

/// How a name is among the others that is called.
fn called(name: &str) -> String {
    format!("{}(", name.to_lowercase())
}

/// Another file of the project.
struct File<'f> {
    name: &'f str,
    text: &'f str,
    read: Arc<(Result<Held, ReadError>, Report)>,
    /// What was taken of it, in small letters.
    taken: HashSet<String>,
}

impl<'f> File<'f> {
    fn of(
        file: &'f Companion,
        read: impl Fn(&str, &str, &mut Report) -> Result<Held, ReadError>,
    ) -> File<'f> {
        let make = |bytes: &[u8]| {
            let mut report = Report::default();
            let text = Source::alone("", bytes).text();
            let mut held = text.and_then(|text| read(&file.name, text, &mut report));
            if let Ok(held) = &mut held {
                at_start(held);
            }
            Arc::new((held, report))
        };
        File {
            name: file.name.rsplit('/').next().unwrap_or(&file.name),
            text: Source::alone("", &file.bytes).text().unwrap_or_default(),
            read: file.bytes.made(make),
            taken: HashSet::new(),
        }
    }

    /// Takes over what these names are names of.
    fn take(&mut self, project: &mut Project, names: &mut HashSet<String>) {
        let read = Arc::clone(&self.read);
        let taken = self.taken.len();
        let runs_programs = project.evaluation == Evaluation::Once;
        let mut is_wanted = |name: &str| {
            let name = name.to_lowercase();
            names.contains(&name) && self.taken.insert(name)
        };
        let held = match &read.0 {
            Ok(held) => held,
            Err(error) => {
                if self.name.split('.').next().is_some_and(is_wanted) {
                    let file = format!("file {}", self.name);
                    let why = format!("it is not read: {error}");
                    project.report.refused(LineColumn::START, file, why);
                }
                return;
            }
        };
        let mut globals: Vec<&Variable> = held.globals.iter().collect();
        globals.retain(|global| {
            is_wanted(&global.name) && is_new(&project.globals, |it| &it.name, &global.name)
        });
        let is_wanted_type = |declared: &&TypeDeclaration| {
            let is_value = match &declared.ty {
                Type::Enumeration(values) => values.iter().any(|(name, _)| is_wanted(name)),
                _ => false,
            };
            is_wanted(&declared.name) || is_value
        };
        let mut types: Vec<&TypeDeclaration> = held.types.iter().filter(is_wanted_type).collect();
        types.retain(|declared| is_new(&project.types, |it| &it.name, &declared.name));
        let is_wanted_unit = |unit: &&Unit| {
            let is_seen =
                unit.kind != UnitKind::Program || runs_programs && names.contains(&called(&unit.name));
            is_seen && is_wanted(&unit.name)
        };
        let mut units: Vec<&Unit> = held.units.iter().filter(is_wanted_unit).collect();
        units.retain(|unit| is_new(&project.units, |it| &it.name, &unit.name));
        if self.taken.len() == taken {
            return;
        }
        for global in &globals {
            // The names of types and constants in it.
            add_names(names, &format!("{:?} {:?}", global.ty, global.initial));
        }
        if !types.is_empty() || !units.is_empty() {
            add_names(names, self.text);
            let first = taken == 0;
            for entry in read.1.remarks().filter(|_| first) {
                let element = format!("{} of {}", entry.element, self.name);
                match &entry.outcome {
                    Outcome::Approximated(why) => {
                        project.report.approximated(LineColumn::START, element, why);
                    }
                    Outcome::Refused(why) => project.report.refused(LineColumn::START, element, why),
                    Outcome::Translated => {}
                }
            }
        }
        project.globals.extend(globals.into_iter().cloned());
        project.types.extend(types.into_iter().cloned());
        for unit in units {
            let mut unit = unit.clone();
            // A program that others call is a block that is there once.
            if unit.kind == UnitKind::Program {
                unit.kind = UnitKind::FunctionBlock;
                let instance = Variable::local(unit.place, unit.name.clone(), Type::Named(unit.name.clone()));
                project.globals.push(Variable {
                    role: Role::Global,
                    ..instance
                });
            }
            project.units.push(unit);
        }
    }
}

/// Whether no nearer file, and not the one that is read, declares a name.
fn is_new<T>(known: &[T], name_of: impl Fn(&T) -> &String, name: &str) -> bool {
    known
        .iter()
        .all(|known| !name_of(known).eq_ignore_ascii_case(name))
}

/// Lets all that is held be at the start: its places are those of another file.
fn at_start(held: &mut Held) {
    for declared in &mut held.types {
        declared.place = LineColumn::START;
    }
    for global in &mut held.globals {
        global.place = LineColumn::START;
    }
    for unit in &mut held.units {
        unit.place = LineColumn::START;
        for variable in &mut unit.variables {
            variable.place = LineColumn::START;
        }
        let parts = unit.parts.iter_mut().map(|part| {
            part.place = LineColumn::START;
            &mut part.body
        });
        for body in parts.chain([&mut unit.body]) {
            match body {
                Body::Graph(graph) => {
                    for node in &mut graph.nodes {
                        node.place = LineColumn::START;
                    }
                    graph.networks.clear();
                }
                Body::Text(_, _, place) => *place = LineColumn::START,
                Body::Chart(_) | Body::Ladder(_) | Body::Empty => {}
            }
        }
    }
}

//! What a project of OpenPLC Editor 4 has beside a unit: `project.json` with types, globals and tasks, types as texts, and the
//! functions and function blocks of its folder `pous`, in ladder or Structured Text.

use crate::{header, rungs};
use ladder_notation::{LineColumn, Lines, ReadError, Report, Source};
use ladder_notation_plcopen::declarations::{Declared, initial_of, type_of, without_comments};
use ladder_notation_plcopen::model::{
    Body, Initial, Project, Role, Task, Type, TypeDeclaration, Unit, UnitKind, Variable,
};
use ladder_notation_plcopen::neighbours::{Held, add_with_used};
use serde::Deserialize;

/// The file that a project's folder has.
pub(crate) const PROJECT: &str = "project.json";

/// Whether a file may hold something that a unit uses.
pub(crate) fn is_file(name: &str) -> bool {
    let (folder, name) = name.rsplit_once('/').unwrap_or(("", name));
    let is_block = folder.ends_with("function-blocks") || folder.ends_with("functions");
    match ending(name) {
        "dt" => true,
        "ld" | "st" => folder.is_empty() || is_block,
        _ => name == PROJECT,
    }
}

/// How a name ends, after its last dot.
fn ending(name: &str) -> &str {
    name.rsplit_once('.').map_or("", |(_, ending)| ending)
}

/// The project that a unit's file is, with what that uses of others.
///
/// # Errors
///
/// If it is not such a unit.
pub(crate) fn project(source: &Source<'_>) -> Result<Project, ReadError> {
    let text = source.text()?;
    let mut project = Project::default();
    let own = drawn(text, &mut project.report)?;
    if own.kind == UnitKind::Program {
        let files = source.companions.iter();
        let file = files
            .into_iter()
            .find(|file| file.name.rsplit('/').next() == Some(PROJECT));
        let tasks = file.and_then(|file| {
            Some(
                File::of(Source::alone("", &file.bytes).text().ok()?)
                    .ok()?
                    .tasks_of(&own),
            )
        });
        project.tasks = tasks.unwrap_or_default();
    }
    add_with_used(&mut project, own, text, source, held);
    Ok(project)
}

/// What another file holds.
fn held(name: &str, text: &str, report: &mut Report) -> Result<Held, ReadError> {
    if name.ends_with(PROJECT) {
        return Ok(File::of(text)?.held());
    }
    let mut held = Held::default();
    match ending(name) {
        "dt" => held
            .types
            .extend(declared(text, text.len(), |declared| declared.data_type(report))),
        "ld" => held.units.push(drawn(text, report)?),
        _ => held.units.push(written(text, report)?),
    }
    Ok(held)
}

/// A unit in ladder.
fn drawn(text: &str, report: &mut Report) -> Result<Unit, ReadError> {
    let (mut unit, json) = header::read(text, report)?;
    unit.body = Body::Graph(rungs::read(text, json, report)?);
    Ok(unit)
}

/// A unit in Structured Text: its statements come after the last section of variables.
fn written(text: &str, report: &mut Report) -> Result<Unit, ReadError> {
    let upper = without_comments(text).to_ascii_uppercase();
    let line = upper
        .trim_start()
        .find('\n')
        .map_or(upper.len(), |at| at + upper.len() - upper.trim_start().len());
    let start = upper.rfind("END_VAR").map_or(line, |at| at + "END_VAR".len());
    let ends = ["END_FUNCTION", "END_PROGRAM"];
    let end = ends
        .iter()
        .filter_map(|end| upper.rfind(end))
        .max()
        .filter(|end| *end >= start);
    let mut unit = declared(text, start, |declared| declared.unit(report))?;
    let place = Lines::of(text).place(text, start);
    unit.body = Body::Text("ST", text[start..end.unwrap_or(text.len())].to_owned(), place);
    Ok(unit)
}

/// What a text declares up to a place.
fn declared<T>(text: &str, end: usize, read: impl FnOnce(&Declared<'_>) -> T) -> T {
    let lines = Lines::of(text);
    let plain = without_comments(text);
    read(&Declared {
        text: &text[..end],
        plain: &plain[..end],
        place: &|offset| lines.place(text, offset),
    })
}

/// `project.json`.
#[derive(Deserialize)]
struct File {
    #[serde(default)]
    data: Data,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Data {
    data_types: Vec<DataType>,
    configuration: Configuration,
}

#[derive(Deserialize, Default)]
#[serde(default)]
struct Configuration {
    resource: Resource,
}

#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", default)]
struct Resource {
    tasks: Vec<TaskOfFile>,
    instances: Vec<Instance>,
    global_variables: Vec<Global>,
}

#[derive(Deserialize)]
struct TaskOfFile {
    name: String,
    #[serde(default)]
    interval: Option<String>,
    #[serde(default)]
    priority: i64,
}

#[derive(Deserialize)]
struct Instance {
    task: String,
    program: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Global {
    name: String,
    #[serde(rename = "type")]
    ty: TypeOfFile,
    #[serde(default)]
    location: String,
    #[serde(default)]
    initial_value: Option<String>,
    #[serde(default)]
    documentation: String,
}

#[derive(Deserialize)]
struct TypeOfFile {
    #[serde(default)]
    value: String,
    #[serde(default)]
    data: Option<ArrayType>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct ArrayType {
    base_type: Base,
    dimensions: Vec<Dimension>,
}

#[derive(Deserialize)]
struct Base {
    value: String,
}

#[derive(Deserialize)]
struct Dimension {
    dimension: String,
}

#[derive(Deserialize)]
#[serde(tag = "derivation", rename_all = "lowercase")]
enum DataType {
    Structure {
        name: String,
        variable: Vec<Member>,
    },
    #[serde(rename_all = "camelCase")]
    Enumerated {
        name: String,
        values: Vec<Value>,
        #[serde(default)]
        initial_value: Option<String>,
    },
    #[serde(rename_all = "camelCase")]
    Array {
        name: String,
        #[serde(flatten)]
        ty: ArrayType,
        #[serde(default)]
        initial_value: Option<String>,
    },
}

#[derive(Deserialize)]
struct Value {
    description: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Member {
    name: String,
    #[serde(rename = "type")]
    ty: TypeOfFile,
    #[serde(default)]
    initial_value: Option<InitialOfFile>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct InitialOfFile {
    simple_value: SimpleValue,
}

#[derive(Deserialize)]
struct SimpleValue {
    value: String,
}

impl File {
    fn of(text: &str) -> Result<File, ReadError> {
        serde_json::from_str(text).map_err(|error| {
            let place = LineColumn {
                line: error.line() as u32,
                column: error.column() as u32,
            };
            ReadError::at(place, format!("this is not a project of OpenPLC: {error}"))
        })
    }

    /// The tasks that run a program.
    fn tasks_of(self, program: &Unit) -> Vec<Task> {
        let Resource { tasks, instances, .. } = self.data.configuration.resource;
        let runs = |task: &TaskOfFile| {
            let mut own = instances.iter().filter(|instance| instance.task == task.name);
            own.any(|instance| instance.program.eq_ignore_ascii_case(&program.name))
        };
        let tasks = tasks.into_iter().filter(runs).map(|task| Task {
            place: LineColumn::START,
            name: task.name,
            interval: task.interval.filter(|interval| !interval.is_empty()),
            event: None,
            priority: task.priority,
            programs: vec![(LineColumn::START, program.name.clone())],
        });
        tasks.collect()
    }

    fn held(self) -> Held {
        let globals = self.data.configuration.resource.global_variables.into_iter();
        Held {
            units: Vec::new(),
            types: self.data.data_types.into_iter().map(DataType::declared).collect(),
            globals: globals.map(Global::declared).collect(),
        }
    }
}

impl Global {
    fn declared(self) -> Variable {
        let filled = |text: String| (!text.trim().is_empty()).then_some(text);
        Variable {
            place: LineColumn::START,
            name: self.name,
            role: Role::Global,
            qualifier: None,
            address: filled(self.location),
            ty: self.ty.declared(),
            initial: self.initial_value.and_then(filled).map(|text| initial_of(&text)),
            comment: filled(self.documentation),
        }
    }
}

impl TypeOfFile {
    fn declared(self) -> Type {
        self.data
            .map_or_else(|| type_of(&self.value), ArrayType::declared)
    }
}

impl ArrayType {
    fn declared(self) -> Type {
        let bounds = self.dimensions.iter().map(|dimension| {
            let (low, high) = dimension
                .dimension
                .split_once("..")
                .unwrap_or(("0", &dimension.dimension));
            (low.trim().to_owned(), high.trim().to_owned())
        });
        Type::Array(bounds.collect(), Box::new(type_of(&self.base_type.value)))
    }
}

impl DataType {
    fn declared(self) -> TypeDeclaration {
        let (name, ty, initial) = match self {
            DataType::Structure { name, variable } => {
                let members = variable.into_iter().map(|member| Variable {
                    place: LineColumn::START,
                    name: member.name,
                    role: Role::Local,
                    qualifier: None,
                    address: None,
                    ty: member.ty.declared(),
                    initial: member
                        .initial_value
                        .map(|initial| initial_of(&initial.simple_value.value)),
                    comment: None,
                });
                (name, Type::Structure(members.collect()), None)
            }
            DataType::Enumerated {
                name,
                values,
                initial_value,
            } => {
                let values = values.into_iter().map(|value| (value.description, None));
                (name, Type::Enumeration(values.collect()), initial_value)
            }
            DataType::Array {
                name,
                ty,
                initial_value,
            } => (name, ty.declared(), initial_value),
        };
        let initial = initial.filter(|text| !text.is_empty());
        TypeDeclaration {
            place: LineColumn::START,
            name,
            ty,
            initial: initial.map(|text| -> Initial { initial_of(&text) }),
            comment: None,
        }
    }
}

//! A unit with what it uses of the files next to it: other units, types, globals.

use crate::unit;
use ladder_notation::xml::{Element, Xml};
use ladder_notation::{LineColumn, Outcome, ReadError, Report, Source};
use ladder_notation_plcopen::model::{
    Body, Evaluation, Project, Type, TypeDeclaration, Unit, UnitKind, Variable,
};
use std::collections::HashSet;

/// How the names of files end that hold what a unit may use.
const ENDS: [&str; 3] = [".tcpou", ".tcdut", ".tcgvl"];

/// Whether a file may hold something that a unit uses.
pub(crate) fn is_file(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    ENDS.iter().any(|end| name.ends_with(end))
}

/// The project that a file is.
///
/// # Errors
///
/// If it is not XML, or no unit.
pub(crate) fn project(source: &Source<'_>) -> Result<Project, ReadError> {
    let text = source.text()?;
    let mut project = Project {
        evaluation: Evaluation::Once,
        ..Project::default()
    };
    let xml = Xml::parse(text)?;
    let root = xml.document.root_element();
    let Some(node) = root.child("POU") else {
        let what = root
            .elements()
            .next()
            .map_or("nothing", |inside| Element::name(&inside));
        let message = format!("only units (`<POU>`) are read, and this file has `<{what}>`");
        return Err(ReadError::at(xml.place(root), message));
    };
    let own = unit::unit(text, &xml, node, &mut project.report)?;
    let mut names = HashSet::new();
    add_names(&mut names, text);
    let mut others: Vec<File<'_>> = Vec::new();
    others.extend(
        source
            .companions
            .iter()
            .map(|file| File::of(&file.name, &file.bytes)),
    );
    // What is used uses something itself.
    loop {
        let before = names.len();
        for file in &mut others {
            file.take(&mut project, &mut names);
        }
        if names.len() == before {
            break;
        }
    }
    project.units.push(own);
    Ok(project)
}

/// Adds all names of a text, in small letters.
fn add_names(names: &mut HashSet<String>, text: &str) {
    let words = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    names.extend(words.map(str::to_lowercase));
}

/// A file next to the unit.
struct File<'f> {
    name: &'f str,
    text: &'f str,
    held: Held,
    report: Report,
}

/// What a file holds.
enum Held {
    Unit(Unit),
    Type(TypeDeclaration),
    Globals(Vec<Variable>),
    /// Something that units do not use.
    Nothing,
    /// Why it cannot be read.
    Broken(ReadError),
}

impl<'f> File<'f> {
    fn of(name: &'f str, bytes: &'f [u8]) -> File<'f> {
        let mut report = Report::default();
        let text = Source::alone(name, bytes).text();
        let held = text
            .clone()
            .and_then(|text| File::held(text, &mut report))
            .unwrap_or_else(Held::Broken);
        File {
            name,
            text: text.unwrap_or_default(),
            held,
            report,
        }
    }

    fn held(text: &str, report: &mut Report) -> Result<Held, ReadError> {
        let xml = Xml::parse(text)?;
        let root = xml.document.root_element();
        if let Some(node) = root.child("POU") {
            let mut unit = unit::unit(text, &xml, node, report)?;
            if unit.kind == UnitKind::Program {
                return Ok(Held::Nothing);
            }
            at_start(&mut unit);
            return Ok(Held::Unit(unit));
        }
        if let Some(node) = root.child("DUT") {
            let ty = unit::declared(text, &xml, node, |declared| declared.data_type(report))?;
            let ty = ty.map(|ty| TypeDeclaration {
                place: LineColumn::START,
                ..ty
            });
            return Ok(ty.map_or(Held::Nothing, Held::Type));
        }
        let Some(node) = root.child("GVL") else {
            return Ok(Held::Nothing);
        };
        let mut globals = unit::declared(text, &xml, node, |declared| declared.globals(report))?;
        for global in &mut globals {
            global.place = LineColumn::START;
        }
        Ok(Held::Globals(globals))
    }

    /// Takes over what these names are names of.
    fn take(&mut self, project: &mut Project, names: &mut HashSet<String>) {
        let is_used = |name: &str| names.contains(&name.to_lowercase());
        let is_used_type = |declared: &TypeDeclaration| {
            let is_value = match &declared.ty {
                Type::Enumeration(values) => values.iter().any(|(name, _)| is_used(name)),
                _ => false,
            };
            is_value || is_used(&declared.name)
        };
        match std::mem::replace(&mut self.held, Held::Nothing) {
            Held::Unit(unit) if is_used(&unit.name) => project.units.push(unit),
            Held::Type(declared) if is_used_type(&declared) => project.types.push(declared),
            Held::Globals(mut globals) => {
                let used: Vec<Variable> = globals.extract_if(.., |global| is_used(&global.name)).collect();
                for global in &used {
                    // The names of types and constants in it.
                    add_names(names, &format!("{:?} {:?}", global.ty, global.initial));
                }
                project.globals.extend(used);
                self.held = Held::Globals(globals);
                return;
            }
            Held::Broken(error) if self.name.split('.').next().is_some_and(is_used) => {
                let file = format!("file {}", self.name);
                let why = format!("it is not read: {error}");
                project.report.refused(LineColumn::START, file, why);
            }
            unused => {
                self.held = unused;
                return;
            }
        }
        add_names(names, self.text);
        for entry in self.report.remarks() {
            let element = format!("{} of {}", entry.element, self.name);
            match &entry.outcome {
                Outcome::Approximated(why) => project.report.approximated(LineColumn::START, element, why),
                Outcome::Refused(why) => project.report.refused(LineColumn::START, element, why),
                Outcome::Translated => {}
            }
        }
    }
}

/// Lets all that a unit has be at the start: its places are those of another file.
fn at_start(unit: &mut Unit) {
    unit.place = LineColumn::START;
    for variable in &mut unit.variables {
        variable.place = LineColumn::START;
    }
    let parts = unit.parts.iter_mut().map(|part| {
        part.place = LineColumn::START;
        &mut part.body
    });
    for body in parts.chain([&mut unit.body]) {
        if let Body::Graph(graph) = body {
            for node in &mut graph.nodes {
                node.place = LineColumn::START;
            }
        }
    }
}

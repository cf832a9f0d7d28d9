//! Plants beside a program (LANGUAGE §9): which tags of theirs are connected with which of its own, and the networks that hand the
//! values over.

use crate::analyze::Analysis;
use crate::findings::article::with_article;
use crate::names::scope::{Origin, SectionKind};
use crate::program::{
    Argument, Block, BlockKind, Bound, Connection, Expr, ExprKind, Location, Network, Place, Plant, Program,
    Role, Step, Tag, TagId,
};
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use ladder_instructions::{Instruction, Op, by_op};
use ladder_syntax::{Name, TextRange};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// A file that runs beside a program as a model of its machine.
#[derive(Debug, Clone)]
pub struct PlantFile {
    /// The file.
    pub analysis: Arc<Analysis>,
    /// What is before the names of its tags: `plant` in `plant.level`.
    pub name: String,
}

/// Two tags that are connected though their names differ, as they are written; one of them is of a plant.
pub type Connect = (String, String);

/// What an error of a plant is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Blames {
    /// The plant of this number.
    Plant(usize),
    /// The connection of this number.
    Connect(usize),
}

/// Why a plant cannot run beside a program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlantError {
    /// What it is about.
    pub blames: Blames,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: String,
}

/// Connects the plants that a program is linked with, whose files begin with this one.
pub(crate) fn connect(
    program: &mut Program,
    first_file: usize,
    files: &[PlantFile],
    connects: &[Connect],
) -> Vec<PlantError> {
    let first_function = program.functions.len() - files.len();
    program.plants = (files.iter().enumerate())
        .map(|(number, file)| Plant {
            name: file.name.clone(),
            file: (first_file + number) as u32,
            function: first_function + number,
            inputs: Vec::new(),
            outputs: Vec::new(),
        })
        .collect();
    let mut connector = Connector {
        names: names(program),
        program,
        errors: Vec::new(),
        driven: FxHashMap::default(),
    };
    for (number, file) in files.iter().enumerate() {
        connector.check_plant(number, file);
    }
    // Whose tags are whose is known only where the names are right.
    if !connector.errors.is_empty() {
        return connector.errors;
    }
    for (number, connect) in connects.iter().enumerate() {
        connector.by_hand(number, connect);
    }
    for plant in 0..files.len() {
        connector.by_name(plant);
    }
    let errors = connector.errors;
    wire(program);
    errors
}

/// The tags that are not in bodies, by all their names.
fn names(program: &Program) -> FxHashMap<Name, TagId> {
    let tags = (0..).map(TagId).zip(&program.tags);
    let mut names = FxHashMap::default();
    for (id, tag) in tags.filter(|(_, tag)| tag.block.is_none()) {
        names.entry(Name::new(&tag.name)).or_insert(id);
        if let Some(address) = &tag.address {
            names.entry(Name::new(address)).or_insert(id);
        }
    }
    for other in program.other_names.iter().filter(|other| other.block.is_none()) {
        names.entry(Name::new(&other.name)).or_insert(other.tag);
    }
    names
}

struct Connector<'p> {
    program: &'p mut Program,
    names: FxHashMap<Name, TagId>,
    errors: Vec<PlantError>,
    /// The tags that take a value, each with the tag whose value it is.
    driven: FxHashMap<TagId, TagId>,
}

impl Connector<'_> {
    fn error(&mut self, blames: Blames, message: impl Into<String>, help: impl Into<String>) {
        self.errors.push(PlantError {
            blames,
            message: message.into(),
            help: help.into(),
        });
    }

    fn tag(&self, id: TagId) -> &Tag {
        &self.program.tags[id.0 as usize]
    }

    /// The name of a plant is its own, and nothing in it is a tag of the workspace.
    fn check_plant(&mut self, number: usize, file: &PlantFile) {
        const RENAME: &str = "give the plant another name, as in: plant tank.clad as tank";
        let blames = Blames::Plant(number);
        let is_name = |text: &str| {
            text.starts_with(|c: char| c.is_ascii_alphabetic())
                && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        let name = &file.name;
        if !is_name(name) || ["SYS", "PORT"].iter().any(|own| name.eq_ignore_ascii_case(own)) {
            return self.error(
                blames,
                format!("a plant cannot be called `{name}`"),
                "a name is letters, digits and _, as in: plant tank.clad as tank",
            );
        }
        let before = &self.program.plants[..number];
        if before.iter().any(|other| other.name.eq_ignore_ascii_case(name)) {
            return self.error(
                blames,
                format!("two plants are called `{name}`"),
                "name each, as in: plant tank.clad as tank",
            );
        }
        let is_other = |tag: &&Tag| {
            let root = tag.name.split(['.', '[']).next().unwrap_or_default();
            tag.block.is_none() && root.eq_ignore_ascii_case(name) && !self.is_in(number, tag)
        };
        if self.program.tags.iter().any(|tag| is_other(&tag)) {
            return self.error(
                blames,
                format!("the program has a tag `{name}`, which is the name of the plant, too"),
                RENAME,
            );
        }
        let context = &file.analysis.context;
        let mut tags = context.scopes.iter().flat_map(|scope| &scope.tags);
        let is_global = |origin: Origin| {
            matches!(
                origin,
                Origin::Declared(SectionKind::Global | SectionKind::External)
            )
        };
        if let Some(global) = tags.find(|tag| tag.cold.foreign.is_some() || is_global(tag.origin)) {
            let message = format!(
                "the plant names `{}`, a VAR_GLOBAL tag: those of the workspace are the program's",
                global.name
            );
            self.error(
                blames,
                message,
                "declare it in the plant as VAR_INPUT or VAR_OUTPUT, which are connected by name",
            );
        }
    }

    fn is_in(&self, plant: usize, tag: &Tag) -> bool {
        // A structure `plant` of the program has parts whose names begin likewise.
        tag.location.file == self.program.plants[plant].file
            && self.program.plants[plant].tag_in(&tag.name).is_some()
    }

    /// A line `connect`.
    fn by_hand(&mut self, number: usize, connect: &Connect) {
        let blames = Blames::Connect(number);
        let mut ends = [None; 2];
        for (end, name) in ends.iter_mut().zip([&connect.0, &connect.1]) {
            let Some(&id) = self.names.get(&Name::new(name.trim())) else {
                let name = name.trim();
                return self.error(
                    blames,
                    format!("there is no tag `{name}`"),
                    "connect a whole tag of a plant with one of the program, as in: connect plant.sensor_1 = near",
                );
            };
            let plants = &self.program.plants;
            let plant = plants
                .iter()
                .position(|plant| plant.tag_in(name.trim()).is_some());
            *end = Some((id, plant));
        }
        let ([Some((theirs, Some(plant))), Some((ours, None))]
        | [Some((ours, None)), Some((theirs, Some(plant)))]) = ends
        else {
            let name = &self.program.plants.first().map_or("plant", |plant| &plant.name);
            let help = format!("write it as in: connect {name}.sensor_1 = near");
            return self.error(
                blames,
                "one side is a tag of a plant, the other one of the program",
                help,
            );
        };
        if !self.are_alike(ours, theirs) {
            let (message, _) = self.types_differ(ours, theirs);
            return self.error(
                blames,
                message,
                "only tags of one type are connected: convert it in the plant, as in: [TYP]( sensor, wide )",
            );
        }
        let into_plant = self.tag(theirs).role == Role::Input;
        if !into_plant && !self.tag(ours).is_input && self.tag(ours).role != Role::Input {
            let message = format!(
                "{} is not an input of the program, and {} none of the plant",
                self.tag(ours).name,
                self.tag(theirs).name
            );
            return self.error(blames, message, "connect an output with an input");
        }
        self.join(blames, plant, into_plant, (ours, theirs));
    }

    /// Outputs and inputs of one name and type.
    fn by_name(&mut self, plant: usize) {
        let blames = Blames::Plant(plant);
        let tags: Vec<TagId> = (0..self.program.tags.len() as u32).map(TagId).collect();
        for theirs in tags {
            let tag = self.tag(theirs);
            if tag.block.is_some() || !self.is_in(plant, tag) {
                continue;
            }
            let Some(own) = self.program.plants[plant].tag_in(&tag.name) else {
                continue;
            };
            if own.starts_with('%') {
                continue;
            }
            let Some(&ours) = self.names.get(&Name::new(own)) else {
                continue;
            };
            let into_plant = match (tag.role, self.tag(ours).role) {
                (Role::Input, Role::Output) => true,
                (Role::Output, Role::Input) => false,
                _ => continue,
            };
            let by_hand = |id: &TagId| self.driven.contains_key(id);
            let is_source = |id: &TagId| self.driven.values().any(|source| source == id);
            if by_hand(&theirs) && into_plant || by_hand(&ours) && is_source(&theirs) && !into_plant {
                continue;
            }
            if !self.are_alike(ours, theirs) {
                let (message, other) = self.types_differ(ours, theirs);
                let help = format!(
                    "give both one type, or connect another tag, as in: connect {} = {other}",
                    self.tag(theirs).name
                );
                self.error(blames, message, help);
                continue;
            }
            self.join(blames, plant, into_plant, (ours, theirs));
        }
    }

    fn are_alike(&self, ours: TagId, theirs: TagId) -> bool {
        let (ours, theirs) = (self.tag(ours), self.tag(theirs));
        ours.ty == theirs.ty && elementary(ours.ty).is_some()
    }

    fn types_differ(&self, ours: TagId, theirs: TagId) -> (String, String) {
        let (ours, theirs) = (self.tag(ours), self.tag(theirs));
        let (one, other) = (with_article(theirs.ty), with_article(ours.ty));
        let message = match elementary(ours.ty) {
            None if ours.ty == theirs.ty => format!(
                "{} is {one}: the state of a timer, counter or block is not connected",
                theirs.name
            ),
            _ => format!("{} is {one}, and {} is {other}", theirs.name, ours.name),
        };
        (message, format!("other_{}", ours.name))
    }

    fn join(&mut self, blames: Blames, plant: usize, into_plant: bool, (ours, theirs): (TagId, TagId)) {
        let connection = if into_plant {
            Connection {
                from: ours,
                to: theirs,
            }
        } else {
            Connection {
                from: theirs,
                to: ours,
            }
        };
        if let Some(&other) = self.driven.get(&connection.to) {
            let message = format!(
                "{} takes the value of both {} and {}",
                self.tag(connection.to).name,
                self.tag(other).name,
                self.tag(connection.from).name
            );
            return self.error(blames, message, "an input has one source: leave only one of them");
        }
        self.driven.insert(connection.to, connection.from);
        self.program.tags[connection.to.0 as usize].is_input = false;
        let plant = &mut self.program.plants[plant];
        if into_plant {
            plant.inputs.push(connection);
        } else {
            plant.outputs.push(connection);
        }
    }
}

/// The type of what a connection hands over, one by one.
fn elementary(ty: Type) -> Option<Scalar> {
    match ty {
        Type::Scalar(ty) | Type::Array { element: ty, .. } => Some(ty),
        Type::State(_) | Type::Compound(_) => None,
    }
}

/// Adds the networks that run before the main program.
fn wire(program: &mut Program) {
    let mut networks = Vec::new();
    for plant in &program.plants {
        networks.extend(plant.inputs.iter().flat_map(|it| moves(program, *it, it.to)));
    }
    for plant in &program.plants {
        let location = Location {
            file: plant.file,
            range: TextRange::default(),
        };
        let function = Bound {
            operand: Some(&by_op(Op::Call).operands[0]),
            parameter: None,
            argument: Argument::Function(plant.function),
            range: location.range,
        };
        networks.push(network(by_op(Op::Call), vec![function], None, location));
    }
    for plant in &program.plants {
        networks.extend(plant.outputs.iter().flat_map(|it| moves(program, *it, it.from)));
    }
    let first = program.networks.len();
    program.networks.extend(networks);
    program.wiring = first..program.networks.len();
}

/// `[MOV]( to, from )`, of an array for each element. It is shown where the plant declares its tag.
fn moves(program: &Program, connection: Connection, of_plant: TagId) -> Vec<Network> {
    let tag = &program.tags[of_plant.0 as usize];
    let range = tag.location.range;
    let row = by_op(Op::Mov);
    let element = |ty: Scalar, place: &dyn Fn(TagId) -> Place| {
        let read = Expr {
            ty,
            kind: ExprKind::Read(place(connection.from)),
            range,
        };
        let bound = |operand: usize, argument| Bound {
            operand: Some(&row.operands[operand]),
            parameter: None,
            argument,
            range,
        };
        let arguments = vec![
            bound(0, Argument::Place(place(connection.to), ty)),
            bound(1, Argument::Value(read)),
        ];
        network(row, arguments, Some(ty), tag.location)
    };
    match tag.ty {
        Type::Scalar(ty) => vec![element(ty, &Place::Tag)],
        Type::Array {
            first,
            last,
            element: ty,
        } => {
            let index = |at: i64| Expr {
                ty: Scalar::Dint,
                kind: ExprKind::Constant(Value::Int(at)),
                range,
            };
            let at = |at: i64| element(ty, &|tag| Place::Element(tag, Box::new(index(at))));
            (first..=last).map(at).collect()
        }
        Type::State(_) | Type::Compound(_) => Vec::new(),
    }
}

fn network(
    row: &'static Instruction,
    arguments: Vec<Bound>,
    works_in: Option<Scalar>,
    location: Location,
) -> Network {
    Network {
        location,
        steps: vec![Step::Start { rail: true }, Step::Block { block: 0, en: 0 }],
        blocks: vec![Block {
            kind: BlockKind::Instruction(row),
            location,
            arguments,
            works_in,
            unread: None,
        }],
        elements: Vec::new(),
    }
}

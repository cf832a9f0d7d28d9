//! From a block of a controller to ladder text: opened alone as a program that runs, and as the files of a workspace, where
//! it is a block that other programs use.

mod call;
mod declare;
mod memory;
mod network;
pub(crate) mod rungs;
mod structured;
mod translate;
mod unread;
pub(crate) mod wiring;

use crate::model::{Kind, Type, Unit};
use crate::scope::{Library, Scope, block_name};
use call::Labels;
use declare::Sections;
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Drawing, Element, Item, Network, Path, ProgramSketch, Section, SectionKind,
};
use ladder_notation::{Content, LineColumn, Names, ProjectFile, Reading, UnreadParts, is_function};
use std::collections::{HashMap, HashSet};
use translate::Translator;

/// No more blocks come along with one.
const MOST_BLOCKS: usize = 500;

/// What makes a sketch of a block.
struct Sketcher<'l> {
    library: &'l Library<'l>,
    reading: Reading,
    /// The blocks that are used.
    needed: Vec<String>,
    /// Types by their names in the project; none where one is being declared, or cannot be.
    types: HashMap<String, Option<String>>,
    type_names: Names,
    type_section: Section,
    unread: UnreadParts,
}

/// As what a block is sketched.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// A program that runs.
    Program,
    /// A program that runs at an event, next to another.
    Event,
    /// A block that others use.
    Block,
}

/// The sketch of a block, with what it uses of the blocks next to it.
pub(crate) fn reading(unit: &Unit, library: &Library<'_>) -> Reading {
    let mut reading = sketch(unit, library, Form::Program);
    if matches!(unit.kind, Kind::FunctionBlock | Kind::Function) {
        let content = Content::Program(sketch(unit, library, Form::Block).program);
        let name = format!("{}.clad", &block_name(&unit.name)[1..]);
        reading.files.push(ProjectFile { name, content });
    }
    reading.report.entries.sort_by_key(|entry| entry.place);
    reading.findings.sort_by_key(|finding| finding.place);
    reading
}

fn sketch(unit: &Unit, library: &Library<'_>, form: Form) -> Reading {
    let mut sketcher = Sketcher {
        library,
        reading: Reading {
            report: unit.report.clone(),
            ..Reading::default()
        },
        needed: Vec::new(),
        types: HashMap::new(),
        type_names: Names::default(),
        type_section: Section::new(SectionKind::Type),
        unread: UnreadParts::default(),
    };
    sketcher.program(unit, form);
    sketcher.reading
}

impl Sketcher<'_> {
    fn program(&mut self, unit: &Unit, form: Form) {
        let networks = unit.networks.iter().zip(1..);
        let names = networks.map(|(own, number)| (own.place, format!("network {number} of {}", unit.name)));
        let own = unit.kind.keyword().to_lowercase().replace('_', " ");
        let own = (unit.place, format!("{own} {}", unit.name));
        self.reading.names = std::iter::once(own).chain(names).collect();
        let is_block = form == Form::Block;
        let shown = format!("{} {}", unit.kind.keyword(), unit.name);
        if unit.kind == Kind::Organization {
            let why = "it is the program here, and runs in every scan: what starts it is not in the file";
            self.reading.report.approximated(unit.place, shown, why);
        } else {
            self.reading.report.translated(unit.place, shown);
        }
        let mut body = match unit.kind {
            Kind::Type => {
                let ty = Type::Structure(unit.variables.clone());
                let known = self.structure_alone(unit, &ty);
                if let Err(why) = known {
                    self.reading
                        .report
                        .refused(unit.place, format!("type {}", unit.name), why);
                }
                Vec::new()
            }
            // An empty data block is nothing.
            Kind::Data if unit.returns.is_none() && unit.variables.is_empty() => Vec::new(),
            Kind::Data => {
                let mut scope = Scope::of(&Unit::default(), self.library);
                let ty = unit
                    .returns
                    .clone()
                    .unwrap_or_else(|| Type::Named(unit.name.clone()));
                scope.global(&unit.name, ty);
                let mut sections = Sections::default();
                self.globals(&scope, &mut sections);
                sections.items()
            }
            _ => self.unit(unit, is_block),
        };
        let mut blocks = Vec::new();
        let mut done = HashSet::from([unit.name.to_lowercase()]);
        while let Some(name) = self.needed.pop() {
            let library = self.library;
            if done.len() > MOST_BLOCKS || !done.insert(name.to_lowercase()) {
                continue;
            }
            if let Some(Ok(unit)) = library.get(&name.to_lowercase()) {
                // Its findings are reported where it is read itself.
                let before = (self.reading.report.clone(), self.reading.findings.clone());
                let places = self.reading.places.len();
                let body = self.unit(unit, true);
                (self.reading.report, self.reading.findings) = before;
                self.reading.places[places..].fill(LineColumn::START);
                blocks.push(Item::Blank);
                blocks.extend(unit.told.iter().cloned().map(Item::Comment));
                blocks.push(block(unit, body));
            }
        }
        if unit.kind == Kind::Organization && form == Form::Program {
            let own: Vec<Item> = body.iter().chain(&blocks).cloned().collect();
            let events = self.at_events(unit, &own);
            let first = body.iter().position(|item| !matches!(item, Item::Section(_)));
            let first = first.unwrap_or(body.len());
            body.splice(first..first, events);
        }
        let mut items: Vec<Item> = unit.told.iter().cloned().map(Item::Comment).collect();
        if !self.type_section.declarations.is_empty() {
            items.extend([Item::Blank, Item::Section(self.type_section.clone())]);
        }
        items.extend(self.unread.items());
        items.extend(blocks);
        if !items.is_empty() {
            items.push(Item::Blank);
        }
        if is_block {
            let block = block(unit, body);
            items.push(block);
        } else {
            items.extend(body);
        }
        self.reading.program = ProgramSketch { items };
    }

    fn structure_alone(&mut self, unit: &Unit, ty: &Type) -> Result<(), String> {
        let name = Type::Named(unit.name.clone());
        let ty = if self.library.contains_key(&unit.name.to_lowercase()) {
            &name
        } else {
            ty
        };
        self.type_text(ty, &unit.name).map(drop)
    }

    /// Declarations and networks of a block.
    fn unit(&mut self, unit: &Unit, is_block: bool) -> Vec<Item> {
        if unread::leads_elsewhere(unit) {
            return self.unread_unit(unit, is_block);
        }
        let (entries, places, parts) = (
            self.reading.report.entries.len(),
            self.reading.places.len(),
            self.unread.len(),
        );
        let mut scope = Scope::of(unit, self.library);
        let memory = memory::of(unit);
        let mut translator = Translator {
            scope: &mut scope,
            labels: Labels::default(),
        };
        let mut networks = Vec::new();
        let is_function = unit.told.iter().any(|told| is_function(told));
        if is_block && (!unit.networks.is_empty() || is_function) {
            let guard = [Block::negated_contact(Path::tag("EN")), Block::ret()];
            let guard = guard.map(|block| Circuit::Element(Element::of(block, None)));
            networks.extend([
                Item::Blank,
                Item::Network(Network {
                    comments: Vec::new(),
                    drawing: Drawing::Circuit(Circuit::Series(guard.into())),
                }),
            ]);
        }
        for (number, network) in unit.networks.iter().enumerate() {
            let Some(made) = self.network(&mut translator, (unit, number), network) else {
                self.reading.report.entries.truncate(entries);
                self.reading.places.truncate(places);
                self.unread.truncate(parts);
                return self.unread_unit(unit, is_block);
            };
            networks.extend(made);
        }
        let mut sections = self.variables(unit, &scope, is_block, |name| {
            memory.contains(&name.to_lowercase())
        });
        self.globals(&scope, &mut sections);
        let mut items = sections.items();
        items.extend(networks);
        items
    }
}

/// A block of one's own. Without power it does not run there.
fn block(unit: &Unit, mut items: Vec<Item>) -> Item {
    let name = block_name(&unit.name);
    if name[1..] != unit.name {
        items.insert(0, Item::Comment(format!("{} in the project", unit.name)));
    }
    Item::Block {
        header: format!("[{name}]"),
        origin: None,
        items,
    }
}

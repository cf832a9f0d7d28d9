//! A project of several programs as the files of a folder.
//!
//! ```text
//! Cell.clad     the controller: its tags, for all files, and the main program, which calls the programs
//! Pump.clad     a program: its tags, and its routines as functions
//! types.clad    the types
//! blocks.clad   Add-On Instructions, and the blocks that the programs bring along
//! ladder.toml   what the checks need not say
//! ```

use crate::model::Project;
use crate::scope::CONTROLLER;
use crate::sketch::Sketcher;
use ladder_format::program::{Item, ProgramSketch, SectionKind};
use ladder_notation::names::Names;
use ladder_notation::{Content, ProjectFile};

/// The parts of a program.
pub(crate) struct Parts {
    pub(crate) types: Vec<Item>,
    /// What runs first.
    pub(crate) begin: Vec<Item>,
    /// The functions of each program.
    pub(crate) functions: Vec<(usize, Vec<Item>)>,
    pub(crate) blocks: Vec<Item>,
}

/// What the files are called, without their ending.
pub(crate) struct Stems {
    types: String,
    blocks: String,
    controller: String,
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
    pub(crate) fn files(&mut self, parts: Parts) -> Vec<ProjectFile> {
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
        let mut items = self.cycle();
        for mut item in self.declarations(|scope| scope == CONTROLLER) {
            if let Item::Section(section) = &mut item {
                section.kind = SectionKind::VarGlobal;
            }
            items.push(item);
        }
        let mut own: Vec<Vec<Item>> = Vec::new();
        for number in 0..project.programs.len() {
            let mut items = self.declarations(|scope| scope == CONTROLLER + 1 + number);
            let functions = parts.functions.iter().filter(|(program, _)| *program == number);
            items.extend(functions.flat_map(|(_, items)| items.clone()));
            own.push(items);
        }
        items.extend(parts.begin);
        add(&controller, items);
        for (name, items) in programs.iter().zip(own) {
            add(name, items);
        }
        add(&types, parts.types);
        add(&blocks, parts.blocks);
        files.push(ProjectFile {
            name: "ladder.toml".to_owned(),
            content: Content::Text(SETTINGS.to_owned()),
        });
        files
    }
}

/// Other devices reach the tags of a controller too, and its rungs go on after a coil.
const SETTINGS: &str = "[lint]\nnever-written = \"off\"\nnever-read = \"off\"\nset-without-reset = \"off\"\nreset-without-set = \"off\"\ncontact-after-coil = \"off\"\n";

//! What things are called in an export, by what they are called in the ladder text that it becomes.

use crate::folder::Stems;
use crate::model::{Project, Task};
use crate::plan::Plan;
use crate::scope::CONTROLLER;
use crate::sketch::{Sketcher, sketched};
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// The names of a project.
#[derive(Debug, Clone, Default)]
pub(crate) struct Originals {
    pub(crate) controller: String,
    /// What its file is called in a folder.
    pub(crate) controller_stem: String,
    /// The programs, and what their files are called in a folder.
    pub(crate) programs: Vec<(String, String)>,
    /// The program and the routine that each function is.
    pub(crate) functions: HashMap<Name, (usize, String)>,
    /// The routine that the main program is.
    pub(crate) main: Option<(usize, String)>,
    /// The tags, but those of Add-On Instructions: the program whose tag it is, and its name.
    pub(crate) tags: HashMap<Name, (Option<usize>, String)>,
    /// The tags of Add-On Instructions, by the blocks that these are.
    pub(crate) locals: HashMap<(Name, Name), String>,
    /// Members of types and parameters, where all of one name here are called alike there.
    pub(crate) members: HashMap<Name, String>,
    /// The types, those that the file declares among them.
    pub(crate) types: HashMap<Name, String>,
    pub(crate) declared: HashSet<String>,
    pub(crate) tasks: Vec<Task>,
}

impl Originals {
    /// Those of a file.
    pub(crate) fn of(project: &Project, text: &str) -> Originals {
        sketched(project, text, Originals::asked).1
    }

    fn asked(sketcher: &Sketcher<'_>, plan: &Plan) -> Originals {
        let project = sketcher.translator.project;
        let tags = &sketcher.translator.tags;
        let stems = Stems::of(project);
        let names = project.programs.iter().map(|program| program.name.clone());
        let mut originals = Originals {
            controller: project.name.clone(),
            controller_stem: stems.controller,
            programs: names.zip(stems.programs).collect(),
            tasks: project.tasks.clone(),
            declared: project
                .types
                .iter()
                .map(|ty| ty.name.to_ascii_uppercase())
                .collect(),
            ..Originals::default()
        };
        for (number, function) in plan.functions.iter().enumerate() {
            let unit = &sketcher.units[number];
            if let crate::unit::Owner::Program(program) = unit.owner {
                let routine = (program, unit.routine.name.clone());
                if plan.main == Some(number) {
                    originals.main = Some(routine.clone());
                }
                originals.functions.insert(Name::new(function), routine);
            }
        }
        let programs = project.programs.len();
        let mut members: HashMap<Name, Option<String>> = HashMap::new();
        let mut member = |name: &str, original: &str| {
            let known = members.entry(Name::new(name));
            let known = known.or_insert_with(|| Some(original.to_owned()));
            if known
                .as_ref()
                .is_some_and(|known| !known.eq_ignore_ascii_case(original))
            {
                *known = None;
            }
        };
        for symbol in tags.symbols.iter().filter(|symbol| !symbol.original.is_empty()) {
            let name = Name::new(&symbol.name);
            match symbol.scope.checked_sub(1 + programs) {
                Some(aoi) => {
                    let block = Name::new(&sketcher.translator.aoi_names[aoi]);
                    originals.locals.insert((block, name), symbol.original.clone());
                    member(&symbol.name, &symbol.original);
                }
                None => {
                    let program = (symbol.scope > CONTROLLER).then(|| symbol.scope - 1);
                    originals.tags.insert(name, (program, symbol.original.clone()));
                }
            }
        }
        for structure in &tags.types.all {
            originals
                .types
                .insert(Name::new(&structure.name), structure.original.clone());
            for field in &structure.members {
                member(&field.name, &field.original);
            }
        }
        for (name, aoi) in sketcher.translator.aoi_names.iter().zip(&project.aois) {
            originals.types.insert(Name::new(name), aoi.name.clone());
        }
        let members = members.into_iter();
        originals.members = members
            .filter_map(|(name, original)| Some((name, original?)))
            .collect();
        originals
    }
}

//! What was read from a file is where it was there, and what is new in the program of its file.

use super::orders::{First, called, ordered};
use super::{Layout, ProgramAt, TagAt, bare, free_main};
use crate::names::Originals;
use ladder_analysis::context::Body;
use ladder_notation::Project;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// The programs that the files of a folder are.
struct Homes {
    /// The programs of the file that they come from, by the files that these are, in small letters.
    stems: HashMap<String, usize>,
    /// The one file that was read holds all of its programs.
    is_alone: bool,
    /// What the file of the controller is called, in small letters.
    controller: String,
    found: HashMap<usize, usize>,
}

impl Homes {
    fn of(originals: &Originals, before: &Project) -> Homes {
        // The files are those that the functions were in, else those of the names.
        let mut stems: HashMap<String, usize> = HashMap::new();
        for (function, (program, _)) in &originals.functions {
            if let Some((file, _)) = before.home_of_function(function.as_str())
                && before.count() > 1
            {
                stems.insert(before.stem(file).to_lowercase(), *program);
            }
        }
        for (number, (_, stem)) in originals.programs.iter().enumerate() {
            stems.entry(stem.to_lowercase()).or_insert(number);
        }
        Homes {
            stems,
            is_alone: before.count() < 2,
            controller: originals.controller_stem.to_lowercase(),
            found: HashMap::new(),
        }
    }

    /// Whether a file has what all programs share, and is none itself.
    fn is_controller(&self, project: &Project, file: usize) -> bool {
        let stem = project.stem(file).to_lowercase();
        !self.is_alone && !self.stems.contains_key(&stem) && (file == 0 || stem == self.controller)
    }

    /// The program that a file is.
    fn known(&self, project: &Project, file: usize, programs: &[ProgramAt]) -> Option<usize> {
        let stem = project.stem(file).to_lowercase();
        if self.is_alone && file == 0 && !programs.is_empty() {
            return Some(0);
        }
        let new = || {
            let name = ProgramAt::of_file(project.stem(file)).name;
            programs.iter().position(|program| program.name == name)
        };
        self.stems.get(&stem).copied().or_else(new)
    }

    /// The program of a file, a new one if there is none.
    fn program(&mut self, project: &Project, file: usize, layout: &mut Layout) -> usize {
        let stem = project.stem(file);
        *self.found.entry(file).or_insert_with(|| {
            let known = self.stems.get(&stem.to_lowercase()).copied();
            let is_all = self.is_alone && file == 0 && !layout.programs.is_empty();
            known.or(is_all.then_some(0)).unwrap_or_else(|| {
                layout.programs.push(ProgramAt::of_file(stem));
                layout.programs.len() - 1
            })
        })
    }
}

impl Layout {
    /// The files of a folder as the programs of the file that they come from.
    pub(in crate::write) fn of_original(
        project: &Project,
        originals: &Originals,
        before: &Project,
    ) -> Layout {
        let context = &project.analysis.context;
        let programs = originals.programs.iter().map(|(name, _)| ProgramAt {
            name: name.clone(),
            ..ProgramAt::default()
        });
        let mut layout = Layout {
            controller: Some(originals.controller.clone()),
            programs: programs.collect(),
            main: originals.main.clone(),
            ..Layout::default()
        };
        let mut homes = Homes::of(originals, before);
        let mains: HashSet<&Name> = (0..project.count())
            .filter_map(|file| project.main(file))
            .collect();
        for function in &context.functions {
            let key = Name::new(&function.name);
            let (file, own) = project
                .home_of_function(&function.name)
                .unwrap_or((0, &function.name));
            if mains.contains(&key) {
                continue;
            }
            if let Some((program, routine)) = originals.functions.get(&Name::new(own))
                && (homes.is_alone || homes.program(project, file, &mut layout) == *program)
            {
                layout.functions.insert(key, (*program, routine.clone()));
                continue;
            }
            let number = homes.program(project, file, &mut layout);
            let bare = bare(&layout.programs[number].name, own);
            let is_taken = layout.is_taken(originals, number, bare);
            let routine = if is_taken { own } else { bare };
            layout.functions.insert(key, (number, routine.to_owned()));
        }
        for file in 0..project.count() {
            if !homes.is_alone && !homes.is_controller(project, file) {
                layout.begin_file(project, originals, before, file, &mut homes);
            }
        }
        layout.order_files(project);
        if let Some((main, routine)) = originals.main.clone() {
            layout.begin_with_main(main, routine);
        }
        for tag in &context.scopes[0].tags {
            let home = project.home_of_tag(&tag.name);
            let own = home.map_or(&*tag.name, |(_, own)| own);
            let program = match home {
                Some((file, _)) if !homes.is_controller(project, file) => {
                    Some(homes.program(project, file, &mut layout))
                }
                _ => None,
            };
            let known = originals.tags.get(&Name::new(own)).filter(|(of, _)| {
                // What is declared for all may be the tag of any program.
                let is_all = homes.is_alone && home.is_some_and(|(file, _)| file == 0);
                home.is_none() || is_all || *of == program
            });
            let at = TagAt {
                program: known.map_or(program, |(of, _)| *of),
                name: known.map_or_else(|| own.to_owned(), |(_, original)| original.clone()),
                is_original: known.is_some(),
            };
            layout.tags.insert(Name::new(&tag.name), at);
        }
        layout.add_tasks_again(project, before, originals, |layout, project, file| {
            if homes.is_controller(project, file) {
                return layout.main.iter().map(|(program, _)| *program).collect();
            }
            homes.known(project, file, &layout.programs).into_iter().collect()
        });
        layout.originals = Some(originals.clone());
        layout
    }

    /// With what the program of a file begins.
    fn begin_file(
        &mut self,
        project: &Project,
        originals: &Originals,
        before: &Project,
        file: usize,
        homes: &mut Homes,
    ) {
        let calls = |project: &Project, file: usize| match First::of(project, file) {
            First::Calls(calls) => {
                let own = calls.iter().map(|function| {
                    let home = project.home_of_function(function);
                    home.map_or_else(|| function.clone(), |(_, own)| own.to_owned())
                });
                own.collect()
            }
            First::Nothing | First::Rungs => Vec::new(),
        };
        let first = First::of(project, file);
        let main = project.main(file);
        let before_file = (0..before.count()).find(|was| before.file(*was) == project.file(file));
        match first {
            // What more a program begins with is called by a routine.
            First::Calls(functions)
                if functions.len() == 1
                    || before_file.is_some_and(|was| calls(before, was) == calls(project, file)) =>
            {
                for function in functions {
                    match main {
                        Some(main) => self.runs.orders.add_main(main),
                        None => self.runs.orders.add_called(&function),
                    }
                    self.begin(&function, true);
                }
            }
            First::Calls(_) | First::Rungs => {
                let number = homes.program(project, file, self);
                let name = free_main(|name| self.is_taken(originals, number, name));
                match main {
                    Some(main) => {
                        self.functions.insert(main.clone(), (number, name));
                        self.begin(main.as_str(), true);
                    }
                    None if self.main.is_none() => self.begin_with_main(number, name),
                    None => {}
                }
            }
            First::Nothing => {}
        }
    }

    /// The networks outside of functions that order the programs of other files.
    fn order_files(&mut self, project: &Project) {
        let context = &project.analysis.context;
        let of_main = |network: &ladder_analysis::networks::NetworkAt<'_>| {
            context.bodies[network.index] == Body::Main && !self.runs.orders.has(context, *network)
        };
        let networks: Vec<_> = context.networks.iter().filter(of_main).collect();
        for network in networks {
            let Some(order) = ordered(context, network) else {
                // It is refused, and what it calls is run as it was.
                if self.main.is_none() {
                    network
                        .blocks()
                        .filter_map(called)
                        .for_each(|function| self.begin(&function, true));
                }
                continue;
            };
            let program = self.functions.get(&Name::new(&order.function));
            let main = self.main.as_ref().map(|(main, _)| *main);
            if program.is_some_and(|(program, _)| Some(*program) != main) {
                self.runs.orders.add_called(&order.function);
                self.begin(&order.function, order.is_run);
            }
        }
    }

    /// Whether a program has a routine of this name.
    fn is_taken(&self, originals: &Originals, program: usize, routine: &str) -> bool {
        let known = originals.functions.values().chain(self.functions.values());
        let mut own = known.filter(|(of, _)| *of == program);
        own.any(|(_, known)| known.eq_ignore_ascii_case(routine))
    }
}

//! A program of several files: the file itself, and of others the functions and blocks that it reaches.

use crate::analyze::{Analysis, AnalyzeOptions, analyze};
use crate::library::{self, SOURCES};
use crate::names::context::Body;
use crate::plants::{self, Connect, PlantError, PlantFile};
use crate::program::{Function, Program};
use crate::resolve::targets::{Target, held, targets};
use crate::resolve::{self, numbers::Unit};
use ladder_syntax::parse;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::{Arc, OnceLock};

/// Why a file has no program that can run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotWhole {
    /// There are errors in this file: the program's own, or one that it uses.
    Errors(Arc<str>),
    /// This file, which it uses, is not there any more, or not as it was.
    Missing(Arc<str>),
}

/// A program with the files that it is made of.
#[derive(Debug, Clone)]
pub struct Linked {
    /// The program.
    pub program: Arc<Program>,
    /// The other files: those whose functions and blocks it reaches, those of the library among them, and those whose types these
    /// and it mention.
    pub others: Vec<Arc<Analysis>>,
}

impl Analysis {
    /// The same file with the program that [`link_files`] made of it and of what it uses.
    #[must_use]
    pub fn with_others(&self, linked: Linked) -> Analysis {
        self.with_files(linked.program, linked.others)
    }
}

/// The analysis of a file of the library.
pub fn library_analysis(file: &str) -> Option<Arc<Analysis>> {
    static ANALYSES: [OnceLock<Arc<Analysis>>; SOURCES.len()] = [const { OnceLock::new() }; SOURCES.len()];
    let source = library::source(file)?;
    let number = SOURCES.iter().position(|other| other == source)?;
    let analyse = || {
        let others = library::offered().others_of(file);
        let options = AnalyzeOptions::new(file).among(&others);
        Arc::new(analyze(&Arc::new(parse(source.text)), options))
    };
    Some(Arc::clone(ANALYSES[number].get_or_init(analyse)))
}

/// The bodies that are reached in each file, by its name.
struct Reached {
    /// The files in the order in which they are reached, the program's own first.
    files: Vec<(Arc<Analysis>, Option<FxHashSet<Body>>)>,
    by_name: FxHashMap<Arc<str>, usize>,
    /// For each file what each of its bodies uses.
    targets: Vec<FxHashMap<Body, Vec<Target>>>,
}

/// The program of a file: see [`link_files`].
///
/// # Errors
/// Those of `link_files`.
pub fn link(
    own: &Arc<Analysis>,
    analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
) -> Result<Arc<Program>, NotWhole> {
    link_files(own, analysis).map(|linked| linked.program)
}

/// The program of a file, with the files that it is made of. `analysis` returns the analysis of another file of the workspace by its name.
///
/// # Errors
/// The file, or one that it uses, has errors or cannot be had.
pub fn link_files(
    own: &Arc<Analysis>,
    analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
) -> Result<Linked, NotWhole> {
    if let Some(program) = own.program() {
        return Ok(Linked {
            program: Arc::clone(program),
            others: with_types(own, Vec::new(), analysis),
        });
    }
    if own.has_errors() {
        return Err(NotWhole::Errors(Arc::clone(&own.context.name)));
    }
    Ok(linked(own, &[], &[], analysis)?.0)
}

/// A project whose tasks run the main programs of several files. `plan` is what runs in a scan: its functions stand for the
/// main programs, in their order, each of which is run once in so many scans.
///
/// # Errors
/// A file, or one that it uses, has errors or cannot be had.
pub fn link_tasks(
    plan: &Arc<Analysis>,
    programs: &[(Arc<Analysis>, u32)],
    analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
) -> Result<Linked, NotWhole> {
    let failing = |(program, _): &&(Arc<Analysis>, u32)| program.has_errors();
    if let Some((program, _)) = programs.iter().find(failing) {
        return Err(NotWhole::Errors(Arc::clone(&program.context.name)));
    }
    Ok(linked(plan, programs, &[], analysis)?.0)
}

/// A program, or a project with its tasks, beside models of its machine: in each scan these run before it. What is wrong with the
/// plants or with how they are connected comes with it; then it must not run.
///
/// # Errors
/// A file, or one that it uses, has errors or cannot be had.
pub fn link_with_plants(
    own: &Arc<Analysis>,
    programs: &[(Arc<Analysis>, u32)],
    (plants, connects): (&[PlantFile], &[Connect]),
    analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
) -> Result<(Linked, Vec<PlantError>), NotWhole> {
    let programs_of = programs.iter().map(|(program, _)| program);
    let mut roots = std::iter::once(own)
        .chain(programs_of)
        .chain(plants.iter().map(|plant| &plant.analysis));
    if let Some(failing) = roots.find(|root| root.has_errors()) {
        return Err(NotWhole::Errors(Arc::clone(&failing.context.name)));
    }
    let (mut linked, file) = linked(own, programs, plants, analysis)?;
    let mut program = Arc::unwrap_or_clone(linked.program);
    let errors = plants::connect(&mut program, file, plants, connects);
    linked.program = Arc::new(program);
    Ok((linked, errors))
}

/// Also returns the number of the first plant's file.
fn linked(
    own: &Arc<Analysis>,
    programs: &[(Arc<Analysis>, u32)],
    plants: &[PlantFile],
    analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
) -> Result<(Linked, usize), NotWhole> {
    let first_plant = 1 + programs.len();
    let roots = std::iter::once(own).chain(programs.iter().map(|(program, _)| program));
    let roots = roots.chain(plants.iter().map(|plant| &plant.analysis));
    let reached = Reached::from(roots, analysis)?;
    let units: Vec<Unit<'_>> = reached
        .files
        .iter()
        .enumerate()
        .map(|(number, (analysis, bodies))| Unit {
            context: &analysis.context,
            name: &analysis.context.name,
            bodies: bodies.clone(),
            plant: number
                .checked_sub(first_plant)
                .and_then(|plant| plants.get(plant))
                .map(|plant| plant.name.as_str()),
        })
        .collect();
    let resolved = resolve::program(&units);
    if resolved.unresolved.is_some() || !resolved.linked {
        return Err(NotWhole::Missing(Arc::clone(&own.context.name)));
    }
    let mut program = resolved.program;
    let mut mains = resolved.mains.into_iter().skip(1);
    for (number, (_, every)) in programs.iter().enumerate() {
        let main = mains.next().unwrap_or_default();
        // What stands for it in the plan does nothing.
        let stand_in = std::mem::replace(&mut program.functions[number].networks, main);
        program.functions[number].every = Some(*every);
        for network in &mut program.networks[stand_in] {
            network.steps.clear();
            network.blocks.clear();
            network.elements.clear();
        }
    }
    for (plant, main) in plants.iter().zip(mains) {
        program.functions.push(Function {
            name: plant.name.clone(),
            networks: main,
            every: None,
        });
    }
    let others = reached.files.into_iter().skip(1).map(|(file, _)| file);
    let linked = Linked {
        program: Arc::new(program),
        others: with_types(own, others.collect(), analysis),
    };
    Ok((linked, first_plant))
}

/// Files, and those that declare the types which they and the program's own mention.
fn with_types(
    own: &Arc<Analysis>,
    mut files: Vec<Arc<Analysis>>,
    analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
) -> Vec<Arc<Analysis>> {
    let mut seen: FxHashSet<Arc<str>> = FxHashSet::default();
    seen.extend(
        std::iter::once(own)
            .chain(&files)
            .map(|file| Arc::clone(&file.context.name)),
    );
    let mut next = 0;
    let mut file = Arc::clone(own);
    loop {
        for ty in file.context.types.of_others() {
            if let Some(name) = &ty.file
                && seen.insert(Arc::clone(name))
            {
                files.extend(analysis(name));
            }
        }
        match files.get(next) {
            Some(other) => file = Arc::clone(other),
            None => return files,
        }
        next += 1;
    }
}

impl Reached {
    /// `roots` are there as wholes.
    fn from<'r>(
        roots: impl Iterator<Item = &'r Arc<Analysis>>,
        analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
    ) -> Result<Reached, NotWhole> {
        let mut reached = Reached {
            files: Vec::new(),
            by_name: FxHashMap::default(),
            targets: Vec::new(),
        };
        let mut open: Vec<(usize, Target)> = Vec::new();
        for root in roots {
            let file = reached.enter(Arc::clone(root), None);
            let targets = reached.targets[file].values().flatten();
            open.extend(targets.map(|target| (file, target.clone())));
        }
        while let Some((from, target)) = open.pop() {
            let (file, body) = match target {
                Target::Own(body) => (from, body),
                Target::Function(import) => {
                    (reached.file(&import.file, analysis)?, Body::Function(import.item))
                }
                Target::Block(import) => (reached.file(&import.file, analysis)?, Body::Block(import.item)),
            };
            let (_, bodies) = &mut reached.files[file];
            if bodies.as_mut().is_some_and(|bodies| bodies.insert(body)) {
                let targets = reached.targets[file].get(&body).into_iter().flatten();
                open.extend(targets.map(|target| (file, target.clone())));
            }
        }
        Ok(reached)
    }

    fn file(
        &mut self,
        name: &Arc<str>,
        analysis: &dyn Fn(&str) -> Option<Arc<Analysis>>,
    ) -> Result<usize, NotWhole> {
        if let Some(&file) = self.by_name.get(name) {
            return Ok(file);
        }
        let found = library_analysis(name).or_else(|| analysis(name));
        let found = found.ok_or_else(|| NotWhole::Missing(Arc::clone(name)))?;
        if found.has_errors() {
            return Err(NotWhole::Errors(Arc::clone(name)));
        }
        Ok(self.enter(found, Some(FxHashSet::default())))
    }

    fn enter(&mut self, analysis: Arc<Analysis>, bodies: Option<FxHashSet<Body>>) -> usize {
        let file = self.files.len();
        self.by_name.insert(Arc::clone(&analysis.context.name), file);
        let mut used = targets(&analysis.context);
        for (body, held) in held(&analysis.context) {
            used.entry(body).or_default().extend(held);
        }
        self.targets.push(used);
        self.files.push((analysis, bodies));
        file
    }
}

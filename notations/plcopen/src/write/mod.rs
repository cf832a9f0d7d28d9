//! From a program to the model of a project.
//!
//! ```text
//! analysis --unit--> types, variables, bodies --rung, element--> graphs --emit--> XML
//! ```

mod declare;
mod element;
mod functions;
mod names;
mod rung;
mod text;
mod touched;
mod unit;

use super::model::{Project, Task, TypeDeclaration, UnitKind};
use declare::Source;
use ladder_analysis::context::Body;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::program::Program;
use ladder_analysis::{Analysis, analyze, library, link};
use ladder_instructions::Profile;
use ladder_notation::{LineColumn, Report, WriteError, no_program};
use ladder_syntax::{Name, TextSize};
use names::{Names, identifier};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;
use unit::{Face, Faces, Parameter, Project as Shared, Unit};

/// How long a scan is where the program says nothing.
const CYCLE: i64 = 10_000_000;

/// The project that a program is.
///
/// # Errors
///
/// If the program has errors, or needs files that are not there.
pub(super) fn project(analysis: &Analysis) -> Result<(Project, Report), WriteError> {
    let text = analysis.context.parse.to_string();
    let own = Arc::new(analysis.clone());
    let Some(program) = program_of(&own) else {
        return Err(no_program(analysis, &text));
    };
    let mut report = Report::default();
    if analysis.context.profile != Profile::default() {
        let why =
            "its arithmetic and timing are those of another system here, and those of the standard there";
        report.approximated(LineColumn::START, "profile of the program", why);
    }
    let reached = |name: &str| {
        program
            .blocks
            .iter()
            .any(|block| block.name.eq_ignore_ascii_case(name))
    };
    let (whole, program) = with_all_blocks(&own, &text, reached).unwrap_or((own, program));
    let own = Unit {
        analysis: &whole,
        program,
        text: &text,
        end: TextSize::of(text.as_str()),
        at: None,
    };
    let of_library = library_of(&own);
    let library: Vec<Unit<'_>> = of_library
        .iter()
        .map(|(analysis, program, text)| Unit {
            analysis,
            program: Arc::clone(program),
            text,
            end: TextSize::of(*text),
            at: Some(LineColumn::START),
        })
        .collect();
    let mut project = Project::default();
    let mut shared = Shared {
        blocks: Names::default(),
        globals: Names::default(),
        faces: &Faces::default(),
    };
    for ty in analysis.context.types.own() {
        shared.globals.fresh(&ty.declaration.name);
    }
    let stem = std::path::Path::new(&*analysis.context.name).file_stem();
    let stem = stem.map_or("Main".into(), |stem| stem.to_string_lossy());
    let name = shared.globals.fresh(if stem.is_empty() { "Main" } else { &stem });
    let all: Vec<&Unit<'_>> = library.iter().chain([&own]).collect();
    for unit in &all {
        let context = unit.context();
        for block in &context.user_blocks[..context.own_blocks] {
            let name = shared.globals.fresh(block.name.trim_start_matches('$'));
            shared.blocks.alias(&block.name, &name);
        }
    }
    project.types = types(&own, &shared, &mut report);
    for unit in &all {
        project.globals.extend(unit.globals(&mut shared, &mut report));
    }
    let mut faces = faces(&all, &shared);
    let (broken, users) = broken(
        &all,
        &Shared {
            faces: &faces,
            ..shared.clone()
        },
    );
    faces.break_with(broken, &users);
    let shared = Shared {
        faces: &faces,
        ..shared
    };
    for unit in &all {
        let context = unit.context();
        for block in 0..context.own_blocks {
            let name = shared.blocks.get(&context.user_blocks[block].name);
            let made = unit.write(
                &shared,
                Some(block),
                name.unwrap_or_default().to_owned(),
                &mut report,
            );
            project.units.push(made);
        }
    }
    project
        .units
        .push(own.write(&shared, None, name.clone(), &mut report));
    project.tasks.push(Task {
        place: LineColumn::START,
        name: "scan".to_owned(),
        interval: Some(text::time(analysis.context.cycle.unwrap_or(CYCLE))),
        priority: 0,
        programs: vec![(LineColumn::START, name)],
    });
    debug_assert!(
        project
            .units
            .last()
            .is_some_and(|unit| unit.kind == UnitKind::Program)
    );
    report.entries.sort_by_key(|entry| entry.place);
    Ok((project, report))
}

/// The program of a file, with the blocks of the library.
fn program_of(analysis: &Arc<Analysis>) -> Option<Arc<Program>> {
    link(analysis, &library::analysis).ok()
}

/// A file with its program, in which every block of its own is used: what nothing uses is not in a program. What is added
/// stands at the end of the text. None: nothing had to be.
fn with_all_blocks(
    analysis: &Analysis,
    text: &str,
    reached: impl Fn(&str) -> bool,
) -> Option<(Arc<Analysis>, Arc<Program>)> {
    let context = &analysis.context;
    let idle: Vec<&str> = context.user_blocks[..context.own_blocks]
        .iter()
        .map(|block| block.name.as_str())
        .filter(|name| !reached(name))
        .collect();
    if idle.is_empty() {
        return None;
    }
    let mut more = format!("{text}\nVAR\n");
    for name in idle {
        more.push_str(&format!("    idle_{} : {name};\n", &name[1..]));
    }
    more.push_str("END_VAR\n");
    let analysis = Arc::new(analyze(&Arc::new(ladder_syntax::parse(&more)), &context.name));
    let program = program_of(&analysis)?;
    Some((analysis, program))
}

/// A file of the library with its program and text.
type OfLibrary = (Arc<Analysis>, Arc<Program>, &'static str);

/// The blocks of the library that a file uses, and those that they use: what is used by others comes first.
fn library_of(own: &Unit<'_>) -> Vec<OfLibrary> {
    let mut found: Vec<OfLibrary> = Vec::new();
    let mut waiting: Vec<Arc<str>> = files(own.analysis);
    let mut seen = HashSet::new();
    while let Some(file) = waiting.pop() {
        if !seen.insert(Arc::clone(&file)) {
            continue;
        }
        let (Some(source), Some(analysis)) = (library::source(&file), library::analysis(&file)) else {
            continue;
        };
        if let Some((analysis, program)) = with_all_blocks(&analysis, source.text, |_| false) {
            waiting.extend(files(&analysis));
            found.push((analysis, program, source.text));
        }
    }
    found.reverse();
    found
}

/// The files of the blocks that a file uses.
fn files(analysis: &Analysis) -> Vec<Arc<str>> {
    let blocks = analysis.context.user_blocks.iter();
    blocks.filter_map(|block| block.file().cloned()).collect()
}

/// The types of the file.
fn types(own: &Unit<'_>, shared: &Shared<'_>, report: &mut Report) -> Vec<TypeDeclaration> {
    let context = own.context();
    let source = Source {
        context,
        text: own.text,
        blocks: &shared.blocks,
        globals: &shared.globals,
    };
    let mut types = Vec::new();
    for ty in context.types.own() {
        let declared = &ty.declaration.declared;
        let at = declare::place(context, ty.declaration.at.start());
        let made = declare::type_in(&source, &declared.spec);
        let made = made.and_then(|made| Ok((made, declare::declared_initial(&source, declared)?)));
        match made {
            Ok((made, initial)) => types.push(TypeDeclaration {
                place: at,
                name: identifier(&ty.declaration.name),
                ty: made,
                initial,
                comment: declare::said(context, ty.declaration.at.start()),
            }),
            Err(why) => report.refused(at, format!("type {}", ty.declaration.name), why),
        }
    }
    types
}

/// The blocks of which not all is written, and for each block those that use it.
fn broken(units: &[&Unit<'_>], shared: &Shared<'_>) -> (Vec<Name>, HashMap<Name, Vec<Name>>) {
    let (mut broken, mut users) = (Vec::new(), HashMap::<Name, Vec<Name>>::new());
    for unit in units {
        let context = unit.context();
        for block in 0..context.own_blocks {
            let mut report = Report::default();
            unit.write(shared, Some(block), String::new(), &mut report);
            if report.tally().refused > 0 {
                broken.push(context.user_blocks[block].key.clone());
            }
        }
        for network in &context.networks {
            let Body::Block(user) = context.bodies[network.index] else {
                continue;
            };
            for block in network.blocks() {
                if let Meaning::User(used) = block.meaning {
                    let used = context.user_blocks[used].key.clone();
                    users
                        .entry(used)
                        .or_default()
                        .push(context.user_blocks[user].key.clone());
                }
            }
        }
    }
    (broken, users)
}

/// How the blocks look from outside.
fn faces(units: &[&Unit<'_>], shared: &Shared<'_>) -> Faces {
    let mut faces = Faces::default();
    for unit in units {
        let context = unit.context();
        for (number, block) in context.user_blocks[..context.own_blocks].iter().enumerate() {
            let scope = unit.scope(shared, number + 1);
            let (power_in, power_out) = scope.power.unwrap_or_default();
            let parameters = block.parameters.iter().map(|parameter| Parameter {
                name: scope.names.get(&parameter.name).unwrap_or_default().to_owned(),
                kind: parameter.kind,
            });
            faces.insert(
                &block.name,
                Face {
                    name: shared.blocks.get(&block.name).unwrap_or_default().to_owned(),
                    power_in,
                    power_out,
                    parameters: parameters.collect(),
                    is_broken: false,
                },
            );
        }
    }
    faces
}

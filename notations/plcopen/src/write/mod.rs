//! From a program to the model of a project.
//!
//! ```text
//! analysis --unit--> types, variables, bodies --rung, element--> graphs --emit--> XML
//! ```

mod added;
mod boxes;
mod compiler;
mod declare;
mod edge;
mod element;
mod faces;
pub(crate) mod files;
mod names;
mod networks;
mod rung;
mod system;
mod text;
pub(crate) mod texts;
mod touched;
mod unit;

use super::along;
use super::arrays;
use super::emit;
use super::model::{Project, Role, Task, TypeDeclaration, UnitKind};
use super::own;
use super::shared;
pub use compiler::Compiler;
use declare::Source;
use faces::{Broken, Face, Faces, Parameter};
use ladder_analysis::context::Body;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::program::Program;
use ladder_analysis::program::SystemTag;
use ladder_analysis::{Analysis, AnalyzeOptions, analyze};
use ladder_instructions::Profile;
use ladder_notation::{
    LineColumn, Report, Target, Unwritable, WriteError, Writing, no_program, refuse_unread,
};
use ladder_syntax::{Name, TextSize};
use names::Names;
pub(crate) use names::identifier;
use std::collections::HashMap;
use std::sync::Arc;
use unit::{Project as Shared, Unit};

/// How long a scan is where the program says nothing.
const CYCLE: i64 = 10_000_000;

/// Writes a program.
///
/// # Errors
///
/// If the program has errors, or needs files that are not there.
pub(super) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    Target::BLOCKS_ALONE.write(analysis, |analysis, unwritable| {
        let (project, report) = project(analysis, unwritable, Compiler::Matiec)?;
        Ok(Writing {
            bytes: emit::project(project).into_bytes(),
            report,
            companions: Vec::new(),
        })
    })
}

/// The project that a program is, with what a compiler of projects lacks expressed by what it has: see [`Target::BLOCKS_ALONE`].
///
/// # Errors
///
/// If the program has errors.
pub fn project(
    analysis: &Analysis,
    unwritable: &Unwritable,
    compiler: Compiler,
) -> Result<(Project, Report), WriteError> {
    let text = analysis.context.parse.to_string();
    let Some(program) = analysis.program() else {
        return Err(no_program(analysis, &text));
    };
    let mut report = Report::default();
    if analysis.context.profile != Profile::default() {
        let why =
            "its arithmetic and timing are those of another system here, and those of the standard there";
        report.approximated(LineColumn::START, "profile of the program", why);
    }
    let whole = with_all_blocks(analysis, program, &text);
    let (whole, program) = match &whole {
        Some(whole) => (whole, whole.program().unwrap_or(program)),
        None => (analysis, program),
    };
    let own = Unit {
        analysis: whole,
        program,
        text: &text,
        end: TextSize::of(text.as_str()),
        compiler,
    };
    let mut project = Project::default();
    let mut shared = Shared {
        blocks: Names::default(),
        globals: Names::default(),
        faces: &Faces::default(),
        sets_system: None,
    };
    let context = own.context();
    for ty in context.types.own() {
        shared.globals.fresh(&ty.declaration.name);
    }
    let stem = std::path::Path::new(&*context.name).file_stem();
    let stem = stem.map_or("Main".into(), |stem| stem.to_string_lossy());
    let name = shared.globals.fresh(if stem.is_empty() { "Main" } else { &stem });
    let blocks = &context.user_blocks[..context.own_blocks];
    for block in blocks {
        let name = shared.globals.fresh(block.name.trim_start_matches('$'));
        shared.blocks.alias(&block.name, &name);
    }
    project.types = types(&own, &shared, &mut report);
    project.globals = own.globals(&mut shared, &mut report);
    let system = system_tags(&own, &mut shared);
    project.globals.extend(
        system
            .iter()
            .map(|(tag, name)| along::system_variable(*tag, name, Role::Global)),
    );
    let sets_system = shared.globals.fresh(along::SYSTEM_BLOCK);
    shared.sets_system = (!system.is_empty()).then(|| sets_system.clone());
    let mut faces = faces(&own, &shared);
    let (mut broken, users) = broken(
        &own,
        &Shared {
            faces: &faces,
            ..shared.clone()
        },
    );
    broken.extend(unwritable.iter().map(|(block, why)| (block.clone(), why.clone())));
    faces.break_with(broken, &users);
    let mut shared = Shared {
        faces: &faces,
        ..shared
    };
    refuse_unread(analysis, &mut report, |name| {
        let block = blocks
            .iter()
            .position(|block| block.name.eq_ignore_ascii_case(name));
        block.is_some_and(|block| own.unread_text(block).is_some())
    });
    for (number, block) in blocks.iter().enumerate() {
        if unwritable.contains_key(&block.key) {
            continue;
        }
        let name = shared.blocks.get(&block.name).unwrap_or_default().to_owned();
        project
            .units
            .push(own.write(&shared, Some(number), name, &mut report));
    }
    project
        .units
        .push(own.write(&shared, None, name.clone(), &mut report));
    project.tasks.push(Task {
        place: LineColumn::START,
        name: "scan".to_owned(),
        interval: Some(text::time(context.cycle.unwrap_or(CYCLE))),
        event: None,
        priority: 0,
        programs: vec![(LineColumn::START, name)],
    });
    shared::move_out(&mut project, &faces.shared());
    along::add(&mut project, &system, sets_system, compiler == Compiler::TwinCat);
    match compiler {
        Compiler::Matiec => arrays::name_all(&mut project, |like| shared.globals.fresh(like)),
        Compiler::TwinCat => project.units.iter_mut().for_each(own::without_sinks),
    }
    debug_assert!(
        project
            .units
            .last()
            .is_some_and(|unit| unit.kind == UnitKind::Program)
    );
    report.entries.sort_by_key(|entry| entry.place);
    Ok((project, report))
}

/// The tags of `SYS` that the file names, and the globals for them.
fn system_tags(own: &Unit<'_>, shared: &mut Shared<'_>) -> Vec<(SystemTag, String)> {
    let blocks = (0..own.context().own_blocks).map(Some);
    let mut tags: Vec<SystemTag> = blocks
        .chain([None])
        .flat_map(|block| system::used(own, block))
        .collect();
    tags.sort_by_key(|tag| tag.name());
    tags.dedup();
    let globals = tags.into_iter().map(|tag| {
        let name = shared.globals.fresh(&format!("SYS_{}", tag.name()));
        shared.globals.alias(&system::key(tag), &name);
        (tag, name)
    });
    globals.collect()
}

/// A file in which every block of its own is used: what nothing uses is not in a program. What is added is at the end of the
/// text. None: nothing had to be.
fn with_all_blocks(analysis: &Analysis, program: &Program, text: &str) -> Option<Analysis> {
    let context = &analysis.context;
    let is_reached = |name: &str| {
        let mut blocks = program.blocks.iter();
        blocks.any(|block| block.name.eq_ignore_ascii_case(name))
    };
    let idle: Vec<&str> = context.user_blocks[..context.own_blocks]
        .iter()
        .map(|block| block.name.as_str())
        .filter(|name| !is_reached(name))
        .collect();
    if idle.is_empty() {
        return None;
    }
    let mut more = format!("{text}\nVAR\n");
    for name in idle {
        more.push_str(&format!("    idle_{} : {name};\n", &name[1..]));
    }
    more.push_str("END_VAR\n");
    let parse = Arc::new(ladder_syntax::parse(&more));
    let analysis = analyze(&parse, AnalyzeOptions::new(&context.name).among(&context.others));
    analysis.program().is_some().then_some(analysis)
}

/// The types of the file.
fn types(own: &Unit<'_>, shared: &Shared<'_>, report: &mut Report) -> Vec<TypeDeclaration> {
    let context = own.context();
    let source = Source {
        context,
        blocks: &shared.blocks,
        globals: &shared.globals,
        compiler: own.compiler,
    };
    let mut types = Vec::new();
    for ty in context.types.own() {
        let declared = &ty.declaration.declared;
        let at = declare::place(context, ty.declaration.at.start());
        let made = match ty.ty.map(|ty| declare::is_taken(ty, Role::Local)) {
            Some(Err(why)) if own.compiler == Compiler::Matiec => Err(why),
            Some(_)
                if ty
                    .ty
                    .is_some_and(|it| declare::is_alias(&ty.declaration.name, it)) =>
            {
                Err(declare::ALIAS.to_owned())
            }
            _ => declare::type_in(&source, &declared.spec),
        };
        let made = made.and_then(|mut made| {
            let initial = match declare::declared_initial(&source, declared)? {
                Some(initial) => declare::in_members(&mut made, initial)?,
                None => declare::lowest(&declared.spec),
            };
            Ok((made, initial))
        });
        match made {
            Ok((made, initial)) => types.push(TypeDeclaration {
                place: at,
                name: identifier(&ty.declaration.name),
                ty: made,
                initial,
                comment: declare::told(context, ty.declaration.at.start()),
            }),
            Err(why) => report.refused(at, format!("type {}", ty.declaration.name), why),
        }
    }
    types
}

/// The blocks of which not all is written, and for each block those that use it.
fn broken(own: &Unit<'_>, shared: &Shared<'_>) -> (Broken, HashMap<Name, Broken>) {
    let (mut broken, mut users) = (Broken::new(), HashMap::<Name, Broken>::new());
    let why = |name: &str| format!("a network of {name} is not written");
    let context = own.context();
    for (number, block) in context.user_blocks[..context.own_blocks].iter().enumerate() {
        let mut report = Report::default();
        own.write(shared, Some(number), String::new(), &mut report);
        if report.tally().refused > 0 {
            broken.push((block.key.clone(), why(&block.name)));
        }
    }
    for network in &context.networks {
        let Body::Block(user) = context.bodies[network.index] else {
            continue;
        };
        for block in network.blocks() {
            if let Meaning::User(used) = block.meaning {
                let users = users.entry(context.user_blocks[used].key.clone()).or_default();
                let user = &context.user_blocks[user];
                users.push((user.key.clone(), why(&user.name)));
            }
        }
    }
    (broken, users)
}

/// How the blocks look from outside.
fn faces(own: &Unit<'_>, shared: &Shared<'_>) -> Faces {
    let mut faces = Faces::default();
    let context = own.context();
    for (number, block) in context.user_blocks[..context.own_blocks].iter().enumerate() {
        let scope = own.scope(shared, number + 1);
        // Of one that does not run without power they are its own there.
        let power = scope.power.unwrap_or_else(|| ("EN".to_owned(), "ENO".to_owned()));
        let (power_in, power_out) = power;
        let parameters = block.parameters.iter().map(|parameter| Parameter {
            name: scope.names.get(&parameter.name).unwrap_or_default().to_owned(),
            kind: parameter.kind,
            is_shared: own
                .tags(number + 1)
                .any(|tag| tag.name == parameter.name && own.is_shared(number, tag)),
        });
        let face = Face {
            name: shared.blocks.get(&block.name).unwrap_or_default().to_owned(),
            power_in,
            power_out,
            parameters: parameters.collect(),
            broken: None,
        };
        faces.insert(&block.name, face);
    }
    faces
}

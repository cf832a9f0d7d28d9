//! From a program to the text.

use crate::comment::{self, Outside};
use crate::names;
use crate::pieces::PIECES;
use crate::project::types::has_blocks;
use crate::project::{Project, Service, Stop, UnitKind};
use crate::sections::{
    Body, block_variables, configuration, externals, own_variables, passed, program_variables, section,
};
use crate::states::piece_of;
use crate::term::{Binding, Term};
use crate::unit::{Local, Unit};
use ladder_analysis::Analysis;
use ladder_analysis::program::{Clock, Location, ParameterKind, Program, TagId};
use ladder_analysis::values::types::Type;
use ladder_instructions::Profile;
use ladder_notation::{LineColumn, Lines, Report, WriteError, Writing, no_program};
use ladder_syntax::{Parse, TextRange};
use std::collections::BTreeMap;
use std::path::Path;

/// How long a scan is where the program says nothing.
const CYCLE: i64 = 10_000_000;

/// Writes the text.
pub(crate) fn write(analysis: &Analysis) -> Result<Writing, WriteError> {
    let text = analysis.context.parse.to_string();
    let program = analysis.program().ok_or_else(|| no_program(analysis, &text))?;
    let lines = Lines::of(&text);
    let place = |location: Location| match location.file {
        0 => lines.place(&text, location.range.start().into()),
        _ => LineColumn::START,
    };
    let refused = |Stop { at, why }: Stop| {
        let of = match at.file {
            0 => String::new(),
            other => format!(
                "in {}: ",
                program
                    .files
                    .get(other as usize)
                    .map_or("another file", String::as_str)
            ),
        };
        WriteError::new(format!(
            "{}: {of}Structured Text cannot say this: {why}",
            place(at)
        ))
    };
    if let Some(profile) = program
        .profiles
        .iter()
        .find(|profile| **profile != Profile::default())
    {
        return Err(WriteError::new(format!(
            "the program has the arithmetic and timing of {}, which Structured Text does not: write it for IEC 61131-3, without \
             the comment that names the profile",
            profile.name()
        )));
    }
    let mut report = Report::default();
    for found in analysis.diagnostics() {
        if found.rule.name() != "overlapping-address" {
            continue;
        }
        let at = lines.place(&text, found.range.start().into());
        if !found.message.to_ascii_uppercase().contains("%I") {
            return Err(WriteError::new(format!(
                "{at}: Structured Text cannot say this: tags at addresses that overlap, which are one memory there; use one of them"
            )));
        }
        let why = "inputs at addresses that overlap are one memory in many systems: what enters one is in the other";
        report.approximated(at, "overlapping addresses", why);
    }
    let mut project = Project::new(program, &text, &analysis.context);
    let file = Path::new(program.files.first().map_or("program", String::as_str));
    let stem = file
        .file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned();
    let name = project.given.names.name(&stem, "program");
    project.source.cycle = analysis.context.cycle.unwrap_or(CYCLE);
    let mut bodies = Vec::new();
    for unit in project.units() {
        bodies.push(body(&mut project, unit, &analysis.context.parse).map_err(refused)?);
    }
    // What the scan begins with has names that nothing in the program has.
    project.given.names = std::mem::take(&mut bodies[0].declared.names);
    let prelude = prelude(&mut project, &mut bodies[0]);
    for variable in project.variables(None) {
        if project.is_shared(variable.root) && !project.is_passed(variable.root) {
            let name = project.name_of_shared(variable.root);
            let ty = project.type_of_variable(&variable);
            bodies[0].shared.insert(name, ty);
        }
    }
    let states = program
        .tags
        .iter()
        .enumerate()
        .filter_map(|(index, tag)| match tag.ty {
            Type::State(state) if !project.is_standard(state, TagId(index as u32)) => Some(piece_of(state)),
            _ => None,
        });
    let states: Vec<&str> = states.collect();
    project.used.pieces.extend(states);
    for network in program
        .networks
        .iter()
        .filter(|network| network.location.file == 0)
    {
        report.translated(place(network.location), "network");
    }
    let outside = Outside::of(&analysis.context.parse);
    let bytes = assembled(&project, &name, &prelude, &bodies, &outside).into_bytes();
    Ok(Writing {
        bytes,
        companions: Vec::new(),
        report,
    })
}

fn body(project: &mut Project<'_>, kind: UnitKind, parse: &Parse) -> Result<Body, Stop> {
    let program = project.source.program;
    let first = program
        .networks
        .get(project.networks(kind).start)
        .map(|network| network.location);
    if project.shared.recursive.contains(&kind) {
        return Err(Stop {
            at: first.unwrap_or(Location {
                file: 0,
                range: TextRange::default(),
            }),
            why: "a function that calls itself: write a loop".into(),
        });
    }
    let start = Location {
        file: 0,
        range: TextRange::default(),
    };
    let text = project.source.text;
    let mut unit = Unit::new(project, kind, start);
    // What the ladder program names keeps its name before anything else has one.
    let block = match kind {
        UnitKind::Block(block) => {
            for name in ["power_in", "power_out"] {
                unit.declared.names.name(name, "");
            }
            for (tag, kind) in &program.blocks[block].parameters {
                let passed = &program.tags[tag.0 as usize];
                let column = passed.column.as_ref();
                if column.is_some_and(|column| has_blocks(column.declared.1)) {
                    unit.here = passed.location;
                    return unit.stop(
                        "a parameter with timers, counters or blocks in it, which compilers that are built on matiec do not take: \
                         declare them in the block",
                    );
                }
                let name = unit.project.root(*tag);
                unit.declared.names.name(name, "");
                if *kind == ParameterKind::InOut {
                    unit.declared.in_outs.insert(names::member(name));
                }
            }
            Some(block)
        }
        _ => None,
    };
    if !matches!(kind, UnitKind::Function(_)) {
        for variable in unit.project.variables(block) {
            // Timers in arrays are variables where they are used.
            if variable.is_part() {
                continue;
            }
            let is_own = block.is_some() || !unit.project.is_shared(variable.root);
            if is_own || kind == UnitKind::Program && unit.project.is_passed(variable.root) {
                let name = unit.variable(variable.id);
                let lines = unit.project.first_values(&variable, &name);
                unit.begin_with(lines, variable.tag.retain);
            }
        }
    }
    let mut comments = |network: usize| {
        let location = program.networks[network].location;
        match location.file {
            0 => comment::of_network(parse, text, location.range),
            _ => vec![String::new()],
        }
    };
    let first = unit.first_scan();
    unit.networks(&mut comments)?;
    let says_nothing = |line: &String| line.trim().is_empty() || line.trim().starts_with("(*");
    if unit.out.lines.iter().all(says_nothing) && !matches!(kind, UnitKind::Block(_)) {
        // A body without statements does not compile everywhere.
        let nothing = unit.instance("nothing", "BOOL");
        unit.line(format!("{nothing} := FALSE;"));
    }
    Ok(Body {
        kind,
        first,
        lines: unit.out.lines,
        shared: BTreeMap::new(),
        declared: unit.declared,
    })
}

/// What a scan begins with, before the first network.
fn prelude(project: &mut Project<'_>, program: &mut Body) -> Vec<String> {
    let mut lines = Vec::new();
    let asked: Vec<Service> = project.used.services.keys().copied().collect();
    let mut name = |project: &mut Project<'_>, service: Service| {
        let name = project.service(service, UnitKind::Program);
        let ty = project.scalar_name(service.ty());
        program.declared.externals.insert(name.clone(), ty);
        name
    };
    if asked.contains(&Service::Ended) {
        let ended = name(project, Service::Ended);
        lines.extend([format!("IF {ended} THEN"), "    RETURN;".into(), "END_IF;".into()]);
    }
    if asked.contains(&Service::FirstScan) {
        let first = name(project, Service::FirstScan);
        let has_run = project.given.names.name("has_run", "of_ladder");
        lines.push(format!("{first} := NOT {has_run};"));
        lines.push(format!("{has_run} := TRUE;"));
        program.declared.instances.push(Local {
            name: has_run,
            ty: "BOOL".into(),
        });
    }
    if asked.contains(&Service::Scan) {
        let scan = name(project, Service::Scan);
        let begun = project.given.names.name("scans_begun", "of_ladder");
        lines.push(format!("{scan} := {begun};"));
        lines.push(format!("{begun} := {begun} + 1;"));
        program.declared.instances.push(Local {
            name: begun,
            ty: "DINT".into(),
        });
    }
    if asked.contains(&Service::Fault) {
        let (fault, faulted) = (name(project, Service::Fault), name(project, Service::Faulted));
        lines.push(format!("{fault} := {faulted};"));
        lines.push(format!("{faulted} := FALSE;"));
    }
    let clocks: Vec<u8> = asked
        .iter()
        .filter_map(|service| match service {
            Service::Clock(n) => Some(*n),
            _ => None,
        })
        .collect();
    if asked.contains(&Service::Now) || asked.contains(&Service::ScanTime) || !clocks.is_empty() {
        let now = name(project, Service::Now);
        project.used.pieces.insert("LADDER_CLOCK");
        let clock = project.given.names.name("ladder_clock_1", "of_ladder");
        lines.push(format!("{clock}();"));
        if asked.contains(&Service::ScanTime) {
            let scan_time = name(project, Service::ScanTime);
            lines.push(format!("{scan_time} := {clock}.NOW - {now};"));
        }
        lines.push(format!("{now} := {clock}.NOW;"));
        program.declared.instances.push(Local {
            name: clock,
            ty: "LADDER_CLOCK".into(),
        });
        for clock in clocks {
            let wave = name(project, Service::Clock(clock));
            project.used.pieces.insert("LADDER_MILLISECONDS");
            let period = Clock::ALL[usize::from(clock)].period() / 1_000_000;
            let number = Term::call("LADDER_MILLISECONDS", &[&Term::variable(&now)]);
            let rest = Term::binary(&number, "MOD", &Term::whole(period.to_string()), Binding::Product);
            lines.push(format!("{wave} := {} >= {};", rest.text, period / 2));
        }
    }
    lines
}

fn assembled(
    project: &Project<'_>,
    name: &str,
    prelude: &[String],
    bodies: &[Body],
    outside: &Outside,
) -> String {
    let told = |all: &[String], indent: &str| -> String {
        let lines = all
            .iter()
            .map(|one| [indent, &comment::comment(one), "\n"].concat());
        lines.collect()
    };
    let program = project.source.program;
    // What more than the program asks for belongs to the configuration.
    let mut shared: BTreeMap<&String, &String> = BTreeMap::new();
    for body in bodies.iter().filter(|body| body.kind != UnitKind::Program) {
        shared.extend(&body.declared.externals);
    }
    shared.extend(&bodies[0].shared);
    let mut out = format!("(* The ladder program {name}. *)\n{}\n", told(&outside.head, ""));
    out.push_str(&project.types());
    let pieces = PIECES.text(&project.used.pieces);
    out.push_str(&pieces);
    for (index, body) in callees_first(program, bodies) {
        let name = match body.kind {
            UnitKind::Function(function) => &project.given.functions[function],
            UnitKind::Block(block) => &project.given.blocks[block],
            UnitKind::Program => continue,
        };
        debug_assert!(index > 0);
        if let UnitKind::Block(block) = body.kind
            && let Some(number) = project.own_block(block)
        {
            out.push_str(&told(
                outside.of_blocks.get(&number).map_or(&[], Vec::as_slice),
                "",
            ));
        }
        out.push_str(&format!("FUNCTION_BLOCK {name}\n"));
        match body.kind {
            UnitKind::Block(block) => block_variables(project, block, body, &mut out),
            unit => {
                let passed = passed(project, unit);
                if !passed.is_empty() {
                    out.push_str(&format!("VAR_IN_OUT\n{passed}END_VAR\n"));
                }
            }
        }
        own_variables(body, &mut out);
        let all: Vec<Local> = body
            .declared
            .externals
            .iter()
            .map(|(name, ty)| Local {
                name: name.clone(),
                ty: ty.clone(),
            })
            .collect();
        externals(project, all, &mut out);
        lines(&body.first, &mut out);
        if matches!(body.kind, UnitKind::Block(_)) {
            out.push_str("    power_out := power_in;\n");
        }
        lines(&body.lines, &mut out);
        out.push_str("END_FUNCTION_BLOCK\n\n");
    }
    out.push_str(&format!("PROGRAM {name}\n"));
    let main = &bodies[0];
    program_variables(project, main, &shared, &mut out);
    own_variables(main, &mut out);
    let (outer, inner): (Vec<_>, Vec<_>) = main
        .declared
        .externals
        .iter()
        .partition(|(name, _)| shared.contains_key(name));
    let local = |all: Vec<(&String, &String)>| -> Vec<Local> {
        all.into_iter()
            .map(|(name, ty)| Local {
                name: name.clone(),
                ty: ty.clone(),
            })
            .collect()
    };
    section("VAR", &local(inner), &mut out);
    externals(project, local(outer), &mut out);
    for line in prelude {
        out.push_str(&format!("    {line}\n"));
    }
    lines(&main.first, &mut out);
    if !prelude.is_empty() || !main.first.is_empty() {
        out.push('\n');
    }
    lines(&main.lines, &mut out);
    out.push_str(&told(&outside.last, "    "));
    out.push_str("END_PROGRAM\n");
    if !shared.is_empty() {
        configuration(project, name, &shared, &mut out);
    }
    out
}

fn lines(lines: &[String], out: &mut String) {
    for line in lines {
        out.push_str(line.trim_end());
        out.push('\n');
    }
}

/// Blocks before those that use them.
fn callees_first<'b>(program: &Program, bodies: &'b [Body]) -> Vec<(usize, &'b Body)> {
    let mut order = Vec::new();
    let mut seen = vec![false; bodies.len()];
    for index in 0..bodies.len() {
        visit(program, bodies, index, &mut seen, &mut order);
    }
    order
}

fn visit<'b>(
    program: &Program,
    bodies: &'b [Body],
    index: usize,
    seen: &mut [bool],
    order: &mut Vec<(usize, &'b Body)>,
) {
    if std::mem::replace(&mut seen[index], true) {
        return;
    }
    let networks = match bodies[index].kind {
        UnitKind::Program => program.main.clone(),
        UnitKind::Function(function) => program.functions[function].networks.clone(),
        UnitKind::Block(block) => program.blocks[block].networks.clone(),
    };
    for block in program.networks[networks]
        .iter()
        .flat_map(|network| &network.blocks)
    {
        let mut called = Vec::new();
        if let ladder_analysis::program::BlockKind::User(user) = block.kind {
            called.push(UnitKind::Block(user));
        }
        for bound in &block.arguments {
            if let ladder_analysis::program::Argument::Function(function) = bound.argument {
                called.push(UnitKind::Function(function));
            }
        }
        for unit in called {
            if let Some(other) = bodies.iter().position(|body| body.kind == unit) {
                visit(program, bodies, other, seen, order);
            }
        }
    }
    order.push((index, &bodies[index]));
}

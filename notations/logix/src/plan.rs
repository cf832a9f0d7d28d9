//! Which routine of a project is the main program, and which are functions.

use crate::mnemonic::{Op, instruction};
use crate::model::Project;
use crate::neutral::instructions;
use crate::unit::{Owner, Unit};
use ladder_notation::names::Names;
use std::collections::{HashMap, HashSet};

/// Which routine is what.
pub(crate) struct Plan {
    /// The name of each unit as a function.
    pub(crate) functions: Vec<String>,
    /// The routine that is the main program, if one alone is.
    pub(crate) main: Option<usize>,
    /// Else the routines that the main program calls, in their order.
    pub(crate) called: Vec<usize>,
}

impl Plan {
    pub(crate) fn of(project: &Project, units: &[Unit<'_>]) -> Plan {
        let mut names = Names::default();
        let mut count: HashMap<String, usize> = HashMap::new();
        for unit in units
            .iter()
            .filter(|unit| matches!(unit.owner, Owner::Program(_)))
        {
            *count.entry(unit.routine.name.to_ascii_uppercase()).or_default() += 1;
        }
        let functions = units.iter().map(|unit| match unit.owner {
            Owner::Program(program) => {
                let routine = &unit.routine.name;
                let name = match count.get(&routine.to_ascii_uppercase()) {
                    Some(1) => routine.clone(),
                    _ => format!("{}_{routine}", project.programs[program].name),
                };
                names.fresh(&name)
            }
            Owner::Aoi(_) => String::new(),
        });
        let functions = functions.collect();
        let mut order: Vec<usize> = Vec::new();
        let scheduled = project.scheduled.iter().filter_map(|name| {
            let mut all = project.programs.iter();
            all.position(|program| program.name.eq_ignore_ascii_case(name))
        });
        order.extend(scheduled);
        // Without tasks, as in the export of a part, all run.
        if project.scheduled.is_empty() {
            order.extend(0..project.programs.len());
        }
        let called: Vec<usize> = order
            .into_iter()
            .flat_map(|program| begun(project, units, program))
            .collect();
        match called[..] {
            [main] => Plan {
                functions,
                main: Some(main),
                called: Vec::new(),
            },
            _ => Plan {
                functions,
                main: None,
                called,
            },
        }
    }
}

/// The routines with which a program begins: its main routine, or in the export of a part all that no other calls.
fn begun(project: &Project, units: &[Unit<'_>], program: usize) -> Vec<usize> {
    let own = || {
        let all = units.iter().enumerate();
        all.filter(move |(_, unit)| unit.owner == Owner::Program(program))
    };
    let main = project.programs[program].main.as_deref();
    let main = main.and_then(|main| own().find(|(_, unit)| unit.routine.name.eq_ignore_ascii_case(main)));
    if let Some((main, _)) = main {
        return vec![main];
    }
    let mut called: HashSet<String> = HashSet::new();
    for (_, unit) in own() {
        for parts in unit.rungs.iter().filter_map(|rung| rung.as_ref().ok()) {
            instructions(parts, &mut |it| {
                if matches!(instruction(it.name, it.operands.len()), Some(Op::Jsr | Op::For)) {
                    called.extend(it.operands.first().map(|name| name.to_ascii_uppercase()));
                }
            });
        }
    }
    let is_begun =
        |unit: &Unit<'_>| !called.contains(&unit.routine.name.to_ascii_uppercase()) && !unit.rungs.is_empty();
    own()
        .filter(|(_, unit)| is_begun(unit))
        .map(|(number, _)| number)
        .collect()
}

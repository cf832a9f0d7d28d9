//! Which routine of a project is the main program, and which are functions.

use crate::mnemonic::{Op, instruction};
use crate::model::{Project, Task, TaskKind};
use crate::unit::{Owner, Unit};
use ladder_drawings::neutral::instructions;
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
    /// The programs that run at other times than the scan, each with the routines with which it begins.
    pub(crate) later: Vec<(Vec<usize>, Later)>,
}

/// A program that runs at other times than the scan.
pub(crate) struct Later {
    pub(crate) program: usize,
    /// When it runs.
    pub(crate) why: String,
    /// It is in the scan here; else nothing runs it.
    pub(crate) is_run: bool,
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
        let order = order(project);
        let begin = |program: &Scheduled| begun(project, units, program.program);
        let runs = order.iter().filter(|program| program.is_run());
        let called: Vec<usize> = runs.flat_map(begin).collect();
        let later = order.iter().filter_map(|program| {
            let why = program.why.clone()?;
            Some((
                begin(program),
                Later {
                    program: program.program,
                    why,
                    is_run: program.is_run(),
                },
            ))
        });
        let later = later.collect();
        match called[..] {
            [main] => Plan {
                functions,
                main: Some(main),
                called: Vec::new(),
                later,
            },
            _ => Plan {
                functions,
                main: None,
                called,
                later,
            },
        }
    }
}

/// A program that a task runs.
struct Scheduled {
    program: usize,
    kind: TaskKind,
    /// When it runs, if that is not the scan.
    why: Option<String>,
}

impl Scheduled {
    fn is_run(&self) -> bool {
        self.kind != TaskKind::Event
    }
}

/// The programs in the order in which tasks run them. One task is the scan: the continuous one, else the first.
fn order(project: &Project) -> Vec<Scheduled> {
    let numbers: HashMap<String, usize> = {
        let names = project
            .programs
            .iter()
            .map(|program| program.name.to_ascii_uppercase());
        names.enumerate().map(|(number, name)| (name, number)).collect()
    };
    let tasks = || project.tasks.iter().filter(|task| !task.programs.is_empty());
    // Without tasks, as in the export of a part, all run.
    if tasks().next().is_none() {
        let all = 0..project.programs.len();
        let scheduled = all.map(|program| Scheduled {
            program,
            kind: TaskKind::Continuous,
            why: None,
        });
        return scheduled.collect();
    }
    let programs = |task: &Task| -> Vec<usize> {
        let names = task.programs.iter().map(|name| name.to_ascii_uppercase());
        let programs = names.filter_map(|name| numbers.get(&name).copied());
        let runs = programs.filter(|program| !project.programs[*program].inhibited);
        runs.collect()
    };
    let runs = || tasks().filter(|task| !task.inhibited && !programs(task).is_empty());
    let of_kind = |kind: TaskKind| runs().find(|task| task.kind == kind);
    let scan = of_kind(TaskKind::Continuous).or_else(|| of_kind(TaskKind::Periodic));
    let mut order = Vec::new();
    for task in runs() {
        let is_scan = scan.is_some_and(|scan| scan.name == task.name);
        let why = match task.kind {
            _ if is_scan => None,
            TaskKind::Event => Some(format!("task {} runs it on an event", task.name)),
            TaskKind::Continuous | TaskKind::Periodic => {
                Some(format!("task {} runs it at times of its own", task.name))
            }
        };
        order.extend(programs(task).into_iter().map(|program| Scheduled {
            program,
            kind: task.kind,
            why: why.clone(),
        }));
    }
    order
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
        |unit: &Unit<'_>| !called.contains(&unit.routine.name.to_ascii_uppercase()) && !unit.is_empty();
    own()
        .filter(|(_, unit)| is_begun(unit))
        .map(|(number, _)| number)
        .collect()
}

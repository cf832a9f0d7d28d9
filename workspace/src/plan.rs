//! A project that runs as its tasks say: which main programs run in a scan, in ladder text.
//!
//! The text is what a person sees of the tasks. The functions in it stand for the main programs
//! ([`link_tasks`](ladder_analysis::link_tasks)).

use crate::error::{FileError, Problem};
use crate::named::Named;
use crate::settings::{Settings, Task, scan_of};
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Declaration, Drawing, Element, Expression, Invalid, Item, Network, Operator, Path, ProgramSketch,
    Section, SectionKind,
};
use ladder_instructions::Op;
use ladder_notations::Names;
use ladder_simulator::value_text::duration;

/// What the tasks of a project run.
#[derive(Debug, Clone)]
pub struct Plan<'s> {
    tasks: &'s [Task],
    scan: i64,
}

impl Plan<'_> {
    /// That of a project whose settings are these.
    ///
    /// # Errors
    /// There are no tasks; `file` names the settings.
    pub fn of<'s>(settings: &'s Settings, file: &std::path::Path) -> Result<Plan<'s>, FileError> {
        let tasks = &*settings.simulate.tasks;
        let scan = scan_of(tasks);
        if scan > 0 {
            return Ok(Plan { tasks, scan });
        }
        Err(FileError::new(file, Problem::NoTasks))
    }

    /// How many scans there are from one run of a task to the next.
    fn every(&self, task: &Task) -> u32 {
        u32::try_from(task.interval / self.scan).unwrap_or(u32::MAX)
    }

    /// The main programs in their order, each with how many scans there are from one run to the next.
    pub fn programs(&self) -> impl Iterator<Item = (&Named, u32)> {
        let tasks = self.tasks.iter();
        tasks.flat_map(|task| {
            task.programs
                .iter()
                .map(|(program, _)| (program, self.every(task)))
        })
    }

    /// The ladder text, laid out so.
    pub fn text(&self, options: &ladder_format::Options) -> String {
        // The names in it are such as can be written.
        self.drawn(options).unwrap_or_default()
    }

    fn drawn(&self, options: &ladder_format::Options) -> Result<String, Invalid> {
        let mut names = Names::default();
        let mut functions = Names::default();
        let mut items = vec![Item::Directive(format!("cycle {}", duration(self.scan)))];
        let mut waiting = Section::new(SectionKind::Var);
        let (mut networks, mut stand_ins) = (Vec::new(), Vec::new());
        for task in self.tasks {
            let mut calls = Vec::new();
            for (program, _) in &task.programs {
                let path = program.path();
                let stem = path
                    .file_stem()
                    .unwrap_or_default()
                    .to_string_lossy()
                    .into_owned();
                let function = Path::tag(functions.fresh(&stem));
                calls.push(Block::of(Op::Call, [function.clone()])?);
                let told = format!("the main program of {stem}.clad");
                stand_ins.push(network(vec![told], vec![Block::of(Op::Fun, [function])?]));
            }
            let every = self.every(task);
            let told = vec![format!("task {}: every {}", task.name, duration(task.interval))];
            if every == 1 {
                networks.push(network(told, calls));
                continue;
            }
            let name = names.fresh(&format!("{}_in", task.name));
            let wait = Path::tag(name.clone());
            waiting.declarations.push(Declaration {
                comment: Some("how many scans it has waited".to_owned()),
                ..Declaration::new(name, "DINT")
            });
            calls.insert(
                0,
                Block::of(
                    Op::Eq,
                    [Expression::from(wait.clone()), Expression::literal("0")?],
                )?,
            );
            networks.push(network(told, calls));
            let next = Expression::from(wait.clone()).with(Operator::Plus, Expression::literal("1")?);
            let next = next.with(Operator::Mod, Expression::literal(every.to_string())?);
            networks.push(network(
                Vec::new(),
                vec![Block::of(Op::Calc, [wait.into(), next])?],
            ));
        }
        items.push(Item::Blank);
        items.push(Item::Section(waiting));
        items.extend(
            networks
                .into_iter()
                .chain(stand_ins)
                .flat_map(|network| [Item::Blank, network]),
        );
        Ok(ProgramSketch { items }.write(options).text)
    }
}

/// Blocks in series.
fn network(comments: Vec<String>, blocks: Vec<Block>) -> Item {
    let elements = blocks
        .into_iter()
        .map(|block| Circuit::Element(Element::of(block, None)));
    Item::Network(Network {
        comments,
        drawing: Drawing::Circuit(Circuit::Series(elements.collect())),
    })
}

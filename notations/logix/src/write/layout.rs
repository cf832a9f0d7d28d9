//! What of ladder text is where in a controller: which functions are the routines of which program, and whose the tags are.
//!
//! A program alone is one program of the controller. The files of a folder are programs, and the networks of the one that runs the others
//! are the order of the task. What was read from a file is what it was there.

use crate::model::Task;
use crate::names::Originals;
use ladder_analysis::context::{Body, Context};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::written::facts::NodeKind;
use ladder_notation::Project;
use ladder_syntax::Name;
use std::collections::{BTreeMap, HashMap, HashSet};

/// The name of the first program, and of its first routine.
pub(super) const PROGRAM: &str = "MainProgram";
pub(super) const MAIN: &str = "MainRoutine";

/// Where everything is.
#[derive(Debug, Default)]
pub(super) struct Layout {
    pub(super) controller: Option<String>,
    /// The programs. None: there is one, which everything is in.
    pub(super) programs: Vec<ProgramAt>,
    /// The program and the routine of each function.
    functions: HashMap<Name, (usize, String)>,
    /// Where the networks outside of functions are. None: in no program.
    pub(super) main: Option<(usize, String)>,
    /// The functions of other files of which networks only say that they run: these are no rungs.
    orders: HashSet<Name>,
    /// Tags, each with the program whose tag it is, and what it is called there.
    tags: HashMap<Name, TagAt>,
    /// The programs in the order in which they run.
    order: Vec<usize>,
    /// What was called how in the file that it comes from.
    pub(super) originals: Option<Originals>,
    pub(super) tasks: Option<Vec<Task>>,
}

/// Where a tag is.
#[derive(Debug, Clone)]
pub(super) struct TagAt {
    /// None: it is the controller's.
    pub(super) program: Option<usize>,
    pub(super) name: String,
    /// Whether that is what it was called in the file that it comes from. Else it is spelled so that it can be.
    pub(super) is_original: bool,
}

/// A program of the controller.
#[derive(Debug, Clone, Default)]
pub(super) struct ProgramAt {
    pub(super) name: String,
    /// The routines with which it begins, in their order.
    pub(super) begins: Vec<String>,
    pub(super) is_run: bool,
}

/// A network that only says that a function of another file runs.
struct Order {
    function: String,
    /// Else something is there that nothing runs.
    is_run: bool,
}

/// The function that a block calls.
fn called(block: BlockAt<'_>) -> Option<String> {
    match block.meaning {
        Meaning::Instruction(row) if row.block() == "<CALL>" => {}
        _ => return None,
    }
    match &block.facts.operands.first()?.value.kind {
        NodeKind::Name(name) => Some(name.to_string()),
        _ => None,
    }
}

/// What a network outside of functions orders, if it does nothing else.
fn ordered(context: &Context, network: NetworkAt<'_>) -> Option<Order> {
    if context.bodies[network.index] != Body::Main {
        return None;
    }
    let blocks: Vec<BlockAt<'_>> = network.blocks().collect();
    let is_off = |block: BlockAt<'_>| {
        let text = context.parse.text_in(block.range());
        let bare: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        bare.eq_ignore_ascii_case("[](SYS.OFF)")
    };
    let (call, is_run) = match blocks[..] {
        [call] => (call, true),
        [off, call] if is_off(off) => (call, false),
        _ => return None,
    };
    Some(Order {
        function: called(call)?,
        is_run,
    })
}

impl Layout {
    /// The files of a folder as programs. A file that others share functions with cannot be one: then all are one program.
    pub(super) fn of_files(project: &Project) -> Layout {
        let context = &project.analysis.context;
        let mut layout = Layout::default();
        if project.count() < 2 {
            return layout;
        }
        let home = |function: &str| project.home_of_function(function).map(|(file, _)| file);
        let orders: Vec<Order> = context
            .networks
            .iter()
            .filter_map(|network| ordered(context, network))
            .collect();
        let orders: Vec<Order> = orders
            .into_iter()
            .filter(|order| home(&order.function) != Some(0))
            .collect();
        layout.orders = orders.iter().map(|order| Name::new(&order.function)).collect();
        for network in &context.networks {
            let from = match context.bodies[network.index] {
                Body::Main if layout.is_order(context, network) => continue,
                Body::Main => Some(0),
                Body::Function(function) => home(&context.functions[function].name),
                Body::Block(_) => continue,
            };
            if network
                .blocks()
                .filter_map(called)
                .any(|called| home(&called) != from)
            {
                return Layout::default();
            }
        }
        let mut routines: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        for function in &context.functions {
            let file = home(&function.name).unwrap_or_default();
            routines.entry(file).or_default().push(function.name.to_string());
        }
        let mut networks = context.networks.iter();
        let has_main = networks.any(|network| {
            let is_main = context.bodies[network.index] == Body::Main;
            is_main && !layout.is_order(context, context.networks.at(network.index))
        });
        // What only orders the others is the controller.
        layout.controller = (!has_main).then(|| project.stem(0).to_owned());
        let own = context.scopes[0].tags.iter();
        let with_tags: HashSet<usize> = own
            .filter_map(|tag| Some(project.home_of_tag(&tag.name)?.0))
            .collect();
        let mut numbers = HashMap::new();
        for file in 0..project.count() {
            let is_first = file == 0 && has_main;
            let has_routines = routines.contains_key(&file);
            let has_tags = file > 0 && with_tags.contains(&file);
            if !(is_first || has_routines || has_tags) {
                continue;
            }
            let number = layout.programs.len();
            numbers.insert(file, number);
            let name = super::names::Names::default().spell(super::names::Kind::Type, project.stem(file));
            let mut program = ProgramAt {
                name,
                ..ProgramAt::default()
            };
            if is_first {
                layout.main = Some((number, MAIN.to_owned()));
                program.begins.push(MAIN.to_owned());
                program.is_run = true;
                layout.order.push(number);
            }
            let all = routines.remove(&file).unwrap_or_default();
            for function in &all {
                let own = project
                    .home_of_function(function)
                    .map_or(function.as_str(), |(_, own)| own);
                let bare = bare(&program.name, own);
                let is_free = !all
                    .iter()
                    .any(|other| other != function && other.eq_ignore_ascii_case(bare));
                let routine = if is_free { bare } else { own };
                let is_main = project
                    .main(file)
                    .is_some_and(|main| *main == Name::new(function));
                let routine = if is_main { MAIN } else { routine };
                layout
                    .functions
                    .insert(Name::new(function), (number, routine.to_owned()));
            }
            layout.programs.push(program);
        }
        for order in &orders {
            layout.begin(&order.function, order.is_run);
        }
        for file in 0..project.count() {
            if let (Some(main), Some(number)) = (project.main(file), numbers.get(&file))
                && layout.programs[*number].begins.is_empty()
            {
                layout.begin(main.as_str(), true);
            }
        }
        for tag in &context.scopes[0].tags {
            if let Some((file, own)) = project.home_of_tag(&tag.name)
                && let Some(number) = numbers.get(&file)
            {
                let at = TagAt {
                    program: Some(*number),
                    name: own.to_owned(),
                    is_original: false,
                };
                layout.tags.insert(Name::new(&tag.name), at);
            }
        }
        layout
    }

    /// What was read from a file is where it was there, and what is new in the program of its file.
    pub(super) fn of_original(project: &Project, originals: &Originals, before: &Project) -> Layout {
        let context = &project.analysis.context;
        let mut layout = Layout {
            controller: Some(originals.controller.clone()),
            main: originals.main.clone(),
            ..Layout::default()
        };
        layout
            .programs
            .extend(originals.programs.iter().map(|(name, _)| ProgramAt {
                name: name.clone(),
                ..ProgramAt::default()
            }));
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
        let is_alone = before.count() < 2;
        let mut numbers: HashMap<usize, usize> = HashMap::new();
        let mut program_of = |file: usize, layout: &mut Layout| -> usize {
            if let Some(number) = numbers.get(&file) {
                return *number;
            }
            let stem = project.stem(file);
            let known = stems.get(&stem.to_lowercase()).copied();
            // The one file that was read holds all of its programs.
            let known = known.or((is_alone && file == 0 && !layout.programs.is_empty()).then_some(0));
            let number = known.unwrap_or_else(|| {
                layout.programs.push(ProgramAt {
                    name: super::names::Names::default().spell(super::names::Kind::Type, stem),
                    ..ProgramAt::default()
                });
                layout.programs.len() - 1
            });
            numbers.insert(file, number);
            number
        };
        for function in &context.functions {
            let key = Name::new(&function.name);
            let (file, own) = project
                .home_of_function(&function.name)
                .unwrap_or((0, &function.name));
            if let Some((program, routine)) = originals.functions.get(&Name::new(own))
                && (is_alone || program_of(file, &mut layout) == *program)
            {
                layout.functions.insert(key, (*program, routine.clone()));
                continue;
            }
            let number = program_of(file, &mut layout);
            let is_main = project.main(file).is_some_and(|main| *main == key);
            let bare = bare(&layout.programs[number].name, own);
            let is_taken = |routine: &str| {
                let known = originals.functions.values().chain(layout.functions.values());
                let mut own = known.filter(|(program, _)| *program == number);
                own.any(|(_, known)| known.eq_ignore_ascii_case(routine))
            };
            let routine = match (is_main, is_taken(bare)) {
                (true, _) => MAIN,
                (false, false) => bare,
                (false, true) => own,
            };
            layout.functions.insert(key.clone(), (number, routine.to_owned()));
            if is_main && layout.programs[number].begins.is_empty() {
                layout.begin(key.as_str(), true);
            }
        }
        for network in &context.networks {
            let Some(order) = ordered(context, network) else {
                // It is refused, and what it calls is run as it was.
                if context.bodies[network.index] == Body::Main && layout.main.is_none() {
                    network
                        .blocks()
                        .filter_map(called)
                        .for_each(|function| layout.begin(&function, true));
                }
                continue;
            };
            let is_one = match layout.functions.get(&Name::new(&order.function)) {
                Some((program, _)) => match &layout.main {
                    Some((main, _)) => main != program,
                    None => true,
                },
                None => false,
            };
            if is_one {
                layout.orders.insert(Name::new(&order.function));
                layout.begin(&order.function, order.is_run);
            }
        }
        if let Some((main, routine)) = layout.main.clone() {
            layout.programs[main].begins.insert(0, routine);
            layout.programs[main].is_run = true;
        }
        for tag in &context.scopes[0].tags {
            let home = project.home_of_tag(&tag.name);
            let own = home.map_or(&*tag.name, |(_, own)| own);
            let program = match home {
                Some((file, _)) if file > 0 || is_alone => Some(program_of(file, &mut layout)),
                _ => None,
            };
            let known = originals.tags.get(&Name::new(own)).filter(|(of, _)| {
                // What is declared for all may be the tag of any program.
                home.is_none() || (is_alone && home.is_some_and(|(file, _)| file == 0)) || *of == program
            });
            let at = TagAt {
                program: known.map_or(program, |(of, _)| *of),
                name: known.map_or_else(|| own.to_owned(), |(_, original)| original.clone()),
                is_original: known.is_some(),
            };
            layout.tags.insert(Name::new(&tag.name), at);
        }
        layout.tasks = Some(layout.tasks_of(originals));
        layout.originals = Some(originals.clone());
        layout
    }

    /// The tasks as they were, with what runs now: what is new is run by the one that is the scan.
    fn tasks_of(&self, originals: &Originals) -> Vec<Task> {
        let mut tasks = originals.tasks.clone();
        let known: HashSet<String> = originals
            .programs
            .iter()
            .map(|(name, _)| name.to_ascii_uppercase())
            .collect();
        let is_run = |name: &String| {
            let mut programs = self.programs.iter();
            programs.any(|program| program.name.eq_ignore_ascii_case(name) && !program.begins.is_empty())
        };
        for task in &mut tasks {
            task.programs
                .retain(|name| !known.contains(&name.to_ascii_uppercase()) || is_run(name));
        }
        let scan = tasks
            .iter()
            .position(|task| task.kind == crate::model::TaskKind::Continuous && !task.inhibited);
        let scan = scan.or((!tasks.is_empty()).then_some(0));
        if let Some(scan) = scan {
            let new = self
                .run()
                .filter(|program| !known.contains(&program.name.to_ascii_uppercase()));
            tasks[scan]
                .programs
                .extend(new.map(|program| program.name.clone()));
        }
        tasks
    }

    /// Whether a network says no more than when a program runs.
    pub(super) fn is_order(&self, context: &Context, network: NetworkAt<'_>) -> bool {
        let order = ordered(context, network);
        order.is_some_and(|order| self.orders.contains(&Name::new(&order.function)))
    }

    fn begin(&mut self, function: &str, is_run: bool) {
        if let Some((program, routine)) = self.functions.get(&Name::new(function)) {
            if !self.order.contains(program) {
                self.order.push(*program);
            }
            let program = &mut self.programs[*program];
            program.begins.push(routine.clone());
            program.is_run |= is_run;
        }
    }

    /// The program and the routine of a function. None: all is one program.
    pub(super) fn routine(&self, function: &str) -> Option<&(usize, String)> {
        self.functions.get(&Name::new(function))
    }

    /// All functions, each with its routine.
    pub(super) fn routines(&self) -> impl Iterator<Item = (&Name, &str)> {
        self.functions
            .iter()
            .map(|(name, (_, routine))| (name, routine.as_str()))
    }

    /// Where a tag is. None: it is called as it is.
    pub(super) fn tag(&self, tag: &str) -> Option<&TagAt> {
        self.tags.get(&Name::new(tag))
    }

    /// The programs that run, in their order.
    pub(super) fn run(&self) -> impl Iterator<Item = &ProgramAt> {
        let run = self.order.iter().map(|program| &self.programs[*program]);
        run.filter(|program| program.is_run)
    }
}

/// A function without the name of its program before it.
fn bare<'f>(program: &str, function: &'f str) -> &'f str {
    let begin = function.get(..program.len());
    let rest = begin
        .filter(|begin| begin.eq_ignore_ascii_case(program))
        .and_then(|_| function[program.len()..].strip_prefix('_'));
    rest.filter(|rest| rest.starts_with(|c: char| c.is_ascii_alphabetic()))
        .unwrap_or(function)
}

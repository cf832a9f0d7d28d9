//! A project as the sketch of a ladder program.
//!
//! The main routine is the main program and every other routine a function; of several programs each is a function, and
//! the main program calls them in the order of their tasks.

use crate::declarations::types;
use crate::folder::Parts;
use crate::mnemonic::{Op, instruction};
use crate::model::{Family, Project, Rung};
use crate::plan::Plan;
use crate::scope::{CONTROLLER, Tags};
use crate::survey::survey;
use crate::translate::{Routines, Translator};
use crate::unit::{Owner, Unit, units};
use crate::unread::LEFT;
use ladder_drawings::neutral::{Instruction, Part, instructions};
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Item, Network, Origin, Path};
use ladder_instructions::Op as Own;
use ladder_notation::names::Names;
use ladder_notation::{LineColumn, Lines, Reading};
use ladder_notation_st::read::Scope;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

/// The whole program. `text` is the file that the project was read from.
pub(crate) fn sketch(project: &Project, text: &str) -> Reading {
    sketched(project, text, |_, _| ()).0
}

/// The same, with what is asked of the sketcher when it is done.
pub(crate) fn sketched<T>(
    project: &Project,
    text: &str,
    ask: impl FnOnce(&Sketcher<'_>, &Plan) -> T,
) -> (Reading, T) {
    let units = units(project);
    let mut tags = Tags::of(project);
    survey(&units, project.family, &mut tags);
    let plan = Plan::of(project, &units);
    let routines = Routines::of(&units, &plan.functions, &mut tags, project.family);
    let mut sketcher = Sketcher {
        translator: Translator::new(project, tags, routines),
        lines: Lines::of(text),
        text,
        units: &units,
        reading: Reading::default(),
        leaves: None,
        seen: HashMap::new(),
    };
    sketcher.program(&plan);
    let asked = ask(&sketcher, &plan);
    let mut reading = sketcher.reading;
    reading.report.entries.sort_by_key(|entry| entry.place);
    (reading, asked)
}

/// Makes the sketch.
pub(crate) struct Sketcher<'p> {
    pub(crate) translator: Translator<'p>,
    lines: Lines,
    pub(crate) text: &'p str,
    pub(crate) units: &'p [Unit<'p>],
    pub(crate) reading: Reading,
    /// Why the routine that is being read may not go on after an instruction that is not read.
    leaves: Option<String>,
    /// What names mean in the texts of a scope, and how many tags had names when that was found.
    pub(crate) seen: HashMap<usize, (usize, Rc<Scope>)>,
}

impl<'p> Sketcher<'p> {
    pub(crate) fn place(&self, at: usize) -> LineColumn {
        self.lines.place(self.text, at)
    }

    pub(crate) fn origin(&mut self, at: usize) -> u32 {
        let place = self.place(at);
        self.reading.origin(place)
    }

    fn program(&mut self, plan: &Plan) {
        let project = self.translator.project;
        // One program alone has its tags beside those of the controller.
        let is_alone = project.programs.len() == 1;
        let begin = self.begin(|scope| scope == CONTROLLER || (is_alone && scope == CONTROLLER + 1));
        let main = plan.main.map(|main| self.unit(main)).unwrap_or_default();
        let call = |called: usize| {
            let call = Block::call(&plan.functions[called]);
            [Item::Blank, network(Vec::new(), alone(call, None))]
        };
        let mut calls: Vec<Item> = plan.called.iter().flat_map(|called| call(*called)).collect();
        let routines = plan
            .called
            .iter()
            .chain(plan.later.iter().flat_map(|(routines, _)| routines));
        let mut mains: Vec<Vec<Item>> = vec![Vec::new(); project.programs.len()];
        let mut called = HashSet::new();
        for &routine in routines {
            if let (Owner::Program(program), true) = (self.units[routine].owner, called.insert(routine)) {
                mains[program].extend(call(routine));
            }
        }
        for (routines, later) in plan.later.iter().filter(|(_, later)| !later.is_run) {
            let program = &project.programs[later.program].name;
            for routine in routines {
                let comments = vec![format!("program {program}: {}", later.why)];
                let never = Block::contact(Path::system("OFF"));
                let call = Block::call(&plan.functions[*routine]);
                let circuit = [never, call].map(|block| alone(block, None));
                calls.extend([Item::Blank, network(comments, Circuit::Series(circuit.to_vec()))]);
            }
        }
        let mut functions: Vec<(usize, Vec<Item>)> = Vec::new();
        for (number, function) in plan.functions.iter().enumerate() {
            let unit = &self.units[number];
            let unit_owner = unit.owner;
            if plan.main != Some(number)
                && let Owner::Program(program) = unit_owner
            {
                let later = plan.later.iter().find(|(routines, _)| routines.contains(&number));
                let later = later.map(|(_, later)| self.later(later)).unwrap_or_default();
                let mut called = plan.called.iter().chain(&plan.main);
                let own = |unit: &&usize| self.units[**unit].owner == unit_owner;
                let begin = match called.find(own) {
                    Some(first) if *first == number && !is_alone => {
                        self.begin(|scope| scope == CONTROLLER + 1 + program)
                    }
                    _ => Vec::new(),
                };
                let first = begin.into_iter().chain(later).collect();
                functions.push((program, self.function(number, function, first)));
            }
        }
        let aois = (0..project.aois.len()).flat_map(|aoi| self.aoi(aoi));
        let mut blocks: Vec<Item> = aois.collect();
        blocks.extend(self.translator.blocks.items());
        blocks.extend(self.translator.unread.items());
        let types = types(&self.translator.tags.types, &self.translator.aoi_names);
        let parts = Parts {
            types: types.into_iter().collect(),
            begin: begin.into_iter().chain(main).collect(),
            calls,
            mains,
            functions,
            blocks,
        };
        let mut items = self.head();
        items.extend(parts.types.iter().cloned());
        items.extend(self.declarations(|_| true));
        items.extend(parts.begin.iter().chain(&parts.calls).cloned());
        items.extend(parts.functions.iter().flat_map(|(_, items)| items.clone()));
        items.extend(parts.blocks.iter().cloned());
        self.reading.program.items = items;
        if project.programs.len() > 1 {
            self.reading.files = self.files(parts, plan);
        }
        self.idle_programs(plan);
        self.name_parts();
        self.protected();
        self.accounts();
    }

    /// A routine as a function.
    fn function(&mut self, number: usize, function: &str, first: Vec<Item>) -> Vec<Item> {
        let routine = self.units[number].routine;
        let origin = self.origin(routine.at);
        let begin = alone(Block::function(function), Some(origin));
        let comments = routine.comment.iter().cloned().collect();
        let mut items = vec![Item::Blank, network(comments, begin)];
        items.extend(first);
        items.extend(self.unit(number));
        items
    }

    /// What a person who has the project open calls its parts; rungs count from 0 there.
    fn name_parts(&mut self) {
        let project = self.translator.project;
        let mut names = Vec::new();
        for program in &project.programs {
            names.push((program.at, format!("program {}", program.name)));
        }
        for aoi in project.aois.iter().filter(|aoi| aoi.sized_from.is_none()) {
            names.push((aoi.at, format!("Add-On Instruction {}", aoi.name)));
        }
        for unit in self.units {
            // The sizes of one instruction are one there.
            let is_size = |number: usize| project.aois[number].sized_from.is_some();
            let owner = match unit.owner {
                Owner::Aoi(number) if is_size(number) => continue,
                Owner::Program(number) => format!("program {}", project.programs[number].name),
                Owner::Aoi(number) => format!("Add-On Instruction {}", project.aois[number].name),
            };
            let routine = format!("routine {} of {owner}", unit.routine.name);
            names.push((unit.routine.at, routine.clone()));
            for (number, rung) in unit.routine.rungs.iter().enumerate() {
                names.push((rung.at, format!("{routine}, rung {number}")));
            }
        }
        let names = names.into_iter().map(|(at, name)| (self.place(at), name));
        self.reading.names = names.collect();
    }

    /// Programs that no task runs.
    fn idle_programs(&mut self, plan: &Plan) {
        let project = self.translator.project;
        for (number, program) in project.programs.iter().enumerate() {
            let own = |unit: &usize| self.units[*unit].owner == Owner::Program(number);
            let mut units = self.units.iter();
            let has_rungs = units.any(|unit| unit.owner == Owner::Program(number) && !unit.is_empty());
            let is_later = plan.later.iter().any(|(_, later)| later.program == number);
            if has_rungs && !is_later && !plan.called.iter().chain(&plan.main).any(own) {
                let place = self.place(program.at);
                let what = format!("program {}", program.name);
                let why = "no task runs its main routine, or it is inhibited: its routines are functions that \
                           nothing calls";
                self.reading.report.approximated(place, what, why);
            }
        }
    }

    /// How long a scan is.
    pub(crate) fn cycle(&self) -> Vec<Item> {
        let rate = self.translator.project.rate.as_deref();
        let rate = rate.filter(|rate| rate.parse::<u32>().is_ok_and(|rate| rate > 0));
        rate.map(|rate| Item::Directive(format!("cycle {rate}ms")))
            .into_iter()
            .collect()
    }

    /// What the tools are told, and what the program is.
    fn head(&self) -> Vec<Item> {
        let project = self.translator.project;
        let others = "other devices reach the tags of a controller too";
        let allowed = [
            ("never-written", others),
            ("never-read", others),
            ("contact-after-coil", "rungs of Logix go on after a coil"),
            ("set-without-reset", others),
            ("reset-without-set", others),
        ];
        let mut items = vec![Item::Directive("profile logix".to_owned())];
        items.extend(self.cycle());
        items.extend(allowed.map(|(rule, why)| Item::Directive(format!("allow-file({rule}): {why}"))));
        let what = match project.family {
            Family::Logix if !project.name.is_empty() => Some(format!("Controller {}", project.name)),
            _ => None,
        };
        items.extend(what.map(Item::Comment));
        items
    }

    /// The rungs of a routine.
    pub(crate) fn unit(&mut self, number: usize) -> Vec<Item> {
        let unit = &self.units[number];
        if let Some(foreign) = &unit.routine.foreign {
            return self.foreign(number, foreign);
        }
        let entries = self.reading.report.entries.len();
        let parts = self.translator.unread.len();
        self.translator.labels = labels(unit);
        self.translator.routine.clone_from(&unit.routine.name);
        let mut items = Vec::new();
        for (rung, parts) in unit.routine.rungs.iter().zip(&unit.rungs) {
            items.push(Item::Blank);
            if parts.as_ref().is_ok_and(|parts| has_nop(parts)) {
                items.push(Item::Directive("allow(no-output): NOP does nothing".to_owned()));
            }
            items.push(self.rung(unit.scope, rung, parts.as_ref()));
            for circuit in std::mem::take(&mut self.translator.after) {
                items.extend([Item::Blank, network(Vec::new(), circuit)]);
            }
        }
        if let Some(why) = self.leaves.take() {
            self.reading.report.entries.truncate(entries);
            self.translator.unread.truncate(parts);
            let rungs = unit.routine.rungs.iter();
            let texts: Vec<&str> = rungs.map(|rung| rung.text.as_str()).collect();
            return self.unread_routine(number, &why, &texts.join("\n"));
        }
        items
    }

    fn rung(
        &mut self,
        scope: usize,
        rung: &Rung,
        parts: Result<&Vec<Part<'p>>, &ladder_drawings::neutral::Wrong>,
    ) -> Item {
        let told = rung.comment.iter().map(|text| text.replace("\r\n", "\n"));
        let mut comments: Vec<String> = told.collect();
        if let Some(edit) = &rung.edit {
            let why = format!(
                "the rung is part of an edit that is not done (its mark is {edit}); it is read as if it stayed"
            );
            self.reading
                .report
                .approximated(self.place(rung.at), &rung.text, why);
        }
        let parts = match parts {
            Ok(parts) => parts,
            Err(wrong) => {
                let place = self.place(rung.at + wrong.at);
                self.reading
                    .report
                    .refused(place, shortened(&rung.text), &wrong.message);
                comments.push(format!("not read: {}", rung.text));
                return Item::Comment(comments.join("\n"));
            }
        };
        let drawn = self.series(scope, rung, parts);
        if parts.is_empty() {
            comments.push("an empty rung".to_owned());
            return Item::Comment(comments.join("\n"));
        }
        network(comments, Circuit::Series(drawn))
    }

    fn series(&mut self, scope: usize, rung: &Rung, parts: &[Part<'p>]) -> Vec<Circuit<Element>> {
        let mut out = Vec::with_capacity(parts.len());
        for part in parts {
            match part {
                Part::Instruction(it) => out.push(self.instruction(scope, rung, it)),
                Part::Branch(legs) => {
                    let legs = legs
                        .iter()
                        .map(|leg| Circuit::Series(self.series(scope, rung, leg)));
                    out.push(Circuit::Parallel(legs.collect()));
                }
            }
        }
        out
    }

    fn instruction(&mut self, scope: usize, rung: &Rung, it: &Instruction<'p>) -> Circuit<Element> {
        let place = self.place(rung.at + it.at);
        let origin = self.reading.origin(place);
        let report = &mut self.reading.report;
        match self.translator.translate(scope, it, Some(origin)) {
            Ok(translated) => {
                match translated.note {
                    None => report.translated(place, it.text),
                    Some(note) => report.approximated(place, it.text, note),
                }
                translated.circuit
            }
            // A controller would not take it either.
            Err(why) if Translator::is_broken(it) => {
                report.refused(place, it.text, why);
                Circuit::Element(Element::comment(it.text, Some(origin)))
            }
            Err(why) => {
                let unread = self.translator.unread(it, &why);
                report.approximated(place, it.text, unread.why);
                if unread.may_leave {
                    let why = || format!("`{}` {LEFT} ({why})", it.text);
                    self.leaves.get_or_insert_with(why);
                }
                alone(unread.block, Some(origin))
            }
        }
    }

    /// What there is to say of declarations and of parts that were not read.
    fn accounts(&mut self) {
        let project = self.translator.project;
        for (at, what, why) in &project.refused {
            let place = self.place(*at);
            self.reading.report.refused(place, what, why);
        }
        let mut told: HashSet<String> = HashSet::new();
        for (at, what, ty) in self.translator.tags.opened.clone() {
            let types = &self.translator.tags.types;
            let name = types.original_of_elements(&ty).to_owned();
            if types.is_guessed(&ty) && told.insert(name.clone()) {
                let why = format!(
                    "its type {name} is not declared in the file: its members are those that are used, with the types of their use"
                );
                self.reading.report.approximated(self.place(at), what, why);
            }
        }
        let tags = std::iter::once(&project.tags).chain(project.programs.iter().map(|program| &program.tags));
        let tags: Vec<(usize, String)> = tags
            .flatten()
            .filter(|tag| project.family == Family::Logix && !tag.name.is_empty())
            .map(|tag| (tag.at, format!("tag {}", tag.name)))
            .collect();
        let types = project
            .types
            .iter()
            .map(|ty| (ty.at, format!("type {}", ty.name)));
        let entries: Vec<(usize, String)> = tags.into_iter().chain(types).collect();
        let told = self.reading.report.entries.iter().map(|entry| entry.place);
        let told: HashSet<LineColumn> = told.collect();
        for (at, what) in entries {
            let place = self.place(at);
            if !told.contains(&place) {
                self.reading.report.translated(place, what);
            }
        }
    }
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(80) {
        Some((end, _)) => format!("{} ..", &text[..end]),
        None => text.to_owned(),
    }
}

/// A block, and what it was made from.
pub(crate) const fn alone(block: Block, origin: Option<Origin>) -> Circuit<Element> {
    Circuit::Element(Element::of(block, origin))
}

/// A network from the left rail to the right one.
pub(crate) fn network(comments: Vec<String>, circuit: Circuit<Element>) -> Item {
    let drawing = Drawing::Circuit(Circuit::Series(vec![circuit]));
    Item::Network(Network { comments, drawing })
}

/// Whether there is an instruction that is there to do nothing.
fn has_nop(parts: &[Part<'_>]) -> bool {
    let mut found = false;
    instructions(parts, &mut |it| {
        found |= matches!(instruction(it.name, it.operands.len()), Some(Op::Nop));
    });
    found
}

/// The labels of a routine, as ladder text spells them.
fn labels(unit: &Unit<'_>) -> HashMap<String, String> {
    let mut names = Names::default();
    let mut labels = HashMap::new();
    for parts in unit.rungs.iter().filter_map(|rung| rung.as_ref().ok()) {
        instructions(parts, &mut |it| {
            if let (Some(Op::Label(Own::Lbl)), Some(name)) =
                (instruction(it.name, it.operands.len()), it.operands.first())
            {
                let key = name.to_ascii_uppercase();
                labels.entry(key).or_insert_with(|| names.spell(name).to_owned());
            }
        });
    }
    labels
}

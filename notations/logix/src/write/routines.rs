//! The parts of a program as routines, with what comments say.

use super::data::Home;
use super::layout::{MAIN, PROGRAM, rate};
use super::names::{Kind, Names};
use super::native::Known;
use super::rung::{Piece, Series, it, text};
use super::{Result, Scope, Writer};
use crate::model::{Program, Project, Routine, Rung, Tag, Task};
use crate::scope::CLEARED;
use ladder_analysis::program::{Argument, BlockKind, Network};
use ladder_instructions::Op;
use ladder_notation::{Unwritable, comments};
use ladder_syntax::{Item, Name};
use std::collections::HashMap;

impl Writer<'_> {
    pub(super) fn project(&mut self, unwritable: &Unwritable) -> Project {
        self.know_blocks(unwritable);
        self.spell_tags();
        self.count_uses();
        self.find_loops();
        let mut project = Project {
            rate: self.input.analysis.context.cycle.map(rate),
            ..Project::default()
        };
        let layout = self.input.layout;
        self.names.fresh(Kind::Routine, MAIN);
        let (first_program, first) = match &layout.main {
            Some((program, routine)) => (Some(*program), routine.as_str()),
            None => (None, MAIN),
        };
        self.scope.program = first_program;
        let mut homes = vec![first_program];
        let mut routines = vec![Routine {
            name: first.to_owned(),
            ..Routine::default()
        }];
        let mut bodies: HashMap<usize, Vec<Rung>> = HashMap::new();
        let mut locals: HashMap<usize, Scope> = HashMap::new();
        let mut waiting: Vec<String> = Vec::new();
        let mut said_of_all: Vec<String> = Vec::new();
        let mut has_begun = false;
        let program = self.input.program;
        let networks = program.networks.iter().enumerate();
        let networks = networks.filter(|(_, network)| network.location.file == 0);
        // Blocks and functions stand in another order in the text.
        let by_start: HashMap<_, _> = networks
            .map(|found| (found.1.location.range.start(), found))
            .collect();
        let parse = self.input.analysis.context.parse.clone();
        let mut within = None;
        for item in &parse.structure().items {
            match *item {
                Item::Decoration(line) => {
                    let told = comments_on(&parse, line);
                    // A blank line within a comment.
                    if told.is_empty() && !waiting.is_empty() {
                        waiting.push(String::new());
                    }
                    if !has_begun
                        && let [only] = &told[..]
                        && let Some(name) = controller(only)
                    {
                        name.clone_into(&mut project.name);
                        continue;
                    }
                    waiting.extend(told);
                }
                Item::Section(_) if !has_begun => said_of_all.append(&mut waiting),
                Item::BlockHeader(number) => {
                    within = Some(number);
                    self.described(number, &mut waiting);
                }
                Item::BlockEnd(_) => {
                    within = None;
                    waiting.clear();
                }
                Item::Network(number) => {
                    has_begun = true;
                    let start = self.input.analysis.context.networks.at(number).range.start();
                    let Some(&(index, network)) = by_start.get(&start) else {
                        let place = self.at(start.into());
                        let why = "nothing uses the function or block that it is in";
                        self.report.refused(place, "network", why);
                        continue;
                    };
                    if self.facts.loops.networks.contains(&index) {
                        self.translated(network);
                        continue;
                    }
                    let drawn = &parse.structure().networks[number];
                    for line in drawn.lines.clone() {
                        waiting.extend(
                            comments_on(&parse, line)
                                .into_iter()
                                .filter(|told| told.trim() != "NOP"),
                        );
                    }
                    let context = &self.input.analysis.context;
                    if within.is_none() && layout.runs.orders.has(context, context.networks.at(number)) {
                        self.translated(network);
                        said_of_all.append(&mut waiting);
                        continue;
                    }
                    if within.is_none()
                        && let Some(name) = function(network)
                    {
                        let name = self.source(name).trim().to_owned();
                        self.scope.in_function = true;
                        self.scope.program = layout.routine(&name).map(|(program, _)| *program);
                        homes.push(self.scope.program);
                        routines.push(Routine {
                            name: self.names.spell(Kind::Routine, &name),
                            comment: comment(&mut waiting),
                            ..Routine::default()
                        });
                        if network.blocks.len() == 1 {
                            self.translated(network);
                            continue;
                        }
                    }
                    if within.is_none() && homes.last() == Some(&None) && !layout.programs.is_empty() {
                        let place = self.at(start.into());
                        let why =
                            "it runs outside of the programs there: put it into the file of one of them";
                        self.report.refused(place, "network", why);
                        waiting.clear();
                        continue;
                    }
                    // The tasks say when their programs run.
                    if layout.runs.tasks.is_some() && self.is_of_a_task(network) {
                        self.translated(network);
                        continue;
                    }
                    let rungs = match within {
                        Some(body) if !self.is_written(body) => {
                            waiting.clear();
                            continue;
                        }
                        Some(body) => {
                            let own = locals.remove(&body).unwrap_or_else(|| Scope {
                                body: Some(body),
                                ..Scope::default()
                            });
                            let outer = std::mem::replace(&mut self.scope, own);
                            let rungs = self.rungs_of(network, comment(&mut waiting));
                            locals.insert(body, std::mem::replace(&mut self.scope, outer));
                            bodies.entry(body).or_default().extend(rungs);
                            continue;
                        }
                        None => self.rungs_of(network, comment(&mut waiting)),
                    };
                    if let Some(routine) = routines.last_mut() {
                        routine.rungs.extend(rungs);
                    }
                }
                Item::Section(_) | Item::Stray(_) => {}
            }
        }
        if !has_begun {
            said_of_all.append(&mut waiting);
        }
        if let (Some(comment), Some(last)) = (comment(&mut waiting), routines.last_mut()) {
            last.rungs.push(Rung {
                text: text(&[it("NOP", &[])]),
                comment: Some(comment),
                ..Rung::default()
            });
        }
        if let Some(first) = self.first_scan_rung(&self.scope.first_scan) {
            routines[0].rungs.insert(0, first);
        }
        for routine in &mut routines {
            let rungs = std::mem::take(&mut routine.rungs);
            (routine.rungs, routine.foreign) = self.in_one_language(rungs);
        }
        self.scope.program = None;
        if let Some(controller) = &layout.controller {
            project.name = Names::default().spell(Kind::Tag, controller);
        }
        if project.name.is_empty() {
            let name = &self.input.analysis.context.name;
            let stem = name.rsplit(['/', '\\']).next().unwrap_or_default();
            let stem = stem.split('.').next().unwrap_or_default();
            project.name = Names::default().spell(Kind::Tag, stem);
        }
        let told = self.comments();
        let scopes = &self.input.analysis.context.scopes;
        project.aois = self.definitions(&mut bodies, &mut locals, &told);
        let mut tags = Vec::new();
        if let Some(scope) = scopes.iter().find(|scope| scope.block.is_none()) {
            tags = self.tags(scope, "", &told);
        }
        let made = std::mem::take(&mut self.scope.made);
        project.types = std::mem::take(&mut self.data.types);
        project
            .types
            .sort_by_key(|ty| self.data.type_order.get(&ty.name).copied().unwrap_or(usize::MAX));
        if layout.programs.is_empty() {
            let (shared, own): (Vec<_>, Vec<_>) =
                tags.into_iter().partition(|(home, _)| *home == Home::Controller);
            project.tags = shared.into_iter().map(|(_, tag)| tag).collect();
            let tags: Vec<Tag> = own.into_iter().map(|(_, tag)| tag).chain(made).collect();
            let has_nothing = |routine: &Routine| routine.rungs.is_empty() && routine.foreign.is_none();
            let is_empty = routines.iter().all(has_nothing) && tags.is_empty();
            if !is_empty || project.aois.is_empty() {
                project.programs.push(Program {
                    name: PROGRAM.to_owned(),
                    main: Some(MAIN.to_owned()),
                    tags,
                    routines,
                    comment: comment(&mut said_of_all),
                    ..Program::default()
                });
            }
            return project;
        }
        self.programs(&mut project, homes, routines, tags, made);
        if let Some(first) = project.programs.first_mut() {
            first.comment = comment(&mut said_of_all);
        }
        project
    }

    /// Each program with its routines and tags, and the tasks.
    fn programs(
        &self,
        project: &mut Project,
        homes: Vec<Option<usize>>,
        routines: Vec<Routine>,
        tags: Vec<(Home, Tag)>,
        made: Vec<Tag>,
    ) {
        let layout = self.input.layout;
        project.programs = layout
            .programs
            .iter()
            .map(|program| Program {
                name: program.name.clone(),
                main: program.begins.first().cloned(),
                ..Program::default()
            })
            .collect();
        for (home, routine) in homes.into_iter().zip(routines) {
            if let Some(home) = home {
                project.programs[home].routines.push(routine);
            }
        }
        // What rungs need of their own is seen from all of them.
        project.tags = made;
        for (home, tag) in tags {
            match home {
                Home::Program(program) if program < project.programs.len() => {
                    project.programs[program].tags.push(tag);
                }
                _ => project.tags.push(tag),
            }
        }
        if layout.originals.is_some() {
            // What is empty now was, or is gone.
            project
                .programs
                .retain(|program| !program.routines.is_empty() || !program.tags.is_empty());
        } else {
            for (program, at) in project.programs.iter_mut().zip(&layout.programs) {
                begin_with_all(program, &at.begins);
            }
        }
        project.tasks = match &layout.runs.tasks {
            Some(tasks) => tasks.clone(),
            None => {
                vec![Task {
                    name: "MainTask".to_owned(),
                    programs: layout.run().map(|program| program.name.clone()).collect(),
                    ..Task::default()
                }]
            }
        };
    }

    /// Whether the definition of a block is written as an Add-On Instruction.
    fn is_written(&self, body: usize) -> bool {
        let of = self.facts.body_of.iter().find(|(_, own)| **own == body);
        of.is_some_and(|(user, _)| matches!(self.facts.known.get(user), Some(Known::Own(_))))
    }

    /// Each name is spelled as it is first, so that those of helpers give way.
    fn spell_tags(&mut self) {
        let scopes = &self.input.analysis.context.scopes;
        let names: Vec<_> = scopes
            .iter()
            .flat_map(|scope| &scope.tags)
            .map(|tag| tag.name.clone())
            .collect();
        let layout = self.input.layout;
        let is_known = |name: &Name| {
            let at = layout.tag(name.as_str());
            let mut locals = layout
                .originals
                .iter()
                .flat_map(|originals| originals.locals.keys());
            at.is_some_and(|at| at.is_original) || locals.any(|(_, local)| local == name)
        };
        for name in names {
            if is_known(&Name::new(&name)) {
                continue;
            }
            if !name.eq_ignore_ascii_case("EN") && !name.eq_ignore_ascii_case("ENO") {
                self.names.spell(Kind::Tag, &name);
            }
        }
    }

    /// Which tags are used once written and once read, and which parameters calls give.
    fn count_uses(&mut self) {
        let mut count: HashMap<u32, usize> = HashMap::new();
        for network in &self.input.program.networks {
            for block in &network.blocks {
                for bound in &block.arguments {
                    for (place, _) in bound.places() {
                        if let Some(root) = place.root() {
                            *count.entry(root.0).or_default() += 1;
                        }
                    }
                    if let (BlockKind::User(user), Some(parameter)) = (block.kind, bound.parameter) {
                        self.data.given.insert((user, parameter));
                    }
                }
            }
        }
        if !self.input.is_own {
            return;
        }
        let told = self.comments();
        let cleared = told.iter().filter(|(_, text)| *text == CLEARED);
        self.facts.cleared = cleared.map(|((_, name), _)| name.clone()).collect();
        self.facts
            .absorbed_names
            .extend(self.facts.cleared.iter().cloned());
        for (number, tag) in self.input.program.tags.iter().enumerate() {
            let block = tag
                .block
                .map(|block| self.input.program.blocks[block].name.to_ascii_uppercase());
            let key = (block.unwrap_or_default(), Name::new(&tag.name));
            if told
                .get(&key)
                .is_some_and(|told| told.ends_with("ends the loop that calls it"))
            {
                self.facts
                    .leaves
                    .insert(ladder_analysis::program::TagId(number as u32));
                self.facts.absorbed_names.insert(Name::new(&tag.name));
            }
            let is_helper = told.get(&key).is_some_and(|told| told.starts_with("helper: "));
            if is_helper && count.get(&(number as u32)) == Some(&2) {
                self.facts
                    .helpers
                    .insert(ladder_analysis::program::TagId(number as u32));
            }
        }
    }

    fn translated(&mut self, network: &Network) {
        let place = self.at(network.location.range.start().into());
        self.report.translated(place, "network");
    }

    /// A network as rungs, with its comment on the first.
    fn rungs_of(&mut self, network: &Network, mut comment: Option<String>) -> Vec<Rung> {
        let place = self.at(network.location.range.start().into());
        self.sheet.note = None;
        let made = (self.scope.made.len(), self.scope.first_scan.len());
        let rungs = match self.unread_routine(network) {
            Some(Ok(mut rungs)) => {
                self.report.translated(place, "network");
                if let Some(first) = rungs.first_mut() {
                    first.comment = comment;
                }
                return rungs;
            }
            Some(Err(why)) => Err(why),
            None => self.network(network).and_then(checked),
        };
        match rungs {
            Ok(rungs) => {
                match self.sheet.note.take() {
                    Some(note) => self.report.approximated(place, "network", note),
                    None => self.report.translated(place, "network"),
                }
                let rung = |series: Series| Rung {
                    text: text(&series),
                    comment: comment.take(),
                    ..Rung::default()
                };
                rungs.into_iter().map(rung).collect()
            }
            Err(why) => {
                self.scope.made.truncate(made.0);
                self.scope.first_scan.truncate(made.1);
                self.report.refused(place, "network", &why);
                let drawing = self.source(network.location.range);
                let told = comment.map_or_else(String::new, |told| format!("{told}\n"));
                vec![Rung {
                    text: text(&[it("NOP", &[])]),
                    comment: Some(format!("{told}not written: {why}\n{drawing}")),
                    ..Rung::default()
                }]
            }
        }
    }

    /// In the first scan what is high has risen: here it has, there the memories of edges are on.
    pub(super) fn first_scan_rung(&self, bits: &[String]) -> Option<Rung> {
        if bits.is_empty() || self.input.is_own {
            return None;
        }
        let mut series = vec![it("XIC", &["S:FS"])];
        series.extend(bits.iter().map(|bit| it("OTU", &[bit])));
        Some(Rung {
            text: text(&series),
            comment: Some("What is high in the first scan has risen".to_owned()),
            ..Rung::default()
        })
    }

    /// Whether several labels have a name.
    pub(super) fn ambiguous_label(&self, name: &str) -> bool {
        let key = Name::new(name);
        let context = &self.input.analysis.context;
        let of = |label: &&ladder_analysis::context::LabelFacts| label.key == key;
        let mut bodies: Vec<_> = context
            .labels
            .iter()
            .filter(of)
            .map(|label| context.bodies[label.network])
            .collect();
        let count = bodies.len();
        bodies.sort_unstable();
        bodies.dedup();
        bodies.len() != count
    }
}

/// A program begins with one routine: of several that run, each is called by one.
fn begin_with_all(program: &mut Program, begins: &[String]) {
    if begins.len() < 2 {
        return;
    }
    let is_taken = |name: &str| {
        program
            .routines
            .iter()
            .any(|routine| routine.name.eq_ignore_ascii_case(name))
    };
    let name = if is_taken(MAIN) {
        format!("{MAIN}_all")
    } else {
        MAIN.to_owned()
    };
    let call = |routine: &String| Rung {
        text: text(&[it("JSR", &[routine, "0"])]),
        ..Rung::default()
    };
    let first = Routine {
        name: name.clone(),
        rungs: begins.iter().map(call).collect(),
        ..Routine::default()
    };
    program.routines.insert(0, first);
    program.main = Some(name);
}

/// What no rung of Logix can be.
fn checked(rungs: Vec<Series>) -> Result<Vec<Series>> {
    const DEEPEST: usize = 20;
    fn depth(series: &[Piece]) -> usize {
        let of = |piece: &Piece| match piece {
            Piece::It(_) => 0,
            Piece::Branch(legs) => 1 + legs.iter().map(|leg| depth(leg)).max().unwrap_or(0),
        };
        series.iter().map(of).max().unwrap_or(0)
    }
    if rungs.iter().any(|rung| depth(rung) > DEEPEST) {
        return Err("its branches are nested too deep".to_owned());
    }
    let filled = rungs.into_iter().map(|rung| {
        if rung.is_empty() {
            vec![it("NOP", &[])]
        } else {
            rung
        }
    });
    Ok(filled.collect())
}

/// The name of the function that a network begins.
fn function(network: &Network) -> Option<ladder_syntax::TextRange> {
    network
        .blocks
        .iter()
        .find_map(|block| match (block.kind, block.arguments.first()) {
            (BlockKind::Instruction(row), Some(bound)) if row.op == Op::Fun => {
                matches!(bound.argument, Argument::Function(_)).then_some(bound.range)
            }
            _ => None,
        })
}

/// The comments on a line, without those for the tools.
fn comments_on(parse: &ladder_syntax::Parse, line: usize) -> Vec<String> {
    let all = comments::on_line(parse, line).into_iter();
    all.filter(|told| !told.trim_start().starts_with("ladder:"))
        .map(|told| {
            let lines: Vec<&str> = told.lines().map(str::trim).collect();
            lines.join("\n").trim().to_owned()
        })
        .collect()
}

/// The name of a controller, as the reader says it.
fn controller(told: &str) -> Option<&str> {
    let name = told.strip_prefix("Controller ")?;
    (!name.contains(char::is_whitespace)).then_some(name)
}

/// What waits as one comment.
fn comment(waiting: &mut Vec<String>) -> Option<String> {
    let told = std::mem::take(waiting).join("\n").trim().to_owned();
    (!told.is_empty()).then_some(told)
}

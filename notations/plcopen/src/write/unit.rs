//! One unit: the program of a file, or a block of one's own.

use super::declare::{self, Source, place};
use super::element::Writer;
use super::names::Names;
use super::rung::Rung;
use crate::graph::{Graph, Kind, Node};
use crate::model::{Body, Role, Type, Unit as Made, UnitKind, Variable};
use crate::own;
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body as OwnBody, Context};
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::program::{Network, ParameterKind, Program};
use ladder_format::program::Qualifier;
use ladder_instructions::Op;
use ladder_notation::guard::is_guarded;
use ladder_notation::{LineColumn, Report, comments};
use ladder_syntax::{Item, Name, TextSize};
use std::collections::HashMap;

/// How blocks of one's own are called from outside, by their names.
#[derive(Default)]
pub(super) struct Faces(HashMap<Name, Face>);

/// Blocks that cannot be called, with why.
pub(super) type Broken = Vec<(Name, String)>;

/// A block of one's own as those that use it see it.
pub(super) struct Face {
    pub(super) name: String,
    pub(super) power_in: String,
    pub(super) power_out: String,
    pub(super) parameters: Vec<Parameter>,
    /// Why a call of it is not written.
    pub(super) broken: Option<String>,
}

/// A parameter of a block.
pub(super) struct Parameter {
    pub(super) name: String,
    pub(super) kind: ParameterKind,
}

impl Faces {
    pub(super) fn get(&self, block: &str) -> Option<&Face> {
        self.0.get(&Name::new(block))
    }

    pub(super) fn insert(&mut self, block: &str, face: Face) {
        self.0.insert(Name::new(block), face);
    }

    /// Marks these as not whole, and all that use them. `users` has for each block those that use it.
    pub(super) fn break_with(&mut self, broken: Broken, users: &HashMap<Name, Broken>) {
        let mut waiting = broken;
        while let Some((name, why)) = waiting.pop() {
            let Some(face) = self.0.get_mut(&name) else {
                continue;
            };
            if face.broken.is_some() {
                continue;
            }
            waiting.extend(users.get(&name).into_iter().flatten().cloned());
            face.broken = Some(why);
        }
    }
}

/// What all units of a project share.
#[derive(Clone)]
pub(super) struct Project<'p> {
    /// The names of blocks, by their names here.
    pub(super) blocks: Names,
    /// The names of globals.
    pub(super) globals: Names,
    pub(super) faces: &'p Faces,
}

/// A file whose units are written.
pub(super) struct Unit<'u> {
    pub(super) analysis: &'u Analysis,
    pub(super) program: &'u Program,
    pub(super) text: &'u str,
    /// What is declared from here on was added for the writer's own sake.
    pub(super) end: TextSize,
}

/// The names of a unit's tags.
pub(super) struct Scope {
    pub(super) names: Names,
    pub(super) power: Option<(String, String)>,
}

impl<'u> Unit<'u> {
    pub(super) fn context(&self) -> &'u Context {
        &self.analysis.context
    }

    fn place(&self, offset: TextSize) -> LineColumn {
        place(self.context(), offset)
    }

    /// Whether a tag is a global of the workspace, in the eyes of a scope.
    fn global<'t>(&self, tag: &'t TagFacts) -> Option<&'t TagFacts>
    where
        'u: 't,
    {
        let shared = self.context().shared(tag);
        let is_global =
            shared.origin == Origin::Declared(SectionKind::Global) || shared.cold.foreign.is_some();
        is_global.then_some(shared)
    }

    /// The tags of a scope that are declared or used there. Direct addresses have no declaration.
    fn tags(&self, scope: usize) -> impl Iterator<Item = &'u TagFacts> {
        let context = self.context();
        let end = self.end;
        context.scopes[scope]
            .tags
            .iter()
            .filter(move |tag| !tag.name.starts_with('%'))
            .filter(move |tag| !tag.name.eq_ignore_ascii_case("SYS"))
            .filter(move |tag| context.place_of(tag).start() < end || end == TextSize::default())
    }

    /// Whether a block does not run without power, here as there: see [`is_guarded`].
    fn is_guarded(&self, block: usize) -> bool {
        let facts = &self.context().user_blocks[block];
        let mut blocks = self.program.blocks.iter();
        let block = blocks.find(|block| block.name == facts.name);
        block.is_some_and(|block| is_guarded(self.program, block))
    }

    /// Names for the tags of a scope: 0 the file's, else that of block definition `scope - 1`.
    pub(super) fn scope(&self, project: &Project<'_>, scope: usize) -> Scope {
        let mut names = project.globals.inside();
        let mut power = None;
        if scope > 0 && !self.is_guarded(scope - 1) {
            let (enters, leaves) = (names.fresh("power_in"), names.fresh("power_out"));
            names.alias("EN", &enters);
            names.alias("ENO", &leaves);
            power = Some((enters, leaves));
        }
        for tag in self.tags(scope) {
            if tag.origin == Origin::Implicit {
                continue;
            }
            let global = self.global(tag);
            if let Some(ty) = global.unwrap_or(tag).ty {
                names.has_type(&tag.name, ty);
            }
            match global.and_then(|global| project.globals.get(&global.name)) {
                Some(global) => names.alias(&tag.name, global),
                None => drop(names.declare(&tag.name)),
            }
        }
        Scope { names, power }
    }

    /// The variables of a scope.
    fn variables(
        &self,
        project: &Project<'_>,
        scope: usize,
        own: &mut Scope,
        report: &mut Report,
    ) -> Vec<Variable> {
        let names = own.names.clone();
        let source = Source {
            context: self.context(),
            text: self.text,
            blocks: &project.blocks,
            globals: &names,
        };
        let mut variables = Vec::new();
        if let Some((enters, leaves)) = &own.power {
            for (name, role, comment) in [
                (enters, Role::Input, own::POWER_IN),
                (leaves, Role::Output, own::POWER_OUT),
            ] {
                variables.push(Variable {
                    role,
                    comment: Some(comment.to_owned()),
                    ..Variable::local(
                        self.place(TextSize::default()),
                        name.clone(),
                        Type::Named("BOOL".to_owned()),
                    )
                });
            }
        }
        for tag in self.tags(scope) {
            let Some(name) = names.get(&tag.name).filter(|_| tag.origin != Origin::Implicit) else {
                continue;
            };
            let global = self.global(tag);
            match declare::variable(&source, global.unwrap_or(tag), name) {
                Ok(mut variable) => {
                    if global.is_some() {
                        variable.role = Role::External;
                        variable.initial = None;
                        variable.address = None;
                    } else {
                        variable.role = role(tag);
                        // A VAR_IN_OUT has neither.
                        variable.qualifier = qualifier(tag).filter(|_| variable.role != Role::InOut);
                    }
                    variables.push(variable);
                }
                Err(why) => {
                    own.names.refuse(&tag.name);
                    let at = self.place(self.context().place_of(tag).start());
                    report.refused(at, format!("tag {}", tag.name), why);
                }
            }
        }
        variables
    }

    /// The globals that the file declares, or uses of another file.
    pub(super) fn globals(&self, project: &mut Project<'_>, report: &mut Report) -> Vec<Variable> {
        let mut variables = Vec::new();
        for scope in 0..self.context().scopes.len() {
            for tag in self.tags(scope) {
                let Some(global) = self.global(tag) else { continue };
                if project.globals.get(&global.name).is_some() {
                    continue;
                }
                let name = project.globals.declare(&global.name);
                let source = Source {
                    context: self.context(),
                    text: self.text,
                    blocks: &project.blocks,
                    globals: &project.globals,
                };
                match declare::variable(&source, global, &name) {
                    Ok(mut variable) => {
                        variable.role = Role::Global;
                        variable.qualifier = qualifier(global);
                        variables.push(variable);
                    }
                    Err(why) => {
                        let at = self.place(self.context().place_of(tag).start());
                        report.refused(at, format!("tag {}", global.name), why);
                    }
                }
            }
        }
        variables
    }

    /// The program of the file, or the body of one of its blocks.
    pub(super) fn write(
        &self,
        project: &Project<'_>,
        block: Option<usize>,
        name: String,
        report: &mut Report,
    ) -> Made {
        let scope = block.map_or(0, |block| block + 1);
        let mut own = self.scope(project, scope);
        let mut variables = self.variables(project, scope, &mut own, report);
        let mut body = Networks {
            unit: self,
            project,
            program: self.program,
            graph: Graph::default(),
            report,
            names: &mut own.names,
            made: Vec::new(),
            retentive: Vec::new(),
        };
        if let Some((enters, leaves)) = &own.power
            && !body.begins_with_power(block)
        {
            body.power(enters, leaves);
        }
        let comment = body.draw(block);
        let Networks {
            graph,
            made,
            retentive,
            ..
        } = body;
        variables.extend(made);
        for variable in &mut variables {
            if retentive
                .iter()
                .any(|name| name.eq_ignore_ascii_case(&variable.name))
                && variable.role != Role::External
            {
                variable.qualifier = Some(Qualifier::Retain);
            }
        }
        let is_empty = graph.nodes.is_empty();
        Made {
            place: self.place(TextSize::default()),
            name,
            kind: if block.is_some() {
                UnitKind::FunctionBlock
            } else {
                UnitKind::Program
            },
            returns: None,
            variables,
            comment,
            body: if is_empty { Body::Empty } else { Body::Graph(graph) },
            parts: Vec::new(),
        }
    }
}

fn role(tag: &TagFacts) -> Role {
    match tag.origin {
        Origin::Declared(SectionKind::Input) => Role::Input,
        Origin::Declared(SectionKind::Output) => Role::Output,
        Origin::Declared(SectionKind::InOut) => Role::InOut,
        Origin::Form if tag.role == ladder_analysis::program::Role::Input => Role::Input,
        Origin::Form if tag.role == ladder_analysis::program::Role::Output => Role::Output,
        _ => Role::Local,
    }
}

fn qualifier(tag: &TagFacts) -> Option<Qualifier> {
    match (tag.constant, tag.retain) {
        (true, _) => Some(Qualifier::Constant),
        (_, true) => Some(Qualifier::Retain),
        _ => None,
    }
}

/// The networks of a unit on their way.
struct Networks<'n, 'u> {
    unit: &'n Unit<'u>,
    project: &'n Project<'n>,
    program: &'n Program,
    graph: Graph,
    report: &'n mut Report,
    names: &'n mut Names,
    made: Vec<Variable>,
    retentive: Vec<String>,
}

/// What is not run as it stands, from one network on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Under {
    Nothing,
    Loop,
    MasterControl,
}

impl Networks<'_, '_> {
    /// What a block's ENO begins with: its EN.
    fn power(&mut self, enters: &str, leaves: &str) {
        use super::rung::pin;
        use crate::graph::{End, Modifier, Storage};
        let none = Modifier::default();
        let at = self.unit.place(TextSize::default());
        let from = |node| vec![pin("", vec![End { node, output: 0 }])];
        for (kind, inputs) in [
            (Kind::LeftRail, Vec::new()),
            (Kind::Contact(enters.to_owned(), none), from(0)),
            (Kind::Coil(leaves.to_owned(), none, Storage::None), from(1)),
        ] {
            self.graph.nodes.push(Node::new(at, kind, inputs));
        }
    }

    /// Whether the first network of a block does that anyway.
    fn begins_with_power(&self, block: Option<usize>) -> bool {
        let Some(block) = block else { return true };
        let context = self.unit.context();
        let mut networks = context.networks.iter();
        let first = networks.find(|network| context.bodies[network.index] == OwnBody::Block(block));
        let Some(first) = first else { return false };
        let said: Vec<String> = first
            .blocks()
            .map(|block| {
                self.unit.text[block.range()]
                    .replace(' ', "")
                    .to_ascii_uppercase()
            })
            .collect();
        said == ["[](EN)", "()(ENO)"]
    }

    /// All networks; comes back what is said of the unit as a whole.
    fn draw(&mut self, block: Option<usize>) -> Option<String> {
        let context = self.unit.context();
        let parse = &context.parse;
        let structure = parse.structure();
        let by_start: HashMap<TextSize, &Network> = self
            .program
            .networks
            .iter()
            .filter(|network| network.location.file == 0)
            .map(|network| (network.location.range.start(), network))
            .collect();
        let mut current = None;
        let mut above: Vec<String> = Vec::new();
        let mut of_unit: Vec<String> = Vec::new();
        let mut under = Under::Nothing;
        let mut is_guard = block.is_some_and(|block| self.unit.is_guarded(block));
        for item in &structure.items {
            let lines = match *item {
                Item::BlockHeader(number) => {
                    if Some(number) == block {
                        of_unit.append(&mut above);
                    }
                    above.clear();
                    current = Some(number);
                    continue;
                }
                Item::BlockEnd(_) => {
                    if current == block {
                        self.leave_comments(&mut above);
                    }
                    above.clear();
                    current = None;
                    continue;
                }
                Item::Decoration(line) => line..line + 1,
                Item::Network(number) => structure.networks[number].lines.clone(),
                Item::Section(_) => {
                    if current == block {
                        of_unit.append(&mut above);
                    }
                    continue;
                }
                Item::Stray(_) => continue,
            };
            for comment in lines.flat_map(|line| comments::on_line(parse, line)) {
                let said: Vec<&str> = comments::said(&comment).collect();
                if !said.is_empty() {
                    above.push(said.join("\n"));
                }
            }
            let Item::Network(number) = *item else { continue };
            if current != block {
                above.clear();
                continue;
            }
            let facts = context.networks.at(number);
            self.leave_comments(&mut above);
            if std::mem::take(&mut is_guard) {
                continue;
            }
            let network = by_start.get(&facts.range.start()).copied();
            self.network(facts, network, &mut under);
        }
        if current == block {
            self.leave_comments(&mut above);
        }
        (!of_unit.is_empty()).then(|| of_unit.join("\n"))
    }

    fn leave_comments(&mut self, above: &mut Vec<String>) {
        for said in above.drain(..) {
            self.comment(said);
        }
    }

    fn comment(&mut self, said: String) {
        let at = self.unit.place(TextSize::default());
        self.graph
            .nodes
            .push(Node::new(at, Kind::Comment(said), Vec::new()));
    }

    fn network(&mut self, facts: NetworkAt<'_>, network: Option<&Network>, under: &mut Under) {
        let has = |op: Op| facts.blocks().any(|block| block.op() == Some(op));
        let at = self.unit.place(facts.range.start());
        if *under != Under::MasterControl && has(Op::Mcr) {
            *under = Under::MasterControl;
        } else if *under == Under::Nothing && has(Op::For) {
            *under = Under::Loop;
        }
        let drawn = match (*under, self.unit.context().bodies[facts.index]) {
            (Under::Loop, _) => Err("the standard has no loops of networks".to_owned()),
            (Under::MasterControl, _) => {
                Err("the standard has no <MCR>, which this is or stands after".to_owned())
            }
            (_, OwnBody::Function(_)) => Err("the standard has no functions without parameters".to_owned()),
            _ => self.rung(at, facts, network),
        };
        if *under == Under::Loop && has(Op::Next) {
            *under = Under::Nothing;
        }
        match drawn {
            Ok(rung) => {
                self.report.translated(at, "network");
                for (element, why) in rung.remarks {
                    self.report.approximated(at, element, why);
                }
                self.graph.nodes.extend(rung.nodes);
                self.made.extend(rung.made);
                self.retentive.extend(rung.retentive);
                *self.names = rung.names;
            }
            Err(why) => {
                for label in facts.blocks().filter(|block| block.op() == Some(Op::Lbl)) {
                    let operand = label.facts.operands.first();
                    let name = operand.map_or("", |it| &self.unit.text[label.absolute(it.value.range)]);
                    let kind = Kind::Label(super::names::identifier(name));
                    self.graph.nodes.push(Node::new(at, kind, Vec::new()));
                }
                let text = self.unit.text[facts.range].trim_end();
                self.comment(format!("Not written, because {why}:\n{text}"));
                self.report.refused(at, "network", why);
            }
        }
    }

    fn rung(&self, at: LineColumn, facts: NetworkAt<'_>, network: Option<&Network>) -> Result<Rung, String> {
        let network = network.ok_or("nothing uses the block that it is in")?;
        let by_start: HashMap<TextSize, usize> = facts
            .blocks()
            .enumerate()
            .map(|(number, block)| (block.range().start(), number))
            .collect();
        let element = |rung: &mut Rung, block: usize, power| {
            let block = &network.blocks[block];
            let number = by_start.get(&block.location.range.start());
            let writer = Writer {
                unit: self.unit,
                program: self.program,
                faces: self.project.faces,
                block,
                facts: facts.block(*number.ok_or("a block of it is not known")?),
            };
            writer.write(rung, power)
        };
        let rung = Rung::of(at, self.graph.nodes.len(), self.names, network, &element)?;
        if rung.goes_on_after_jump() {
            return Err("something is done after a jump in it, whose order is not settled there".to_owned());
        }
        Ok(rung)
    }
}

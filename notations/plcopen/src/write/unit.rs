//! One unit: the program of a file, or a block of one's own.

use super::added::Added;
use super::compiler::Compiler;
use super::declare::{self, Source, place};
use super::faces::Faces;
use super::names::Names;
use super::networks::Networks;
use super::system;
use crate::along;
use crate::graph::Graph;
use crate::model::{Body, Role, Type, Unit as Made, UnitKind, Variable};
use crate::own;
use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_analysis::names::scope::{Origin, SectionKind, TagFacts};
use ladder_analysis::program::Program;
use ladder_format::program::Qualifier;
use ladder_notation::guard::is_guarded;
use ladder_notation::{LineColumn, Report, foreign_text_of, is_function};
use ladder_syntax::{Name, TextSize};

/// What all units of a project share.
#[derive(Clone)]
pub(super) struct Project<'p> {
    /// The names of blocks, by their names here.
    pub(super) blocks: Names,
    /// The names of globals.
    pub(super) globals: Names,
    pub(super) faces: &'p Faces,
    /// The block that sets the globals of `SYS`, if there are any.
    pub(super) sets_system: Option<String>,
}

/// A file whose units are written.
pub(super) struct Unit<'u> {
    pub(super) analysis: &'u Analysis,
    pub(super) program: &'u Program,
    pub(super) text: &'u str,
    /// What is declared from here on was added for the writer's own sake.
    pub(super) end: TextSize,
    pub(super) compiler: Compiler,
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

    pub(super) fn place(&self, offset: TextSize) -> LineColumn {
        place(self.context(), offset)
    }

    /// Whether a tag is a global of the workspace, in the eyes of a scope.
    fn global<'t>(&self, tag: &'t TagFacts) -> Option<&'t TagFacts>
    where
        'u: 't,
    {
        let shared = self.context().shared(tag);
        let is_global = shared.origin == Origin::Declared(SectionKind::Global)
            || shared.cold.foreign.is_some()
            // Blocks there have nothing at an address.
            || shared.name.starts_with('%') && self.is_of_a_block(&Name::new(&shared.name));
        is_global.then_some(shared)
    }

    /// Whether the body of a block names a tag.
    fn is_of_a_block(&self, name: &Name) -> bool {
        let mut bodies = self.context().scopes.iter().skip(1);
        bodies.any(|scope| scope.find(name).is_some())
    }

    /// The tags of a scope that are declared or used there.
    pub(super) fn tags(&self, scope: usize) -> impl Iterator<Item = &'u TagFacts> {
        let context = self.context();
        let end = self.end;
        context.scopes[scope]
            .tags
            .iter()
            .filter(move |tag| !tag.name.eq_ignore_ascii_case("SYS"))
            .filter(move |tag| context.place_of(tag).start() < end || end == TextSize::default())
    }

    /// Whether a block does not run without power, here as there: see [`is_guarded`].
    pub(super) fn is_guarded(&self, block: usize) -> bool {
        let facts = &self.context().user_blocks[block];
        let mut blocks = self.program.blocks.iter();
        let block = blocks.find(|block| block.name == facts.name);
        facts.unread.is_some() || block.is_some_and(|block| is_guarded(self.program, block))
    }

    /// Whether a block that is a function is handed an instance, which is a global there.
    pub(super) fn is_shared(&self, block: usize, parameter: &TagFacts) -> bool {
        let parse = &self.context().parse;
        let header = parse
            .frame()
            .blocks
            .get(block)
            .map_or(0, |block| block.lines.start);
        let mut above = (0..header).rev().map(|line| parse.lines()[line].text().trim());
        let is_handed = parameter.origin == Origin::Declared(SectionKind::InOut)
            && parameter.ty.is_some_and(declare::is_instance);
        is_handed
            && self.compiler == Compiler::Matiec
            && above
                .by_ref()
                .take_while(|line| line.starts_with('#'))
                .any(|line| is_function(line.trim_start_matches(['#', ' '])))
    }

    /// The text in ST of a block that is an unread part, if it is one, and its names are those of the text.
    pub(super) fn unread_text(&self, block: usize) -> Option<String> {
        let context = self.context();
        let facts = &context.user_blocks[block];
        facts.unread.as_ref()?;
        let lines = context.parse.frame().blocks.get(block)?.lines.clone();
        let text_on = |line: usize| context.parse.lines()[line].text();
        let told = text_on(lines.start.checked_sub(1)?);
        let definition: String = lines.map(text_on).collect();
        let is_renamed = definition.contains(" in the project");
        let is_result = |tag: &TagFacts| facts.name[1..].eq_ignore_ascii_case(&tag.name);
        let is_other = |tag: &TagFacts| is_result(tag) || !tag.name.is_ascii();
        let is_whole = !is_renamed && !self.tags(block + 1).any(is_other);
        foreign_text_of(&definition).filter(|_| is_whole && told.contains("(ST) is not read"))
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
        for tag in system::used(self, scope.checked_sub(1)) {
            let key = system::key(tag);
            if let Some(global) = project.globals.get(&key) {
                names.alias(&key, global);
            }
        }
        for tag in self.tags(scope) {
            if tag.origin == Origin::Implicit {
                continue;
            }
            let global = self.global(tag);
            let name = match global.and_then(|global| project.globals.get(&global.name)) {
                Some(global) => global.to_owned(),
                None => names.fresh(&tag.name),
            };
            names.alias(&tag.name, &name);
            if let Some(address) = &tag.cold.address {
                names.alias(address, &name);
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
            blocks: &project.blocks,
            globals: &names,
            compiler: self.compiler,
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
        for tag in system::used(self, scope.checked_sub(1)) {
            let name = names.get(&system::key(tag));
            variables.extend(name.map(|name| along::system_variable(tag, name, Role::External)));
        }
        for tag in self.tags(scope) {
            let Some(name) = names.get(&tag.name).filter(|_| tag.origin != Origin::Implicit) else {
                continue;
            };
            let global = self.global(tag);
            let role = match (global, role(tag)) {
                (Some(_), _) => Role::External,
                // What is at an address is neither an input nor an output: the address says it.
                (None, Role::Input | Role::Output) if tag.cold.address.is_some() => Role::Local,
                (None, Role::InOut) if scope > 0 && self.is_shared(scope - 1, tag) => Role::External,
                (None, role) => role,
            };
            match declare::variable(&source, global.unwrap_or(tag), name, role) {
                Ok(mut variable) => {
                    variable.qualifier = match role {
                        Role::InOut => None,
                        Role::External => global.and_then(qualifier).filter(|it| *it == Qualifier::Constant),
                        _ => qualifier(tag),
                    };
                    if role == Role::External {
                        variable.initial = None;
                        variable.address = None;
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
                    blocks: &project.blocks,
                    globals: &project.globals,
                    compiler: self.compiler,
                };
                match declare::variable(&source, global, &name, Role::Global) {
                    Ok(mut variable) => {
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
        let (body, comment) = match block.and_then(|block| self.unread_text(block)) {
            Some(text) => (Body::Text("ST", text, LineColumn::START), None),
            None => self.networks((project, block), own, &mut variables, report),
        };
        Made {
            place: self.place(TextSize::default()),
            name,
            kind: match block {
                Some(_) => UnitKind::FunctionBlock,
                None => UnitKind::Program,
            },
            returns: None,
            variables,
            comment,
            body,
            parts: Vec::new(),
        }
    }

    /// The networks of a unit, and the comment on it as a whole. What they need is added to its variables.
    fn networks(
        &self,
        (project, block): (&Project<'_>, Option<usize>),
        own: Scope,
        variables: &mut Vec<Variable>,
        report: &mut Report,
    ) -> (Body, Option<String>) {
        let mut body = Networks {
            unit: self,
            project,
            graph: Graph::default(),
            report,
            made: Added::of(own.names),
        };
        if let Some((enters, leaves)) = &own.power
            && !body.begins_with_power(block)
        {
            body.power(enters, leaves);
        }
        if let (None, Some(name)) = (block, &project.sets_system) {
            body.calls_system(name);
        }
        let comment = body.draw(block);
        if self.compiler == Compiler::Matiec {
            body.does_something();
        }
        let Networks { graph, made, .. } = body;
        variables.extend(made.variables);
        let is_retentive = |name: &str| made.retentive.iter().any(|it| it.eq_ignore_ascii_case(name));
        for variable in variables {
            if variable.role != Role::External && is_retentive(&variable.name) {
                variable.qualifier = Some(Qualifier::Retain);
            }
        }
        (Body::Graph(graph), comment)
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

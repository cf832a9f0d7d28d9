//! A file as a program: what it declares, what runs, and the blocks that it is made of.

use super::body::Body;
use super::chart;
use super::chart_syntax::ChartText;
use super::declare::{Sections, type_section};
use super::declared::{File, Role, Unit, UnitKind};
use super::dialect::Dialect;
use super::initial::initial_text;
use super::lower::{self, Restarted, Surroundings, comment_of};
use super::scope::{Scope, Type};
use super::token::Comment;
use super::{neighbours, types, units};
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Drawing, Element, Expression, Item, Network, Path, Section, SectionKind,
};
use ladder_notation::address::several;
use ladder_notation::chart::Clock;
use ladder_notation::{
    BlockNames, Companion, Finding, Lines, Names, Power, ReadError, Reading, Turn, Unread, UnreadParts,
    unread_body,
};
use std::collections::HashSet;

/// Reads a file. `others` are those whose declarations it sees, the nearest first.
///
/// # Errors
///
/// If nothing in it is Structured Text.
pub(crate) fn read(text: &str, dialect: Dialect, others: &[Companion]) -> Result<Reading, ReadError> {
    let (file, comments) = units::file(text, dialect);
    let lines = Lines::of(text);
    if file.units.is_empty() && file.types.is_empty() && file.globals.is_empty() {
        let mut problems = file
            .problems
            .iter()
            .map(|problem| (lines.place(text, problem.span.start), problem.message.clone()));
        return Err(match problems.next() {
            Some((place, message)) => ReadError {
                more: problems.collect(),
                ..ReadError::at(place, message)
            },
            None => ReadError::whole("there is no program in the file: one begins with `PROGRAM`"),
        });
    }
    let mut scope = Scope::default();
    neighbours::declare(others, &file, &mut scope);
    let of_units = file.units.iter().flat_map(|unit| &unit.variables);
    let declared = file.globals.iter().chain(of_units);
    let mut reader = Reader {
        text,
        lines: &lines,
        dialect,
        comments: &comments,
        scope,
        names: Names::default(),
        blocks: BlockNames::default(),
        unread: UnreadParts::default(),
        shared: several(declared.filter_map(|variable| variable.address.as_deref())),
        others: Vec::new(),
        reading: Reading::default(),
    };
    for problem in &file.problems {
        let place = lines.place(text, problem.span.start);
        let message = problem.message.clone();
        reader.reading.findings.push(Finding {
            place,
            severity: Severity::Error,
            check: "st-syntax",
            message,
        });
    }
    reader.file(&file);
    Ok(reader.reading)
}

struct Reader<'a> {
    text: &'a str,
    lines: &'a Lines,
    dialect: Dialect,
    comments: &'a [Comment],
    /// Types, blocks, functions and globals.
    scope: Scope,
    /// Of the globals and the types.
    names: Names,
    /// The names of blocks that are taken.
    blocks: BlockNames,
    unread: UnreadParts,
    /// The addresses that several variables have.
    shared: HashSet<String>,
    /// The places of programs that are not read.
    others: Vec<Item>,
    reading: Reading,
}

impl Reader<'_> {
    fn file(&mut self, file: &File) {
        let types = self.types(file);
        for unit in &file.units {
            neighbours::enter(unit, &mut self.blocks, &mut self.scope);
        }
        let globals = self.globals(file);
        let main = main_program(file);
        let mut blocks = Vec::new();
        for unit in file.units.iter().filter(|unit| unit.kind != UnitKind::Program) {
            blocks.push(Item::Blank);
            blocks.extend(self.block(unit));
        }
        let mut program = Vec::new();
        for unit in file.units.iter().filter(|unit| unit.kind == UnitKind::Program) {
            if main.is_some_and(|main| std::ptr::eq(main, unit)) {
                program = self.program(unit);
            } else {
                self.other_program(unit, file);
            }
        }
        let items = &mut self.reading.program.items;
        items.extend(types);
        items.extend(self.unread.items());
        items.extend(blocks);
        items.push(Item::Blank);
        items.extend(globals);
        items.extend(program);
        items.extend(self.others.drain(..).flat_map(|other| [Item::Blank, other]));
    }

    fn origin(&mut self, at: usize) -> u32 {
        let place = self.lines.place(self.text, at);
        self.reading.origin(place)
    }

    /// Something that is not read as it is meant there.
    fn remark(&mut self, at: usize, what: impl Into<String>, why: impl Into<String>) {
        let place = self.lines.place(self.text, at);
        self.reading.report.approximated(place, what, why);
    }

    /// Declares the types. Each may use those before it.
    fn types(&mut self, file: &File) -> Option<Item> {
        // A structure may be declared before what it is made of.
        let mut left: Vec<_> = file.types.iter().collect();
        let mut section = Section::new(SectionKind::Type);
        loop {
            let before = left.len();
            let mut later = Vec::new();
            for declared in left {
                let spelled = self.names.spell(&declared.name).to_owned();
                match types::declared(&spelled, &declared.ty, &self.scope) {
                    Ok((ty, text)) => {
                        let initial = declared
                            .initial
                            .as_ref()
                            .and_then(|initial| initial_text(initial, &ty, &self.scope).ok());
                        let origin = self.origin(declared.span.start);
                        section
                            .declarations
                            .push(type_section(&spelled, text, initial, declared, origin));
                        self.scope.data_type(&declared.name, ty);
                    }
                    Err(_) => later.push(declared),
                }
            }
            if later.is_empty() || later.len() == before {
                left = later;
                break;
            }
            left = later;
        }
        for declared in left {
            let why = types::declared(&declared.name, &declared.ty, &self.scope)
                .err()
                .unwrap_or_default();
            self.remark(declared.span.start, format!("type {}", declared.name), why);
        }
        (!section.declarations.is_empty()).then_some(Item::Section(section))
    }

    fn globals(&mut self, file: &File) -> Vec<Item> {
        let mut sections = Sections::default();
        for variable in &file.globals {
            let spelled = self.names.spell(&variable.name).to_owned();
            self.declare(
                variable,
                &spelled,
                SectionKind::VarGlobal,
                (&mut sections, false),
                None,
            );
        }
        sections.items()
    }

    /// Declares a variable, for the file or for a unit.
    fn declare(
        &mut self,
        variable: &super::declared::Variable,
        spelled: &str,
        kind: SectionKind,
        (sections, is_program): (&mut Sections, bool),
        scope: Option<&mut Scope>,
    ) {
        let what = format!("variable {}", variable.name);
        let origin = self.origin(variable.span.start);
        let declared = sections.variable(
            variable,
            spelled,
            kind,
            origin,
            (&self.scope, &self.shared, is_program),
        );
        let place = self.lines.place(self.text, variable.span.start);
        let ty = match declared {
            Ok((ty, None)) => {
                self.reading.report.translated(place, what);
                ty
            }
            Ok((ty, Some(why))) => {
                self.reading.report.approximated(place, what, why);
                ty
            }
            Err(why) => {
                self.reading
                    .report
                    .approximated(place, what, format!("{why}; it is not declared"));
                // Its name is taken all the same.
                scope.unwrap_or(&mut self.scope).tag(
                    &variable.name,
                    Path::tag(spelled),
                    Type::Unknown,
                    false,
                );
                return;
            }
        };
        let is_constant = variable.qualifier == Some(ladder_format::program::Qualifier::Constant);
        scope
            .unwrap_or(&mut self.scope)
            .tag(&variable.name, Path::tag(spelled), ty, is_constant);
    }

    /// The variables of a unit, and what its body sees.
    fn variables(&mut self, unit: &Unit) -> (Sections, Scope, Names) {
        let mut scope = self.scope.clone();
        scope.begin_unit();
        let mut names = if unit.kind == UnitKind::Program {
            self.names.clone()
        } else {
            Names::default()
        };
        let mut sections = Sections::default();
        let is_program = unit.kind == UnitKind::Program;
        for variable in &unit.variables {
            if variable.role == Role::External && self.scope.known(&variable.name).is_some() {
                continue;
            }
            let spelled = names.spell(&variable.name).to_owned();
            if variable.role == Role::External {
                let why = "no file that is read has a global of this name; it is not declared";
                self.remark(variable.span.start, format!("variable {}", variable.name), why);
                scope.tag(&variable.name, Path::tag(spelled), Type::Unknown, false);
                continue;
            }
            let kind = match variable.role {
                Role::Input => SectionKind::VarInput,
                Role::Output => SectionKind::VarOutput,
                Role::InOut if !is_program => SectionKind::VarInOut,
                Role::Global => SectionKind::VarGlobal,
                _ => SectionKind::Var,
            };
            self.declare(
                variable,
                &spelled,
                kind,
                (&mut sections, is_program),
                Some(&mut scope),
            );
        }
        if let Some(shape) = self.scope.function_named(&unit.name).cloned()
            && let Some((output, ty)) = &shape.returns
        {
            let origin = self.origin(unit.span.start);
            sections.result(output, ty, origin);
            scope.tag(&unit.name, Path::tag(output.clone()), ty.clone(), false);
        }
        (sections, scope, names)
    }

    /// The networks of a unit. None: it is unread as a whole; why.
    fn body(&mut self, unit: &Unit, scope: &Scope, names: &mut Names) -> Result<Body, String> {
        if let Some(problem) = unit.problems.first() {
            for problem in &unit.problems {
                let place = self.lines.place(self.text, problem.span.start);
                let message = problem.message.clone();
                self.reading.findings.push(Finding {
                    place,
                    severity: Severity::Error,
                    check: "st-syntax",
                    message,
                });
            }
            return Err(problem.in_words(self.lines.place(self.text, problem.span.start).line));
        }
        for (span, method) in &unit.methods {
            self.remark(
                span.start,
                format!("method {method}"),
                "a method of a block; only its body is read",
            );
        }
        let around = Surroundings {
            text: self.text,
            lines: self.lines,
            dialect: self.dialect,
            unit: &unit.name,
            scope,
            comments: self.comments,
            instructions: None,
            first_origin: self.reading.places.len() as u32,
            first_label: 0,
        };
        if let Some(chart) = &unit.chart {
            let body = self.chart((unit, chart), &around, names)?;
            body.note(self.text, |at| self.lines.place(self.text, at), &mut self.reading);
            return Ok(body);
        }
        let restarted = Reader::restarted(unit, scope);
        let mut body = lower::lower(&unit.body, &around, &restarted, names, &mut self.unread);
        if let Some(why) = body.unread.take() {
            return Err(why);
        }
        let place = |at| self.lines.place(self.text, at);
        body.note(self.text, place, &mut self.reading);
        Ok(body)
    }

    /// The networks of a chart.
    fn chart(
        &mut self,
        (unit, chart): (&Unit, &ChartText),
        around: &Surroundings<'_>,
        names: &mut Names,
    ) -> Result<Body, String> {
        if !unit.body.is_empty() {
            return Err("statements follow its chart".to_owned());
        }
        if unit.variables.iter().any(|one| one.role == Role::Temp) {
            return Err("its temporary variables begin again in each scan".to_owned());
        }
        let clock = match unit.kind {
            UnitKind::Program => Clock::EachScan,
            UnitKind::FunctionBlock => Clock::AtCalls,
            UnitKind::Function => {
                return Err("a function keeps nothing, so it has no chart".to_owned());
            }
        };
        chart::body(chart, around, clock, names, &mut self.unread)
    }

    fn block(&mut self, unit: &Unit) -> Vec<Item> {
        let name = match (
            self.scope.function_named(&unit.name),
            self.scope.type_named(&unit.name),
        ) {
            (Some(shape), _) => shape.name.clone(),
            (_, Some(Type::Block(shape))) => shape.name.clone(),
            _ => return Vec::new(),
        };
        let (mut sections, scope, mut names) = self.variables(unit);
        let mut items = Vec::new();
        if let Some(comment) = &unit.comment {
            items.push(Item::Comment(comment_of(comment)));
        }
        let mut inside;
        match self.body(unit, &scope, &mut names) {
            Ok(body) => {
                sections.tags(body.tags);
                inside = sections.items();
                inside.extend(body.items);
            }
            Err(why) => {
                self.remark(unit.span.start, unit.name.clone(), why.clone());
                items.push(Item::Comment(format!(
                    "{}: {}; it is not run here.",
                    unit.name, why
                )));
                inside = sections.items();
                inside.extend(unread_body(&self.text[unit.body_span.clone()], None));
            }
        }
        items.push(Item::Block {
            header: format!("[${name}]"),
            origin: Some(self.origin(unit.name_span.start)),
            items: inside,
        });
        items
    }

    /// What begins again at each call: the result and the locals of functions, temporary variables.
    fn restarted(unit: &Unit, scope: &Scope) -> Vec<Restarted> {
        let is_own =
            |role: Role| role == Role::Temp || unit.kind == UnitKind::Function && role == Role::Local;
        let result = unit.returns.as_ref().map(|_| (&unit.name, None));
        let locals = unit
            .variables
            .iter()
            .filter(|variable| is_own(variable.role) && variable.qualifier.is_none());
        let all = result
            .into_iter()
            .chain(locals.map(|variable| (&variable.name, variable.initial.as_ref())));
        let all = all.map(|(name, initial)| {
            let value = initial.and_then(|initial| {
                let text = initial_text(initial, &scope.known(name)?.ty, scope).ok()?;
                Expression::read(&text).ok()
            });
            Restarted {
                name: name.clone(),
                is_compound: initial.is_some() && value.is_none(),
                initial: value,
            }
        });
        all.collect()
    }

    fn program(&mut self, unit: &Unit) -> Vec<Item> {
        let (mut sections, scope, mut names) = self.variables(unit);
        let mut items = Vec::new();
        if let Some(comment) = &unit.comment {
            items.extend([Item::Comment(comment_of(comment)), Item::Blank]);
        }
        match self.body(unit, &scope, &mut names) {
            Ok(body) => {
                sections.tags(body.tags);
                items.extend(sections.items());
                items.push(Item::Blank);
                items.extend(body.items);
            }
            Err(why) => {
                items.extend(sections.items());
                self.remark(unit.span.start, unit.name.clone(), why.clone());
                let block = self.unread_program(unit, &why, Turn::Here);
                items.push(Item::Blank);
                items.push(block);
            }
        }
        items
    }

    fn unread_program(&mut self, unit: &Unit, why: &str, turn: Turn) -> Item {
        let about = format!("{}: {}; it is not run here.", unit.name, why);
        let part = Unread {
            name: &unit.name,
            about: &about,
            text: &self.text[unit.body_span.clone()],
            writes: None,
            power: Power::Passes,
            turn,
        };
        let scope = &self.scope;
        let block: Block = self
            .unread
            .body(part, |name| scope.has_block(name.trim_start_matches('$')));
        let origin = self.origin(unit.span.start);
        let drawing = Drawing::Circuit(Circuit::Element(Element::of(block, Some(origin))));
        Item::Network(Network {
            comments: Vec::new(),
            drawing,
        })
    }

    /// A program besides the one that is read.
    fn other_program(&mut self, unit: &Unit, file: &File) {
        let runs = file
            .runs
            .iter()
            .any(|(name, _)| name.eq_ignore_ascii_case(&unit.name));
        let why = if runs {
            "another program of the file runs first, and one is read: keep each in a file of its own"
        } else {
            "nothing runs it, and another program of the file is read"
        };
        self.remark(unit.span.start, format!("program {}", unit.name), why);
        if runs {
            let block = self.unread_program(unit, why, Turn::AnyTime);
            self.others.push(block);
        }
    }
}

/// The program that runs: the first of the first task, or the first there is.
fn main_program(file: &File) -> Option<&Unit> {
    let mut programs = file.units.iter().filter(|unit| unit.kind == UnitKind::Program);
    let priority = |task: &Option<String>| {
        let task = task.as_ref()?;
        let task = file
            .tasks
            .iter()
            .find(|own| own.name.eq_ignore_ascii_case(task))?;
        Some(task.priority)
    };
    let first = file
        .runs
        .iter()
        .min_by_key(|(_, task)| priority(task).unwrap_or(u32::MAX));
    let named =
        first.and_then(|(name, _)| programs.clone().find(|unit| unit.name.eq_ignore_ascii_case(name)));
    named.or_else(|| programs.next())
}

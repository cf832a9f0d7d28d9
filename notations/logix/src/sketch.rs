//! A project as the sketch of a ladder program.
//!
//! The main routine is the main program and every other routine a function; of several programs each is a function, and
//! the main program calls them in the order of their tasks.

use crate::mnemonic::{Op, instruction};
use crate::model::{Family, Project, Rung};
use crate::neutral::{Instruction, Part, instructions};
use crate::scope::{CONTROLLER, Kind, Tags};
use crate::survey::survey;
use crate::translate::{Routines, Translator};
use crate::types::{Ty, Types};
use crate::unit::{Owner, Unit, units};
use ladder_analysis::Severity;
use ladder_format::Circuit;
use ladder_format::program::{
    Declaration, Drawing, Element, Item, Network, Qualifier, Section, SectionKind, comment_text,
};
use ladder_notation::names::Names;
use ladder_notation::{Finding, LineColumn, Lines, Reading};
use std::collections::{HashMap, HashSet};

/// The check that tells of an instruction without a counterpart.
const INERT: &str = "logix-inert";

/// The whole program. `text` is the file that the project was read from.
pub(crate) fn sketch(project: &Project, text: &str) -> Reading {
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
    };
    sketcher.program(&plan);
    let mut reading = sketcher.reading;
    reading.report.entries.sort_by_key(|entry| entry.place);
    reading.findings.sort_by_key(|finding| finding.place);
    reading
}

/// Which routine is what.
struct Plan {
    /// The name of each unit as a function.
    functions: Vec<String>,
    /// The routine that is the main program, if one alone is.
    main: Option<usize>,
    /// Else the routines that the main program calls, in their order.
    called: Vec<usize>,
}

impl Plan {
    fn of(project: &Project, units: &[Unit<'_>]) -> Plan {
        let mut names = Names::default();
        let mut taken: HashSet<String> = HashSet::new();
        let functions = units.iter().map(|unit| match unit.owner {
            Owner::Program(program) => {
                let routine = &unit.routine.name;
                let name = if taken.insert(routine.to_ascii_uppercase()) {
                    routine.clone()
                } else {
                    format!("{}_{routine}", project.programs[program].name)
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
                if instruction(it.name, it.operands.len()) == Some(Op::Jsr) {
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

struct Sketcher<'p> {
    translator: Translator<'p>,
    lines: Lines,
    text: &'p str,
    units: &'p [Unit<'p>],
    reading: Reading,
}

impl<'p> Sketcher<'p> {
    fn place(&self, at: usize) -> LineColumn {
        self.lines.place(self.text, at)
    }

    fn origin(&mut self, at: usize) -> u32 {
        let place = self.place(at);
        self.reading.origin(place)
    }

    fn program(&mut self, plan: &Plan) {
        let project = self.translator.project;
        let mut body = Vec::new();
        if let Some(main) = plan.main {
            body.extend(self.unit(main));
        }
        for &called in &plan.called {
            let block = Circuit::Element(Element::block(
                format!("<CALL>( {} )", plan.functions[called]),
                None,
            ));
            body.extend([Item::Blank, network(Vec::new(), block)]);
        }
        for (number, function) in plan.functions.iter().enumerate() {
            let unit = &self.units[number];
            if plan.main == Some(number) || matches!(unit.owner, Owner::Aoi(_)) {
                continue;
            }
            let comments = unit.routine.comment.iter().cloned();
            let origin = self.origin(unit.routine.at);
            let begin = Circuit::Element(Element::block(format!("<FUN>( {function} )"), Some(origin)));
            body.extend([Item::Blank, network(comments.collect(), begin)]);
            body.extend(self.unit(number));
        }
        let aois: Vec<Item> = (0..project.aois.len()).flat_map(|aoi| self.aoi(aoi)).collect();
        let mut items = self.head();
        items.extend(types(&self.translator.tags.types, &self.translator.aoi_names));
        items.extend(self.declarations());
        items.append(&mut body);
        items.extend(aois);
        items.extend(self.translator.blocks.items());
        self.reading.program.items = items;
        self.accounts();
    }

    /// What the tools are told, and what the program is.
    fn head(&self) -> Vec<Item> {
        let project = self.translator.project;
        let mut items = Vec::new();
        let mut tell = |said: &str| items.push(Item::Directive(said.to_owned()));
        tell("profile logix");
        if let Some(rate) = project
            .rate
            .as_deref()
            .filter(|rate| rate.parse::<u32>().is_ok_and(|rate| rate > 0))
        {
            tell(&format!("cycle {rate}ms"));
        }
        for (rule, why) in [
            (
                "never-written",
                "other devices reach the tags of a controller too",
            ),
            ("never-read", "other devices reach the tags of a controller too"),
            ("contact-after-coil", "rungs of Logix go on after a coil"),
            (
                "set-without-reset",
                "other devices reach the tags of a controller too",
            ),
            (
                "reset-without-set",
                "other devices reach the tags of a controller too",
            ),
        ] {
            tell(&format!("allow-file({rule}): {why}"));
        }
        let what = match project.family {
            Family::Logix if !project.name.is_empty() => Some(format!("Controller {}", project.name)),
            _ => None,
        };
        items.extend(what.map(Item::Comment));
        items
    }

    /// The sections of the file.
    fn declarations(&mut self) -> Vec<Item> {
        let bodies = CONTROLLER + self.translator.project.programs.len();
        let mut items = Vec::new();
        let sections = [
            (Kind::Input, SectionKind::VarInput, None),
            (Kind::Output, SectionKind::VarOutput, None),
            (Kind::Plain, SectionKind::Var, None),
            (Kind::Constant, SectionKind::Var, Some(Qualifier::Constant)),
        ];
        for (kind, section, qualifier) in sections {
            let declarations = self.declared(kind, |scope| scope <= bodies);
            if !declarations.is_empty() {
                let mut section = Section::new(section);
                section.qualifier = qualifier;
                section.declarations = declarations;
                items.extend([Item::Blank, Item::Section(section)]);
            }
        }
        items
    }

    fn declared(&mut self, kind: Kind, of: impl Fn(usize) -> bool) -> Vec<Declaration> {
        let tags = &self.translator.tags;
        let own = tags
            .symbols
            .iter()
            .filter(|symbol| symbol.kind == kind && of(symbol.scope));
        let mut places: Vec<(usize, Option<usize>)> = Vec::new();
        let mut declarations = Vec::new();
        for symbol in own {
            let mut declaration = Declaration::new(&symbol.name, self.type_text(&symbol.ty));
            let value = symbol.value.as_ref();
            declaration.initial = value.and_then(|value| value.text(&symbol.ty, &tags.types));
            declaration.comment = symbol
                .comment
                .as_ref()
                .map(|text| text.replace(['\n', '\r'], " "));
            places.push((declarations.len(), symbol.at));
            declarations.push(declaration);
        }
        for (number, at) in places {
            if let Some(at) = at {
                declarations[number].origin = Some(self.origin(at));
            }
        }
        declarations
    }

    fn type_text(&self, ty: &Ty) -> String {
        type_text(&self.translator.tags.types, &self.translator.aoi_names, ty)
    }

    /// An Add-On Instruction as a block.
    fn aoi(&mut self, aoi: usize) -> Vec<Item> {
        let project = self.translator.project;
        let definition = &project.aois[aoi];
        let scope = 1 + project.programs.len() + aoi;
        let name = self.translator.aoi_names[aoi].clone();
        let mut body = Vec::new();
        let routine = |name: &str| {
            let mut all = self.units.iter();
            all.position(|unit| unit.owner == Owner::Aoi(aoi) && unit.routine.name.eq_ignore_ascii_case(name))
        };
        let (logic, when_off) = (routine("Logic"), routine("EnableInFalse"));
        // With dead power nothing of it runs, but what it has for that.
        let alone = |text: &str| Circuit::Element(Element::block(text, None));
        match when_off.filter(|unit| !self.units[*unit].rungs.is_empty()) {
            Some(unit) => {
                let label = self.translator.tags.fresh(scope, "logic");
                let jump = vec![alone("[ ]( EN )"), alone(&format!("<JMP>( {label} )"))];
                body.push(network(Vec::new(), Circuit::Series(jump)));
                body.extend(self.unit(unit));
                let end = network(Vec::new(), alone("<RET>"));
                body.extend([Item::Blank, end, Item::Blank]);
                body.push(network(Vec::new(), alone(&format!("<LBL>( {label} )"))));
            }
            None => {
                let leave = vec![alone("[/]( EN )"), alone("<RET>")];
                body.push(network(Vec::new(), Circuit::Series(leave)));
            }
        }
        if let Some(logic) = logic {
            body.extend(self.unit(logic));
        }
        let place = self.place(definition.at);
        for unit in self.units.iter().filter(|unit| unit.owner == Owner::Aoi(aoi)) {
            let own = unit.routine;
            let runs = matches!(own.name.to_ascii_uppercase().as_str(), "LOGIC" | "ENABLEINFALSE");
            if !runs && !own.rungs.is_empty() {
                let place = self.place(own.at);
                let what = format!("routine {} of {}", own.name, definition.name);
                self.reading
                    .report
                    .approximated(place, what, "it is not run here: there is no such phase");
            }
        }
        let mut items = vec![Item::Blank];
        let said = definition.comment.as_deref().unwrap_or_default();
        let title = format!("Add-On Instruction {}\n{said}", definition.name);
        items.push(Item::Comment(title.trim().to_owned()));
        let mut inner = Vec::new();
        let sections = [
            (Kind::Input, SectionKind::VarInput, None),
            (Kind::InOut, SectionKind::VarInOut, None),
            (Kind::Output, SectionKind::VarOutput, None),
            (Kind::Plain, SectionKind::Var, None),
            (Kind::Constant, SectionKind::Var, Some(Qualifier::Constant)),
        ];
        for (kind, section, qualifier) in sections {
            let mut section = Section::new(section);
            section.qualifier = qualifier;
            section.declarations = self.declared(kind, |of| of == scope);
            if kind == Kind::Input {
                // What a call need not give has a value of its own.
                for declaration in &mut section.declarations {
                    let default = if declaration.ty == "BOOL" { "FALSE" } else { "0" };
                    let elementary = !declaration.ty.starts_with(['A', 'S', '$']) || declaration.ty == "SINT";
                    if declaration.initial.is_none() && elementary {
                        let real = matches!(declaration.ty.as_str(), "REAL" | "LREAL");
                        declaration.initial = Some(if real { "0.0" } else { default }.to_owned());
                    }
                }
            }
            inner.push(Item::Section(section));
        }
        inner.push(Item::Blank);
        inner.append(&mut body);
        self.reading
            .report
            .translated(place, format!("Add-On Instruction {}", definition.name));
        items.push(Item::Block {
            header: format!("[{name}]"),
            items: inner,
        });
        items
    }

    /// The rungs of a routine.
    fn unit(&mut self, number: usize) -> Vec<Item> {
        let unit = &self.units[number];
        self.translator.labels = labels(unit);
        self.translator.routine.clone_from(&unit.routine.name);
        let mut items = Vec::new();
        for (rung, parts) in unit.routine.rungs.iter().zip(&unit.rungs) {
            items.push(Item::Blank);
            items.push(self.rung(unit.scope, rung, parts.as_ref()));
        }
        items
    }

    fn rung(
        &mut self,
        scope: usize,
        rung: &Rung,
        parts: Result<&Vec<Part<'p>>, &crate::neutral::Wrong>,
    ) -> Item {
        let said = rung.comment.iter().map(|text| text.replace("\r\n", "\n"));
        let mut comments: Vec<String> = said.collect();
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
                self.inert(
                    place,
                    it.text,
                    &format!("{why}; it does nothing here, and power passes"),
                );
                Circuit::Element(Element::comment(it.text, Some(origin)))
            }
        }
    }

    /// Something that is not in the program here.
    fn inert(&mut self, place: LineColumn, what: &str, message: &str) {
        self.reading.report.approximated(place, what, message);
        self.reading.findings.push(Finding {
            place,
            severity: Severity::Info,
            check: INERT,
            message: format!("`{}`: {message}", shortened(what)),
        });
    }

    /// What there is to say of declarations and of parts that were not read.
    fn accounts(&mut self) {
        let project = self.translator.project;
        for (at, what, why) in &project.refused {
            let place = self.place(*at);
            self.reading.report.refused(place, what, why);
        }
        for (at, what, why) in self.translator.tags.unknown.clone() {
            let place = self.place(at);
            self.inert(place, &what, &format!("{why}: it is not declared here"));
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
        let said: HashSet<LineColumn> = self
            .reading
            .report
            .entries
            .iter()
            .map(|entry| entry.place)
            .collect();
        for (at, what) in entries {
            let place = self.place(at);
            if !said.contains(&place) {
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

fn network(comments: Vec<String>, circuit: Circuit<Element>) -> Item {
    let drawing = Drawing::Circuit(Circuit::Series(vec![circuit]));
    Item::Network(Network { comments, drawing })
}

/// The labels of a routine, as ladder text spells them.
fn labels(unit: &Unit<'_>) -> HashMap<String, String> {
    let mut names = Names::default();
    let mut labels = HashMap::new();
    for parts in unit.rungs.iter().filter_map(|rung| rung.as_ref().ok()) {
        instructions(parts, &mut |it| {
            if let (Some(Op::Lbl), Some(name)) =
                (instruction(it.name, it.operands.len()), it.operands.first())
            {
                let key = name.to_ascii_uppercase();
                labels.entry(key).or_insert_with(|| names.spell(name).to_owned());
            }
        });
    }
    labels
}

fn type_text(types: &Types, aois: &[String], ty: &Ty) -> String {
    match ty {
        Ty::Elem(elem) => elem.text(),
        Ty::Structure(index) => types.all[*index].name.clone(),
        Ty::Aoi(index) => aois[*index].clone(),
        Ty::Array(ty, sizes) => {
            let bounds: Vec<String> = sizes.iter().map(|size| format!("0..{}", size - 1)).collect();
            format!("ARRAY[{}] OF {}", bounds.join(", "), type_text(types, aois, ty))
        }
    }
}

/// The types that declared tags have.
fn types(types: &Types, aois: &[String]) -> Option<Item> {
    let mut text = String::new();
    for structure in types.all.iter().filter(|structure| structure.used) {
        if let Some(comment) = &structure.comment {
            for line in comment_text(comment)
                .lines()
                .filter(|line| !line.trim().is_empty())
            {
                text.push_str(&format!("    # {} #\n", line.trim()));
            }
        }
        text.push_str(&format!("    {} : STRUCT\n", structure.name));
        for field in &structure.members {
            text.push_str(&format!(
                "        {} : {};",
                field.name,
                type_text(types, aois, &field.ty)
            ));
            if let Some(comment) = &field.comment {
                text.push_str(&format!("  # {} #", comment_text(comment).replace('\n', " ")));
            }
            text.push('\n');
        }
        if structure.original == "TIMER" {
            text.push_str("        LAST : TIME;  # when the time was last counted #\n");
        }
        text.push_str("    END_STRUCT;\n");
    }
    (!text.is_empty()).then(|| Item::Text(format!("\nTYPE\n{text}END_TYPE")))
}

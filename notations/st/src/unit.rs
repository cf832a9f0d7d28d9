//! A program, function or block on its way into the text: its variables, and the lines of its body.

use crate::flow::Flow;
use crate::names::{self, Names};
use crate::power::{Factor, Power};
use crate::project::{Project, Result, Service, Stop, UnitKind};
use crate::term::Term;
use ladder_analysis::program::{Location, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// A variable that the ladder program does not declare.
pub(crate) struct Local {
    pub(crate) name: String,
    pub(crate) ty: String,
}

pub(crate) struct Unit<'a, 'p> {
    pub(crate) project: &'a mut Project<'p>,
    pub(crate) kind: UnitKind,
    pub(crate) declared: Variables,
    pub(crate) rungs: Rungs,
    pub(crate) out: Statements,
    pub(crate) here: Location,
    numbers: usize,
    pub(crate) flow: Flow,
}

/// The variables of a unit.
#[derive(Default)]
pub(crate) struct Variables {
    /// The names that are taken in it.
    pub(crate) names: Names,
    /// The variables of tags by the name of the tag.
    pub(crate) of_tags: BTreeMap<String, String>,
    /// Variables of others that it uses: their names and types.
    pub(crate) externals: BTreeMap<String, String>,
    /// Variables that stay, over a warm restart too.
    pub(crate) retained: Vec<Local>,
    /// Blocks for edges, timers of bodies and other things that stay.
    pub(crate) instances: Vec<Local>,
    /// Values on their way.
    pub(crate) temporaries: Vec<Local>,
    /// The parameters that stand for variables of the caller.
    pub(crate) in_outs: BTreeSet<String>,
    /// The names of temporaries by their type, and how many are in use.
    pool: BTreeMap<String, (Vec<String>, usize)>,
}

/// Of the network that is written.
#[derive(Default)]
pub(crate) struct Rungs {
    /// The power of each step that is still needed, and how often.
    pub(crate) powers: Vec<Power>,
    pub(crate) left: Vec<usize>,
    /// The variable that holds the power of the rails, if they can be switched off.
    pub(crate) rail: Option<String>,
    called: HashMap<usize, String>,
    /// Whether what an index is computed from may change before its place is used.
    pub(crate) holds_indices: bool,
}

/// The text of a body.
pub(crate) struct Statements {
    /// What gives variables the values that they begin with: those that go with the power, and those that do not.
    pub(crate) first: [Vec<String>; 2],
    pub(crate) lines: Vec<String>,
    indent: usize,
}

impl<'a, 'p> Unit<'a, 'p> {
    pub(crate) fn new(project: &'a mut Project<'p>, kind: UnitKind, here: Location) -> Unit<'a, 'p> {
        Unit {
            declared: Variables {
                names: project.given.names.clone(),
                ..Variables::default()
            },
            project,
            kind,
            rungs: Rungs::default(),
            out: Statements {
                first: Default::default(),
                lines: Vec::new(),
                indent: 1,
            },
            here,
            numbers: 0,
            flow: Flow::default(),
        }
    }

    /// That it cannot be written.
    pub(crate) fn stop<T>(&self, why: impl Into<String>) -> Result<T> {
        Err(Stop {
            at: self.here,
            why: why.into(),
        })
    }

    pub(crate) fn line(&mut self, text: impl AsRef<str>) {
        self.out
            .lines
            .push(format!("{}{}", "    ".repeat(self.out.indent), text.as_ref()));
    }

    pub(crate) fn open(&mut self, head: impl AsRef<str>) {
        self.line(head);
        self.out.indent += 1;
    }

    pub(crate) fn close(&mut self, end: &str) {
        self.out.indent -= 1;
        // An IF around nothing says nothing.
        let is_empty = |line: &String| line.trim_start().starts_with("IF ") && line.ends_with(" THEN");
        if end == "END_IF;" && self.out.lines.last().is_some_and(is_empty) {
            self.out.lines.pop();
        } else {
            self.line(end);
        }
    }

    /// `ELSE`
    pub(crate) fn other(&mut self) {
        self.out.indent -= 1;
        self.line("ELSE");
        self.out.indent += 1;
    }

    pub(crate) fn number(&mut self) -> usize {
        self.numbers += 1;
        self.numbers
    }

    /// The variable of a tag.
    pub(crate) fn variable(&mut self, tag: TagId) -> String {
        let program = self.project.source.program;
        let tag_of = &program.tags[tag.0 as usize];
        let name = self.project.root(tag);
        if let Some(block) = tag_of.block {
            let user = &program.blocks[block];
            if user.en == tag {
                return "power_in".into();
            }
            if user.eno == tag {
                return "power_out".into();
            }
            let is_parameter = |&(parameter, _): &(TagId, _)| self.project.root(parameter) == name;
            if user.parameters.iter().any(is_parameter) {
                return names::member(name);
            }
        } else if self.project.is_passed(name) {
            let shared = self.project.name_of_shared(name);
            self.declared.in_outs.insert(shared.clone());
            if self.kind == UnitKind::Program {
                self.declared.of_tags.insert(name.to_owned(), shared.clone());
            }
            return shared;
        } else if self.project.is_shared(name) {
            let shared = self.project.name_of_shared(name);
            if !self.declared.externals.contains_key(&shared) {
                let ty = match self.project.declared_type(None, name) {
                    Some(Type::State(state)) if self.project.is_standard(state, tag) => state.name().into(),
                    declared => self.project.type_name(declared.unwrap_or(Type::BOOL)),
                };
                self.declared.externals.insert(shared.clone(), ty);
            }
            return shared;
        }
        if let Some(variable) = self.declared.of_tags.get(name) {
            return variable.clone();
        }
        let variable = self.declared.names.name(name, "tag");
        self.declared.of_tags.insert(name.to_owned(), variable.clone());
        variable
    }

    /// Statements that give a variable the value that it begins with.
    pub(crate) fn begin_with(&mut self, lines: Vec<String>, is_retained: bool) {
        self.out.first[usize::from(is_retained)].extend(lines);
    }

    /// What is done once, before anything else.
    pub(crate) fn first_scan(&mut self) -> Vec<String> {
        for (number, lines) in std::mem::take(&mut self.out.first).into_iter().enumerate() {
            if lines.is_empty() {
                continue;
            }
            let has_begun = self
                .declared
                .names
                .name(if number == 0 { "has_begun" } else { "has_been_on" }, "2");
            let list = if number == 0 {
                &mut self.declared.instances
            } else {
                &mut self.declared.retained
            };
            list.push(Local {
                name: has_begun.clone(),
                ty: "BOOL".into(),
            });
            self.open(format!("IF NOT {has_begun} THEN"));
            self.line(format!("{has_begun} := TRUE;"));
            for line in lines {
                self.line(line);
            }
            self.close("END_IF;");
        }
        std::mem::take(&mut self.out.lines)
    }

    /// The arguments of a call for the variables of the program that the unit uses.
    pub(crate) fn passed(&mut self, unit: UnitKind) -> Vec<String> {
        let roots: Vec<String> = self.project.passed(unit).iter().cloned().collect();
        let names = roots.iter().map(|root| self.project.name_of_shared(root));
        let names: Vec<String> = names.collect();
        self.declared.in_outs.extend(names.iter().cloned());
        names.iter().map(|name| format!("{name} := {name}")).collect()
    }

    /// Something that is counted.
    pub(crate) fn service(&mut self, service: Service) -> String {
        let name = self.project.service(service, self.kind);
        let ty = self.project.scalar_name(service.ty());
        self.declared.externals.insert(name.clone(), ty);
        name
    }

    /// A variable that lives as long as the unit.
    pub(crate) fn instance(&mut self, base: &str, ty: &str) -> String {
        let name = self.declared.names.name(base, "2");
        self.declared.instances.push(Local {
            name: name.clone(),
            ty: ty.to_owned(),
        });
        name
    }

    /// The same, with a number.
    pub(crate) fn numbered(&mut self, base: &str, ty: &str) -> String {
        let name = self.declared.names.numbered(base);
        self.declared.instances.push(Local {
            name: name.clone(),
            ty: ty.to_owned(),
        });
        name
    }

    /// A variable for a value within one network.
    pub(crate) fn temporary(&mut self, base: &str, ty: Scalar) -> String {
        let ty = self.project.scalar_name(ty);
        let (all, used) = self.declared.pool.entry(format!("{base} {ty}")).or_default();
        *used += 1;
        if let Some(name) = all.get(*used - 1) {
            return name.clone();
        }
        let name = self.declared.names.numbered(base);
        all.push(name.clone());
        self.declared.temporaries.push(Local {
            name: name.clone(),
            ty,
        });
        name
    }

    pub(crate) fn value_temporary(&mut self, ty: Scalar) -> String {
        let base = match ty {
            Scalar::Bool => "bit".to_owned(),
            Scalar::String(_) => "text".into(),
            Scalar::Enum(_) => "value".into(),
            other => other.name().to_ascii_lowercase(),
        };
        self.temporary(&base, ty)
    }

    /// All temporaries are free again.
    pub(crate) fn free_temporaries(&mut self) {
        self.declared.pool.values_mut().for_each(|(_, used)| *used = 0);
    }

    /// The variable that holds a function's own state, which all that call it share.
    pub(crate) fn function_instance(&mut self, function: usize) -> String {
        let name = self.rungs.called.get(&function).cloned();
        name.unwrap_or_else(|| {
            let ty = self.project.given.functions[function].clone();
            let shared = self.project.given.function_states[function].clone();
            if self.project.is_called_in_one(function) {
                self.declared.instances.push(Local {
                    name: shared.clone(),
                    ty,
                });
            } else {
                self.declared.externals.insert(shared.clone(), ty);
            }
            self.rungs.called.insert(function, shared.clone());
            shared
        })
    }

    /// Before something of these is written: what is still to be read of it as it was is kept. `None` is anything that others
    /// can see.
    pub(crate) fn keep(&mut self, written: Option<&BTreeSet<String>>) {
        let is_open = |name: &String| {
            self.declared.externals.contains_key(name) || self.declared.in_outs.contains(name)
        };
        // In-outs may be one another, or what others see.
        let any_open = match written {
            Some(written) => !self.declared.in_outs.is_empty() && written.iter().any(is_open),
            None => true,
        };
        let mut kept: BTreeMap<usize, Term> = BTreeMap::new();
        for (power, left) in self.rungs.powers.iter().zip(&self.rungs.left) {
            let Power::Live(factors) = power else { continue };
            if *left == 0 {
                continue;
            }
            for factor in factors {
                let is_touched = |read: &String| {
                    (any_open && is_open(read)) || written.is_some_and(|written| written.contains(read))
                };
                if factor.term.reads.iter().any(is_touched) {
                    kept.insert(factor.number, factor.term.clone());
                }
            }
        }
        let mut names = BTreeMap::new();
        for (number, term) in kept {
            let name = self.temporary("power", Scalar::Bool);
            self.line(format!("{name} := {};", term.text));
            names.insert(number, name);
        }
        if names.is_empty() {
            return;
        }
        for power in &mut self.rungs.powers {
            let Power::Live(factors) = power else { continue };
            for factor in factors {
                if let Some(name) = names.get(&factor.number) {
                    factor.term = Term::variable(name);
                }
            }
        }
    }

    /// From here on the power with these conditions is what a variable holds that is about to be written.
    pub(crate) fn hold(&mut self, numbers: &[usize], variable: &str) -> usize {
        let number = self.number();
        for power in &mut self.rungs.powers {
            let Power::Live(factors) = power else { continue };
            let begins = factors.len() >= numbers.len()
                && factors
                    .iter()
                    .zip(numbers)
                    .all(|(factor, number)| factor.number == *number);
            if begins {
                let held = Factor {
                    number,
                    term: Term::whole(variable),
                };
                factors.splice(..numbers.len(), [held]);
            }
        }
        number
    }

    /// The variable is written: from here on it may be written again.
    pub(crate) fn is_held(&mut self, number: usize, variable: &str) {
        for power in &mut self.rungs.powers {
            let Power::Live(factors) = power else { continue };
            for factor in factors.iter_mut().filter(|factor| factor.number == number) {
                factor.term = Term::variable(variable);
            }
        }
    }

    /// The power that enters a block, ready to be written: what is needed again has a name.
    pub(crate) fn entering(&mut self, en: usize, step: usize) -> Power {
        let power = self.rungs.powers[en].clone();
        if power.is_short() || !self.is_needed_again(en, step) {
            return power;
        }
        let Some(term) = power.term() else { return power };
        let name = self.temporary("power", Scalar::Bool);
        self.line(format!("{name} := {};", term.text));
        let number = self.hold(&power.numbers(), &name);
        self.is_held(number, &name);
        self.rungs.powers[en].clone()
    }

    /// Whether something else will ask for the power that enters a block, or leaves it as the same one.
    pub(crate) fn is_needed_again(&self, en: usize, step: usize) -> bool {
        self.rungs.left[en] > 0 || self.rungs.left[step] > 0
    }
}

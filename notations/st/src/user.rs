//! User-defined blocks as function blocks, and functions as those without inputs.

use crate::arguments::by_place;
use crate::checks::Checks;
use crate::names;
use crate::power::Power;
use crate::project::{Result, Service, UnitKind};
use crate::term::Term;
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Block, BlockKind, ParameterKind};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Op, Shape};
use std::collections::BTreeSet;

impl Unit<'_, '_> {
    pub(crate) fn user_block(&mut self, index: usize, block: &Block, en: usize, step: usize) -> Result<()> {
        let program = self.project.source.program;
        let user = &program.blocks[index];
        let mut checks = Checks::new();
        let mut written = BTreeSet::new();
        let state = block.arguments.iter().find(|bound| bound.parameter.is_none());
        let ty = self.project.given.blocks[index].clone();
        let instance = match state.map(|bound| &bound.argument) {
            Some(state) => self.path(self.state_tag(state)?, &[]).1,
            None => {
                let base = ty.to_lowercase();
                self.numbered(&base, &ty)
            }
        };
        let mut arguments = Vec::new();
        let mut after = Vec::new();
        for (number, &(id, kind)) in user.parameters.iter().enumerate() {
            let tag = &program.tags[id.0 as usize];
            let parameter = names::member(self.project.root(id));
            let given = block
                .arguments
                .iter()
                .find(|bound| bound.parameter == Some(number));
            match (kind, given.map(|bound| &bound.argument)) {
                (ParameterKind::Input, Some(Argument::Value(value))) => {
                    let value = self.settled(value, &mut checks)?;
                    arguments.push(format!("{parameter} := {}", value.text));
                }
                // An instance keeps there what it is not given, too.
                (ParameterKind::Input, None) if state.is_some() => {}
                (ParameterKind::Input, None) => {
                    let Some(scalar) = tag.ty.scalar() else {
                        return self.stop("an input that is a structure or an array, and is left out");
                    };
                    let value = tag
                        .initial
                        .first()
                        .cloned()
                        .unwrap_or_else(|| Value::zero(scalar));
                    arguments.push(format!("{parameter} := {}", self.project.literal(&value, scalar)));
                }
                (ParameterKind::Output, None) => {}
                (ParameterKind::Output, Some(Argument::Place(place, to))) => {
                    self.rungs.holds_indices = true;
                    let target = self.place(place, &mut checks);
                    self.rungs.holds_indices = false;
                    let target = target?;
                    let from = tag.ty.scalar().unwrap_or(*to);
                    let value =
                        crate::expression::pass(Term::whole(format!("{instance}.{parameter}")), from, *to);
                    written.insert(target.variable.clone());
                    after.extend(target.assign(&value));
                }
                (ParameterKind::InOut, Some(Argument::Place(place, _))) => {
                    let target = self.place(place, &mut checks)?;
                    let Some(text) = target.plain() else {
                        return self.stop("a bit of a number as an in-out: use a BOOL");
                    };
                    arguments.push(format!("{parameter} := {text}"));
                    written.insert(target.variable.clone());
                }
                (_, Some(whole)) => {
                    let range = given.map(|bound| bound.range);
                    let (text, variable) = self.whole(whole, range, block, &mut checks)?;
                    match kind {
                        ParameterKind::Output => after.push(format!("{text} := {instance}.{parameter};")),
                        _ => arguments.push(format!("{parameter} := {text}")),
                    }
                    if kind != ParameterKind::Input {
                        written.insert(variable);
                    }
                }
                (ParameterKind::InOut, None) => return self.stop("an in-out that is left out"),
            }
        }
        let power = self.entering(en, en);
        self.keep(None);
        self.keep(Some(&written));
        let root = instance.split(['.', '[']).next().unwrap_or_default().to_owned();
        self.keep(Some(&BTreeSet::from([root.clone()])));
        let term = power.or_true();
        arguments.insert(0, format!("power_in := {}", term.text));
        arguments.extend(self.passed(UnitKind::Block(index)));
        let mut lines = vec![format!("{instance}({});", arguments.join(", "))];
        lines.extend(after);
        let mut out = Term::whole(format!("{instance}.power_out"));
        out.reads.insert(root);
        let number = self.number();
        if checks.is_empty() {
            for line in &lines {
                self.line(line);
            }
            self.rungs.powers[step] = Power::of(number, out);
        } else {
            let done = self.done(step);
            self.all_or_low(checks, lines, &out, (step, done));
        }
        if user.shape == Shape::Function && self.leaves(UnitKind::Block(index)) {
            return self.stop("a block that returns or jumps where it stands: write that next to it");
        }
        self.after_call();
        Ok(())
    }

    /// Whether a body jumps, returns or ends in its caller's stead.
    fn leaves(&self, unit: UnitKind) -> bool {
        let program = self.project.source.program;
        let mut blocks = program.networks[self.project.networks(unit)]
            .iter()
            .flat_map(|network| &network.blocks);
        blocks.any(|block| match block.kind {
            BlockKind::Instruction(row) => {
                row.op == Op::Ret
                    || block
                        .arguments
                        .iter()
                        .any(|bound| matches!(bound.argument, Argument::OuterLabel(_)))
            }
            BlockKind::User(inner) => {
                program.blocks[inner].shape == Shape::Function && self.leaves(UnitKind::Block(inner))
            }
        })
    }

    /// `<CALL>`
    pub(crate) fn call(&mut self, block: &Block, en: usize, step: usize) -> Result<()> {
        let Some(Argument::Function(function)) = by_place(block).first() else {
            return self.stop("a call of something that is no function");
        };
        let power = self.entering(en, step);
        self.rungs.powers[step] = power.clone();
        self.keep(None);
        let instance = self.function_instance(*function);
        let passed = self.passed(UnitKind::Function(*function));
        let mut lines = vec![format!("{instance}({});", passed.join(", "))];
        if self.may_end_elsewhere() {
            let ended = self.service(Service::Ended);
            lines.extend([format!("IF {ended} THEN"), "    RETURN;".into(), "END_IF;".into()]);
        }
        self.when(&power, &lines);
        Ok(())
    }

    /// Whether the program may have ended in what was called.
    fn may_end_elsewhere(&self) -> bool {
        let program = self.project.source.program;
        let elsewhere = self
            .project
            .units()
            .into_iter()
            .filter(|unit| *unit != UnitKind::Program);
        let mut networks = elsewhere.flat_map(|unit| &program.networks[self.project.networks(unit)]);
        networks.any(|network| {
            network
                .blocks
                .iter()
                .any(|block| crate::network::is(block, Op::End))
        })
    }

    fn after_call(&mut self) {
        if self.may_end_elsewhere() {
            let ended = self.service(Service::Ended);
            self.open(format!("IF {ended} THEN"));
            self.line("RETURN;");
            self.close("END_IF;");
        }
    }
}

//! Networks as rungs.

use super::act::{is_condition, op};
use super::condition::all;
use super::value::Refusal;
use super::{Above, Back, pin_of_register, text};
use crate::dsl;
use crate::model::{Action, Bits, Condition, Contact, ContactKind, Instruction, Program, Routine, Rung};
use crate::python_name::python_name;
use ladder_analysis::program::{Block, Network};
use ladder_format::Circuit;
use ladder_instructions::Op;
use ladder_notation::circuit::series_parallel;
use std::collections::HashSet;

impl Back<'_> {
    /// The main program and the subroutines, from the top to the bottom of the text.
    pub(super) fn routines(&mut self) -> Program {
        let mut out = Program::default();
        let mut routine = Routine::default();
        let mut at = text::head_end(self.text);
        routine.comments = text::between(&self.text[..at]).concat();
        let program = self.program;
        let bodies = program.blocks.iter().map(|block| block.networks.clone());
        let bodies: HashSet<usize> = bodies.flatten().collect();
        let mut networks: Vec<&Network> = (0..)
            .zip(&program.networks)
            .filter(|(number, network)| network.location.file == 0 && !bodies.contains(number))
            .map(|(_, network)| network)
            .collect();
        networks.sort_by_key(|network| network.location.range.start());
        for network in networks {
            let range = network.location.range;
            let start = usize::from(range.start()).max(at);
            let mut told = text::between(&self.text[at..start]);
            at = usize::from(range.end()).max(at);
            if let Some(name) = self.function(network) {
                let comments = told.pop().unwrap_or_default();
                routine.after.extend(told.concat());
                let place = self.place_of(network.location);
                let before = std::mem::replace(
                    &mut routine,
                    Routine {
                        name,
                        place,
                        comments,
                        rungs: Vec::new(),
                        after: Vec::new(),
                    },
                );
                self.finish(before, &mut out);
                self.in_subroutine = true;
                continue;
            }
            self.network(network, told.concat(), &mut routine);
        }
        routine.after.extend(text::between(&self.text[at..]).concat());
        self.finish(routine, &mut out);
        out
    }

    fn finish(&self, routine: Routine, out: &mut Program) {
        if self.in_subroutine {
            out.subroutines.push(routine);
        } else {
            out.main = routine;
        }
    }

    /// The name of the function that a network begins.
    fn function(&self, network: &Network) -> Option<String> {
        let first = network
            .blocks
            .first()
            .filter(|block| op(block) == Some(Op::Fun))?;
        let start = first.location.range.start();
        let functions = &self.program.functions;
        let own = functions.iter().find(|function| {
            let begins = self.program.networks.get(function.networks.start);
            begins.is_some_and(|network| network.location.file == 0 && network.location.range.contains(start))
        })?;
        Some(python_name(&own.name))
    }

    fn network(&mut self, network: &Network, told: Vec<String>, routine: &mut Routine) {
        let is_reset = told.len() == 1 && told[0].starts_with("reset of ");
        let registers = std::mem::take(&mut self.computed.registers);
        let before = self.report.entries.len();
        match self.rungs(network, &registers, is_reset, routine) {
            Ok(mut rungs) => {
                if let Some(first) = rungs.first_mut() {
                    let waiting = std::mem::take(&mut routine.after);
                    first.comments = waiting.into_iter().chain(told).collect();
                } else if !is_reset {
                    // They were above a rung of the importer's, and belong to the one that follows.
                    routine.after.extend(told);
                }
                routine.rungs.append(&mut rungs);
            }
            Err(why) => {
                self.report.entries.truncate(before);
                let place = self.place_of(network.location);
                let mut comments = std::mem::take(&mut routine.after);
                comments.extend(told);
                comments.extend(
                    self.written(network.location.range)
                        .lines()
                        .map(|line| line.trim_end().to_owned()),
                );
                routine.rungs.push(Rung {
                    place,
                    comments,
                    condition: Condition::ALWAYS,
                    actions: vec![Action {
                        place,
                        condition: Condition::ALWAYS,
                        what: Instruction::Kept {
                            text: "the network above has no counterpart in Click".to_owned(),
                            why,
                        },
                        oneshot: false,
                        comment: None,
                    }],
                });
            }
        }
    }

    /// A network as a rung, or as several where power goes on after a timer.
    fn rungs(
        &mut self,
        network: &Network,
        registers: &[Option<ladder_analysis::program::TagId>],
        is_reset: bool,
        routine: &mut Routine,
    ) -> Result<Vec<Rung>, Refusal> {
        let circuit = if network.blocks.is_empty() {
            Circuit::Series(Vec::new())
        } else {
            series_parallel(network).ok_or("it is not made of series and branches alone")?
        };
        let mut parts = Vec::new();
        flatten(circuit, &mut parts);
        let place = self.place_of(network.location);
        let split = parts
            .iter()
            .position(|part| !Self::lets_through(network, part))
            .unwrap_or(parts.len());
        let mut conditions = Vec::new();
        for part in &parts[..split] {
            conditions.push(self.condition(network, part)?);
        }
        let condition = all(conditions);
        if let Some(blocks) = series(network, &parts[split..]) {
            match self.above(&condition, &blocks) {
                Above::Yes => return Ok(Vec::new()),
                Above::Clock(tag) if registers.contains(&Some(tag)) => {
                    let given =
                        pin_of_register(&mut routine.rungs, |shift| shift.clock = Some(condition.clone()));
                    if given {
                        // Its reset may follow.
                        self.computed.registers = registers.to_vec();
                        return Ok(Vec::new());
                    }
                }
                _ => {}
            }
        }
        if is_reset
            && !registers.is_empty()
            && pin_of_register(&mut routine.rungs, |shift| shift.reset = Some(condition.clone()))
        {
            return Ok(Vec::new());
        }
        let mut rungs = Vec::new();
        let mut condition = condition;
        let mut rest = &parts[split..];
        loop {
            // After a timer or counter its own bit is the power.
            let state = rest
                .iter()
                .position(|part| Self::state_block(network, part).is_some());
            let cut = match state {
                Some(at) if at + 1 < rest.len() => at + 1,
                _ => rest.len(),
            };
            let mut actions = self.branch(network, &rest[..cut])?;
            if actions.is_empty() {
                actions.push(nop(place));
            }
            let next = state
                .filter(|_| cut < rest.len())
                .and_then(|at| Self::state_block(network, &rest[at]));
            rungs.push(Rung {
                place,
                comments: Vec::new(),
                condition,
                actions,
            });
            rest = &rest[cut..];
            let Some(block) = next else { return Ok(rungs) };
            let tag = self.tag(&block.arguments[0])?;
            let contact = Condition::Contact(Contact {
                place: self.place_of(block.location),
                kind: ContactKind::Open,
                bits: Bits::One(tag),
            });
            let more = rest
                .iter()
                .position(|part| !Self::lets_through(network, part))
                .unwrap_or(rest.len());
            let mut conditions = vec![contact];
            for part in &rest[..more] {
                conditions.push(self.condition(network, part)?);
            }
            condition = all(conditions);
            rest = &rest[more..];
        }
    }

    /// The timer or counter that a part is.
    fn state_block<'n>(network: &'n Network, part: &Circuit<usize>) -> Option<&'n Block> {
        let Circuit::Element(block) = part else {
            return None;
        };
        let block = &network.blocks[*block];
        let is_state = matches!(
            op(block),
            Some(Op::Ton | Op::Tof | Op::Rto | Op::Rtof | Op::Ctu | Op::Ctd | Op::Ctud)
        );
        is_state.then_some(block)
    }

    /// The actions of what is in series after a condition; the last part may be branches.
    fn branch(&mut self, network: &Network, parts: &[Circuit<usize>]) -> Result<Vec<Action>, Refusal> {
        let mut out = Vec::new();
        let mut blocks: Vec<&Block> = Vec::new();
        for (number, part) in parts.iter().enumerate() {
            match part {
                Circuit::Element(block) => {
                    let block = &network.blocks[*block];
                    let changes_power = matches!(
                        op(block),
                        Some(
                            Op::SetCoil
                                | Op::ResetCoil
                                | Op::OneShotFalling
                                | Op::Ton
                                | Op::Tof
                                | Op::Rto
                                | Op::Rtof
                                | Op::Ctu
                                | Op::Ctd
                                | Op::Ctud
                        )
                    );
                    if changes_power && number + 1 < parts.len() {
                        let written = self.written(block.location.range);
                        return Err(format!("in Click nothing is after {written}"));
                    }
                    blocks.push(block);
                }
                Circuit::Parallel(branches) => {
                    let shots = blocks.iter().any(|block| op(block) == Some(Op::OneShotRising));
                    let actions = self.actions(&blocks)?;
                    out.extend(actions);
                    blocks.clear();
                    if number + 1 < parts.len() {
                        return Err("in Click nothing is after branches with instructions".to_owned());
                    }
                    for branch in branches {
                        let mut parts = Vec::new();
                        flatten(branch.clone(), &mut parts);
                        let split = parts
                            .iter()
                            .position(|part| !Self::lets_through(network, part))
                            .unwrap_or(parts.len());
                        let mut conditions = Vec::new();
                        for part in &parts[..split] {
                            conditions.push(self.condition(network, part)?);
                        }
                        let own = all(conditions);
                        for mut action in self.branch(network, &parts[split..])? {
                            action.oneshot |= shots;
                            action.condition = match (own.is_always(), action.condition.is_always()) {
                                (_, true) => own.clone(),
                                (true, false) => action.condition,
                                (false, false) => Condition::All(vec![own.clone(), action.condition]),
                            };
                            out.push(action);
                        }
                    }
                }
                Circuit::Series(_) => return Err("Click has no such branches".to_owned()),
            }
        }
        // Copies between numbers and characters compare with tags of their own.
        let is_late = |block: &&&Block| is_condition(block) && self.helper(block.arguments.first()).is_none();
        if let Some(block) = blocks.iter().find(is_late) {
            let written = self.written(block.location.range);
            return Err(format!(
                "in Click the contact {written} is before all instructions of its rung"
            ));
        }
        out.extend(self.actions(&blocks)?);
        Ok(out)
    }

    /// The instruction that the importer left as a comment in a wire, if a block is in for one.
    pub(super) fn kept(&self, block: &Block) -> Option<Action> {
        let told = self.written(block.location.range).strip_prefix(text::KEPT)?;
        let kept = told.trim_end_matches('#').trim().replace("\\x23", "#");
        let place = self.place_of(block.location);
        let action = dsl::single_action(&kept).unwrap_or_else(|| Action {
            what: Instruction::Kept {
                text: kept,
                why: "it is not an instruction of the DSL".to_owned(),
            },
            ..nop(place)
        });
        Some(Action {
            place,
            comment: self.comment_after(block),
            ..action
        })
    }
}

fn nop(place: ladder_notation::LineColumn) -> Action {
    Action {
        place,
        condition: Condition::ALWAYS,
        what: Instruction::Nop,
        oneshot: false,
        comment: None,
    }
}

/// What is in series, without nesting.
fn flatten(circuit: Circuit<usize>, out: &mut Vec<Circuit<usize>>) {
    match circuit {
        Circuit::Series(parts) => parts.into_iter().for_each(|part| flatten(part, out)),
        other => out.push(other),
    }
}

/// The blocks of what is in series, if there are no branches.
fn series<'n>(network: &'n Network, parts: &[Circuit<usize>]) -> Option<Vec<&'n Block>> {
    let block = |part: &Circuit<usize>| match part {
        Circuit::Element(block) => Some(&network.blocks[*block]),
        _ => None,
    };
    parts.iter().map(block).collect()
}

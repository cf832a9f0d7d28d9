//! A network as statements, in the order in which its blocks are evaluated.

use crate::power::Power;
use crate::project::Result;
use crate::unit::Unit;
use ladder_analysis::program::{Block, BlockKind, Network, Step};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Op;

/// A condition that has grown longer than this gets a name.
const LONGEST: usize = 160;

impl Unit<'_, '_> {
    /// Its statements. What comes back is whether it has been left open: by a jump that passes over the rest of it.
    pub(crate) fn network(&mut self, network: &Network) -> Result<usize> {
        self.free_temporaries();
        let count = network.steps.len();
        self.rungs.powers = vec![Power::Dead; count];
        self.rungs.left = vec![0; count];
        for step in &network.steps {
            match *step {
                Step::Start { .. } => {}
                Step::Block { en, .. } => self.rungs.left[en] += 1,
                Step::Join { upper, lower } => {
                    self.rungs.left[upper] += 1;
                    self.rungs.left[lower] += 1;
                }
            }
        }
        let holds_mcr = network.blocks.iter().any(|block| is(block, Op::Mcr));
        let rail_number = self.number();
        let mut opened = 0;
        let mut step = 0;
        while step < count {
            match network.steps[step] {
                Step::Start { rail: false } => {}
                Step::Start { rail: true } => {
                    self.rungs.powers[step] = match &self.rungs.rail {
                        Some(rail) if !holds_mcr => Power::of(rail_number, crate::term::Term::variable(rail)),
                        _ => Power::rail(),
                    };
                }
                Step::Join { upper, lower } => {
                    self.rungs.left[upper] -= 1;
                    self.rungs.left[lower] -= 1;
                    let number = self.number();
                    self.rungs.powers[step] = self.rungs.powers[upper].or(&self.rungs.powers[lower], number);
                    self.shorten(step);
                }
                Step::Block { block, en } => {
                    self.rungs.left[en] -= 1;
                    if let Some((last, is_open)) = self.chain(network, step)? {
                        step = last;
                        opened += usize::from(is_open);
                    } else {
                        let block = &network.blocks[block];
                        self.here = block.location;
                        opened += usize::from(self.block(block, en, step)?);
                    }
                    self.shorten(step);
                }
            }
            step += 1;
        }
        Ok(opened)
    }

    fn shorten(&mut self, step: usize) {
        if self.rungs.left[step] == 0 {
            return;
        }
        let Some(term) = self.rungs.powers[step]
            .term()
            .filter(|term| term.text.len() > LONGEST)
        else {
            return;
        };
        let name = self.temporary("power", Scalar::Bool);
        self.line(format!("{name} := {};", term.text));
        let number = self.hold(&self.rungs.powers[step].numbers(), &name);
        self.is_held(number, &name);
    }

    /// Blocks in a row that act on the power that enters the first, in one IF, with the jump after them: the last step of them, and
    /// whether the rest of the network is in an IF that is still open. None: there is no such block here.
    fn chain(&mut self, network: &Network, first: usize) -> Result<Option<(usize, bool)>> {
        let mut lines = Vec::new();
        let mut written = std::collections::BTreeSet::new();
        let mut last = None;
        let mut step = first;
        let Step::Block { en: entered, .. } = network.steps[first] else {
            return Ok(None);
        };
        if matches!(self.rungs.powers[entered], Power::Dead) {
            return Ok(None);
        }
        while let Some(Step::Block { block, en }) = network.steps.get(step).copied() {
            if step > first && (en != step - 1 || self.rungs.left[en] != 1) {
                break;
            }
            let block = &network.blocks[block];
            self.here = block.location;
            let Some((all, variable)) = self.plain_act(block)? else {
                break;
            };
            lines.extend(all);
            written.insert(variable);
            if step > first {
                self.rungs.left[en] = 0;
            }
            last = Some(step);
            step += 1;
        }
        let Some(mut last) = last else { return Ok(None) };
        let mut jump = None;
        if let Some(Step::Block { block, en }) = network.steps.get(step).copied()
            && en == last
            && self.rungs.left[en] == 1
            && is(&network.blocks[block], Op::Jmp)
        {
            let (flag, all, leaves) = self.jump_lines(&network.blocks[block])?;
            lines.extend(all);
            self.rungs.left[en] = 0;
            last = step;
            jump = Some((flag, leaves));
        }
        let power = self.entering(entered, if jump.is_some() { entered } else { last });
        if jump.is_none() {
            self.rungs.powers[last] = power.clone();
        }
        self.keep(Some(&written));
        self.when(&power, &lines);
        let is_open = self.behind_jump(jump);
        Ok(Some((last, is_open)))
    }

    /// Statements that are run with this power.
    pub(crate) fn when(&mut self, power: &Power, lines: &[String]) {
        match power.term() {
            None => lines.iter().for_each(|line| self.line(line)),
            Some(_) if matches!(power, Power::Dead) => {}
            Some(term) => {
                self.open(format!("IF {} THEN", term.text));
                for line in lines {
                    self.line(line);
                }
                self.close("END_IF;");
            }
        }
    }
}

/// Whether a block is this instruction.
pub(crate) fn is(block: &Block, op: Op) -> bool {
    matches!(block.kind, BlockKind::Instruction(row) if row.op == op)
}

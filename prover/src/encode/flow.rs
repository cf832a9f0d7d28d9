//! The order in which code is followed: what is passed over, functions, bodies, loops (LANGUAGE §5.5).

use super::{MOST_NODES, Region, Scan};
use crate::graph::Lit;
use crate::limits::LATE;
use crate::never::is_never;
use crate::number::Number;
use ladder_simulator::compiled::{CALL_DEPTH, Instr};
use std::collections::BTreeMap;

/// What a call, or the body of a user-defined block, has of its own.
#[derive(Debug, Clone)]
pub(super) struct Frame {
    /// The rail is live.
    pub(super) rail: Lit,
    /// Who makes turns at the end of the network, and how many.
    noted: (Lit, Number),
    /// The number of the turn.
    turn: i64,
}

impl Default for Frame {
    fn default() -> Frame {
        Frame {
            rail: Lit::TRUE,
            noted: (Lit::FALSE, Number::constant(0)),
            turn: 0,
        }
    }
}

impl Scan<'_, '_> {
    /// Follows code from an instruction on: to the end of the main program or the function, or of a turn, whose last
    /// instruction is returned. Who jumps back in it goes through it once more, after all others.
    pub(super) fn stretch(&mut self, start: u32) -> Option<u32> {
        let outer = std::mem::take(&mut self.back);
        let last = self.pass(start);
        let mut done = self.act;
        let mut further = BTreeMap::new();
        for round in 1.. {
            let all = std::mem::take(&mut self.back);
            let (back, out): (BTreeMap<_, _>, _) = all.into_iter().partition(|(to, _)| *to >= start);
            further.extend(out);
            let Some((&first, _)) = back.first_key_value() else {
                break;
            };
            let who = self.world.graph.any(back.values().map(|back| back.who));
            if round % ASKED_EVERY == 0 && self.is_never(who) {
                break;
            }
            let is_affordable =
                self.budget / 2 > self.code.instrs.len() && self.world.graph.len() < MOST_NODES / 4;
            if round == MOST_TURNS || !is_affordable {
                for (to, Back { who, from }) in back {
                    self.lose(who, to, "a jump may go back more often than is followed", from);
                }
                break;
            }
            self.act = Lit::FALSE;
            for (to, back) in back {
                self.leave(back.who, to);
            }
            self.pass(first);
            done = self.world.graph.or(done, self.act);
        }
        self.act = done;
        self.back = outer;
        for (to, back) in further {
            self.park(to, back);
        }
        last
    }

    /// The same once.
    fn pass(&mut self, start: u32) -> Option<u32> {
        let mut pc = start;
        loop {
            self.arrive(pc);
            if pc == self.code.main && pc > 0 && self.open.is_empty() {
                self.faulted_before = std::mem::replace(&mut self.faulted, Lit::FALSE);
            }
            if self.is_alone() && self.alone.as_ref().is_some_and(|stretch| stretch.end == pc) {
                return None;
            }
            let instr = *self.code.instrs.get(pc as usize)?;
            if self.is_stopped || self.world.blocked.is_some() {
                return None;
            }
            if self.budget.is_multiple_of(LATE_EVERY) && self.world.end.is_over() {
                self.stop(LATE, pc);
                return None;
            }
            let Some(budget) = self.budget.checked_sub(1) else {
                self.stop("the loops of the program make too many turns to be followed", pc);
                return None;
            };
            self.budget = budget;
            if self.world.graph.len() > MOST_NODES {
                self.stop("the program computes too much in a scan to be followed", pc);
                return None;
            }
            pc += 1;
            match instr {
                Instr::Finish => return None,
                Instr::Network { .. } | Instr::Left { .. } => {}
                Instr::Powered { out, en, end } => {
                    let power = self.bit(en);
                    self.write_bit(out, power);
                    let without = self.world.graph.and(self.act, !power);
                    self.regions.push(Region {
                        end,
                        act: self.act,
                        without,
                        leaks: false,
                        frame: self.frame.clone(),
                        frames: self.frames.clone(),
                    });
                    self.act = self.world.graph.and(self.act, power);
                }
                Instr::Rail { out } => self.write_bit(out, self.frame.rail),
                Instr::Mcr { en } => {
                    let power = self.bit(en);
                    self.frame.rail = self.world.graph.choose(self.act, power, self.frame.rail);
                }
                Instr::Jump { en, to, .. } => {
                    let taken = self.taken(en);
                    self.jump(taken, pc - 1, to);
                }
                Instr::Return { en, .. } => {
                    let taken = self.taken(en);
                    self.leave(taken, u32::MAX);
                }
                Instr::End { en, .. } => {
                    let taken = self.taken(en);
                    self.ended = self.world.graph.or(self.ended, taken);
                    self.leave(taken, u32::MAX);
                }
                Instr::Call { en, to, .. } => self.call(en, to, pc - 1),
                Instr::For { .. } | Instr::Enter { .. } | Instr::Again { .. } if self.is_alone() => {
                    self.block("it begins or ends a loop", pc - 1);
                }
                Instr::Again { .. } => return Some(pc - 1),
                Instr::For { en, turns } => {
                    self.frame.noted = (self.taken(en), self.word(turns));
                }
                Instr::Enter { body, after } => pc = self.enter(body, after)?,
                Instr::Turn { to, width } => {
                    let turn = width.wrap(self.frame.turn);
                    self.write_word(to, Number::constant(turn));
                }
                Instr::EnterBody => {
                    self.frames.push(std::mem::take(&mut self.frame));
                }
                Instr::LeaveBody => self.frame = self.frames.pop().unwrap_or_default(),
                other if self.act != Lit::FALSE => self.instr(pc - 1, other),
                _ => {}
            }
        }
    }

    /// Whether it is in a network that is followed alone, not in a function that this calls.
    fn is_alone(&self) -> bool {
        self.alone.is_some() && self.open.is_empty()
    }

    /// Who goes on at this instruction joins.
    fn arrive(&mut self, pc: u32) {
        while let Some(region) = self.regions.pop_if(|region| region.end <= pc) {
            self.act = if region.leaks {
                self.world.graph.or(self.act, region.without)
            } else {
                region.act
            };
            // Who had no power has not left the bodies that were left in it.
            if self.frames.len() != region.frames.len() {
                (self.frame, self.frames) = (region.frame, region.frames);
            }
        }
        if let Some(waiting) = self.pending.remove(&pc) {
            self.act = self.world.graph.or(self.act, waiting);
        }
    }

    fn taken(&mut self, en: ladder_simulator::compiled::Bit) -> Lit {
        let power = self.bit(en);
        self.world.graph.and(self.act, power)
    }

    /// These go on at another instruction further down.
    pub(super) fn leave(&mut self, who: Lit, to: u32) {
        self.act = self.world.graph.and(self.act, !who);
        if who == Lit::FALSE {
            return;
        }
        for region in &mut self.regions {
            region.leaks |= region.end < to;
        }
        if to != u32::MAX {
            let waiting = self.pending.get(&to).copied().unwrap_or(Lit::FALSE);
            let all = self.world.graph.or(waiting, who);
            self.pending.insert(to, all);
        }
    }

    fn jump(&mut self, taken: Lit, from: u32, to: u32) {
        if taken == Lit::FALSE {
            return;
        }
        if to <= from && self.is_alone() {
            self.regions.iter_mut().for_each(|region| region.leaks = true);
            return self.leave(taken, to);
        }
        if to <= from && !self.frames.is_empty() {
            return self.lose(taken, to, "a jump goes back in the body of a block", from);
        }
        let enters =
            |&(body, after): &(u32, u32)| (body + 1..after).contains(&to) && !(body..after).contains(&from);
        if self.loops.iter().any(enters) {
            return self.lose(taken, from.min(to), "a jump goes into a loop", from);
        }
        if to > from {
            return self.leave(taken, to);
        }
        self.regions.iter_mut().for_each(|region| region.leaks = true);
        self.act = self.world.graph.and(self.act, !taken);
        self.park(to, Back { who: taken, from });
    }

    /// These wait for the next round.
    fn park(&mut self, to: u32, back: Back) {
        let known = self.back.entry(to).or_insert(Back {
            who: Lit::FALSE,
            ..back
        });
        known.who = self.world.graph.or(known.who, back.who);
    }

    /// A function is followed where it is called. It calls nobody that is open: that would have no end here.
    fn call(&mut self, en: ladder_simulator::compiled::Bit, to: u32, at: u32) {
        let taken = self.taken(en);
        if taken == Lit::FALSE {
            return;
        }
        if self.open.contains(&to) || self.open.len() == CALL_DEPTH {
            return self.lose(taken, 0, "a function calls itself", at);
        }
        self.open.push(to);
        let act = std::mem::replace(&mut self.act, taken);
        let pending = std::mem::take(&mut self.pending);
        let regions = std::mem::take(&mut self.regions);
        let frame = std::mem::take(&mut self.frame);
        let frames = std::mem::take(&mut self.frames);
        let back = std::mem::take(&mut self.back);
        let ended = std::mem::replace(&mut self.ended, Lit::FALSE);
        self.stretch(to);
        let ends_here = self.ended;
        self.open.pop();
        (self.pending, self.regions, self.frame, self.frames) = (pending, regions, frame, frames);
        self.back = back;
        self.ended = self.world.graph.or(ended, ends_here);
        self.act = self.world.graph.and(act, !ends_here);
    }

    /// Whether a literal is low in all scans, where that is quickly seen; it is not asked for ever.
    fn is_never(&mut self, lit: Lit) -> bool {
        let Some(left) = self.questions.checked_sub(1) else {
            return lit == Lit::FALSE;
        };
        self.questions = left;
        is_never(&self.world.graph, lit, &self.world.end)
    }

    /// The turns of a loop, one after the other. Returns where it goes on.
    fn enter(&mut self, body: u32, after: u32) -> Option<u32> {
        let nothing = (Lit::FALSE, Number::constant(0));
        let (who, turns) = std::mem::replace(&mut self.frame.noted, nothing.clone());
        let graph = &mut self.world.graph;
        let some = graph.less(&Number::constant(0), &turns);
        let turning = graph.all([self.act, who, some]);
        if turning == Lit::FALSE {
            return Some(after);
        }
        let passing = graph.and(self.act, !turning);
        self.leave(passing, after);
        self.act = turning;
        let outer = self.frame.turn;
        let most = turns.known().unwrap_or(MOST_TURNS);
        let mut last = None;
        for turn in 1..=most {
            if turn > 1 {
                let is_over = self.world.graph.less(&turns, &Number::constant(turn));
                let done = self.world.graph.and(self.act, is_over);
                self.leave(done, after);
            }
            let is_asked = turn > 1 && (turn - 1) % ASKED_EVERY == 0;
            if self.act == Lit::FALSE || is_asked && self.is_never(self.act) {
                self.act = Lit::FALSE;
                break;
            }
            self.frame.turn = turn;
            self.frame.noted = nothing.clone();
            last = Some(self.stretch(body)?);
        }
        self.frame.turn = outer;
        let more = self.world.graph.less(&Number::constant(most), &turns);
        let more = self.world.graph.and(self.act, more);
        self.lose(
            more,
            body,
            "a loop may make more turns than are followed",
            body - 1,
        );
        last.map(|again| again + 1)
    }
}

/// Who jumps back, and at which instruction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Back {
    who: Lit,
    from: u32,
}

/// After so many instructions it is asked whether there is time for more.
const LATE_EVERY: usize = 64;
/// Of a loop whose turns a tag says so many are followed, and as many rounds of who jumps back.
const MOST_TURNS: i64 = 64;
/// After so many turns it is asked whether one more can be made.
const ASKED_EVERY: i64 = 8;

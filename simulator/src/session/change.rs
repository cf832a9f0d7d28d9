//! A change of the program while it runs. What ran before the change stays as an era of its own, with its program and its
//! history, so that stepping back goes across the change.
//!
//! ```text
//! earlier eras .. | this era: base --scan--> .. here .. --scan--> newest | later eras, when stepped back
//! ```
//!
//! The end of an era and the start of the next are the same moment; the session is in the later one there.

use super::history::History;
use super::{Breakpoint, Session, Writers};
use crate::carry::{self, Changeover, Moved};
use crate::code::{ElementPlace, Instr};
use crate::compile_error::CompileError;
use crate::machine::FaultRecord;
use crate::simulation::{Simulation, ValueRefused};
use crate::tags::Point;
use ladder_analysis::program::{Location, Program};
use std::borrow::Cow;
use std::cell::OnceCell;
use std::collections::VecDeque;
use std::sync::Arc;

/// This many programs that ran before are kept.
const MOST_ERAS: usize = 64;

/// The time in which one program ran.
#[derive(Debug)]
pub(super) struct Era {
    simulation: Simulation,
    history: History,
    faults: VecDeque<FaultRecord>,
    breakpoints: Vec<Breakpoint>,
    generation: u64,
}

impl Era {
    /// How many scans of it are kept.
    pub(super) fn kept(&self) -> usize {
        self.history.kept()
    }

    /// How many bytes it takes, more or less: its scans, its code and its memory.
    pub(super) fn size(&self) -> usize {
        let compiled = &self.simulation.compiled;
        let instructions = compiled.code.instrs.len() + compiled.fused.code.instrs.len();
        let memory = &compiled.initial;
        self.history.size()
            + instructions * size_of::<Instr>()
            + compiled.elements.len() * size_of::<ElementPlace>()
            // As it began, as it was left, and the history's.
            + 3 * (memory.bits.len() + memory.words.len() * size_of::<i64>())
    }

    /// Its program and its history.
    pub(super) fn parts(&self) -> (&Simulation, &History) {
        (&self.simulation, &self.history)
    }
}

impl Session {
    /// Goes on with another program: a later form of the one that runs. A scan that is open is finished first, unless
    /// the program does what it did; then nothing happens but that places in the text are those of the new one. What was
    /// stepped back from is forgotten.
    ///
    /// # Errors
    /// The program needs more memory than there is. The one that runs goes on.
    pub fn change(&mut self, program: Arc<Program>) -> Result<Changeover, CompileError> {
        let newest = self.later.first().map_or(&self.simulation, |era| &era.simulation);
        let new = Simulation::new(program, newest.options)?;
        if carry::is_same(newest, &new) {
            let newest = match self.later.first_mut() {
                Some(era) => &mut era.simulation,
                None => &mut self.simulation,
            };
            // The state fits to the slot; only the reference to the text is another.
            (newest.program, newest.compiled) = (new.program, new.compiled);
            (newest.names, newest.points) = (new.names, new.points);
            (newest.instances, newest.bodies) = (new.instances, new.bodies);
            self.writers = OnceCell::new();
            return Ok(Changeover::None);
        }
        if self.simulation.is_open() {
            self.finish_scan();
        }
        let generation = self.newest_generation() + 1;
        let unused = self.forget_unused();
        let lost = self.begin_era(new, generation);
        if let Some(unused) = unused {
            let moved = carry::moved(&unused.simulation, &self.simulation);
            self.note_renamed(&moved);
            self.breakpoints = moved_breakpoints(&unused.breakpoints, &self.simulation, &moved);
        }
        Ok(Changeover::Carried { lost })
    }

    /// How often the running program had been changed before it became the one that runs where the session is: a
    /// change that was none does not count.
    pub fn generation(&self) -> u64 {
        self.generation
    }

    /// The number of the newest program, which differs from [`Self::generation`] where the session was stepped back
    /// over a change.
    pub fn newest_generation(&self) -> u64 {
        self.later.first().map_or(self.generation, |era| era.generation)
    }

    /// The number of the oldest program that can still be stepped back to.
    pub fn oldest_generation(&self) -> u64 {
        self.earlier.first().map_or(self.generation, |era| era.generation)
    }

    fn finish_scan(&mut self) {
        let _ = self.go_on(crate::machine::Until::End);
        if self.simulation.is_open() {
            self.give_up_scan();
        }
    }

    /// A program with which nothing has run, and that nothing was given to, is as none: what ran before it is there again,
    /// with all that it held. Returns the one that is forgotten.
    fn forget_unused(&mut self) -> Option<Era> {
        if !self.later.is_empty() || self.history.behind() > 0 || self.changed {
            return None;
        }
        let before = self.earlier.pop()?;
        Some(self.enter(before))
    }

    /// Lets a new program go on from here; what is not kept of the one that ran.
    fn begin_era(&mut self, mut new: Simulation, generation: u64) -> Vec<carry::Lost> {
        self.later.clear();
        self.history.forget_ahead();
        self.forget_faults_ahead();
        let (lost, moved) = carry::carry(&self.simulation, &mut new);
        self.note_given_at_change(&new);
        self.note_renamed(&moved);
        let mut history = History::new(&new, self.history.limits());
        history.follow_serial(&self.history);
        history.is_from_the_start &= self.history.kept() == 0;
        let faults = self
            .faults
            .iter()
            .filter_map(|fault| moved_fault(fault, &self.simulation, &new, &moved));
        let faults = faults.collect();
        let breakpoints = moved_breakpoints(&self.breakpoints, &new, &moved);
        let era = Era {
            simulation: std::mem::replace(&mut self.simulation, new),
            history: std::mem::replace(&mut self.history, history),
            faults: std::mem::replace(&mut self.faults, faults),
            breakpoints: std::mem::replace(&mut self.breakpoints, breakpoints),
            generation: std::mem::replace(&mut self.generation, generation),
        };
        // An era in which nothing ran has no scan to go back to.
        if era.kept() > 0 {
            self.earlier.push(era);
        }
        self.changed = false;
        self.repeats = false;
        self.unseen_network = false;
        self.writers = OnceCell::<Writers>::new();
        self.forget_oldest();
        lost
    }

    /// Something else happens in the past: the newest program takes over there.
    pub(super) fn take_over(&mut self) {
        if self.later.is_empty() {
            return;
        }
        if self.simulation.is_open() {
            self.finish_scan();
        }
        if self.later.is_empty() {
            return;
        }
        let era = self.later.swap_remove(0);
        let (mut newest, generation) = (era.simulation, era.generation);
        newest.open = false;
        newest.pending.clear();
        newest.forces.clear();
        newest.machine.memory.held = crate::memory::Held::default();
        newest.machine.restart(&newest.compiled.initial);
        self.later.clear();
        self.begin_era(newest, generation);
    }

    /// A point of the program that takes what is given now: after a change it may have moved.
    pub(super) fn point_of_now<'p>(&mut self, point: &'p Point) -> Result<Cow<'p, Point>, ValueRefused> {
        if self.later.is_empty() {
            return Ok(Cow::Borrowed(point));
        }
        self.take_over();
        let found = self.simulation.resolve(&point.name);
        found.map(Cow::Owned).map_err(|error| ValueRefused {
            message: error.message,
        })
    }

    /// Goes to the newest program, wherever that was.
    pub(super) fn go_to_newest(&mut self) {
        while let Some(era) = self.later.pop() {
            self.enter(era);
        }
        self.earlier.clear();
    }

    /// Goes to the end of the era before. False if there is none.
    pub(super) fn go_to_earlier(&mut self) -> bool {
        if self.history.behind() > 0 {
            return false;
        }
        let Some(era) = self.earlier.pop() else {
            return false;
        };
        if std::mem::take(&mut self.changed) {
            self.history.set_aside(&self.simulation);
        }
        let this = self.enter(era);
        self.later.push(this);
        true
    }

    /// Goes to the start of the next era if this one is at its end.
    pub(super) fn go_to_later(&mut self) {
        if self.history.ahead() > 0 {
            return;
        }
        let Some(era) = self.later.pop() else {
            return;
        };
        let this = self.enter(era);
        self.earlier.push(this);
        self.history.restore(&mut self.simulation);
        self.changed = self.history.give_what_waits(&mut self.simulation);
    }

    /// Takes up another era; gives the one that was left.
    fn enter(&mut self, era: Era) -> Era {
        self.writers = OnceCell::new();
        self.unseen_network = false;
        let cancel = self.simulation.machine.cancel.take();
        let left = Era {
            simulation: std::mem::replace(&mut self.simulation, era.simulation),
            history: std::mem::replace(&mut self.history, era.history),
            faults: std::mem::replace(&mut self.faults, era.faults),
            breakpoints: std::mem::replace(&mut self.breakpoints, era.breakpoints),
            generation: std::mem::replace(&mut self.generation, era.generation),
        };
        self.simulation.machine.cancel = cancel;
        left
    }

    /// Forgets scans of earlier programs that are more than may be kept.
    pub(super) fn forget_oldest(&mut self) {
        let limits = self.history.limits();
        while !self.earlier.is_empty() {
            let is_too_much = self.scans_behind() > limits.scans || self.history_size() > limits.bytes;
            if self.earlier.len() > MOST_ERAS {
                self.earlier.remove(0);
            } else if !is_too_much {
                return;
            } else {
                let oldest = &mut self.earlier[0];
                oldest.history.forget_oldest();
                if oldest.kept() == 0 {
                    self.earlier.remove(0);
                }
            }
        }
    }
}

/// The breakpoints whose places are still there.
fn moved_breakpoints(breakpoints: &[Breakpoint], new: &Simulation, moved: &Moved) -> Vec<Breakpoint> {
    let moved = breakpoints.iter().filter_map(|breakpoint| match breakpoint {
        Breakpoint::Network(network) => moved.network(*network).map(Breakpoint::Network),
        // Where a block went is not known by its place alone: the caller must set it again.
        Breakpoint::Block(_) => None,
        Breakpoint::Change(point) => {
            let point = new.resolve(&moved.name(&point.name)).ok();
            point.map(Breakpoint::Change)
        }
    });
    moved.collect()
}

/// A fault whose block is still there.
fn moved_fault(
    fault: &FaultRecord,
    old: &Simulation,
    new: &Simulation,
    moved: &Moved,
) -> Option<FaultRecord> {
    let was: Location = old.compiled.code.blocks.get(fault.block as usize)?.location;
    let is = moved.block(was)?;
    let blocks = new.compiled.code.blocks.iter();
    let block = blocks.zip(0..).find(|(block, _)| block.location == is)?.1;
    Some(FaultRecord { block, ..*fault })
}

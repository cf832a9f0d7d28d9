//! Steps: by block, by rung, out of a routine or to the end of the scan, and back.

use std::sync::atomic::Ordering;

use ladder_analysis::program::Location;
use ladder_simulator::{Hit, StepBy, Stepped, Stop};

use crate::adapter::Adapter;
use crate::configuration::BackBy;
use crate::messages::Granularity;
use crate::running::{After, Going, Stopped};

/// A step forward.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stepping {
    /// The next block, wherever it is.
    Into,
    /// The next block of this routine, or of the one that it goes back to.
    OverBlock,
    /// The next rung, likewise.
    OverRung,
    /// Out of the function or body; in the main program to the end of the scan.
    Out,
}

impl Stepping {
    /// What `next` means.
    pub(crate) fn next(granularity: Option<Granularity>) -> Stepping {
        match granularity {
            Some(Granularity::Instruction) => Stepping::OverBlock,
            Some(Granularity::Statement | Granularity::Line) | None => Stepping::OverRung,
        }
    }
}

impl Adapter {
    /// Goes a step forward.
    pub(crate) fn step(&mut self, step: Stepping) -> Result<(), String> {
        self.forget_stop();
        let after = self.go_step(step)?;
        match after {
            After::Go => self.stop(Stopped::because("step", "")),
            other => self.conclude(other),
        }
        Ok(())
    }

    fn go_step(&mut self, step: Stepping) -> Result<After, String> {
        let target = self.target()?;
        if target.simulation().status() != ladder_simulator::Status::Ready {
            return Ok(self.finish());
        }
        target.give();
        if !target.session.is_open() && step != Stepping::Out {
            // What is between two scans is shown in front of the first rung: that is where it steps from.
            match target.session.step_network() {
                Stepped::At(_) => {}
                Stepped::Done => return Ok(self.scan_ended()),
                Stepped::Stopped => return Ok(self.after_stop(Some(Stop::Faulted), true)),
            }
        }
        let depth = self.depth();
        let here = self.here();
        loop {
            let by = match step {
                Stepping::Into | Stepping::OverBlock => StepBy::Block,
                Stepping::OverRung => StepBy::Network,
                Stepping::Out if depth > 1 => StepBy::Block,
                Stepping::Out => StepBy::Scan,
            };
            match self.target()?.session.run_step(by) {
                Some(Stop::At(_)) => {}
                Some(Stop::Breakpoint(hit)) => match self.after_stop(Some(Stop::Breakpoint(hit)), true) {
                    After::Go => {}
                    stop => return Ok(stop),
                },
                // The scan took long, and the client wants something else.
                Some(Stop::Cancelled) => return Ok(After::Go),
                other => return Ok(self.after_stop(other, true)),
            }
            if let Some(stopped) = self.fault_stop() {
                return Ok(After::Stop(stopped));
            }
            if self.urgent.load(Ordering::SeqCst) > 0 {
                return Ok(After::Go);
            }
            let is_there = match step {
                Stepping::Into => self.here() != here,
                Stepping::OverBlock => self.depth() <= depth && self.here() != here,
                Stepping::OverRung => self.depth() <= depth && self.is_in_front_of_rung(),
                Stepping::Out => depth > 1 && self.depth() < depth,
            };
            if is_there {
                return Ok(After::Go);
            }
        }
    }

    /// How many routines are open.
    fn depth(&self) -> usize {
        self.target
            .as_ref()
            .map_or(0, |target| target.activations().len())
    }

    /// Where it is: the block, and how many were evaluated before.
    fn here(&self) -> Option<(Location, u64)> {
        let target = self.target.as_ref()?;
        Some((
            target.activations().first()?.location,
            target.simulation().blocks_done(),
        ))
    }

    /// A breakpoint on a block may have let the step halt between two rungs.
    fn is_in_front_of_rung(&self) -> bool {
        self.target
            .as_ref()
            .is_some_and(|target| target.session.is_in_front_of_network())
    }

    /// Goes back.
    pub(crate) fn step_back(&mut self, granularity: Option<Granularity>) -> Result<(), String> {
        let by = match granularity {
            Some(Granularity::Instruction) => BackBy::Block,
            Some(Granularity::Line) => BackBy::Rung,
            Some(Granularity::Statement) | None => self.configuration.step_back.unwrap_or_default(),
        };
        self.step_back_by(by)
    }

    /// Goes back by a block, a rung or a scan.
    pub(crate) fn step_back_by(&mut self, by: BackBy) -> Result<(), String> {
        self.forget_stop();
        self.judged = None;
        self.end_is_shown = false;
        let went = self.go_back(by)?;
        self.stop(if went {
            Stopped::because("step", "")
        } else {
            Stopped::because("entry", "This is as far back as it goes")
        });
        Ok(())
    }

    /// Whether there was anything to go back to.
    fn go_back(&mut self, by: BackBy) -> Result<bool, String> {
        let target = self.target()?;
        // As a step forward by rungs runs through what a rung calls, one back goes over it.
        let depth = target.activations().len();
        let is_over = |session: &ladder_simulator::Session| {
            by == BackBy::Rung && session.simulation().activations().len() > depth
        };
        let is_calling = |session: &ladder_simulator::Session| {
            by == BackBy::Rung && session.simulation().activations().len() < depth
        };
        let session = &mut target.session;
        let step = |session: &mut ladder_simulator::Session| match by {
            BackBy::Block => session.step_block(),
            BackBy::Rung | BackBy::Scan => session.step_network(),
        };
        if by == BackBy::Scan {
            return Ok(session.step_back(1) > 0);
        }
        let limit = session.is_open().then(|| session.simulation().blocks_done());
        if session.step_back(1) == 0 {
            return Ok(false);
        }
        // The last place of the scan before the one where it was.
        let mut last = None;
        while let Stepped::At(_) = step(session) {
            let done = session.simulation().blocks_done();
            // The rung that calls has done no more in front of its first block than the rung that it calls.
            if limit.is_some_and(|limit| done > limit || done == limit && !is_calling(session)) {
                break;
            }
            if !is_over(session) {
                last = Some(done);
            }
        }
        // The scan may have come to its end here, or is open.
        session.step_back(1);
        // In front of the first rung it is between two scans.
        let Some(last) = last.filter(|&last| last > 0 || limit.is_none()) else {
            return Ok(true);
        };
        while let Stepped::At(_) = step(session) {
            if session.simulation().blocks_done() >= last {
                break;
            }
        }
        Ok(true)
    }

    /// Goes back up to a breakpoint, or as far as it goes.
    pub(crate) fn run_back(&mut self) -> Result<(), String> {
        self.target()?;
        self.forget_stop();
        self.judged = None;
        self.end_is_shown = false;
        self.going = Some(Going::Back);
        Ok(())
    }

    /// One scan of a run backwards: looks for the last breakpoint in it before the place where it is.
    pub(crate) fn back_a_scan(&mut self) -> After {
        let Some(target) = &mut self.target else {
            return After::Go;
        };
        let limit = target
            .session
            .is_open()
            .then(|| target.simulation().blocks_done());
        if target.session.breakpoints().is_empty() {
            target.session.step_back(usize::MAX);
            return After::Stop(Stopped::because("entry", "This is as far back as it goes"));
        }
        if target.session.step_back(1) == 0 {
            return After::Stop(Stopped::because("entry", "This is as far back as it goes"));
        }
        let mut number = 0;
        let mut last = None;
        while let Some(Stop::Breakpoint(hit)) = self.next_hit() {
            let done = self
                .target
                .as_ref()
                .map_or(0, |target| target.simulation().blocks_done());
            let is_open = self
                .target
                .as_ref()
                .is_some_and(|target| target.session.is_open());
            if limit.is_some_and(|limit| done >= limit || !is_open) {
                break;
            }
            number += 1;
            if let Some(stopped) = self.met(&hit, false) {
                last = Some((number, stopped));
            }
            if !is_open {
                break;
            }
        }
        let Some(target) = &mut self.target else {
            return After::Go;
        };
        target.session.step_back(1);
        let Some((number, stopped)) = last else {
            return After::Go;
        };
        for _ in 0..number {
            let _ = self.next_hit();
        }
        After::Stop(stopped)
    }

    fn next_hit(&mut self) -> Option<Stop> {
        let stop = self.target.as_mut()?.session.run_step(StepBy::Scan);
        match stop {
            Some(Stop::Breakpoint(Hit::Network(_) | Hit::Block(_) | Hit::Change { .. })) => stop,
            _ => None,
        }
    }
}

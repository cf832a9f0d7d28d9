//! Where a run stops of itself.

use super::{Session, Stop};
use crate::machine::Until;
use crate::simulation::{Status, Stepped};
use crate::tags::Point;
use ladder_analysis::Cancel;
use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
use ladder_syntax::TextSize;

/// Where a run stops of itself.
#[derive(Debug, Clone, PartialEq)]
pub enum Breakpoint {
    /// In front of a network, by its number in the program: whenever it is about to be evaluated.
    Network(usize),
    /// In front of the block at this place, wherever its code runs: the body of a user-defined block has code for each
    /// place where that is.
    Block(Location),
    /// After the block that changes what a point holds. What is given from outside does not count.
    Change(Point),
}

/// How far a run in steps goes, unless a breakpoint stops it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum StepBy {
    /// In front of the next block.
    Block,
    /// In front of the next network.
    Network,
    /// To the end of the scan.
    Scan,
}

/// Why a run stopped at a breakpoint.
#[derive(Debug, Clone, PartialEq)]
pub enum Hit {
    /// This network runs next.
    Network(Location),
    /// This block runs next.
    Block(Location),
    /// A point has changed.
    Change {
        /// The point.
        point: Point,
        /// What it held before.
        before: Value,
        /// What it holds now.
        after: Value,
        /// The block that ran.
        block: Option<Location>,
    },
}

impl Session {
    /// The network that a place in the text belongs to, or else the first one after it: its number.
    pub fn network_at(&self, file: u32, offset: TextSize) -> Option<usize> {
        let networks = self.simulation.program().networks.iter().enumerate();
        let after = networks
            .filter(|(_, network)| network.location.file == file && network.location.range.end() > offset);
        after
            .min_by_key(|(_, network)| network.location.range.start())
            .map(|(number, _)| number)
    }

    /// Sets a breakpoint, if it is not set yet.
    pub fn add_breakpoint(&mut self, breakpoint: Breakpoint) {
        if !self.breakpoints.contains(&breakpoint) {
            self.breakpoints.push(breakpoint);
        }
    }

    /// Takes a breakpoint away. False if there was none.
    pub fn remove_breakpoint(&mut self, breakpoint: &Breakpoint) -> bool {
        let before = self.breakpoints.len();
        self.breakpoints.retain(|known| known != breakpoint);
        self.breakpoints.len() < before
    }

    /// Takes all breakpoints away.
    pub fn clear_breakpoints(&mut self) {
        self.breakpoints.clear();
    }

    /// The breakpoints, in the order in which they were set.
    pub fn breakpoints(&self) -> &[Breakpoint] {
        &self.breakpoints
    }

    /// Runs up to this many scans; one that is open counts. How many came to their end, and why there were no more.
    pub fn run(&mut self, scans: u64, cancel: &Cancel) -> (u64, Stop) {
        for run in 0..scans {
            if cancel.is_cancelled() {
                return (run, Stop::Cancelled);
            }
            if let Some(stop) = self.run_scan() {
                // The last block of a scan may have hit the breakpoint.
                let came_to_its_end = matches!(stop, Stop::Breakpoint(_)) && !self.simulation.is_open();
                return (run + u64::from(came_to_its_end), stop);
            }
        }
        (scans, Stop::Done)
    }

    /// Runs one scan, or the rest of the one that is open, unless a breakpoint stops it. None if it came to its end.
    pub fn run_scan(&mut self) -> Option<Stop> {
        self.run_step(StepBy::Scan)
    }

    /// Goes a step on, into functions and the bodies of user-defined blocks too, unless a breakpoint stops it before.
    /// Begins a scan if none is open. None if the scan came to its end.
    pub fn run_step(&mut self, by: StepBy) -> Option<Stop> {
        if self.breakpoints.is_empty() && by == StepBy::Scan {
            return (!self.scan()).then(|| self.why_not());
        }
        let fresh = !self.simulation.is_open();
        if !self.open_scan() {
            return Some(self.why_not());
        }
        if (fresh || self.unseen_network)
            && let Some(hit) = self.hit_here()
        {
            self.unseen_network = false;
            return Some(Stop::Breakpoint(hit));
        }
        self.simulation.machine.pass_stops();
        let until = self.until(by);
        loop {
            let before = self.watched_values();
            let block = self.simulation.next_block();
            let stepped = self.go_on(until);
            if let Some(hit) = self.change_hit(before, block) {
                self.unseen_network = self.simulation.is_open();
                return Some(Stop::Breakpoint(hit));
            }
            match stepped {
                Stepped::Done => return None,
                Stepped::Stopped => return Some(self.why_not()),
                Stepped::At(location) => {
                    if let Some(hit) = self.hit_here() {
                        return Some(Stop::Breakpoint(hit));
                    }
                    if self.ends_step(by) {
                        return Some(Stop::At(location));
                    }
                }
            }
        }
    }

    /// Whether the scan that is open has halted where a network begins.
    pub fn is_in_front_of_network(&self) -> bool {
        self.simulation.is_open() && self.ends_step(StepBy::Network)
    }

    /// How far the machine runs at once.
    fn until(&self, by: StepBy) -> Until {
        let looks_at_blocks = |breakpoint: &Breakpoint| !matches!(breakpoint, Breakpoint::Network(_));
        if self.breakpoints.iter().any(looks_at_blocks) {
            return Until::BlockOrNetwork;
        }
        match by {
            StepBy::Block if self.breakpoints.is_empty() => Until::Block,
            StepBy::Block => Until::BlockOrNetwork,
            StepBy::Network | StepBy::Scan => Until::Network,
        }
    }

    /// Whether what is here ends a step.
    fn ends_step(&self, by: StepBy) -> bool {
        let pc = self.simulation.machine.open_scan().pc();
        let code = &self.simulation.compiled.code;
        match by {
            StepBy::Block => code.block_from(pc).is_some(),
            StepBy::Network => code.networks_at(pc).next().is_some(),
            StepBy::Scan => false,
        }
    }

    fn why_not(&self) -> Stop {
        match self.simulation.status() {
            Status::Ended => Stop::Ended,
            Status::Faulted => Stop::Faulted,
            // The scan was cancelled, and taken back.
            Status::Ready => Stop::Cancelled,
        }
    }

    /// The network or block with a breakpoint that runs next.
    fn hit_here(&self) -> Option<Hit> {
        let pc = self.simulation.machine.open_scan().pc();
        let code = &self.simulation.compiled.code;
        let is_set = |breakpoint| self.breakpoints.contains(&breakpoint);
        if let Some(network) = code
            .networks_at(pc)
            .find(|&network| is_set(Breakpoint::Network(network)))
        {
            return Some(Hit::Network(self.simulation.program().networks[network].location));
        }
        let block = code.block_from(pc)?.location;
        is_set(Breakpoint::Block(block)).then_some(Hit::Block(block))
    }

    fn watched_values(&self) -> Vec<Value> {
        self.watched().map(|point| self.simulation.value(point)).collect()
    }

    fn watched(&self) -> impl Iterator<Item = &Point> {
        self.breakpoints.iter().filter_map(|breakpoint| match breakpoint {
            Breakpoint::Change(point) => Some(point),
            Breakpoint::Network(_) | Breakpoint::Block(_) => None,
        })
    }

    fn change_hit(&self, before: Vec<Value>, block: Option<Location>) -> Option<Hit> {
        self.watched().zip(before).find_map(|(point, before)| {
            let after = self.simulation.value(point);
            (after != before).then(|| Hit::Change {
                point: point.clone(),
                before,
                after,
                block,
            })
        })
    }
}

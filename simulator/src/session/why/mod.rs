//! Why a tag holds what it holds: which block wrote it, in which scan, with which contacts closed, back to what was
//! given from outside; and for what is off, the contacts that block it.
//!
//! Nothing is recorded for this while scans run. The scan in question is restored from the history and run again, block
//! by block, until the last write of the tag has been seen.

mod place;
mod reasons;
mod text;
mod trace;

use super::Session;
use super::reach::Reach;
use crate::simulation::State;
use crate::tags::Point;
use ladder_analysis::program::{Location, Network, Role, Step};
use ladder_analysis::types::Scalar;
use ladder_analysis::value::Value;
use reasons::Blocker;
pub use text::Wording;
use trace::{Limit, Targets, Traced};

/// Why a point holds its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Why {
    /// The point.
    pub point: Point,
    /// What it holds.
    pub value: Value,
    /// Since when.
    pub since: Since,
    /// Through what: what happened then.
    pub cause: Cause,
    /// For what is off since an earlier scan: what keeps it off now, if a block still writes it in every scan.
    pub now: Option<Box<Write>>,
}

/// Since when a point holds its value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Since {
    /// It has held no other since the start.
    Start,
    /// Since before the kept scans.
    Longer,
    /// Since this scan.
    Scan {
        /// Its number, from 0.
        scan: u64,
        /// Its clock, in nanoseconds.
        time: i64,
    },
}

/// What made a point hold its value.
#[derive(Debug, Clone, PartialEq)]
pub enum Cause {
    /// Nothing has written it: it has its initial value.
    Initial,
    /// It was given from outside.
    Given,
    /// It is forced.
    Forced,
    /// The simulation itself keeps it: a system tag.
    System,
    /// What wrote it is not known any more: the scan is not kept, or a block's body did.
    Unknown,
    /// A block of the program wrote it.
    Block(Box<Write>),
}

/// A block that wrote a tag.
#[derive(Debug, Clone, PartialEq)]
pub struct Write {
    /// The scan in which it did, from 0.
    pub scan: u64,
    /// The block.
    pub block: Location,
    /// Whether power reached it.
    pub power: bool,
    /// With power: one list, of the blocks that passed it on, from left to right. Without: each list is one way in
    /// which power would reach the block, by letting it pass all blocks of the list; no list has more than it needs.
    pub reasons: Vec<Vec<Reason>>,
    /// What it made its result of, where it writes more than its power.
    pub read: Vec<(Point, Value)>,
    /// Why that was so, as far as it was followed.
    pub because: Vec<Why>,
}

/// A block that passes power on, or does not.
#[derive(Debug, Clone, PartialEq)]
pub struct Reason {
    /// The block; for a rail the network.
    pub block: Location,
    /// It is the left rail, which an `<MCR>` has switched off.
    pub is_rail: bool,
    /// What it looked at, with the values of that moment.
    pub values: Vec<(Point, Value)>,
    /// Why these were so, as far as that was followed.
    pub because: Vec<Why>,
}

/// So many scans are run again at most for one question.
const MOST_TRACES: usize = 60;
/// So far the chain is followed.
const DEEPEST: usize = 4;

/// A moment in the kept scans: an entry of the history, and there so many blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct When {
    reach: Reach,
    blocks: Limit,
}

impl Session {
    /// Why a point holds what it holds now.
    pub fn why(&mut self, point: &Point) -> Why {
        let state = self.simulation.state();
        let faults = self.simulation.machine.faults.len();
        // The scans that are run again here came to their end before.
        let brake = self.simulation.machine.brake.take();
        let mut inquiry = Inquiry {
            session: self,
            now: &state,
            traces: 0,
        };
        let when = inquiry.present();
        let why = inquiry.why(point, when, DEEPEST, &mut Vec::new());
        self.simulation.restore(&state);
        self.simulation.machine.faults.truncate(faults);
        self.simulation.machine.brake = brake;
        why
    }
}

struct Inquiry<'s> {
    session: &'s mut Session,
    now: &'s State,
    traces: usize,
}

impl Inquiry<'_> {
    fn present(&self) -> When {
        if self.session.simulation.is_open() {
            return When {
                reach: Reach::Open,
                blocks: Limit::of(&self.session.simulation),
            };
        }
        When {
            reach: Reach::Behind(self.session.history.behind()),
            blocks: Limit::End,
        }
    }

    /// `asked` are the points that this is asked for, with their values.
    fn why(&mut self, point: &Point, when: When, depth: usize, asked: &mut Vec<(Point, Value)>) -> Why {
        self.session.simulation.restore(self.now);
        let value = self.value_at(point, when);
        let forced = self.session.simulation.is_forced(point);
        let mut why = Why {
            point: point.clone(),
            value,
            since: Since::Longer,
            cause: Cause::Unknown,
            now: None,
        };
        let change = self.last_change(point, &why.value, when);
        why.since = match change {
            Change::Never => Since::Start,
            Change::NotKept => Since::Longer,
            Change::Given(entry) | Change::In(entry) => self.scan_of(entry),
        };
        if forced {
            why.cause = Cause::Forced;
            return why;
        }
        if point.is_system() {
            why.cause = Cause::System;
            return why;
        }
        let targets = Targets::of(&self.session.simulation, point);
        if targets.is_empty() {
            why.cause = match change {
                Change::Never => Cause::Initial,
                Change::NotKept if point.role == Role::Input => Cause::Given,
                Change::NotKept | Change::In(_) => Cause::Unknown,
                Change::Given(_) => Cause::Given,
            };
            return why;
        }
        asked.push((point.clone(), why.value.clone()));
        let changed_in = match change {
            Change::In(entry) => Some(self.end_of(entry, when)),
            _ => None,
        };
        why.cause = match changed_in.and_then(|changed| self.written(&targets, point, changed, depth, asked))
        {
            Some(write) => Cause::Block(Box::new(write)),
            None if matches!(change, Change::Given(_)) => Cause::Given,
            None => {
                // Not written yet at this moment of the scan: in the one before.
                let before = (when.blocks != Limit::End).then(|| self.before(when)).flatten();
                let moments = [Some(when), before].into_iter().flatten();
                let write = moments
                    .filter(|&moment| Some(moment) != changed_in)
                    .find_map(|moment| self.written(&targets, point, moment, depth, asked));
                match write {
                    Some(write) => Cause::Block(Box::new(write)),
                    None if change == Change::Never => Cause::Initial,
                    None => Cause::Unknown,
                }
            }
        };
        let off = point.ty == Scalar::Bool && why.value == Value::Bool(false);
        if off && depth == DEEPEST && changed_in.is_some_and(|changed| changed != when) {
            let now = self.written(&targets, point, when, depth, asked);
            let obstacles = |write: &Write| -> Vec<Vec<Location>> {
                let ways = write.reasons.iter();
                ways.map(|way| way.iter().map(|reason| reason.block).collect())
                    .collect()
            };
            let then = match &why.cause {
                Cause::Block(write) => obstacles(write),
                _ => Vec::new(),
            };
            why.now = now
                .filter(|now| !now.power && obstacles(now) != then)
                .map(Box::new);
        }
        asked.pop();
        why
    }

    /// The end of an entry's scan, but not behind a moment.
    fn end_of(&self, entry: usize, when: When) -> When {
        let reach = if entry == self.session.history.behind() {
            Reach::Open
        } else {
            Reach::Behind(entry + 1)
        };
        let blocks = if reach == when.reach {
            when.blocks
        } else {
            Limit::End
        };
        When { reach, blocks }
    }

    fn before(&self, when: When) -> Option<When> {
        let entries = match when.reach {
            Reach::Open => self.session.history.behind(),
            Reach::Behind(entries) => entries.checked_sub(1)?,
        };
        (entries > 0).then_some(When {
            reach: Reach::Behind(entries),
            blocks: Limit::End,
        })
    }

    fn written(
        &mut self,
        targets: &Targets,
        point: &Point,
        when: When,
        depth: usize,
        asked: &mut Vec<(Point, Value)>,
    ) -> Option<Write> {
        let (traced, scan) = self.trace(targets, point, when)?;
        let program = self.session.simulation.program().clone();
        let network = &program.networks[traced.network];
        let block = &network.blocks[traced.block];
        let lists: Vec<Vec<Blocker>> = if traced.power {
            vec![reasons::passed(network, traced.en, &traced.powers)]
        } else {
            reasons::missing(network, traced.en, &traced.powers, &traced.conducts)
        };
        let mut ways = Vec::with_capacity(lists.len());
        for list in lists {
            let mut way = Vec::with_capacity(list.len());
            for blocker in list {
                way.push(self.reason(network, &traced, blocker, when.reach, depth, asked));
            }
            ways.push(way);
        }
        // What a coil writes is its power; other blocks write what they make of their operands.
        let of_itself =
            |(read, _): &(Point, Value)| place::tag_of(&self.session.simulation, read) == targets.tag;
        let mut read = traced.values.get(&traced.block).cloned().unwrap_or_default();
        read.retain(|value| !of_itself(value));
        let because = if traced.power {
            self.because(&read, traced.moment(traced.block, when.reach), depth, asked)
        } else {
            read.clear();
            Vec::new()
        };
        Some(Write {
            scan,
            block: block.location,
            power: traced.power,
            reasons: ways,
            read,
            because,
        })
    }

    fn reason(
        &mut self,
        network: &Network,
        traced: &Traced,
        blocker: Blocker,
        reach: Reach,
        depth: usize,
        asked: &mut Vec<(Point, Value)>,
    ) -> Reason {
        let Blocker::Block(index) = blocker else {
            return Reason {
                block: network.location,
                is_rail: true,
                values: Vec::new(),
                because: Vec::new(),
            };
        };
        let mut looked_at = vec![index];
        let en = network.steps.iter().find_map(|step| match *step {
            Step::Block { block, en } if block == index => Some(en),
            _ => None,
        });
        if let Some(en) = en
            && reasons::inverts(network, index)
            && traced.powers[en]
        {
            // It passes nothing on because power reaches it.
            looked_at = reasons::passed(network, en, &traced.powers)
                .into_iter()
                .filter_map(|blocker| match blocker {
                    Blocker::Block(index) => Some(index),
                    Blocker::Rail => None,
                })
                .collect();
        }
        let mut values = Vec::new();
        let mut because = Vec::new();
        for index in looked_at {
            let of_block = traced.values.get(&index).cloned().unwrap_or_default();
            because.extend(self.because(&of_block, traced.moment(index, reach), depth, asked));
            values.extend(of_block);
        }
        Reason {
            block: network.blocks[index].location,
            is_rail: false,
            values,
            because,
        }
    }

    /// Why points had their values at a moment.
    fn because(
        &mut self,
        values: &[(Point, Value)],
        when: When,
        depth: usize,
        asked: &mut Vec<(Point, Value)>,
    ) -> Vec<Why> {
        let mut because = Vec::new();
        for value in values.iter().filter(|_| depth > 0) {
            // A seal-in asks for itself.
            if !asked.contains(value) {
                because.push(self.why(&value.0, when, depth - 1, asked));
            }
        }
        because
    }

    /// The last write of a point at a moment, and the number of the scan.
    fn trace(&mut self, targets: &Targets, point: &Point, when: When) -> Option<(Traced, u64)> {
        if self.traces == MOST_TRACES || !self.go_to_start(when.reach) {
            return None;
        }
        self.traces += 1;
        let scan = self.session.simulation.scans();
        let traced = trace::last_write(&mut self.session.simulation, targets, point, when.blocks)?;
        Some((traced, scan))
    }

    fn scan_of(&self, entry: usize) -> Since {
        let (scan, time) = self.session.history.clock_before(entry);
        Since::Scan { scan, time }
    }

    /// What a point holds at a moment.
    fn value_at(&mut self, point: &Point, when: When) -> Value {
        if when == self.present() {
            return self.session.simulation.value(point);
        }
        if self.go_to_start(when.reach) {
            trace::run_up_to(&mut self.session.simulation, when.blocks);
        }
        self.session.simulation.value(point)
    }

    /// Stands at the start of a scan, with what was given for it.
    fn go_to_start(&mut self, reach: Reach) -> bool {
        let simulation = &mut self.session.simulation;
        simulation.open = false;
        simulation.machine.faults.clear();
        self.session.history.put_at_start(reach, simulation)
    }

    /// When a point took on the value that it has at a moment.
    fn last_change(&mut self, point: &Point, value: &Value, when: When) -> Change {
        self.session
            .history
            .last_change(when.reach, when.blocks == Limit::End, |memory| {
                point.read(memory) == *value
            })
    }
}

/// When a value came to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// It was there at the start.
    Never,
    /// Before the kept scans.
    NotKept,
    /// Given from outside before the scan of this entry of the history; or before the next scan, which is not run yet.
    Given(usize),
    /// In the scan of this entry; or in the one that is open.
    In(usize),
}

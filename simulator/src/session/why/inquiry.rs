//! How the reasons are found: questions that go back in time, and one way back over the kept scans for all of them.
//!
//! ```text
//! question --value was another before scan e--> changed in e --that scan again--> the block, and new questions in e
//!        \--it never was another--> the scan of the question again --> the block that keeps it so, and new questions
//! ```
//!
//! Every question is about a moment, and its answer lies at that moment or before it. So the scans are gone back over
//! once, with all questions that are open, instead of once for each. A question whose tag has never changed refers to a
//! scan that was passed by already; such scans wait for the next way back, of which there are few.

use super::question::{Change, Found, FoundReason, FoundWrite, Question, When, before, written_out};
use super::reasons::{self, Blocker};
use super::trace::{self, Limit, Traced};
use super::writers::Writers;
use super::{Cause, Why};
use crate::places::BlockAt;
use crate::session::history::History;
use crate::session::rewind::Rewind;
use crate::session::touched::Cells;
use crate::simulation::Simulation;
use crate::tags::Point;
use ladder_analysis::program::Network;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use std::ops::Range;

/// This many scans are run again at most for one question.
const MOST_TRACES: usize = 60;
/// So far the chain is followed.
const DEEPEST: usize = 4;

/// A scan that is to be run again for a question.
#[derive(Debug)]
struct Job {
    question: usize,
    when: When,
    purpose: Purpose,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Purpose {
    /// Which block wrote it, where its value did not change.
    Cause,
    /// What keeps it off now.
    Now,
}

pub(in crate::session) struct Inquiry<'s> {
    simulation: &'s mut Simulation,
    history: &'s History,
    writers: &'s Writers,
    traces: usize,
    /// This many kept scans, and spans of such, were gone back over.
    scans: usize,
    questions: Vec<Question>,
    /// Those whose last change is looked for on this way back.
    open: Vec<usize>,
    jobs: Vec<Job>,
}

impl Inquiry<'_> {
    /// Why a point holds what it holds now, and how many kept scans were gone back over for it. The simulation is left
    /// anywhere.
    pub(in crate::session) fn answer(
        simulation: &mut Simulation,
        history: &History,
        writers: &Writers,
        point: &Point,
    ) -> (Why, usize) {
        let when = if simulation.is_open() {
            Some(When {
                entry: history.here,
                limit: Limit::of(simulation),
            })
        } else {
            history.here.checked_sub(1).map(|entry| When {
                entry,
                limit: Limit::End,
            })
        };
        let value = simulation.value(point);
        let present = Rewind::new(history, simulation);
        let mut inquiry = Inquiry {
            simulation,
            history,
            writers,
            traces: 0,
            scans: 0,
            questions: Vec::new(),
            open: Vec::new(),
            jobs: Vec::new(),
        };
        inquiry.ask(point, value, when, None, DEEPEST);
        while !inquiry.is_done() {
            inquiry.go_back(&mut present.clone());
        }
        let mut questions = inquiry.questions.into_iter().map(Some).collect::<Vec<_>>();
        (written_out(&mut questions, history, 0), inquiry.scans)
    }

    fn is_done(&self) -> bool {
        self.open.is_empty() && self.jobs.is_empty()
    }

    /// Whether further back there is nothing to find: scans that were passed by wait for the next way back.
    fn is_done_before(&self, entry: usize) -> bool {
        self.open.is_empty() && self.jobs.iter().all(|job| job.when.entry >= entry)
    }

    /// One way back over the kept scans, as far as there is anything to find.
    fn go_back(&mut self, rewind: &mut Rewind<'_>) {
        loop {
            self.at_start(rewind);
            rewind.undo_given();
            self.at_end_before(rewind);
            if self.is_done_before(rewind.entry()) {
                break;
            }
            self.scans += rewind.undo_spans(|cells, entries| self.passes(cells, &entries));
            if !rewind.undo_scan() {
                break;
            }
            self.scans += 1;
        }
        for question in std::mem::take(&mut self.open) {
            let change = if self.history.is_on() && self.history.base.scan == 0 {
                Change::Never
            } else {
                Change::NotKept
            };
            self.has_not_changed(question, change);
        }
    }

    /// Whether nothing is to be found in a span of scans that has changed these cells.
    fn passes(&self, cells: &Cells, entries: &Range<usize>) -> bool {
        let is_touched = |question: &usize| cells.hold(&self.questions[*question].point);
        let is_looked_at = |job: &Job| entries.contains(&job.when.entry);
        !self.open.iter().any(is_touched) && !self.jobs.iter().any(is_looked_at)
    }

    /// The start of a scan, with what was given for it: what was another value here has changed in this scan.
    fn at_start(&mut self, rewind: &Rewind<'_>) {
        let entry = rewind.entry();
        let mut at = 0;
        loop {
            if let Some(job) = self.jobs.iter().position(|job| job.when.entry == entry) {
                let job = self.jobs.swap_remove(job);
                self.do_job(rewind, job);
                continue;
            }
            let Some(&question) = self.open.get(at) else {
                return;
            };
            let this = &self.questions[question];
            // The value of now is not that of a scan that has not begun.
            let is_run = entry < self.history.here || self.simulation_was_open(this);
            if is_run && rewind.value(&this.point) != this.value {
                self.open.swap_remove(at);
                self.has_changed_in(rewind, question);
            } else {
                at += 1;
            }
        }
    }

    /// Whether a kept scan can have changed what a question is about: if none has there is nothing to go back for.
    fn has_changed_since_base(&self, question: usize) -> bool {
        let point = &self.questions[question].point;
        self.history.touched.holds_since(point, self.history.base.scan)
    }

    fn simulation_was_open(&self, question: &Question) -> bool {
        question.when.is_some_and(|when| when.entry == self.history.here)
    }

    /// The end of a scan: what was another value here was given after it.
    fn at_end_before(&mut self, rewind: &Rewind<'_>) {
        let entry = rewind.entry();
        let mut at = 0;
        while let Some(&question) = self.open.get(at) {
            let this = &mut self.questions[question];
            if rewind.value(&this.point) != this.value {
                self.open.swap_remove(at);
                this.change = Change::Given(entry);
                if this.takes_a_cause() {
                    this.cause = Found::Plain(Cause::Given);
                }
            } else if self.history.is_on() && !self.has_changed_since_base(question) {
                self.open.swap_remove(at);
                let has_changed = self.history.touched.holds(&self.questions[question].point);
                let change = if self.history.is_from_the_start && !has_changed {
                    Change::Never
                } else {
                    Change::NotKept
                };
                self.has_not_changed(question, change);
            } else {
                at += 1;
            }
        }
    }

    fn ask(
        &mut self,
        point: &Point,
        value: Value,
        when: Option<When>,
        asker: Option<usize>,
        depth: usize,
    ) -> usize {
        let forced = self.simulation.is_forced(point);
        let cause = match () {
            () if forced => Cause::Forced,
            () if point.is_system() => Cause::System,
            () => Cause::Unknown,
        };
        self.questions.push(Question {
            point: point.clone(),
            value,
            when,
            asker,
            depth,
            forced,
            change: Change::NotKept,
            cause: Found::Plain(cause),
            now: None,
        });
        let question = self.questions.len() - 1;
        if self.history.is_on() {
            self.open.push(question);
        } else {
            self.has_not_changed(question, Change::NotKept);
        }
        question
    }

    /// It changed in the scan at whose start this is.
    fn has_changed_in(&mut self, rewind: &Rewind<'_>, question: usize) {
        let entry = rewind.entry();
        let this = &mut self.questions[question];
        this.change = Change::In(entry);
        if !this.takes_a_cause() || self.blocks_for(question).is_empty() {
            return;
        }
        let this = &self.questions[question];
        let Some(when) = this.when else { return };
        let changed = When {
            entry,
            limit: if entry == when.entry {
                when.limit
            } else {
                Limit::End
            },
        };
        let is_off = this.point.ty == Scalar::Bool && this.value == Value::Bool(false);
        let is_later = changed != when;
        if is_off && is_later && this.asker.is_none() {
            self.jobs.push(Job {
                question,
                when,
                purpose: Purpose::Now,
            });
        }
        match self.written(rewind, question, changed) {
            Some(write) => self.questions[question].cause = Found::Block(write),
            None if is_later => self.look_in(question, when),
            None => {
                if let Some(before) = before(when) {
                    self.look_in(question, before);
                }
            }
        }
    }

    /// It held its value before, as far as is known.
    fn has_not_changed(&mut self, question: usize, change: Change) {
        self.questions[question].change = change;
        if !self.questions[question].takes_a_cause() {
            return;
        }
        let has_writers = !self.blocks_for(question).is_empty();
        let this = &mut self.questions[question];
        this.cause = Found::Plain(match change {
            Change::Never => Cause::Initial,
            _ if !has_writers && this.point.is_input => Cause::Given,
            _ => Cause::Unknown,
        });
        if let Some(when) = this.when
            && has_writers
        {
            self.look_in(question, when);
        }
    }

    /// Which block wrote it is to be found in that scan.
    fn look_in(&mut self, question: usize, when: When) {
        self.jobs.push(Job {
            question,
            when,
            purpose: Purpose::Cause,
        });
    }

    fn do_job(&mut self, rewind: &Rewind<'_>, job: Job) {
        let write = self.written(rewind, job.question, job.when);
        match (write, job.purpose) {
            (Some(write), Purpose::Cause) => self.questions[job.question].cause = Found::Block(write),
            // It was not written yet at this moment of the scan: in the one before.
            (None, Purpose::Cause) => {
                if let Some(before) = before(job.when)
                    && self.questions[job.question].change != Change::In(before.entry)
                {
                    self.look_in(job.question, before);
                }
            }
            (write, Purpose::Now) => self.questions[job.question].now = write.filter(|write| !write.power),
        }
    }

    /// The blocks that may write what a question is about.
    fn blocks_for(&self, question: usize) -> Vec<BlockAt> {
        self.writers
            .of_point(self.simulation, &self.questions[question].point)
    }

    /// The last write in the scan at whose start this is, up to a moment.
    fn written(&mut self, rewind: &Rewind<'_>, question: usize, when: When) -> Option<FoundWrite> {
        if self.traces == MOST_TRACES {
            return None;
        }
        self.traces += 1;
        let point = self.questions[question].point.clone();
        let tag = self.writers.tag_of(&point);
        let blocks = self.blocks_for(question);
        self.simulation.open = false;
        self.simulation.machine.faults.clear();
        rewind.restore(self.simulation);
        let scan = self.simulation.scans();
        let traced = trace::last_write(self.simulation, self.writers, &blocks, &point, when.limit)?;
        let program = self.simulation.program().clone();
        let network = &program.networks[traced.at.network];
        let lists = traced.ways(network);
        let mut ways = Vec::with_capacity(lists.len());
        for list in lists {
            let mut way = Vec::with_capacity(list.len());
            for blocker in list {
                way.push(self.reason(network, &traced, blocker, when.entry, question));
            }
            ways.push(way);
        }
        // What a coil writes is its power; other blocks write what they make of their operands.
        let of_itself = |(read, _): &(Point, Value)| {
            *read == point || (tag.is_some() && self.writers.tag_of(read) == tag)
        };
        let mut read = traced.read.clone();
        read.retain(|value| !of_itself(value));
        let because = if traced.power {
            self.because(&read, &traced, traced.at.block, when.entry, question)
        } else {
            read.clear();
            Vec::new()
        };
        Some(FoundWrite {
            scan,
            block: network.blocks[traced.at.block].location,
            called: traced.called,
            power: traced.power,
            ways,
            indices: traced.indices,
            read,
            because,
        })
    }

    fn reason(
        &mut self,
        network: &Network,
        traced: &Traced,
        blocker: Blocker,
        entry: usize,
        asker: usize,
    ) -> FoundReason {
        let Blocker::Block(index) = blocker else {
            return FoundReason {
                block: network.location,
                is_rail: true,
                values: Vec::new(),
                because: Vec::new(),
            };
        };
        let mut values = Vec::new();
        let mut because = Vec::new();
        for index in reasons::deciding(network, index, &traced.powers) {
            let of_block = traced.values.get(&index).cloned().unwrap_or_default();
            because.extend(self.because(&of_block, traced, index, entry, asker));
            values.extend(of_block);
        }
        FoundReason {
            block: network.blocks[index].location,
            is_rail: false,
            values,
            because,
        }
    }

    /// Why points had their values when a block had run. That a constant has its value is no news.
    fn because(
        &mut self,
        values: &[(Point, Value)],
        traced: &Traced,
        block: usize,
        entry: usize,
        asker: usize,
    ) -> Vec<usize> {
        let depth = self.questions[asker].depth;
        let Some(&limit) = traced.positions.get(&block) else {
            return Vec::new();
        };
        let mut because = Vec::new();
        let news = values
            .iter()
            .filter(|(point, _)| depth > 0 && !point.is_constant());
        for (point, value) in news {
            // A seal-in asks for itself.
            if !self.is_asked(asker, point, value) {
                let when = Some(When { entry, limit });
                because.push(self.ask(point, value.clone(), when, Some(asker), depth - 1));
            }
        }
        because
    }

    /// Whether a question, or one that led to it, is this very one.
    fn is_asked(&self, question: usize, point: &Point, value: &Value) -> bool {
        let this = &self.questions[question];
        (this.point == *point && this.value == *value)
            || this.asker.is_some_and(|asker| self.is_asked(asker, point, value))
    }
}

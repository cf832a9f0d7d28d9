//! The questions of an [`Inquiry`](super::inquiry::Inquiry), what is known of their answers, and these written out as a tree.

use super::trace::Limit;
use super::{Cause, Reason, Since, Why, Write};
use crate::session::history::History;
use crate::tags::Point;
use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;

/// A moment in a scan: an entry of the history, or the one that is open, and how far it had come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct When {
    pub(super) entry: usize,
    pub(super) limit: Limit,
}

/// Why a point had a value at a moment.
#[derive(Debug)]
pub(super) struct Question {
    pub(super) point: Point,
    pub(super) value: Value,
    /// Before the first scan there is no moment.
    pub(super) when: Option<When>,
    /// The question that led to this one.
    pub(super) asker: Option<usize>,
    pub(super) depth: usize,
    pub(super) forced: bool,
    pub(super) change: Change,
    pub(super) cause: Found,
    pub(super) now: Option<FoundWrite>,
}

/// When a value came to be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// It was there at the start.
    Never,
    /// Before the kept scans; also as long as it was not looked for.
    NotKept,
    /// Given from outside before the scan of this entry of the history; or before the next scan, which is not run yet.
    Given(usize),
    /// In the scan of this entry; or in the one that is open.
    In(usize),
}

#[derive(Debug)]
pub(super) enum Found {
    Plain(Cause),
    Block(FoundWrite),
}

/// As [`Write`], with questions where that has their answers.
#[derive(Debug)]
pub(super) struct FoundWrite {
    pub(super) scan: u64,
    pub(super) block: Location,
    pub(super) called: Option<Location>,
    pub(super) power: bool,
    pub(super) ways: Vec<Vec<FoundReason>>,
    pub(super) indices: Vec<(Point, Value)>,
    pub(super) read: Vec<(Point, Value)>,
    pub(super) because: Vec<usize>,
}

#[derive(Debug)]
pub(super) struct FoundReason {
    pub(super) block: Location,
    pub(super) is_rail: bool,
    pub(super) values: Vec<(Point, Value)>,
    pub(super) because: Vec<usize>,
}

impl Question {
    /// Whether it is for a block, or for the outside, to have given the value.
    pub(super) fn takes_a_cause(&self) -> bool {
        !self.forced && !self.point.is_system()
    }
}

/// The scan before a moment within one.
pub(super) fn before(when: When) -> Option<When> {
    let entry = when.entry.checked_sub(1).filter(|_| when.limit != Limit::End)?;
    Some(When {
        entry,
        limit: Limit::End,
    })
}

/// The tree of a question and those that it led to.
pub(super) fn written_out(questions: &mut [Option<Question>], history: &History, question: usize) -> Why {
    let Question {
        point,
        value,
        change,
        cause,
        now,
        ..
    } = questions[question].take().expect("each question is asked by one");
    let since = match change {
        Change::Never => Since::Start,
        Change::NotKept => Since::Longer,
        Change::Given(entry) | Change::In(entry) => {
            let (scan, time) = history.clock_before(entry);
            Since::Scan { scan, time }
        }
    };
    let cause = match cause {
        Found::Plain(cause) => cause,
        Found::Block(write) => Cause::Block(Box::new(write_of(questions, history, write))),
    };
    let now = now.map(|now| Box::new(write_of(questions, history, now)));
    let then = match &cause {
        Cause::Block(write) => obstacles(write),
        _ => Vec::new(),
    };
    Why {
        point,
        value,
        since,
        now: now.filter(|now| obstacles(now) != then),
        cause,
    }
}

fn obstacles(write: &Write) -> Vec<Vec<Location>> {
    let ways = write.reasons.iter();
    ways.map(|way| way.iter().map(|reason| reason.block).collect())
        .collect()
}

fn write_of(questions: &mut [Option<Question>], history: &History, found: FoundWrite) -> Write {
    let mut answers = |because: Vec<usize>| -> Vec<Why> {
        let answers = because.into_iter();
        answers
            .map(|question| written_out(questions, history, question))
            .collect()
    };
    let ways = found.ways.into_iter();
    let reasons = ways
        .map(|way| {
            let reasons = way.into_iter().map(|reason| Reason {
                block: reason.block,
                is_rail: reason.is_rail,
                values: reason.values,
                because: answers(reason.because),
            });
            reasons.collect()
        })
        .collect();
    Write {
        scan: found.scan,
        block: found.block,
        called: found.called,
        power: found.power,
        reasons,
        indices: found.indices,
        read: found.read,
        because: answers(found.because),
    }
}

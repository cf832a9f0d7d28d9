//! The properties that a program which is debugged is watched for.

use std::collections::VecDeque;

use ladder_simulator::Session;
use ladder_simulator::scenario::{self, Form, Memory, Monitor, Outside, ScenarioError, Suite, Watched};
use ladder_simulator::value_text;
use ladder_syntax::TextRange;

use crate::sources::Source;

/// So many changes of what is known of the past are kept, for going back. Further back nothing is known of the scans before.
const MOST_KEPT: usize = 10_000;
/// A violated property is shown with what so many of its tags are.
const MOST_SHOWN: usize = 8;

/// The properties of a file, watched from scan to scan.
#[derive(Debug)]
pub(crate) struct Properties {
    pub file: Source,
    pub suite: Suite,
    watched: Watched,
    /// What is known before a scan, and before those that follow up to the next entry.
    known: VecDeque<(u64, Known)>,
    /// The scan that is expected next.
    next: u64,
}

/// What is known of the scans before.
#[derive(Debug, Clone, PartialEq, Default)]
struct Known {
    memory: Memory,
    /// Which properties the last of them violated.
    violated: Vec<bool>,
    /// One of them did not keep what is assumed.
    is_outside: bool,
}

/// What is to be told of a scan.
#[derive(Debug)]
pub(crate) enum Remark {
    /// A property is violated that was not in the scan before: in words, and where it has its name.
    Violated(String, TextRange),
    /// It does not keep what is assumed, in words.
    Outside(String),
}

impl Properties {
    /// Binds the properties of a file; none if it has none.
    ///
    /// # Errors
    ///
    /// What is wrong in the file.
    pub(crate) fn bind(
        file: Source,
        suite: Suite,
        session: &Session,
    ) -> Result<Option<Properties>, Vec<ScenarioError>> {
        let (watched, found) = scenario::bind_properties(&suite, session.simulation());
        let errors: Vec<ScenarioError> = suite.errors.iter().cloned().chain(found).collect();
        if !errors.is_empty() {
            return Err(errors);
        }
        let is_empty = watched.properties.is_empty();
        Ok((!is_empty).then(|| Properties {
            file,
            suite,
            watched,
            known: VecDeque::new(),
            next: 0,
        }))
    }

    /// After a scan: what is to be told of it. A scan that was gone back to is watched from what was known there.
    pub(crate) fn after_scan(&mut self, session: &Session) -> Vec<Remark> {
        let Some(scan) = session.simulation().scans().checked_sub(1) else {
            return Vec::new();
        };
        let is_known = self.go_to(scan);
        let mut known = match self.known.back() {
            Some((_, known)) => known.clone(),
            None => Known::default(),
        };
        let mut remarks = Vec::new();
        if !known.is_outside {
            self.watch(session, scan, &mut known, &mut remarks);
        }
        if !is_known && scan > 0 {
            // Nobody knows what `was(e)` is in the first scan that is seen of a run: it counts for those that follow alone.
            remarks.clear();
            known = Known {
                memory: self.watched.memory(),
                ..Known::default()
            };
        }
        self.next = scan + 1;
        if self.known.back().is_none_or(|(_, before)| *before != known) {
            self.known.push_back((scan + 1, known));
        }
        if self.known.len() > MOST_KEPT {
            self.known.pop_front();
        }
        remarks
    }

    /// Knows what is known before a scan. False if nothing is.
    fn go_to(&mut self, scan: u64) -> bool {
        if scan == self.next && !self.known.is_empty() {
            return true;
        }
        let first = self.known.front().map_or(u64::MAX, |(first, _)| *first);
        let is_known = (first..=self.next).contains(&scan);
        if is_known {
            let after = self.known.partition_point(|(from, _)| *from <= scan);
            self.known.truncate(after);
        } else {
            self.known.clear();
            self.known.push_back((scan, Known::default()));
        }
        self.watched.restart();
        if let Some((_, known)) = self.known.back() {
            self.watched.remember(&known.memory);
        }
        is_known
    }

    fn watch(&mut self, session: &Session, scan: u64, known: &mut Known, remarks: &mut Vec<Remark>) {
        let simulation = session.simulation();
        let interval = simulation.options().interval;
        if !simulation.had_power() {
            self.watched.restart();
            known.memory = self.watched.memory();
            return;
        }
        if let Some(assumption) = self.watched.broken_assumption(simulation) {
            known.is_outside = true;
            let outside = Outside { assumption, scan };
            remarks.push(Remark::Outside(scenario::outside_sentence(
                &self.suite,
                &outside,
                interval,
            )));
            return;
        }
        let faulted = !session.faults_of(scan).is_empty();
        let properties = &mut self.watched.properties;
        known.violated.resize(properties.len(), false);
        for (property, was_violated) in properties.iter_mut().zip(&mut known.violated) {
            let is_found = property.violates(simulation, faulted);
            // What is to be possible somewhere need not be so here.
            let is_violated = is_found && !matches!(property.form, Form::Possible { .. });
            if is_violated && !*was_violated {
                let sentence = sentence(property, session, scan);
                remarks.push(Remark::Violated(sentence, property.range));
            }
            *was_violated = is_violated;
        }
        known.memory = self.watched.memory();
    }
}

/// `the property "not both" is violated in scan 3 (at 30ms): up is TRUE, down is TRUE`
fn sentence(property: &Monitor, session: &Session, scan: u64) -> String {
    let simulation = session.simulation();
    let mut text = scenario::violated_in_scan(&property.name, scan, None, simulation.options().interval);
    let points = property.points();
    let shown = points.iter().take(MOST_SHOWN).map(|point| {
        let value = value_text::display(&simulation.value(point), point.ty);
        format!("{} is {value}", point.name)
    });
    let shown: Vec<String> = shown.collect();
    if !shown.is_empty() {
        text.push_str(": ");
        text.push_str(&shown.join(", "));
    }
    text
}

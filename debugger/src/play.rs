//! A scenario that is debugged.

use ladder_simulator::Session;
use ladder_simulator::scenario::{self, Case, ScenarioError, Suite, Unmet};

use crate::once::Once;
use crate::sources::Source;

/// A scenario on its way.
#[derive(Debug)]
pub(crate) struct Play {
    pub file: Source,
    suite: Suite,
    pub case: Case,
    given: Once,
    /// What the program had sent through the serial port when the step began.
    sent_before: Vec<u8>,
    /// An expectation was not met.
    pub has_failed: bool,
}

impl Play {
    pub(crate) fn new(file: Source, suite: Suite, case: Case) -> Play {
        Play {
            file,
            suite,
            case,
            given: Once::default(),
            sent_before: Vec::new(),
            has_failed: false,
        }
    }

    /// Before a scan: gives what is before its step, unless the history gives it again.
    pub(crate) fn give(&mut self, session: &mut Session) {
        let scan = session.simulation().scans();
        let Some(step) = self.case.step_before(scan) else {
            return;
        };
        if !self.given.is_due(session) {
            return;
        }
        self.sent_before = session.serial();
        self.case.give(step, session);
    }

    /// The program has another text, and its tags other places.
    ///
    /// # Errors
    ///
    /// What the scenario names is not there any more.
    pub(crate) fn bind_again(&mut self, session: &Session) -> Result<(), Vec<ScenarioError>> {
        let (cases, errors) = scenario::bind(&self.suite, session.simulation());
        let same = cases.into_iter().find(|case| case.name == self.case.name);
        self.case = same.filter(|_| errors.is_empty()).ok_or(errors)?;
        Ok(())
    }

    /// What was given is given again where it is due.
    pub(crate) fn give_again(&mut self) {
        self.given = Once::default();
    }

    /// After a scan: what is not as expected, if a step ends here.
    pub(crate) fn unmet(&mut self, session: &Session) -> Vec<Unmet> {
        let scans = session.simulation().scans();
        let Some(step) = self.case.step_after(scans) else {
            return Vec::new();
        };
        let sent = session.serial();
        let during = sent.strip_prefix(self.sent_before.as_slice()).unwrap_or(&sent);
        let unmet = self.case.unmet(step, session.simulation(), during);
        self.has_failed |= !unmet.is_empty();
        unmet
    }

    /// Whether all of its steps have been run.
    pub(crate) fn is_over(&self, session: &Session) -> bool {
        session.simulation().scans() >= self.case.scans()
    }

    /// The step that a scan belongs to, from 0.
    pub(crate) fn step(&self, scan: u64) -> usize {
        self.case.step_at(scan)
    }
}

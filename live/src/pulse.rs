//! Pulses: a tag of BOOL that holds its other value for one scan, as if a user had touched a button.

use ladder_analysis::values::value::Value;

use crate::engine::{Engine, point};
use crate::request::Failure;

/// A tag that goes back when its scan is done.
#[derive(Debug)]
pub(crate) struct Pulse {
    tag: String,
    back: Value,
    /// This many scans are done then.
    until: u64,
}

impl Engine {
    /// Toggles a tag for the next scan.
    pub(crate) fn pulse(&mut self, tag: &str) -> Result<(), Failure> {
        let simulation = self.session.simulation();
        let point = point(simulation, tag)?;
        let Value::Bool(now) = simulation.value(&point) else {
            let ty = ladder_analysis::with_article(point.ty);
            let message = format!("{} is {ty}; only a tag of BOOL has pulses", point.name);
            return Err(Failure::Invalid(message));
        };
        if simulation.is_forced(&point) {
            let message = format!("{} is forced; release it first", point.name);
            return Err(Failure::Failed(message));
        }
        if self.pulses.iter().any(|pulse| pulse.tag == point.name) {
            return Ok(());
        }
        // What is set within a scan waits for its end.
        let until = simulation.scans() + 1 + u64::from(simulation.is_open());
        let set = self.session.set(&point, Value::Bool(!now));
        self.look_at_what_runs();
        set.map_err(|error| Failure::Failed(error.to_string()))?;
        self.pulses.push(Pulse {
            tag: point.name,
            back: Value::Bool(now),
            until,
        });
        Ok(())
    }

    /// Ends the pulses whose scan is done.
    pub(crate) fn end_pulses(&mut self) {
        let scans = self.session.simulation().scans();
        let (over, open) = std::mem::take(&mut self.pulses)
            .into_iter()
            .partition(|pulse| pulse.until <= scans);
        self.pulses = open;
        for Pulse { tag, back, .. } in over {
            // A change of the program may have taken it away, or its type.
            if let Ok(point) = self.session.simulation().resolve(&tag) {
                let _ = self.session.set(&point, back);
            }
        }
    }
}

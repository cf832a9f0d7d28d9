//! Beginning again: cold, or with what is retentive.

use super::{Simulation, Status};
use crate::memory::Memory;
use crate::retain::{self, Kept, Retained};
use crate::tags::Point;
use ladder_analysis::program::Program;
use ladder_analysis::values::value::Value;

impl Simulation {
    /// Begins again from cold: all tags as before the first scan. Forces stay.
    pub fn reset(&mut self) {
        self.restart(|_, _, _| ());
    }

    /// Begins again as after a power failure: retentive tags keep their values, all others begin as before the
    /// first scan. Forces stay. Plants begin again, too; in a session
    /// they go on.
    pub fn warm_restart(&mut self) {
        let (kept, then) = (self.machine.memory.clone(), self.machine.now);
        self.restart(|_, retained, memory| {
            for tag in retained {
                tag.restore(memory, &kept, then);
            }
        });
    }

    /// The same with values from outside, of this program or an older form of it. What cannot be used begins
    /// as before the first scan; for each such tag there is a sentence that says why.
    pub fn warm_start(&mut self, kept: &[Kept]) -> Vec<String> {
        self.restart(|program, retained, memory| retain::restore(program, retained, kept, memory))
    }

    /// What a warm restart would keep now, tag by tag: for a file.
    pub fn retained(&self) -> Vec<Kept> {
        retain::kept(
            &self.program,
            &self.compiled.retained,
            &self.machine.memory,
            self.machine.now,
        )
    }

    fn restart<T>(&mut self, keep: impl FnOnce(&Program, &[Retained], &mut Memory) -> T) -> T {
        // A scan that is open is given up.
        self.open = false;
        self.take_pending();
        let forced: Vec<(Point, Value)> = self
            .forces
            .values()
            .map(|force| (force.point.clone(), self.value(&force.point)))
            .collect();
        self.unforce_all();
        self.machine.restart(&self.compiled.initial);
        let kept = keep(&self.program, &self.compiled.retained, &mut self.machine.memory);
        self.status = Status::Ready;
        for (point, value) in forced {
            self.hold(point, value);
        }
        kept
    }
}

//! Steps, breakpoints, and the way back.

use super::app::App;
use super::plant::StepUnit;
use ladder_analysis::program::Location;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Breakpoint, Hit, Status, Stepped, value_text};

impl App<'_> {
    /// Whether the program can go on; if not, a message says so.
    fn is_ready(&mut self) -> bool {
        match self.plant.status() {
            Status::Ready => return true,
            Status::Ended => self
                .view
                .say("the program has ended: b goes back, c starts it again"),
            Status::Faulted => self
                .view
                .say("a fault has stopped the program: b goes back, c starts it again"),
        }
        false
    }

    /// One scan, or the rest of the one that is open.
    pub(super) fn step(&mut self) {
        if self.is_ready() {
            self.plant.scan();
        }
    }

    /// To the next block or rung.
    pub(super) fn step_part(&mut self, part: StepUnit) {
        if !self.is_ready() {
            return;
        }
        match self.plant.step(part) {
            Stepped::At(location) => self.show(location),
            Stepped::Done => self.view.say("the scan is over"),
            Stepped::Stopped => {
                self.is_ready();
            }
        }
    }

    /// To the scan before.
    pub(super) fn step_back(&mut self) {
        if !self.plant.step_back() {
            self.view.say(match self.plant.scans() {
                0 => "this is the beginning",
                _ => "no earlier scan is kept; [simulate] history in ladder.toml says how many are",
            });
        }
    }

    /// Selects the block at a place, or the first one after it.
    fn show(&mut self, location: Location) {
        if location.file != 0 {
            self.view.say("this runs in another file");
            return;
        }
        let block = self.plant.sheet.block_from(location.range.start().into());
        self.view.select(block, &self.plant);
    }

    /// Sets a breakpoint, or takes it away.
    pub(super) fn toggle(&mut self, breakpoint: Breakpoint) {
        let what = match &breakpoint {
            Breakpoint::Change(point) => format!("when {} changes", point.name),
            Breakpoint::Block(location) => {
                let place = self.plant.sheet.place(*location);
                format!("at the block in line {}", place.map_or(0, |(line, _)| line + 1))
            }
            Breakpoint::Network(network) => {
                let network = self.plant.simulation().program().networks.get(*network);
                let place = network.and_then(|network| self.plant.sheet.place(network.location));
                format!("at the rung in line {}", place.map_or(0, |(line, _)| line + 1))
            }
        };
        let is_set = self.plant.toggle_breakpoint(breakpoint);
        let verb = if is_set { "stops" } else { "no longer stops" };
        self.view.say(format!("the program {verb} {what}"));
    }

    /// A breakpoint has stopped the run.
    pub(super) fn stopped_at(&mut self, hit: Hit) {
        self.view.running = false;
        match hit {
            Hit::Block(location) => {
                self.show(location);
                self.view
                    .say("stopped before this block: . , s step on, p runs on");
            }
            Hit::Network(location) => {
                self.show(location);
                self.view
                    .say("stopped before this rung: . , s step on, p runs on, B takes the stop away");
            }
            Hit::Change {
                point,
                before,
                after,
                block,
            } => {
                if let Some(block) = block {
                    self.show(block);
                }
                let value = |value: &Value| value_text::display(value, point.ty);
                self.view.say(format!(
                    "stopped: here {} has changed from {} to {}",
                    point.name,
                    value(&before),
                    value(&after)
                ));
            }
        }
    }
}

//! The models of the machine that run beside the program, and what is connected.

use super::{Reader, as_written, file_of};
use crate::scenario::property::Written;
use crate::scenario::suite::{ConnectLine, PlantLine, connected, plant_named};
use crate::scenario::words::{Word, range};

impl Reader {
    /// `plant tank.clad`, `plant tank.clad as tank`.
    pub(super) fn plant(&mut self, first: Word, rest: &[Word]) {
        match file_of(rest) {
            Some((written, range)) => {
                let (file, name) = plant_named(&written);
                self.suite.plants.push(PlantLine {
                    file: file.to_owned(),
                    range,
                    name: name.to_owned(),
                });
            }
            None => self.error(
                first.range(),
                "the model of the machine is missing",
                "name its file, as in: plant tank.clad",
            ),
        }
    }

    /// `connect plant.sensor_1 = near`
    pub(super) fn connect(&mut self, first: Word, rest: &[Word]) {
        const EXAMPLE: &str = "write it as in: connect plant.sensor_1 = near";
        let (written, place) = as_written(rest).unwrap_or((String::new(), first.range()));
        let Some((one, other)) = connected(&written) else {
            return self.error(place, "a connection is between two tags", EXAMPLE);
        };
        let start = usize::from(place.start());
        let other_start = start + written.len() - other.len();
        let side = |text: &str, start: usize| Written {
            text: text.to_owned(),
            range: range(start, start + text.len()),
        };
        let sides = [side(one, start), side(other, other_start)];
        self.suite.connects.push(ConnectLine { sides, range: place });
    }
}

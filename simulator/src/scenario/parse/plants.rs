//! The models of the machine that run beside the program, and what is connected.

use super::{Reader, file_of};
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
        let written: Vec<&str> = rest.iter().map(|word| word.text).collect();
        let written = written.join(" ");
        let end = rest.last().map_or(first.end(), Word::end);
        let place = range(rest.first().map_or(first.start, |word| word.start), end);
        match connected(&written) {
            Some(sides) => self.suite.connects.push(ConnectLine { sides, range: place }),
            None => self.error(place, "a connection is between two tags", EXAMPLE),
        }
    }
}

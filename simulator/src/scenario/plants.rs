//! The plants of a file: what is wrong with them at its lines, and these lines once more.

use super::error::ScenarioError;
use super::record::file_line;
use super::suite::{PLANT, Suite};
use ladder_analysis::{Blames, PlantError};
use ladder_syntax::TextRange;

/// The lines about the program and what runs beside it.
pub fn head(suite: &Suite) -> String {
    let program = suite
        .program
        .iter()
        .map(|(name, _)| file_line("program", name, ""));
    let plants = suite.plants.iter().map(|plant| {
        let name = match plant.name.as_str() {
            PLANT => String::new(),
            name => format!(" as {name}"),
        };
        file_line("plant", &plant.file, &name)
    });
    let connects = suite.connects.iter();
    let connects = connects.map(|connect| format!("connect {} = {}\n", connect.sides.0, connect.sides.1));
    program.chain(plants).chain(connects).collect()
}

/// What is wrong with a plant or a connection, where the file names it.
pub fn plant_error(suite: &Suite, error: &PlantError) -> ScenarioError {
    let range = match error.blames {
        Blames::Plant(number) => suite.plants.get(number).map(|plant| plant.range),
        Blames::Connect(number) => suite.connects.get(number).map(|connect| connect.range),
    };
    ScenarioError::new(
        range.unwrap_or(TextRange::default()),
        error.message.clone(),
        error.help.clone(),
    )
}

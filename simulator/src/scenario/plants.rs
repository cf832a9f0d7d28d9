//! The plants of a file: what is wrong with them at its lines, and these lines once more.

use super::error::ScenarioError;
use super::record::file_line;
use super::suite::{PLANT, Suite};
use ladder_analysis::program::Program;
use ladder_analysis::{Blames, PlantError};
use ladder_syntax::TextRange;

/// The lines about the program and what runs beside it.
pub fn head(suite: &Suite) -> String {
    let program = suite
        .program
        .iter()
        .map(|(name, _)| file_line("program", name, ""));
    let plants = suite.plants.iter();
    let plants = plants.map(|plant| plant_line(&plant.file, &plant.name));
    let connects = suite.connects.iter().map(|connect| &connect.sides);
    let connects = connects.map(|[one, other]| connect_line(&one.text, &other.text));
    program.chain(plants).chain(connects).collect()
}

/// The same lines of a program that runs beside plants, in a file next to it.
pub(super) fn lines_of(program: &Program) -> String {
    let files = &program.files;
    let own = files.first().map_or("", String::as_str);
    let plants = program.plants.iter().filter_map(|plant| {
        let file = files.get(plant.file as usize)?;
        Some(plant_line(&seen_from(own, file), &plant.name))
    });
    let connects = program.plants.iter().flat_map(|plant| {
        let connections = plant.inputs.iter().chain(&plant.outputs);
        connections.filter_map(|it| {
            let [from, to] = [it.from, it.to].map(|tag| &*program.tags[tag.0 as usize].name);
            let of_plant = plant.tag_in(from).or_else(|| plant.tag_in(to))?;
            let by_name = [from, to].iter().any(|name| name.eq_ignore_ascii_case(of_plant));
            (!by_name).then(|| connect_line(from, to))
        })
    });
    plants.chain(connects).collect()
}

/// The name of a file, seen from the folder of another; both are seen from one folder.
fn seen_from(other: &str, file: &str) -> String {
    let folder = other.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut above = folder.split('/').filter(|name| !name.is_empty()).peekable();
    let mut below = file.split('/').peekable();
    while above.peek().is_some() && above.peek() == below.peek() {
        above.next();
        below.next();
    }
    let up = above.map(|_| "..");
    up.chain(below).collect::<Vec<_>>().join("/")
}

fn plant_line(file: &str, name: &str) -> String {
    let after = match name {
        PLANT => String::new(),
        name => format!(" as {name}"),
    };
    file_line("plant", file, &after)
}

fn connect_line(one: &str, other: &str) -> String {
    format!("connect {one} = {other}\n")
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

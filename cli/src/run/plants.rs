//! The models of its machine that run beside a program: options of `ladder sim`, else what the settings say.

use super::Stimulus;
use crate::findings::Source;
use crate::outcome::Failure;
use crate::terminal;
use clap::Args;
use ladder_analysis::{Blames, Connect};
use ladder_simulator::scenario::{connected, plant_named};
use ladder_simulator::{Inputs, Point, Simulation};
use ladder_workspace::{Settings, shown};
use std::path::{Path, PathBuf};

/// See the module.
#[derive(Debug, Default, Args)]
pub(crate) struct Plants {
    /// A model of the machine that runs beside the program: its outputs are inputs of the program and the reverse, where names and
    /// types are the same. `FILE as NAME` calls it otherwise than `plant`; may be given again [default: what ladder.toml says]
    #[arg(long, value_name = "FILE")]
    plant: Vec<String>,

    /// Connect a tag of the plant with one of the program though their names differ; may be given again
    #[arg(long, value_name = "TAG=TAG")]
    connect: Vec<String>,
}

impl Plants {
    /// One that is named, if any is.
    #[cfg(feature = "mcp")]
    pub(crate) fn named(plant: Option<String>) -> Plants {
        Plants {
            plant: Vec::from_iter(plant),
            connect: Vec::new(),
        }
    }

    /// The program beside those that are named; what the settings say does not count: values of a real machine come from no model.
    ///
    /// # Errors
    /// As [`Plants::beside`].
    pub(crate) fn named_beside(&self, source: Source) -> Result<Source, Failure> {
        if self.plant.is_empty() && self.connect.is_empty() {
            return Ok(source);
        }
        self.beside(source)
    }

    /// The program beside them.
    ///
    /// # Errors
    /// One of them cannot be read, or what is connected does not fit.
    pub(crate) fn beside(&self, source: Source) -> Result<Source, Failure> {
        let settings = Settings::of(Path::new(&source.file))?.simulate;
        let is_asked = !self.plant.is_empty();
        let named: Vec<(PathBuf, String)> = if is_asked {
            let named = self.plant.iter().map(|text| plant_named(text));
            named.map(|(file, name)| (file.into(), name.to_owned())).collect()
        } else {
            let plants = settings.plants_of(Path::new(&source.file)).iter();
            plants
                .map(|plant| (plant.file.path(), plant.name.clone()))
                .collect()
        };
        let connects = self.connects(if is_asked { &[] } else { &settings.connects })?;
        if named.is_empty() {
            return match self.connect.first() {
                None => Ok(source),
                Some(_) => Err(Failure::new(
                    "--connect is for a plant: name it, as in --plant tank.clad",
                )),
            };
        }
        let plants = named.iter().map(|(file, name)| {
            let bytes = ladder_workspace::read_bytes(file)?;
            let plant = Source::of_bytes(file, bytes, None)?.in_workspace()?;
            Ok((plant, name.clone()))
        });
        let plants = plants.collect::<Result<Vec<_>, Failure>>()?;
        let beside = source.beside(plants, connects.clone());
        if let Some(error) = beside.plant_errors().first() {
            let about = match error.blames {
                Blames::Plant(number) => shown::path(&named[number].0),
                Blames::Connect(number) => {
                    let (one, other) = &connects[number];
                    format!("{one} = {other}")
                }
            };
            return Err(Failure::new(format!(
                "{about}: {}: {}",
                error.message, error.help
            )));
        }
        // What the settings say is for all programs of the workspace, and some have nothing to do with the machine.
        match beside.program() {
            Ok(program) if !program.is_connected() && !is_asked => Ok(beside.alone()),
            _ => Ok(beside),
        }
    }

    fn connects(&self, others: &[Connect]) -> Result<Vec<Connect>, Failure> {
        let mut connects = others.to_vec();
        for text in &self.connect {
            let (one, other) = connected(text).ok_or_else(|| {
                Failure::new(format!(
                    "--connect {text}: a connection is between two tags, as in --connect plant.sensor_1=near"
                ))
            })?;
            connects.push((one.to_owned(), other.to_owned()));
        }
        Ok(connects)
    }
}

/// Says once which inputs of the plants neither the program nor what is given drives: there may be a slip in a name.
pub(crate) fn note_undriven(simulation: &Simulation, inputs: &Inputs, stimulus: &Stimulus) {
    let given = stimulus.named().filter_map(|name| simulation.resolve(name).ok());
    let given: Vec<Point> = given.chain(inputs.points().iter().cloned()).collect();
    let undriven = simulation.program().undriven().map(|tag| tag.name.as_str());
    let undriven: Vec<&str> = undriven
        .filter(|name| given.iter().all(|point| !point.is_in(name)))
        .collect();
    if !undriven.is_empty() {
        let undriven = undriven.join(", ");
        terminal::note(&format_args!("nothing drives {}", shown::line(&undriven)));
    }
}

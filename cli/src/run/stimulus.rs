//! What the world outside gives to a program that runs: options that several commands share.

use crate::outcome::Failure;
use crate::output::Existing;
use clap::Args;
use ladder_analysis::program::Program;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Inputs, Options, Point, Simulation, value_text};
use ladder_workspace::Settings;
use std::path::{Path, PathBuf};

/// The clock and the inputs of a run.
#[derive(Debug, Default, Args)]
pub(crate) struct Stimulus {
    /// The time from one scan to the next [default: what ladder.toml says, else the program, else 10ms]
    #[arg(long, value_name = "TIME", value_parser = interval)]
    dt: Option<i64>,

    /// A CSV file with the values that tags are set to before each scan
    #[arg(long, value_name = "FILE")]
    inputs: Option<PathBuf>,

    /// Set a tag before the first scan; may be given again
    #[arg(long, value_name = "TAG=VALUE")]
    set: Vec<String>,

    /// Hold a tag at a value during the whole run; may be given again. Alone, after everything else: replace the output
    /// file, whatever it is
    #[arg(long, value_name = "TAG=VALUE", num_args = 0..=1, default_missing_value = "")]
    force: Vec<String>,
}

impl Stimulus {
    /// Whether anything is given for a run.
    pub(crate) fn is_given(&self) -> bool {
        self.dt.is_some()
            || self.inputs.is_some()
            || !self.set.is_empty()
            || self.force.iter().any(|text| !text.is_empty())
    }

    /// How the program of a file is run: as its workspace has it, unless the command line says otherwise.
    ///
    /// # Errors
    /// The workspace's settings cannot be read.
    pub(crate) fn options(&self, file: &Path, program: &Program) -> Result<Options, Failure> {
        let settings = Settings::of(file)?.simulate.options(program, file);
        if self.dt.is_some() && program.has_tasks() {
            return Err(Failure::new(
                "--dt is not for a project: its tasks say how often each program runs",
            ));
        }
        Ok(Options {
            interval: self.dt.unwrap_or(settings.interval),
            ..settings
        })
    }

    /// What is to become of an output file that is there: `--force` alone says it.
    pub(crate) fn existing(&self) -> Existing {
        Existing::by(self.force.iter().any(String::is_empty))
    }

    /// Sets and forces what is asked for before the first scan, and reads what is given later.
    ///
    /// # Errors
    /// A tag is not there or cannot be written, a value is not of its type, or the file cannot be read.
    pub(crate) fn give(&self, simulation: &mut Simulation) -> Result<Inputs, Failure> {
        let inputs = match &self.inputs {
            Some(file) => {
                let text = ladder_workspace::read(file)?;
                Inputs::parse(&file.display().to_string(), &text, simulation)
                    .map_err(|error| Failure::new(error.to_string()))?
            }
            None => Inputs::default(),
        };
        for text in &self.set {
            let (point, value) = assignment("--set", text, simulation)?;
            simulation
                .set(&point, value)
                .map_err(|refused| Failure::new(format!("--set {text}: {refused}")))?;
        }
        for text in self.force.iter().filter(|text| !text.is_empty()) {
            let (point, value) = assignment("--force", text, simulation)?;
            simulation
                .force(&point, value)
                .map_err(|refused| Failure::new(format!("--force {text}: {refused}")))?;
        }
        Ok(inputs)
    }
}

impl Stimulus {
    /// The tags that `--set` and `--force` are about, as they are written.
    pub(crate) fn named(&self) -> impl Iterator<Item = &str> {
        let texts = self.set.iter().chain(&self.force);
        texts.filter_map(|text| Some(text.split_once('=')?.0))
    }
}

/// `start=1`
fn assignment(option: &str, text: &str, simulation: &Simulation) -> Result<(Point, Value), Failure> {
    let failure = |problem: &str| Failure::new(format!("{option} {text}: {problem}"));
    let (tag, value) = text
        .split_once('=')
        .ok_or_else(|| failure("write it TAG=VALUE, for example start=1"))?;
    let point = simulation
        .resolve(tag)
        .map_err(|unknown| failure(&unknown.to_string()))?;
    let value = value_text::parse(value, point.ty).map_err(|problem| failure(&problem))?;
    Ok((point, value))
}

/// The interval, in nanoseconds.
fn interval(text: &str) -> Result<i64, String> {
    match value_text::parse(text, Scalar::Time)? {
        Value::Int(nanoseconds) if nanoseconds > 0 => Ok(nanoseconds),
        _ => Err("the time from one scan to the next must be longer than 0".to_owned()),
    }
}

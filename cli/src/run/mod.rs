//! A run: scan after scan, with what is given to the program and what it complains about.

mod plants;
mod program;
mod reasons;
mod retention;
mod stimulus;
pub(crate) mod unread;

pub(crate) use plants::{Plants, note_undriven};
pub(crate) use program::{place, program, show_errors, simulation};
pub(crate) use reasons::with_wording;
pub(crate) use retention::{KeptIn, Retention};
pub(crate) use stimulus::Stimulus;

use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
use crate::terminal;
use ladder_analysis::program::Program;
#[cfg(feature = "run")]
use ladder_analysis::values::{types::Scalar, value::Value};
#[cfg(feature = "run")]
use ladder_simulator::value_text;
use ladder_simulator::{Fault, Inputs, Simulation, Status};
use ladder_workspace::shown;
use std::path::Path;
use std::sync::Arc;
#[cfg(feature = "run")]
use std::time::Duration;

/// How many scans to run, as it is on the command line.
pub(crate) fn number_of_scans(text: &str) -> Result<u64, String> {
    text.parse()
        .map_err(|_| "write a whole number, such as 100".to_owned())
}

/// A time that is not negative, as it is on the command line.
#[cfg(feature = "run")]
pub(crate) fn time(text: &str) -> Result<Duration, String> {
    match value_text::parse(text, Scalar::Time)? {
        Value::Int(nanoseconds) => u64::try_from(nanoseconds)
            .map(Duration::from_nanos)
            .map_err(|_| "a time is not negative".to_owned()),
        _ => Err("write a time, such as 10s".to_owned()),
    }
}

/// A program on its way through a number of scans.
pub(crate) struct Run<'s> {
    pub(crate) simulation: Simulation,
    pub(crate) inputs: Inputs,
    pub(crate) source: &'s Source,
    /// How many scans to run.
    pub(crate) scans: u64,
    /// Where retentive tags are kept, if anywhere.
    pub(crate) retention: Option<Retention>,
}

impl<'s> Run<'s> {
    /// A run up to its last scan, as the workspace of a file and the command line have it. Nothing is kept of it.
    ///
    /// # Errors
    /// The settings or what is given do not fit the program, or it needs more memory than there is.
    pub(crate) fn whole(
        stimulus: &Stimulus,
        file: &Path,
        (source, program): (&'s Source, Arc<Program>),
        scans: u64,
    ) -> Result<Run<'s>, Failure> {
        let options = stimulus.options(file, &program)?;
        let mut simulation = simulation(source, program, options)?;
        let inputs = stimulus.give(&mut simulation)?;
        let mut run = Run {
            simulation,
            inputs,
            source,
            scans,
            retention: None,
        };
        while run.scan() {}
        Ok(run)
    }

    /// Runs the next scan. False if all have been run, or if the program did not come to the end of this one.
    pub(crate) fn scan(&mut self) -> bool {
        let scan = self.simulation.scans();
        if scan >= self.scans {
            return false;
        }
        self.inputs.give(scan, &mut self.simulation);
        let ran = self.simulation.scan();
        for fault in self.simulation.take_faults() {
            self.report(&fault);
        }
        if let Some(retention) = &mut self.retention {
            retention.keep(&self.simulation);
        }
        ran
    }

    /// How the run has ended: a fault that stopped it is a finding.
    pub(crate) fn outcome(&self) -> Outcome {
        match self.simulation.status() {
            Status::Faulted => Outcome::Findings,
            Status::Ready | Status::Ended => Outcome::Fine,
        }
    }

    /// What is left to do after the last scan.
    ///
    /// # Errors
    /// The retentive file cannot be written.
    pub(crate) fn finish(&mut self) -> Result<(), Failure> {
        match &mut self.retention {
            Some(retention) => retention.finish(&self.simulation),
            None => Ok(()),
        }
    }

    /// Faults go to stderr, each on a line of its own, in the form that editors and terminals find places in.
    fn report(&self, fault: &Fault) {
        let place = place(self.source, fault.location);
        terminal::plain(&format_args!(
            "{place}: fault in scan {}: {}",
            fault.scan,
            shown::line(&fault.message)
        ));
    }
}

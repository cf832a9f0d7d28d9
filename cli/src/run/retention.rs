//! `--retain`: what is retentive outlives the run.

use crate::outcome::Failure;
use crate::terminal;
use ladder_simulator::Simulation;
use ladder_workspace::{Named, RetentiveFile, SystemDisk, shown};
use std::path::Path;
use std::time::{Duration, Instant};

/// Which file keeps what is retentive.
#[derive(Debug, Clone, Copy)]
pub(crate) enum KeptIn<'a> {
    /// One that the person named.
    File(&'a Path),
    /// One that the workspace names.
    #[cfg_attr(
        not(any(feature = "screen", feature = "run")),
        allow(dead_code, reason = "only what runs in real time asks the workspace")
    )]
    OfWorkspace(&'a Named),
}

/// The retentive file of a run.
pub(crate) struct Retention {
    file: RetentiveFile,
    opened: Instant,
}

impl Retention {
    /// Reads the file and begins the simulation with what it kept. What a person should know about that goes to
    /// stderr.
    ///
    /// # Errors
    /// The file cannot be used.
    pub(crate) fn begin(
        file: KeptIn,
        program: &Path,
        simulation: &mut Simulation,
    ) -> Result<Retention, Failure> {
        let name = program.file_name().unwrap_or_default().to_string_lossy();
        let (opened, found) = match file {
            KeptIn::File(file) => RetentiveFile::open(file, &name)?,
            KeptIn::OfWorkspace(file) => RetentiveFile::open_named(&SystemDisk, file, &name, Duration::ZERO)?,
        };
        for note in &found.notes {
            terminal::warning(&note);
        }
        if let Some(kept) = found.kept {
            for complaint in simulation.warm_start(&kept) {
                let file = shown::path(opened.path());
                terminal::warning(&format_args!("{file}: {}", shown::line(&complaint)));
            }
        }
        Ok(Retention {
            file: opened,
            opened: Instant::now(),
        })
    }

    /// Between two scans: saves if that is due. A failure is reported at the end, when it fails again.
    pub(crate) fn keep(&mut self, simulation: &Simulation) {
        if self.file.is_due(self.opened.elapsed()) {
            let _ = self.file.save(&simulation.retained());
        }
    }

    /// Saves at the end.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn finish(&mut self, simulation: &Simulation) -> Result<(), Failure> {
        Ok(self.file.save(&simulation.retained())?)
    }
}

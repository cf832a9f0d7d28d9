//! `--retain`: what is retentive outlives the run.

use crate::outcome::Failure;
use crate::terminal;
use ladder_simulator::Simulation;
use ladder_workspace::RetentiveFile;
use std::path::Path;

/// The retentive file of a run.
pub(crate) struct Retention {
    file: RetentiveFile,
}

impl Retention {
    /// Reads the file and begins the simulation with what it kept. What a person should know about that goes to
    /// stderr.
    ///
    /// # Errors
    /// The file cannot be read.
    pub(crate) fn begin(
        file: &Path,
        program: &Path,
        simulation: &mut Simulation,
    ) -> Result<Retention, Failure> {
        let name = program.file_name().unwrap_or_default().to_string_lossy();
        let (opened, found) = RetentiveFile::open(file, &name)?;
        for note in &found.notes {
            terminal::warning(&note);
        }
        if let Some(kept) = found.kept {
            for complaint in simulation.warm_start(&kept) {
                terminal::warning(&format_args!("{}: {complaint}", file.display()));
            }
        }
        Ok(Retention { file: opened })
    }

    /// Between two scans: saves if that is due. A failure is told at the end, when it fails again.
    pub(crate) fn keep(&mut self, simulation: &Simulation) {
        if self.file.is_due() {
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

//! What was done, written as a test next to the program.

use super::app::App;
use ladder_simulator::scenario;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::Path;

impl App<'_> {
    /// Writes what was done so far as a file of scenarios next to the program, and runs it once; one that is there is left
    /// alone. `outputs` are the tags of which something is expected.
    pub(super) fn record(&mut self, outputs: &[String]) -> Result<(), String> {
        let program = self.request.file;
        let name = program.file_name().unwrap_or_default().to_string_lossy();
        let recorded = self.plant.record_as_test(&name, Some(outputs))?;
        let file = keep(
            &recorded.text,
            &program.with_file_name(scenario::recorded_file(&name)),
        )?;
        let verdict = if self.plant.passes(&recorded) {
            "and passes"
        } else {
            "and fails: `ladder test` shows where"
        };
        let written = format!("{file} was written {verdict}");
        let told: Vec<String> = std::iter::once(written).chain(recorded.notes).collect();
        self.view.say(told.join("; "));
        Ok(())
    }
}

/// Writes a new file; its name, with a number if there is one of that name.
fn keep(text: &str, file: &Path) -> Result<String, String> {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    for number in 1..1000 {
        let file = match number {
            1 => file.to_owned(),
            number => file.with_file_name(format!("{stem}-{number}.ladder-test")),
        };
        let name = || {
            file.file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned()
        };
        let opened = OpenOptions::new().write(true).create_new(true).open(&file);
        match opened.and_then(|mut opened| opened.write_all(text.as_bytes())) {
            Ok(()) => return Ok(name()),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(format!("{} cannot be written: {error}", name())),
        }
    }
    Err(format!("there are a thousand files of the name {stem} already"))
}

//! What is written while files are checked, in the chosen form.

use super::Format;
use crate::findings::{Source, full, json};
use crate::terminal::{Stdout, stdout_has_colours};
use annotate_snippets::Renderer;
use ladder_analysis::Diagnostic;
use ladder_analysis::Severity;
use std::fmt;
use std::io::{self, Write};

/// The report, written as the files come: none is kept in memory.
pub(super) struct Report {
    format: Format,
    out: Stdout,
    renderer: Renderer,
    tally: Tally,
}

impl Report {
    pub(super) fn new(format: Format) -> Report {
        let renderer = if stdout_has_colours() {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        Report {
            format,
            out: Stdout::new(),
            renderer,
            tally: Tally::default(),
        }
    }

    /// Checks a program and writes what is found.
    pub(super) fn add(&mut self, source: &Source) -> io::Result<()> {
        let findings = source.analyze().diagnostics;
        for finding in &findings {
            match self.format {
                Format::Full => {
                    writeln!(self.out, "{}\n", full::render(source, finding, &self.renderer))?;
                }
                Format::Json => {
                    let before = if self.tally.findings() == 0 {
                        "[\n  "
                    } else {
                        ",\n  "
                    };
                    self.out.write_all(before.as_bytes())?;
                    serde_json::to_writer(&mut self.out, &json::Finding::new(source, finding))?;
                }
            }
            self.tally.count(finding);
        }
        self.tally.files += 1;
        Ok(())
    }

    /// Writes what stands at the end. Where no file could be checked, nothing is written at all.
    pub(super) fn finish(mut self) -> io::Result<Tally> {
        match self.format {
            _ if self.tally.files == 0 => {}
            Format::Full => writeln!(self.out, "{}", self.tally)?,
            Format::Json if self.tally.findings() == 0 => writeln!(self.out, "[]")?,
            Format::Json => writeln!(self.out, "\n]")?,
        }
        self.out.flush()?;
        Ok(self.tally)
    }
}

/// How many findings of each kind there are.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Tally {
    files: usize,
    pub(super) errors: usize,
    pub(super) warnings: usize,
    infos: usize,
}

impl Tally {
    fn count(&mut self, finding: &Diagnostic) {
        match finding.severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Info => self.infos += 1,
        }
    }

    fn findings(&self) -> usize {
        self.errors + self.warnings + self.infos
    }
}

impl fmt::Display for Tally {
    /// `Checked 5 files: 2 errors, 1 warning.`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counted = |count: usize, one: &str| format!("{count} {one}{}", if count == 1 { "" } else { "s" });
        let found: Vec<String> = [
            (self.errors, "error"),
            (self.warnings, "warning"),
            (self.infos, "info"),
        ]
        .into_iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, one)| counted(count, one))
        .collect();
        let found = if found.is_empty() {
            "no mistakes found".to_owned()
        } else {
            found.join(", ")
        };
        write!(f, "Checked {}: {found}.", counted(self.files, "file"))
    }
}

//! What is written while files are checked, in the chosen form.

use super::tally::Tally;
use super::{Checked, Format};
use crate::findings::{concise, full, github, json, sarif};
use crate::terminal::{Stdout, stdout_has_colours};
use annotate_snippets::Renderer;
use serde::Serialize;
use serde_json::Value;
use std::io::{self, Write};

/// The report, written as the files come: none is kept in memory (but for SARIF).
pub(super) struct Report {
    format: Format,
    out: Stdout,
    renderer: Renderer,
    tally: Tally,
    statistics: bool,
    /// The results of SARIF, which stand in the middle of its document.
    results: Vec<Value>,
}

impl Report {
    pub(super) fn new(format: Format, statistics: bool) -> Report {
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
            statistics,
            results: Vec::new(),
        }
    }

    /// How excerpts look.
    pub(super) fn renderer(&self) -> &Renderer {
        &self.renderer
    }

    /// Writes what was found in a file.
    pub(super) fn add(&mut self, checked: &Checked) -> io::Result<()> {
        let source = &checked.source;
        for finding in &checked.findings {
            match self.format {
                Format::Full => {
                    writeln!(self.out, "{}\n", full::render(source, finding, &self.renderer))?;
                }
                Format::Concise => writeln!(self.out, "{}", concise::line(source, finding))?,
                Format::Github => writeln!(self.out, "{}", github::line(source, finding))?,
                Format::Sarif => self.results.push(sarif::result(source, finding)),
                Format::Json => self.object(&json::Finding::new(source, finding))?,
            }
            self.tally.count(finding);
        }
        for problem in &checked.problems {
            match self.format {
                Format::Full => writeln!(self.out, "{}\n", problem.shown)?,
                Format::Concise => writeln!(self.out, "{}", problem.concise())?,
                Format::Github => writeln!(self.out, "{}", problem.github())?,
                Format::Sarif => self.results.push(problem.sarif()),
                Format::Json => self.object(problem)?,
            }
            self.tally.errors += 1;
        }
        self.tally.file(checked.mended);
        Ok(())
    }

    /// One more element of the array.
    fn object(&mut self, finding: &impl Serialize) -> io::Result<()> {
        let before = if self.tally.findings() == 0 {
            "[\n  "
        } else {
            ",\n  "
        };
        self.out.write_all(before.as_bytes())?;
        serde_json::to_writer(&mut self.out, finding)?;
        Ok(())
    }

    /// Writes what stands at the end. Where no file could be checked, nothing is written at all.
    pub(super) fn finish(mut self) -> io::Result<Tally> {
        let for_people = matches!(self.format, Format::Full | Format::Concise);
        match self.format {
            _ if self.tally.is_empty() => {}
            Format::Full | Format::Concise if self.statistics => {
                write!(self.out, "{}", self.tally.statistics())?;
            }
            Format::Json if self.tally.findings() == 0 => writeln!(self.out, "[]")?,
            Format::Json => writeln!(self.out, "\n]")?,
            Format::Sarif => {
                let document = sarif::document(std::mem::take(&mut self.results));
                serde_json::to_writer_pretty(&mut self.out, &document)?;
                writeln!(self.out)?;
            }
            Format::Full | Format::Concise | Format::Github => {}
        }
        if for_people && !self.tally.is_empty() {
            writeln!(self.out, "{}", self.tally)?;
        }
        self.out.flush()?;
        Ok(self.tally)
    }
}

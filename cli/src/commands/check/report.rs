//! What is written while files are checked, in the chosen form.

use super::fix::Fixed;
use super::tally::Tally;
use super::{Checked, Format};
use crate::diff;
use crate::findings::{Problem, concise, full, github, json, sarif};
use crate::json::{to_writer, to_writer_pretty};
use crate::terminal::{self, Stdout, stderr_has_colours, stdout_has_colours};
use annotate_snippets::Renderer;
use serde::Serialize;
use serde_json::Value;
use std::io::{self, BufWriter, Stderr, Write};
use std::path::Path;

/// Where a report goes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Target {
    Stdout,
    /// Stdout has something else.
    Stderr,
}

/// An open target.
enum Out {
    Stdout(Stdout),
    Stderr(BufWriter<Stderr>),
}

impl Out {
    fn is_closed(&self) -> bool {
        matches!(self, Out::Stdout(out) if out.is_closed())
    }
}

impl Write for Out {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Out::Stdout(out) => out.write(bytes),
            Out::Stderr(out) => out.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Out::Stdout(out) => out.flush(),
            Out::Stderr(out) => out.flush(),
        }
    }
}

/// The report, written as the files come: none is kept in memory (but for SARIF).
pub(super) struct Report {
    format: Format,
    out: Out,
    renderer: Renderer,
    tally: Tally,
    statistics: bool,
    /// The results of SARIF, which are in the middle of its document.
    results: Vec<Value>,
}

impl Report {
    pub(super) fn new(format: Format, statistics: bool, target: Target) -> Report {
        let (out, has_colours) = match target {
            Target::Stdout => (Out::Stdout(Stdout::new()), stdout_has_colours()),
            Target::Stderr => (Out::Stderr(terminal::stderr()), stderr_has_colours()),
        };
        let renderer = if has_colours {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        Report {
            format,
            out,
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
        self.fixed(checked)?;
        if checked.fixed.before.is_some() {
            // What is left is for a check of its own.
            let fixes = checked.fixed.fixes.len();
            self.tally.file_to_fix(&checked.findings, fixes);
            return Ok(());
        }
        self.problems(&checked.problems)?;
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
        self.tally.file(checked.fixed.fixes.len());
        Ok(())
    }

    /// Writes what is wrong next to the findings of the rules.
    pub(super) fn problems(&mut self, problems: &[Problem]) -> io::Result<()> {
        for problem in problems {
            match self.format {
                Format::Full => writeln!(self.out, "{}\n", problem.shown)?,
                Format::Concise => writeln!(self.out, "{}", problem.concise())?,
                Format::Github => writeln!(self.out, "{}", problem.github())?,
                Format::Sarif => self.results.push(problem.sarif()),
                Format::Json => self.object(problem)?,
            }
            self.tally.count_severity(problem.severity);
        }
        Ok(())
    }

    /// Lists the fixes that were made, and shows what would change.
    fn fixed(&mut self, checked: &Checked) -> io::Result<()> {
        let Fixed { fixes, before } = &checked.fixed;
        let verb = if before.is_some() { "would fix" } else { "fixed" };
        for fix in fixes {
            match self.format {
                Format::Full | Format::Concise => writeln!(self.out, "{verb} {fix}")?,
                // Standard output belongs to the machine that reads it.
                Format::Json | Format::Sarif | Format::Github => {
                    terminal::plain(&format!("{verb} {fix}"));
                }
            }
        }
        match before {
            Some(before) if !fixes.is_empty() => {
                let (file, now) = (Path::new(&checked.source.file), &checked.source.text);
                diff::print(file, before, now, &mut self.out)
            }
            _ => Ok(()),
        }
    }

    /// One more element of the array.
    fn object(&mut self, finding: &impl Serialize) -> io::Result<()> {
        let before = if self.tally.findings() == 0 {
            "[\n  "
        } else {
            ",\n  "
        };
        self.out.write_all(before.as_bytes())?;
        to_writer(&mut self.out, finding)
    }

    /// Writes what is at the end. Where no file could be checked, nothing is written at all. Also says whether
    /// the reader has gone away.
    pub(super) fn finish(mut self) -> io::Result<(Tally, bool)> {
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
                to_writer_pretty(&mut self.out, &document)?;
                writeln!(self.out)?;
            }
            Format::Full | Format::Concise | Format::Github => {}
        }
        if for_people && !self.tally.is_empty() {
            writeln!(self.out, "{}", self.tally)?;
        }
        self.out.flush()?;
        Ok((self.tally, self.out.is_closed()))
    }
}

//! Results for people: a line for each scenario, and what differs below those that failed.

use super::coverage::{self, Covered};
use super::mutation;
use super::report::{CaseReport, FileReport};
use super::{All, Writer};
use anstyle::{AnsiColor, Style};
use ladder_simulator::scenario::LineKind;
use ladder_syntax::numeral::counted;
use ladder_workspace::shown;
use std::io::{self, Write};

/// What is before a drawing.
pub(super) const INDENT: &str = "        ";

pub(super) struct People {
    colours: bool,
    coverage: bool,
    /// Whether what is above ends with a blank line.
    separated: bool,
}

impl People {
    pub(super) fn new(colours: bool, coverage: bool) -> People {
        People {
            colours,
            coverage,
            separated: false,
        }
    }

    fn paint(&self, style: Style, text: &str) -> String {
        if self.colours {
            format!("{style}{text}{style:#}")
        } else {
            text.to_owned()
        }
    }

    fn case(&self, case: &CaseReport, out: &mut dyn Write) -> io::Result<()> {
        let word = if case.passed {
            self.paint(GOOD, "ok  ")
        } else {
            self.paint(BAD, "FAIL")
        };
        writeln!(out, "  {word}  {}", shown::line(&case.name))?;
        for line in &case.drawing {
            let style = match line.kind {
                LineKind::Given => FAINT,
                LineKind::Expected => Style::new(),
                LineKind::Got => Style::new().bold(),
                LineKind::Marks => BAD,
                LineKind::Sentence => Style::new(),
            };
            writeln!(out, "{INDENT}{}", self.paint(style, &shown::line(&line.text)))?;
        }
        if let Some(step) = case.stopped {
            writeln!(out, "{INDENT}the simulation stopped in step {step}")?;
        }
        if let Some(outside) = &case.outside {
            writeln!(out, "{INDENT}{}", self.paint(UNSURE, &shown::line(outside)))?;
        }
        for fault in &case.faults {
            writeln!(out, "{INDENT}{}", fault.line())?;
        }
        if !case.passed {
            let place = case.first_place();
            let place = format!("{}:{}:{}", shown::line(&place.file), place.line, place.column);
            writeln!(out, "{INDENT}{}", self.paint(FAINT, &format!("at {place}")))?;
        }
        for picture in &case.pictures {
            let line = format!("picture: {}", shown::line(picture));
            writeln!(out, "{INDENT}{}", self.paint(FAINT, &line))?;
        }
        Ok(())
    }

    fn covered(&self, covered: &Covered, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "\n{}", self.paint(Style::new().bold(), "Coverage"))?;
        write!(out, "{}", coverage::table(covered))?;
        let missed = coverage::missed(covered);
        let heading = if covered.was_mutated() {
            "Never exercised, or not shown to matter"
        } else {
            "Never exercised"
        };
        if missed.is_empty() {
            return Ok(());
        }
        writeln!(out, "\n{}", self.paint(Style::new().bold(), heading))?;
        for place in missed {
            writeln!(out, "  {}\n    {}", place.title, place.rung)?;
            writeln!(out, "    {}", self.paint(BAD, &place.marks))?;
        }
        Ok(())
    }
}

const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();
const UNSURE: Style = AnsiColor::Yellow.on_default();
const FAINT: Style = AnsiColor::BrightBlack.on_default();

impl Writer for People {
    fn file(&mut self, report: &FileReport, out: &mut dyn Write) -> io::Result<()> {
        for problem in &report.problems {
            writeln!(out, "{}\n", problem.shown)?;
            self.separated = true;
        }
        if report.cases.is_empty() && report.properties == 0 {
            return Ok(());
        }
        self.separated = false;
        writeln!(
            out,
            "{}",
            self.paint(Style::new().bold(), &shown::line(&report.file))
        )?;
        report.cases.iter().try_for_each(|case| self.case(case, out))?;
        let (has_them, decides) = match report.properties {
            0 => return Ok(()),
            1 => ("1 property".to_owned(), "decides it"),
            count => (format!("{count} properties"), "decides them"),
        };
        let watched = if report.cases.is_empty() { "" } else { " watched" };
        let file = shown::line(&report.file);
        let line = format!("{has_them}{watched}; ladder prove {file} {decides} for all runs");
        writeln!(out, "        {}", self.paint(FAINT, &line))
    }

    /// `12 scenarios in 3 files: 11 passed, 1 failed, in 0.02 s.`
    fn end(&mut self, all: &All, out: &mut dyn Write) -> io::Result<()> {
        if let Some(covered) = all.covered.filter(|_| self.coverage) {
            self.covered(covered, out)?;
            self.separated = false;
        }
        if all.tally.files > 0 {
            self.sum(all, out)?;
        }
        let (colours, mutated) = (self.colours, all.mutated);
        mutated.map_or(Ok(()), |mutated| mutation::People { mutated, colours }.write(out))
    }
}

impl People {
    fn sum(&self, all: &All, out: &mut dyn Write) -> io::Result<()> {
        if !self.separated {
            writeln!(out)?;
        }
        let tally = all.tally;
        let mut parts = vec![format!("{} passed", tally.passed)];
        if tally.failed > 0 {
            parts.push(self.paint(BAD, &format!("{} failed", tally.failed)));
        }
        if tally.broken > 0 {
            let broken = format!("{} not run for errors", counted(tally.broken, "file"));
            parts.push(self.paint(BAD, &broken));
        }
        writeln!(
            out,
            "{} in {}: {}, in {:.2} s.",
            counted(tally.scenarios(), "scenario"),
            counted(tally.files, "file"),
            parts.join(", "),
            all.seconds
        )
    }
}

//! Results as GitHub shows them at the lines of a change.

use super::mutation::Mutated;
use super::report::FileReport;
use super::{All, Writer};
use crate::findings::annotation;
use ladder_syntax::numeral::counted;
use std::io::{self, Write};

pub(super) struct Github;

impl Writer for Github {
    fn file(&mut self, report: &FileReport, out: &mut dyn Write) -> io::Result<()> {
        for problem in &report.problems {
            writeln!(out, "{}", problem.github())?;
        }
        for case in &report.cases {
            for fault in &case.faults {
                let title = format!("fault in \"{}\"", case.name);
                let line = annotation("warning", &fault.place, &title, &fault.message);
                writeln!(out, "{line}")?;
            }
            if let Some(outside) = &case.outside {
                let line = annotation("warning", &case.place, &case.name, outside);
                writeln!(out, "{line}")?;
            }
            if case.passed {
                continue;
            }
            let message = format!("{}\n\n{}", case.sentences().join("\n"), case.drawn());
            let line = annotation("error", case.first_place(), &case.name, message.trim_end());
            writeln!(out, "{line}")?;
        }
        Ok(())
    }

    fn end(&mut self, all: &All, out: &mut dyn Write) -> io::Result<()> {
        for (place, message) in all.mutated.iter().copied().flatten().flat_map(Mutated::missed) {
            writeln!(
                out,
                "{}",
                annotation("warning", &place, "no scenario notices this change", &message)
            )?;
        }
        let tally = all.tally;
        write!(
            out,
            "{} in {}: {} passed, {} failed",
            counted(tally.scenarios(), "scenario"),
            counted(tally.files, "file"),
            tally.passed,
            tally.failed
        )?;
        if tally.broken > 0 {
            write!(out, ", {} not run for errors", counted(tally.broken, "file"))?;
        }
        writeln!(out)
    }
}

//! Results as XML in the form that JUnit began and build servers read.

use super::mutation::Mutated;
use super::report::FileReport;
use super::{All, Writer};
use crate::run::unread;
use crate::xml::{attribute, escaped};
use std::fmt::Write as _;
use std::io::{self, Write};

/// The sums are at the beginning, so the suites are kept until all are there.
#[derive(Default)]
pub(super) struct Junit {
    suites: String,
    tests: usize,
    failures: usize,
    errors: usize,
}

impl Writer for Junit {
    fn file(&mut self, report: &FileReport, _: &mut dyn Write) -> io::Result<()> {
        let failures = report.cases.iter().filter(|case| !case.passed).count();
        let errors = report.problems.len();
        let tests = report.cases.len() + errors;
        self.tests += tests;
        self.failures += failures;
        self.errors += errors;
        // Writing to a String does not fail.
        let _ = self.suite(report, tests, failures, errors);
        Ok(())
    }

    fn end(&mut self, all: &All, out: &mut dyn Write) -> io::Result<()> {
        for mutated in all.mutated.unwrap_or_default() {
            // Writing to a String does not fail.
            let _ = self.changes(mutated);
        }
        writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
        writeln!(
            out,
            "<testsuites name=\"ladder test\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6}\">",
            self.tests, self.failures, self.errors, all.seconds
        )?;
        write!(out, "{}", self.suites)?;
        writeln!(out, "</testsuites>")
    }
}

impl Junit {
    /// A change that no scenario notices is a test that fails.
    fn changes(&mut self, mutated: &Mutated) -> std::fmt::Result {
        let missed: Vec<_> = mutated.missed().collect();
        let (program, count) = (attribute(mutated.program()), missed.len());
        (self.tests, self.failures) = (self.tests + count, self.failures + count);
        let out = &mut self.suites;
        writeln!(
            out,
            "  <testsuite name=\"changes to {program}\" tests=\"{count}\" failures=\"{count}\" errors=\"0\" skipped=\"0\" \
             time=\"0\" file=\"{program}\">"
        )?;
        for (place, message) in missed {
            let (line, column, message) = (place.line, place.column, attribute(&message));
            writeln!(
                out,
                "    <testcase name=\"{program}:{line}:{column}\" classname=\"{program}\" time=\"0\" file=\"{program}\" \
                 line=\"{line}\">\n      <failure message=\"no scenario notices this change: {message}\" type=\"change\"/>\n    \
                 </testcase>"
            )?;
        }
        writeln!(out, "  </testsuite>")
    }

    fn suite(
        &mut self,
        report: &FileReport,
        tests: usize,
        failures: usize,
        errors: usize,
    ) -> std::fmt::Result {
        let out = &mut self.suites;
        let file = attribute(&report.file);
        writeln!(
            out,
            "  <testsuite name=\"{file}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" \
             skipped=\"0\" time=\"{:.6}\" file=\"{file}\">",
            report.seconds
        )?;
        let parts = report
            .unread_parts
            .iter()
            .map(|part| ("unread part", part.as_str()));
        out.push_str(&unread::properties(parts));
        for problem in &report.problems {
            let place = &problem.place;
            writeln!(
                out,
                "    <testcase name=\"{}:{}:{}\" classname=\"{file}\" time=\"0\" file=\"{}\" line=\"{}\">",
                attribute(&place.file),
                place.line,
                place.column,
                attribute(&place.file),
                place.line
            )?;
            writeln!(
                out,
                "      <error message=\"{}\" type=\"{}\">{}</error>\n    </testcase>",
                attribute(&problem.message),
                problem.rule,
                escaped(&problem.shown)
            )?;
        }
        for case in &report.cases {
            write!(
                out,
                "    <testcase name=\"{}\" classname=\"{file}\" time=\"{:.6}\" file=\"{file}\" line=\"{}\"",
                attribute(&case.name),
                case.seconds,
                case.place.line
            )?;
            let told: Vec<String> = case
                .outside
                .iter()
                .cloned()
                .chain(case.faults.iter().map(super::report::FaultReport::line))
                .collect();
            if case.passed && told.is_empty() {
                writeln!(out, "/>")?;
                continue;
            }
            writeln!(out, ">")?;
            if !case.passed {
                writeln!(
                    out,
                    "      <failure message=\"{}\" type=\"scenario\">{}</failure>",
                    attribute(&case.sentences().join("; ")),
                    escaped(&case.drawn())
                )?;
            }
            if !case.pictures.is_empty() {
                // As GitLab and a plugin of Jenkins read it.
                let attached = case.pictures.iter().map(|file| format!("[[ATTACHMENT|{file}]]"));
                let attached = attached.collect::<Vec<_>>().join("\n");
                writeln!(out, "      <system-out>{}</system-out>", escaped(&attached))?;
            }
            if !told.is_empty() {
                writeln!(
                    out,
                    "      <system-err>{}</system-err>",
                    escaped(&told.join("\n"))
                )?;
            }
            writeln!(out, "    </testcase>")?;
        }
        writeln!(out, "  </testsuite>")
    }
}

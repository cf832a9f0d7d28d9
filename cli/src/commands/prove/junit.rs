//! Answers as XML in the form that JUnit began and build servers read.

use super::file::{FileAnswers, PropertyAnswer};
use crate::outcome::Outcome;
use crate::run::unread;
use crate::xml::{attribute, escaped};
use ladder_prover::Verdict;
use ladder_prover::drawn;
use std::io::{self, Write};

pub(super) fn write(
    all: &[FileAnswers],
    allow_unknown: bool,
    seconds: f64,
    out: &mut dyn Write,
) -> io::Result<()> {
    let fails = |property: &&PropertyAnswer| property.outcome(allow_unknown) != Outcome::Fine;
    let failures = |answers: &FileAnswers| answers.properties.iter().filter(fails).count();
    let errors: usize = all.iter().map(|answers| answers.problems.len()).sum();
    let properties: usize = all.iter().map(|answers| answers.properties.len()).sum();
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>")?;
    writeln!(
        out,
        "<testsuites name=\"ladder prove\" tests=\"{}\" failures=\"{}\" errors=\"{errors}\" time=\"{seconds:.6}\">",
        properties + errors,
        all.iter().map(failures).sum::<usize>(),
    )?;
    for answers in all {
        let (file, errors) = (attribute(&answers.file), answers.problems.len());
        writeln!(
            out,
            "  <testsuite name=\"{file}\" tests=\"{}\" failures=\"{}\" errors=\"{errors}\" skipped=\"0\" \
             time=\"{:.6}\" file=\"{file}\">",
            answers.properties.len() + errors,
            failures(answers),
            answers.seconds
        )?;
        let plants = answers.basis.plants.iter().map(|plant| ("plant", plant.as_str()));
        let parts = answers
            .unread_parts
            .iter()
            .map(|part| ("unread part", part.as_str()));
        out.write_all(unread::properties(plants.chain(parts)).as_bytes())?;
        for problem in &answers.problems {
            let place = &problem.place;
            writeln!(
                out,
                "    <testcase name=\"{}:{}:{}\" classname=\"{file}\" time=\"0\" file=\"{}\" line=\"{}\">\n      \
                 <error message=\"{}\" type=\"{}\">{}</error>\n    </testcase>",
                attribute(&place.file),
                place.line,
                place.column,
                attribute(&place.file),
                place.line,
                attribute(&problem.message),
                problem.rule,
                escaped(&problem.shown)
            )?;
        }
        for property in &answers.properties {
            write!(
                out,
                "    <testcase name=\"{}\" classname=\"{file}\" time=\"{:.6}\" file=\"{file}\" line=\"{}\"",
                attribute(&property.name),
                property.answer.time.as_secs_f64(),
                property.place.line
            )?;
            if property.outcome(allow_unknown) == Outcome::Fine {
                writeln!(out, "/>")?;
                continue;
            }
            let verdict = property.answer.verdict.word();
            let message = format!("{verdict} {}", answers.note(property));
            writeln!(
                out,
                ">\n      <failure message=\"{}\" type=\"{verdict}\">{}</failure>\n    </testcase>",
                attribute(message.trim_end()),
                escaped(&details(property))
            )?;
        }
        writeln!(out, "  </testsuite>")?;
    }
    writeln!(out, "</testsuites>")
}

/// The run that was found, or why nothing is known.
fn details(property: &PropertyAnswer) -> String {
    let mut lines: Vec<String> = Vec::new();
    if matches!(property.answer.verdict, Verdict::Unknown(_)) {
        lines.extend(property.open.iter().map(|(what, _)| what.clone()));
    }
    lines.extend(property.scenario.as_deref().map(drawn));
    lines.join("\n")
}

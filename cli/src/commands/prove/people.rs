//! Answers for people: a line for each property, and below it the run that was found, or why nothing is known.

use super::file::FileAnswers;
use crate::findings::FileRange;
use anstyle::{AnsiColor, Style};
use ladder_prover::{Verdict, drawn};
use ladder_syntax::numeral::counted;
use ladder_workspace::shown;
use std::io::{self, Write};

const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();
const UNSURE: Style = AnsiColor::Yellow.on_default();
const FAINT: Style = AnsiColor::BrightBlack.on_default();

/// What is before what belongs to a property.
const INDENT: &str = "              ";

/// How a verdict is shown.
const fn style(verdict: &Verdict) -> Style {
    match verdict {
        Verdict::Proved(_) | Verdict::Possible(_) => GOOD,
        Verdict::Violated(_) | Verdict::Impossible(_) | Verdict::Vacuous => BAD,
        Verdict::Unknown(_) => UNSURE,
    }
}

fn paint(colours: bool, style: Style, text: &str) -> String {
    if colours {
        format!("{style}{text}{style:#}")
    } else {
        text.to_owned()
    }
}

pub(super) fn file(answers: &FileAnswers, colours: bool, out: &mut dyn Write) -> io::Result<()> {
    for problem in &answers.problems {
        writeln!(out, "{}\n", problem.shown)?;
    }
    if answers.properties.is_empty() {
        return Ok(());
    }
    writeln!(
        out,
        "{}",
        paint(colours, Style::new().bold(), &shown::line(&answers.file))
    )?;
    let names = answers
        .properties
        .iter()
        .map(|property| shown::line(&property.name).chars().count());
    let widest = names.max().unwrap_or(0).min(60);
    for property in &answers.properties {
        let verdict = &property.answer.verdict;
        let name = shown::line(&property.name);
        let word = paint(colours, style(verdict), &format!("{:<10}", verdict.word()));
        let line = format!("  {word}  {name:<widest$}  {}", answers.note(property));
        writeln!(out, "{}", line.trim_end())?;
        if property.answer.never_triggered {
            writeln!(
                out,
                "{INDENT}never triggered: what is on its left side never happens"
            )?;
        }
        if let Some(scan) = property.answer.fault {
            writeln!(
                out,
                "{INDENT}a fault can happen in it (in scan {scan}): its expression is FALSE then"
            )?;
        }
        let what = match property.answer.verdict {
            Verdict::Unknown(_) => "not decided",
            _ => "left open",
        };
        let line = |(open, place): &(String, Option<FileRange>)| match place {
            Some(place) => format!(
                "{} ({}:{})",
                shown::line(open),
                shown::line(&place.file),
                place.line
            ),
            None => shown::line(open).into_owned(),
        };
        let mut lines: Vec<String> = property.open.iter().map(line).collect();
        // A formula has many operations.
        lines.dedup();
        for line in lines {
            writeln!(out, "{INDENT}{what}: {line}")?;
        }
        if let Some(scenario) = &property.scenario {
            for row in drawn(scenario).lines() {
                writeln!(out, "{INDENT}{}", paint(colours, FAINT, &shown::line(row)))?;
            }
        }
    }
    for output in &answers.basis.unchanging {
        let output = shown::line(output);
        writeln!(
            out,
            "  {output} never changes: what is proved with it is about a machine that does nothing"
        )?;
    }
    writeln!(out)
}

/// `5 properties in 1 file: 3 proved, 1 violated, 1 unknown, in 0.02 s.`
pub(super) fn end(all: &[FileAnswers], seconds: f64, colours: bool, out: &mut dyn Write) -> io::Result<()> {
    let properties = || all.iter().flat_map(|answers| &answers.properties);
    let mut parts = Vec::new();
    for wanted in [
        "proved",
        "possible",
        "violated",
        "impossible",
        "unknown",
        "vacuous",
    ] {
        let mut of_it = properties()
            .map(|property| &property.answer.verdict)
            .filter(|verdict| verdict.word() == wanted);
        let Some(first) = of_it.next() else { continue };
        let part = format!("{} {wanted}", of_it.count() + 1);
        let style = style(first);
        parts.push(if style == GOOD {
            part
        } else {
            paint(colours, style, &part)
        });
    }
    let broken = all.iter().filter(|answers| !answers.problems.is_empty()).count();
    if broken > 0 {
        parts.push(paint(
            colours,
            BAD,
            &format!("{} not read for errors", counted(broken, "file")),
        ));
    }
    let count = properties().count();
    let count = if count == 1 {
        "1 property".to_owned()
    } else {
        format!("{count} properties")
    };
    writeln!(
        out,
        "{count} in {}: {}, in {seconds:.2} s.",
        counted(all.len(), "file"),
        parts.join(", ")
    )
}

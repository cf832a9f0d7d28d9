//! Answers for people: a line for each property, and below it the run that was found, or why nothing is known.

use super::file::{FileAnswers, PropertyAnswer};
use anstyle::{AnsiColor, Style};
use ladder_prover::{Times, Verdict};
use ladder_simulator::value_text::duration;
use ladder_syntax::numeral::counted;
use ladder_workspace::shown;
use std::io::{self, Write};

const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();
const UNSURE: Style = AnsiColor::Yellow.on_default();
const FAINT: Style = AnsiColor::BrightBlack.on_default();

/// What is before what belongs to a property.
const INDENT: &str = "              ";

/// The word for a verdict, and how it is shown.
pub(super) fn word(verdict: &Verdict) -> (&'static str, Style) {
    match verdict {
        Verdict::Proved(_) => ("proved", GOOD),
        Verdict::Violated(_) => ("violated", BAD),
        Verdict::Possible(_) => ("possible", GOOD),
        Verdict::Impossible(_) => ("impossible", BAD),
        Verdict::Unknown(_) => ("unknown", UNSURE),
        Verdict::Vacuous => ("vacuous", BAD),
    }
}

fn paint(colours: bool, style: Style, text: &str) -> String {
    if colours {
        format!("{style}{text}{style:#}")
    } else {
        text.to_owned()
    }
}

/// What is said next to the name.
pub(super) fn note(property: &PropertyAnswer, interval: i64) -> String {
    match &property.answer.verdict {
        Verdict::Proved(Times::Any) | Verdict::Impossible(Times::Any) => "for any times".into(),
        Verdict::Proved(Times::Exact) | Verdict::Impossible(Times::Exact) => {
            format!("for an interval of {}", duration(interval))
        }
        Verdict::Violated(_) | Verdict::Possible(_) => {
            let scan = property.scan().unwrap_or(0);
            let time = interval.saturating_mul(scan as i64);
            format!("in scan {scan}, at {}", duration(time))
        }
        Verdict::Unknown(0) => String::new(),
        Verdict::Unknown(scans) => format!("no such run in {}", counted(*scans, "scan")),
        Verdict::Vacuous => "what is assumed cannot hold in the first scan".into(),
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
        let (word, style) = word(&property.answer.verdict);
        let name = shown::line(&property.name);
        let word = paint(colours, style, &format!("{word:<10}"));
        let line = format!("  {word}  {name:<widest$}  {}", note(property, answers.interval));
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
        for (open, place) in &property.open {
            let place = place
                .as_ref()
                .map(|place| format!(" ({}:{})", shown::line(&place.file), place.line));
            writeln!(
                out,
                "{INDENT}{what}: {}{}",
                shown::line(open),
                place.unwrap_or_default()
            )?;
        }
        if let Some(scenario) = &property.scenario {
            for row in drawn(scenario).lines() {
                writeln!(out, "{INDENT}{}", paint(colours, FAINT, &shown::line(row)))?;
            }
        }
    }
    writeln!(out)
}

/// The rows of a run, in columns.
pub(super) fn drawn(scenario: &str) -> String {
    let file = ladder_simulator::scenario::layout(&format!("program p\n\n{scenario}"));
    let rows = file
        .lines()
        .skip_while(|line| !line.starts_with("scenario"))
        .skip(1);
    rows.collect::<Vec<&str>>().join("\n")
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
            .map(|property| word(&property.answer.verdict))
            .filter(|(word, _)| *word == wanted);
        let Some((_, style)) = of_it.next() else { continue };
        let part = format!("{} {wanted}", of_it.count() + 1);
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

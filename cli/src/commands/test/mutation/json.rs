//! What came of the changes, for machines. The members are documented; nothing may be renamed.

use super::fate::Fate;
use super::{Change, Mutated};
use serde::Serialize;

#[derive(Serialize)]
struct OfProgram<'a> {
    program: &'a str,
    /// The scenario that fails though nothing was changed: then no change was tried.
    #[serde(skip_serializing_if = "Option::is_none")]
    fails: Option<&'a str>,
    caught: usize,
    missed: usize,
    same: usize,
    unknown: usize,
    /// In hundredths.
    score: Option<usize>,
    /// Those that were not caught.
    changes: Vec<Changed<'a>>,
}

#[derive(Serialize)]
struct Changed<'a> {
    line: u32,
    column: u32,
    end_line: u32,
    end_column: u32,
    change: &'a str,
    before: &'a str,
    after: String,
    /// `missed`, `same` or `unknown`.
    fate: &'static str,
    /// Why it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    why: Option<&'a str>,
    /// The rows of a scenario that notices it.
    #[serde(skip_serializing_if = "Option::is_none")]
    scenario: Option<String>,
    /// What the changed program does in it, as it is shown to people.
    #[serde(skip_serializing_if = "Option::is_none")]
    diagram: Option<String>,
}

/// See the module.
pub(in super::super) fn json(mutated: &[Mutated]) -> impl Serialize + '_ {
    mutated.iter().map(program).collect::<Vec<_>>()
}

fn program(mutated: &Mutated) -> OfProgram<'_> {
    let score = mutated.score();
    let uncaught = mutated
        .changes
        .iter()
        .filter(|(_, fate)| !matches!(fate, Fate::Caught));
    OfProgram {
        program: &mutated.subject.source.file,
        fails: mutated.subject.fails.as_deref(),
        caught: score.caught,
        missed: score.missed,
        same: score.same,
        unknown: score.unknown,
        score: score.percent(),
        changes: uncaught
            .map(|(change, fate)| changed(mutated, change, fate))
            .collect(),
    }
}

fn changed<'a>(mutated: &'a Mutated, change: &'a Change, fate: &'a Fate) -> Changed<'a> {
    let place = mutated.place(change);
    let run = match fate {
        Fate::Missed(run) => Some(run),
        _ => None,
    };
    let name = format!("line {}", place.line);
    Changed {
        line: place.line,
        column: place.column,
        end_line: place.end_line,
        end_column: place.end_column,
        change: &change.title,
        before: change.before(&mutated.subject.source),
        after: change.after(&mutated.subject.source),
        fate: match fate {
            Fate::Caught => "caught",
            Fate::Missed(_) => "missed",
            Fate::Same => "same",
            Fate::Unknown(_) => "unknown",
        },
        why: match fate {
            Fate::Unknown(why) => Some(why),
            _ => None,
        },
        scenario: run.and_then(|run| run.scenario(&mutated.subject, &name)),
        diagram: run.map(|run| run.drawn_text()),
    }
}

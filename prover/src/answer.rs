//! The answers: what is known of each property, and why no more.

use crate::decide::{Depth, Known, decide, reach};
use crate::encode;
use crate::graph::Lit;
use crate::lemmas;
use crate::model::{Model, build};
pub use crate::replay::Shown;
use crate::replay::replay;
use ladder_analysis::program::Location;
use ladder_simulator::Simulation;
use ladder_simulator::compiled::Home;
use ladder_simulator::scenario::{Form, Watched};
use std::time::{Duration, Instant};

/// How much may be done.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// For all properties of a file.
    pub time: Duration,
    /// How many scans from the cold start are searched.
    pub scans: usize,
}

impl Default for Options {
    /// 20 seconds and 200 scans.
    fn default() -> Options {
        Options {
            time: Duration::from_secs(20),
            scans: 200,
        }
    }
}

/// For which times of the timers something is proved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Times {
    /// Whatever their presets are.
    Any,
    /// For the presets and the interval as they are.
    Exact,
}

/// What is known of a property.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// It holds in every run.
    Proved(Times),
    /// A run violates it: in its last scan.
    Violated(Shown),
    /// A run has it: in its last scan.
    Possible(Shown),
    /// No run has it.
    Impossible(Times),
    /// Neither was found: there is no such run in so many scans.
    Unknown(usize),
    /// What is assumed cannot hold at the start: nothing is said.
    Vacuous,
}

/// What came of a property.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// What is known.
    pub verdict: Verdict,
    /// Why it is not known, or what was left open on the way: in words, with the block that it is about.
    pub open: Vec<(String, Option<Location>)>,
    /// What is on its left side never happens.
    pub never_triggered: bool,
}

/// A run that was found and does not happen in the simulator, though nothing was left open: an error of the prover.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refuted {
    /// The property.
    pub name: String,
}

/// Decides the properties of a file, in their order.
///
/// # Errors
/// A run was found that does not happen.
pub fn prove(
    simulation: &mut Simulation,
    watched: &mut Watched,
    options: Options,
) -> Result<Vec<Answer>, Refuted> {
    let end = Instant::now() + options.time;
    let is_open: Vec<bool> = vec![true; watched.properties.len()];
    let mut answers: Vec<Option<Answer>> = vec![None; is_open.len()];
    // First with times that may be anything: what holds then needs no counting.
    let open = build(simulation, watched, encode::Times::Open);
    if let Some(gap) = &open.world.blocked {
        let cause = vec![(gap.what.clone(), gap.location)];
        let unknown = Answer {
            verdict: Verdict::Unknown(0),
            open: cause,
            never_triggered: false,
        };
        return Ok(vec![unknown; is_open.len()]);
    }
    let targets: Vec<Lit> = open.properties.iter().map(|property| property.bad).collect();
    let depth = Depth {
        base: 5,
        step: 5,
        end,
    };
    for (n, known) in decide(&open, &targets, depth).0.into_iter().enumerate() {
        if matches!(known, Known::Never(_) | Known::Vacuous) {
            let cause = left_open(&open, targets[n]);
            answers[n] = Some(answer(watched, n, known, Times::Any, cause));
        }
    }
    let rest: Vec<usize> = (0..answers.len()).filter(|n| answers[*n].is_none()).collect();
    let mut exact = build(simulation, watched, encode::Times::Exact);
    if !rest.is_empty() {
        let targets: Vec<Lit> = rest.iter().map(|n| exact.properties[*n].bad).collect();
        lemmas::add(&mut exact, &targets, end);
        let depth = Depth {
            base: options.scans,
            step: 20,
            end,
        };
        let (known, _) = decide(&exact, &targets, depth);
        for (n, known) in rest.into_iter().zip(known) {
            let cause = left_open(&exact, exact.properties[n].bad);
            let found = match known {
                Known::Found(run) => {
                    let shown = replay(simulation, watched, n, (&run, &exact.world.inputs));
                    match shown {
                        Some(shown) => Answer {
                            verdict: found(watched, n, shown),
                            open: cause,
                            never_triggered: false,
                        },
                        None if cause.is_empty() => {
                            return Err(Refuted {
                                name: watched.properties[n].name.clone(),
                            });
                        }
                        None => answer(watched, n, Known::NotIn(run.scans - 1), Times::Exact, cause),
                    }
                }
                known => answer(watched, n, known, Times::Exact, cause),
            };
            answers[n] = Some(found);
        }
    }
    let mut answers: Vec<Answer> = answers.into_iter().flatten().collect();
    for (answer, property) in answers.iter_mut().zip(&exact.properties) {
        if let Verdict::Unknown(scans) = answer.verdict {
            answer
                .open
                .extend(long_timers(simulation, &exact, property.bad, scans));
        }
    }
    note_untriggered(&exact, &mut answers, end);
    Ok(answers)
}

fn is_possible(watched: &Watched, property: usize) -> bool {
    matches!(watched.properties[property].form, Form::Possible { .. })
}

fn found(watched: &Watched, property: usize, shown: Shown) -> Verdict {
    if is_possible(watched, property) {
        Verdict::Possible(shown)
    } else {
        Verdict::Violated(shown)
    }
}

fn answer(
    watched: &Watched,
    property: usize,
    known: Known,
    times: Times,
    open: Vec<(String, Option<Location>)>,
) -> Answer {
    let verdict = match known {
        Known::Never(_) if is_possible(watched, property) => Verdict::Impossible(times),
        Known::Never(_) => Verdict::Proved(times),
        Known::Vacuous => Verdict::Vacuous,
        Known::NotIn(scans) => Verdict::Unknown(scans),
        Known::Found(run) => Verdict::Unknown(run.scans.saturating_sub(1)),
    };
    Answer {
        verdict,
        open,
        never_triggered: false,
    }
}

/// What was left open that a literal depends on.
fn left_open(model: &Model, target: Lit) -> Vec<(String, Option<Location>)> {
    let nodes = reach(model, std::iter::once(target));
    let gaps = &model.world.gaps;
    let mut found: Vec<usize> = (model.world.open.iter())
        .filter(|(node, _)| nodes.contains(node))
        .map(|(_, gap)| *gap)
        .collect();
    found.sort_unstable();
    found.dedup();
    let found = found.into_iter().map(|gap| &gaps[gap]);
    found.map(|gap| (gap.what.clone(), gap.location)).collect()
}

/// Asks of what is proved and has a left side whether that is ever so.
fn note_untriggered(model: &Model, answers: &mut [Answer], end: Instant) {
    let asked: Vec<(usize, Lit)> = (answers.iter().zip(&model.properties).enumerate())
        .filter(|(_, (answer, _))| matches!(answer.verdict, Verdict::Proved(_)))
        .filter_map(|(n, (_, property))| Some((n, property.trigger?)))
        .collect();
    if asked.is_empty() {
        return;
    }
    let targets: Vec<Lit> = asked.iter().map(|(_, trigger)| *trigger).collect();
    let depth = Depth {
        base: 8,
        step: 8,
        end: end.min(Instant::now() + Duration::from_secs(2)),
    };
    for ((n, _), known) in asked.into_iter().zip(decide(model, &targets, depth).0) {
        answers[n].never_triggered = matches!(known, Known::Never(_));
    }
}

/// The timers on which a literal depends and that take longer than was searched.
fn long_timers(
    simulation: &Simulation,
    model: &Model,
    target: Lit,
    scans: usize,
) -> Vec<(String, Option<Location>)> {
    let nodes = reach(model, std::iter::once(target));
    let matters = |ages: &Vec<usize>| {
        let mut leaves = ages.iter().map(|n| model.world.states[*n].leaf.node());
        leaves.any(|node| nodes.contains(&node))
    };
    let program = simulation.program();
    let tags = program.tags.iter().zip(&simulation.compiled().homes);
    let mut found = Vec::new();
    for (tag, home) in tags {
        let Home::State { bits, .. } = home else { continue };
        let is_in_it = model.world.timers.iter().zip(&model.world.ages);
        let mut is_in_it = is_in_it.filter(|(timer, ages)| **timer == bits.0 && matters(ages));
        if is_in_it.next().is_none() {
            continue;
        }
        match model.world.presets.get(&bits.0) {
            Some(Some(preset)) if *preset >= scans as u64 => {
                found.push((format!("{} takes {preset} scans", tag.name), Some(tag.location)));
            }
            Some(None) => found.push((
                format!("{} has a preset that changes", tag.name),
                Some(tag.location),
            )),
            _ => {}
        }
    }
    found
}

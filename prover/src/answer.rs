//! The answers: what is known of each property, and why no more.

use crate::causes::{left_open, what_takes_long};
use crate::clock::Clock;
use crate::decide::{CONFLICTS, DEAR, Depth, Known, Seeks, decide};
use crate::encode;
use crate::graph::Lit;
use crate::lemmas;
use crate::limits::{End, LATE};
use crate::model::{Model, Target, build};
use crate::progress::Listener;
pub use crate::replay::Shown;
use crate::replay::{Wanted, replay};
use crate::sure::{Sure, depending, doubtful_assumptions};
use ladder_analysis::Cancel;
use ladder_analysis::program::Location;
use ladder_simulator::Simulation;
use ladder_simulator::scenario::{Form, Watched};
use ladder_simulator::value_text::duration;
use std::time::Duration;

/// How much may be done, and for whom.
#[derive(Debug, Clone)]
pub struct Options {
    /// For all properties of a file.
    pub time: Duration,
    /// How many steps the solver may make, where what is found must not depend on how fast it is.
    pub steps: Option<u64>,
    /// How many scans from the cold start are searched.
    pub scans: usize,
    /// Measures the time.
    pub clock: Clock,
    /// What is not decided once it is cancelled is unknown: it is asked often.
    pub cancel: Cancel,
    /// Hears how far it is.
    pub listener: Listener,
}

impl Default for Options {
    /// 20 seconds and 200 scans.
    fn default() -> Options {
        Options {
            time: Duration::from_secs(20),
            steps: None,
            scans: 200,
            clock: Clock::default(),
            cancel: Cancel::default(),
            listener: Listener::default(),
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
    /// What is assumed cannot hold at the start: nothing follows from it.
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
    /// The first scan known after which a fault happens in one of its expressions, which makes that FALSE.
    pub fault: Option<usize>,
    /// Of what is proved beside a plant and is not about that: whether it was not proved without.
    pub needs_plant: Option<bool>,
    /// Of what is proved or impossible over how many scans the induction goes.
    pub k: Option<usize>,
    /// How many clauses the solver had when it was decided.
    pub clauses: u64,
    /// How long it took until then, with the properties that are decided together with it.
    pub time: Duration,
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
    let Options {
        time,
        steps,
        scans: most_scans,
        clock,
        cancel,
        listener,
    } = options;
    let began = clock.now();
    let taken = || clock.now().saturating_sub(began);
    let end = End::after(time, &clock, &cancel).with_work(steps);
    let mut answers: Vec<Option<Answer>> = vec![None; watched.properties.len()];
    // First with times that may be anything: what holds then needs no counting.
    let open = build(simulation, watched, encode::Times::Open, &end);
    let targets: Vec<Lit> = open.properties.iter().map(|property| property.bad).collect();
    let depth = Depth {
        base: 5,
        step: 5,
        end: end.clone(),
        seeks: Seeks::Every,
        conflicts: DEAR,
        listener,
    };
    let (known, clauses) = decide(&open, &targets, &depth);
    let is_late = end.is_over();
    for (n, known) in known.into_iter().enumerate() {
        if is_late || matches!(known, Known::Never(_) | Known::Vacuous) {
            let cause = left_open(&open, targets[n]);
            let answer = answer(watched, n, known, Times::Any, cause);
            answers[n] = Some(answer.after(clauses, taken()));
        }
    }
    let rest: Vec<usize> = (0..answers.len()).filter(|n| answers[*n].is_none()).collect();
    let may_be_noted = |property: &Target| property.trigger.is_some() || property.fault != Lit::FALSE;
    if is_late || rest.is_empty() && !open.properties.iter().any(may_be_noted) {
        let mut answers: Vec<Answer> = answers.into_iter().flatten().collect();
        for answer in &mut answers {
            note_end(answer, &end, &cancel);
        }
        return Ok(answers);
    }
    let mut exact = build(simulation, watched, encode::Times::Exact, &end);
    if !rest.is_empty() {
        let targets: Vec<Lit> = rest.iter().map(|n| exact.properties[*n].bad).collect();
        lemmas::add(&mut exact, &targets, &end);
        let depth = Depth {
            base: most_scans,
            step: 20,
            conflicts: CONFLICTS,
            ..depth.clone()
        };
        let (mut known, clauses) = decide(&exact, &targets, &depth);
        make_sure(&exact, &targets, &mut known, &depth);
        for (n, known) in rest.into_iter().zip(known) {
            let cause = left_open(&exact, exact.properties[n].bad);
            let found = match known {
                Known::Found(run) => {
                    let shown = replay(
                        simulation,
                        watched,
                        (n, Wanted::Property),
                        (&run, &exact.world.inputs),
                    );
                    match shown {
                        Some(shown) => Answer::of(found(watched, n, shown), cause),
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
            answers[n] = Some(found.after(clauses, taken()));
        }
    }
    let mut answers: Vec<Answer> = answers.into_iter().flatten().collect();
    for (answer, property) in answers.iter_mut().zip(&exact.properties) {
        if let Verdict::Unknown(scans) = answer.verdict {
            let long = what_takes_long(simulation, &exact, property.bad, scans);
            answer.open.extend(long);
            note_end(answer, &end, &cancel);
            if scans > 0 && !simulation.program().plants.is_empty() {
                answer.open.push((slow_plant(simulation, scans), None));
            }
            if answer.open.is_empty() && scans < most_scans {
                let why = format!("what happens in scan {scans} is too hard for the solver");
                answer.open.push((why, None));
            }
        }
    }
    note_untriggered(&exact, &mut answers, &depth);
    note_faults(simulation, watched, &exact, &mut answers, &depth);
    Ok(answers)
}

/// A run that was found and needs a value that an unread part writes counts for nothing. One that needs none may be there.
fn make_sure(model: &Model, targets: &[Lit], known: &mut [Known], depth: &Depth) {
    if model.world.unread.is_empty() {
        return;
    }
    let depends = depending(model);
    let assumes = !doubtful_assumptions(model).is_empty();
    let is_found =
        |n: &usize| matches!(known[*n], Known::Found(_)) && (assumes || depends[targets[*n].node()]);
    let doubtful: Vec<usize> = (0..known.len()).filter(is_found).collect();
    if doubtful.is_empty() {
        return;
    }
    let sure = Sure::of(model);
    let sure_targets: Vec<Lit> = doubtful.iter().map(|n| sure.lit(targets[*n])).collect();
    let found = decide(&sure.model, &sure_targets, depth).0;
    for (n, found) in doubtful.into_iter().zip(found) {
        known[n] = match (found, &known[n]) {
            (Known::Found(run), _) => Known::Found(run),
            (_, Known::Found(run)) => Known::NotIn(run.scans - 1),
            (_, other) => other.clone(),
        };
    }
}

impl Answer {
    fn of(verdict: Verdict, open: Vec<(String, Option<Location>)>) -> Answer {
        Answer {
            verdict,
            open,
            never_triggered: false,
            fault: None,
            needs_plant: None,
            k: None,
            clauses: 0,
            time: Duration::ZERO,
        }
    }

    fn after(self, clauses: u64, time: Duration) -> Answer {
        Answer {
            clauses,
            time,
            ..self
        }
    }
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
    let k = match known {
        Known::Never(k) => Some(k),
        _ => None,
    };
    let verdict = match known {
        Known::Never(_) if is_possible(watched, property) => Verdict::Impossible(times),
        Known::Never(_) => Verdict::Proved(times),
        Known::Vacuous => Verdict::Vacuous,
        Known::NotIn(scans) => Verdict::Unknown(scans),
        Known::Found(run) => Verdict::Unknown(run.scans.saturating_sub(1)),
    };
    Answer {
        k,
        ..Answer::of(verdict, open)
    }
}

/// What may help where a machine is slow: in fewer scans it comes as far.
fn slow_plant(simulation: &Simulation, scans: usize) -> String {
    const COARSER: i64 = 5;
    let interval = simulation.options().interval;
    let seen = interval.saturating_mul(scans as i64);
    format!(
        "the search saw {} of the machine: a coarser interval reaches further, as in: interval {}",
        duration(seen),
        duration(interval.saturating_mul(COARSER))
    )
}

/// Says of what is not known whether more time may help, if nothing else says why it is not.
fn note_end(answer: &mut Answer, end: &End, cancel: &Cancel) {
    let is_said = answer.open.iter().any(|(what, _)| what == LATE);
    if !matches!(answer.verdict, Verdict::Unknown(_)) || is_said {
        return;
    }
    let why = match (end.is_over(), cancel.is_cancelled()) {
        (true, false) => "the time was over",
        (true, true) => "it was stopped",
        (false, _) if answer.open.is_empty() => "no induction excludes a longer run: an assumption may help",
        (false, _) => return,
    };
    answer.open.push((why.to_owned(), None));
}

/// Asks of what is proved and has a left side whether that is ever so.
fn note_untriggered(model: &Model, answers: &mut [Answer], depth: &Depth) {
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
        ..depth.clone()
    };
    for ((n, _), known) in asked.into_iter().zip(decide(model, &targets, &depth).0) {
        answers[n].never_triggered = matches!(known, Known::Never(_));
    }
}

/// Looks for runs in which a fault happens in an expression of a property.
fn note_faults(
    simulation: &mut Simulation,
    watched: &mut Watched,
    model: &Model,
    answers: &mut [Answer],
    depth: &Depth,
) {
    let faults = model.properties.iter().map(|property| property.fault);
    let asked: Vec<(usize, Lit)> = faults
        .enumerate()
        .filter(|(_, fault)| *fault != Lit::FALSE)
        .collect();
    if asked.is_empty() {
        return;
    }
    let targets: Vec<Lit> = asked.iter().map(|(_, fault)| *fault).collect();
    let depth = Depth {
        base: 20,
        step: 4,
        ..depth.clone()
    };
    for ((n, _), known) in asked.into_iter().zip(decide(model, &targets, &depth).0) {
        if let Known::Found(run) = known {
            let shown = replay(
                simulation,
                watched,
                (n, Wanted::Fault),
                (&run, &model.world.inputs),
            );
            answers[n].fault = shown.and_then(|shown| shown.scans().checked_sub(1));
        }
    }
}

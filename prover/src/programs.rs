//! Whether two whole programs do the same in every run: a miter of both.
//!
//! ```text
//! two simulations --both--> one graph, shared inputs --merged--> what is the same by its form is one node
//!     --runs with inputs that are held--> a difference, soon --merged, by induction--> more is one node
//!     --decide--> all that is left is never different, or a run --divergence--> in both simulators, made readable
//! ```

use crate::both::{Both, both};
use crate::clock::Clock;
use crate::decide::{CONFLICTS, Depth, Known, Run, Seeks, decide, dependents, inputs_of, reach};
use crate::divergence::Stage;
pub use crate::divergence::{Differing, Divergence, Row, Which};
use crate::equal::{another_part, is_another};
use crate::graph::Lit;
use crate::lanes::Lanes;
use crate::lemmas;
use crate::limits::End;
use crate::merged::{drop_seen, keep, merge};
use crate::model::Model;
use crate::progress::Listener;
use crate::shown_tags::{self, shared};
use crate::sure::{depending, doubtful_assumptions};
use ladder_analysis::Cancel;
use ladder_simulator::Simulation;
use ladder_simulator::scenario::Watched as Assumed;
use std::time::Duration;

/// How much may be done to compare two programs.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// In all.
    pub time: Duration,
    /// How many scans from the cold start the solver searches.
    pub scans: usize,
    /// To make a run readable that was found: so many blocks are run. It is not a time, so that a run comes out the same everywhere.
    pub readable: u64,
}

impl Default for Limits {
    /// 5 seconds and 200 scans, and ten million blocks more.
    fn default() -> Limits {
        Limits {
            time: Duration::from_secs(5),
            scans: 200,
            readable: 10_000_000,
        }
    }
}

/// What is known of two programs.
#[derive(Debug, Clone, PartialEq)]
pub enum Whole {
    /// With the same inputs they show the same after every scan, from the cold start on, whatever goes in.
    Same,
    /// They do not: a run that shows it, as it went in the simulator.
    Differs(Box<Divergence>),
    /// Neither was found: why.
    Unknown(String),
}

/// A difference was found that the simulator does not have, though nothing was left open: an error of the prover.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotReproduced;

/// Runs before the solver is asked: for how many scans inputs are held in each of them, by and large.
const SOON: [u64; 5] = [2, 8, 4, 32, 16];
/// How many scans these have, of a machine of so many nodes.
const SOON_SCANS: std::ops::RangeInclusive<usize> = 24..=400;
const SOON_NODES: usize = 2_000_000;
/// The same later, where the solver has found nothing near.
const LATE: [u64; 3] = [64, 512, 16];
const LATE_SCANS: usize = 2_000;
/// The steps of all runs of either kind.
const MOST_STEPS: usize = 150_000_000;
/// So many scans are searched before guesses about what always holds are made.
const SHORT: usize = 3;
/// How many runs with a difference are played, where something was left open that may not be so.
const MOST_PLAYED: usize = 8;

/// Compares what two programs show to the outside or keep: outputs, direct addresses, VAR_GLOBAL and undeclared tags that they
/// write, retentive tags, faults, and their end. Tags that only one has are not compared. Both are left in some state.
///
/// # Errors
/// See [`NotReproduced`].
pub fn compare_programs(
    old: &mut Simulation,
    new: &mut Simulation,
    limits: Limits,
) -> Result<Whole, NotReproduced> {
    compare_programs_assuming(old, new, &mut Assumed::default(), limits)
}

/// The same in runs in which something is assumed of what goes into the old program: runs in which that does not hold count for nothing.
///
/// # Errors
/// See [`NotReproduced`].
pub fn compare_programs_assuming(
    old: &mut Simulation,
    new: &mut Simulation,
    assumed: &mut Assumed,
    limits: Limits,
) -> Result<Whole, NotReproduced> {
    let end = End::after(limits.time, &Clock::default(), &Cancel::default());
    if old.options().interval != new.options().interval {
        return Ok(Whole::Unknown("the times between scans differ".into()));
    }
    let shared = match shared(old, new) {
        Ok(shared) => shared,
        Err(why) => return Ok(Whole::Unknown(why)),
    };
    let both = match both(old, new, &shared, &assumed.assumptions, &end) {
        Ok(both) => both,
        Err(why) => return Ok(Whole::Unknown(why)),
    };
    let parts = [&*old, &*new].map(|simulation| simulation.compiled().code.unread.iter().collect());
    let another = another_part(parts).map(is_another);
    let stage = Stage {
        old,
        new,
        shared: &shared,
        assumed,
        blocks: 0,
        doubtful: doubtful(&both.model, &both.differs),
        was_stopped: false,
    };
    let whole = Search {
        stage,
        limits,
        end,
        open: None,
    }
    .search(both)?;
    Ok(match (whole, another.or(shared.untracked.clone())) {
        (Whole::Same, Some(why)) => Whole::Unknown(why),
        (whole, _) => whole,
    })
}

/// The outputs that only one of two programs has, by their names.
pub fn outputs_of_one(old: &Simulation, new: &Simulation) -> Vec<(Which, String)> {
    shown_tags::outputs_of_one(old, new)
}

/// Why a run that was found tells nothing.
const STOPPED: &str = "a scan does not come to its end: the watchdog stops it";

struct Search<'s> {
    stage: Stage<'s>,
    limits: Limits,
    end: End,
    /// What was left open and may be the reason for a difference that the simulator does not have.
    open: Option<String>,
}

impl Search<'_> {
    fn search(mut self, both: Both) -> Result<Whole, NotReproduced> {
        let Both {
            model,
            differs,
            mut pairs,
            ..
        } = both;
        let wanted = possible(&differs);
        if wanted.is_empty() {
            return Ok(Whole::Same);
        }
        let scans = SOON_NODES / model.world.graph.len();
        let scans = scans.clamp(*SOON_SCANS.start(), *SOON_SCANS.end());
        if let Some(found) = self.try_runs(&model, &wanted, &mut pairs, (&SOON, scans))? {
            return Ok(Whole::Differs(Box::new(found)));
        }
        let kept = keep(&model, &wanted, pairs, &self.end);
        let merged = merge(&model, &kept);
        let differs: Vec<Lit> = differs.iter().map(|lit| merged.lit(*lit)).collect();
        // What holds the same in both, whatever that is, decides about no difference.
        self.stage.doubtful = doubtful(&merged.model, &differs);
        self.decide(merged.model, possible(&differs))
    }

    /// Runs in which inputs are held: most differences show in one of them.
    fn try_runs(
        &mut self,
        model: &Model,
        wanted: &[Lit],
        pairs: &mut Vec<(usize, usize)>,
        (holds, scans): (&[u64], usize),
    ) -> Result<Option<Divergence>, NotReproduced> {
        let inputs = inputs_of(model, wanted);
        let mut played = 0;
        for (round, hold) in (1u64..).zip(holds.iter().copied()) {
            let mut lanes = Lanes::new(model, wanted, round * 0x9E37_79B9, hold);
            for _ in 0..scans.min(MOST_STEPS / holds.len() / lanes.steps()) {
                if self.end.is_over() || played == MOST_PLAYED {
                    return Ok(None);
                }
                lanes.scan();
                drop_seen(model, pairs, &lanes);
                let found = wanted.iter().fold(0, |found, lit| found | lanes.value(*lit)) & lanes.alive;
                if found == 0 {
                    continue;
                }
                let run = lanes.run(found.trailing_zeros(), &inputs);
                played += 1;
                if let Some(found) = self.play(model, wanted, &run)? {
                    return Ok(Some(found));
                }
                // What goes on after a difference that is none shows nothing more.
                break;
            }
        }
        Ok(None)
    }

    /// Plays a run that was found in a model.
    fn play(
        &mut self,
        model: &Model,
        wanted: &[Lit],
        run: &Run,
    ) -> Result<Option<Divergence>, NotReproduced> {
        if let Some(found) = self.stage.play(run, &model.world.inputs, self.limits.readable) {
            return Ok(Some(found));
        }
        let stopped = self.stage.was_stopped.then(|| STOPPED.to_owned());
        let open = open(model, wanted).or(stopped).ok_or(NotReproduced)?;
        self.open.get_or_insert(open);
        Ok(None)
    }

    /// Proves that what is left never differs, or finds a run.
    fn decide(mut self, mut model: Model, wanted: Vec<Lit>) -> Result<Whole, NotReproduced> {
        // What depends on nothing that was left open first: a run of it is one.
        let unsure = dependents(&model, model.world.open.keys().copied());
        let (unsure, sure): (Vec<Lit>, Vec<Lit>) = wanted.iter().partition(|lit| unsure[lit.node()]);
        let mut reached = usize::MAX;
        for (mut wanted, seeks) in [(sure, Seeks::One), (unsure, Seeks::Every)] {
            for (base, step) in [(SHORT, SHORT), (self.limits.scans, 20)] {
                if wanted.is_empty() {
                    break;
                }
                if base > SHORT {
                    if let Some(found) =
                        self.try_runs(&model, &wanted, &mut Vec::new(), (&LATE, LATE_SCANS))?
                    {
                        return Ok(Whole::Differs(Box::new(found)));
                    }
                    lemmas::add(&mut model, &wanted, &self.end);
                }
                let depth = Depth {
                    base,
                    step,
                    end: self.end.clone(),
                    seeks,
                    conflicts: CONFLICTS,
                    listener: Listener::default(),
                };
                let known = decide(&model, &wanted, &depth).0;
                let mut left = Vec::new();
                for (lit, known) in wanted.into_iter().zip(known) {
                    match known {
                        Known::Never(_) | Known::Vacuous => {}
                        Known::NotIn(scans) => {
                            left.push(lit);
                            if base > SHORT {
                                reached = reached.min(scans);
                            }
                        }
                        Known::Found(run) => {
                            if let Some(found) = self.play(&model, &[lit], &run)? {
                                return Ok(Whole::Differs(Box::new(found)));
                            }
                        }
                    }
                }
                wanted = left;
            }
        }
        Ok(match (self.open, reached) {
            (Some(open), _) => Whole::Unknown(open),
            (None, usize::MAX) => Whole::Same,
            (None, reached) => Whole::Unknown(format!("no difference in {reached} scans, and no proof")),
        })
    }
}

/// Those of some differences that may be, each once.
fn possible(differs: &[Lit]) -> Vec<Lit> {
    let mut possible = differs.to_vec();
    possible.retain(|lit| *lit != Lit::FALSE);
    possible.sort_unstable();
    possible.dedup();
    possible
}

/// Of each difference whether what unread parts write decides about it. The simulator does not have that, so it shows none.
fn doubtful(model: &Model, differs: &[Lit]) -> Vec<bool> {
    let depends = depending(model);
    differs.iter().map(|lit| depends[lit.node()]).collect()
}

/// What was left open that one of these depends on.
fn open(model: &Model, wanted: &[Lit]) -> Option<String> {
    let assumed = doubtful_assumptions(model);
    let nodes = reach(model, wanted.iter().copied().chain(assumed));
    let open = model.world.open.iter();
    let open = open.filter(|(node, _)| nodes.contains(node)).map(|(_, gap)| *gap);
    Some(model.world.gaps[open.min()?].what.clone())
}

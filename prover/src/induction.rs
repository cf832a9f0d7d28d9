//! The step of an induction: what cannot be violated after so many scans without a violation, from whichever state.

use crate::decide::{Depth, Known, cone};
use crate::graph::Lit;
use crate::model::Model;
use crate::unrolled::{Found, From, Unrolled};

/// Conflicts that one question may have, after which the next scan may help.
const CONFLICTS: u64 = 20_000;
/// How often a question is put again without a run that repeats itself.
const MOST_REPEATS: usize = 100;
/// Runs of more bits that are remembered are not asked for repetitions.
const MOST_COMPARED: usize = 4_000;

/// See the module.
pub(crate) struct Induction<'m> {
    pub(crate) step: Unrolled<'m>,
    targets: &'m [Lit],
    /// One for each target: where it is high, the target is low in all scans but the last.
    selectors: Vec<Lit>,
    /// The leaves of what is remembered.
    states: Vec<Lit>,
    depth: &'m Depth,
    scans: usize,
}

impl<'m> Induction<'m> {
    pub(crate) fn new(model: &'m Model, targets: &'m [Lit], depth: &'m Depth) -> Induction<'m> {
        let mut step = Unrolled::new(model, From::Anywhere, &depth.end);
        Induction {
            selectors: targets.iter().map(|_| step.selector()).collect(),
            states: cone(model, targets).into_iter().collect(),
            step,
            targets,
            depth,
            scans: 0,
        }
    }

    /// Adds a scan, before which none of the chosen properties is violated, unless the solver has done more than it may by now.
    /// False: there is none to ask about.
    pub(crate) fn add_scan(&mut self, most_work: u64) -> bool {
        let is_enough = self.scans >= self.depth.step || self.step.work() > most_work;
        if is_enough || self.step.is_full() || !self.step.add_scan() {
            return false;
        }
        if let Some(before) = self.scans.checked_sub(1) {
            for (&target, &selector) in self.targets.iter().zip(&self.selectors) {
                let bad = self.step.lit(before, target);
                self.step.require_one(&[!selector, !bad]);
            }
        }
        self.scans += 1;
        true
    }

    /// Notes which open properties cannot be violated in the last scan if none of them was in those before. Only those are asked about that
    /// no run from the cold start violates in as many scans; `reached` says in how many.
    pub(crate) fn decide(&mut self, known: &mut [Option<Known>], reached: &[usize], most_work: u64) {
        let is_open = |n: &usize| known[*n].is_none() && reached[*n] >= self.scans;
        let open = (0..self.targets.len()).filter(is_open).collect();
        for n in self.lasting(open, most_work) {
            known[n] = Some(Known::Never(self.scans - 1));
            self.step.require(self.selectors[n]);
        }
    }

    /// Those of the open properties that exclude the violation of each of them. None, if more work would be needed.
    fn lasting(&mut self, mut open: Vec<usize>, most_work: u64) -> Vec<usize> {
        let last = self.scans - 1;
        loop {
            let before = open.clone();
            for n in before.iter().copied() {
                let bad = self.step.lit(last, self.targets[n]);
                let mut question: Vec<Lit> = open.iter().map(|n| self.selectors[*n]).collect();
                question.push(bad);
                let mut repeats = 0;
                loop {
                    if self.step.work() > most_work {
                        return Vec::new();
                    }
                    match self.step.ask(&question, self.depth.conflicts.min(CONFLICTS)) {
                        Found::No => break,
                        // A run that comes back to where it was need not be followed.
                        Found::Yes if repeats < MOST_REPEATS && self.forbid_repeat() => repeats += 1,
                        _ => {
                            open.retain(|other| *other != n);
                            break;
                        }
                    }
                }
            }
            if open.len() == before.len() {
                return open;
            }
        }
    }

    /// Excludes two scans of the run that was found to begin in the same state, if two do.
    fn forbid_repeat(&mut self) -> bool {
        let Induction { step, states, .. } = self;
        let last = self.scans - 1;
        if states.is_empty() || last == 0 || states.len() > MOST_COMPARED {
            return false;
        }
        // All must be known to the solver, or their values mean nothing: then the question is put once more.
        let mut is_new = false;
        for scan in 0..=last {
            for state in states.iter() {
                is_new |= step.make_known(scan, *state);
            }
        }
        if is_new {
            return true;
        }
        let of = |scan: usize| -> Vec<bool> { states.iter().map(|state| step.value(scan, *state)).collect() };
        let seen: Vec<Vec<bool>> = (0..=last).map(of).collect();
        for one in 0..last {
            for other in one + 1..=last {
                if seen[one] == seen[other] {
                    let pairs: Vec<(Lit, Lit)> = states
                        .iter()
                        .map(|state| (step.lit(one, *state), step.lit(other, *state)))
                        .collect();
                    let differ = step.differ(&pairs);
                    step.require(differ);
                    return true;
                }
            }
        }
        false
    }
}

//! Verdicts on programs, by the prover; and next to it by judges that see something else than what is there.

use super::case::Case;
use super::runs;
use ladder_prover::{Limits, Options, Verdict, Whole, compare_programs, prove};
use ladder_simulator::scenario::{bind_properties, parse};
use std::time::Duration;

/// The program that a judge sees, and the one that it is compared with.
pub(crate) type Sees = fn(&mut Case, &mut Case);

/// The prover itself.
pub(crate) const fn all(_: &mut Case, _: &mut Case) {}

/// How often each was reported.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) refused: usize,
    pub(crate) never: usize,
    pub(crate) found: usize,
    pub(crate) unknown: usize,
    pub(crate) same: usize,
    pub(crate) differs: usize,
    pub(crate) undecided: usize,
}

/// Asks for properties of a program. Returns the verdicts that a run contradicts.
pub(crate) fn wrong_proof(
    case: &Case,
    properties: &str,
    seed: u64,
    sees: Sees,
    tally: &mut Tally,
) -> Option<String> {
    let mut seen = case.clone();
    sees(&mut seen, &mut case.clone());
    let Some(mut simulation) = seen.opened() else {
        tally.refused += 1;
        return None;
    };
    let suite = parse(properties);
    assert_eq!(suite.errors, [], "{properties}");
    let (mut watched, errors) = bind_properties(&suite, &simulation);
    assert_eq!(errors, [], "{seen}\n{properties}");
    let options = Options {
        time: Duration::from_millis(400),
        scans: 8,
        ..Options::default()
    };
    let answers = prove(&mut simulation, &mut watched, options).unwrap_or_else(|refuted| {
        panic!(
            "seed {seed}: a run of \"{}\" does not happen\n{seen}",
            refuted.name
        )
    });
    let is_never = |verdict: &Verdict| matches!(verdict, Verdict::Proved(_) | Verdict::Impossible(_));
    let is_found = |verdict: &Verdict| matches!(verdict, Verdict::Violated(_) | Verdict::Possible(_));
    let told: Vec<bool> = answers.iter().map(|answer| is_never(&answer.verdict)).collect();
    let found = answers.iter().filter(|answer| is_found(&answer.verdict)).count();
    let never = told.iter().filter(|told| **told).count();
    tally.never += never;
    tally.found += found;
    tally.unknown += answers.len() - never - found;
    if never == 0 {
        return None;
    }
    let run = runs::violated(case, properties, &told, seed)?;
    Some(format!(
        "seed {seed}: this never happens, it is reported: {run}\n{case}\n{properties}"
    ))
}

/// Asks whether two programs do the same. A run that contradicts that they do.
pub(crate) fn wrong_sameness(
    old: &Case,
    new: &Case,
    seed: u64,
    sees: Sees,
    tally: &mut Tally,
) -> Option<String> {
    let (mut was, mut is) = (old.clone(), new.clone());
    sees(&mut was, &mut is);
    sees(&mut is, &mut was);
    let (Some(mut before), Some(mut after)) = (was.opened(), is.opened()) else {
        tally.refused += 1;
        return None;
    };
    let limits = Limits {
        time: Duration::from_millis(400),
        scans: 8,
        readable: 100_000,
    };
    let whole = compare_programs(&mut before, &mut after, limits)
        .unwrap_or_else(|_| panic!("seed {seed}: a difference was found that does not happen\n{was}\n{is}"));
    match whole {
        Whole::Same => tally.same += 1,
        Whole::Differs(run) => {
            tally.differs += 1;
            let is_so = runs::is_so(before, after, &run);
            return (!is_so)
                .then(|| format!("seed {seed}: this is no difference: {run:?}\n{was}\nand\n{is}"));
        }
        Whole::Unknown(_) => {
            tally.undecided += 1;
            return None;
        }
    }
    let run = runs::differing(old, new, seed)?;
    Some(format!(
        "seed {seed}: they do the same, it is reported, and differ: {run}\n{old}\nand\n{new}"
    ))
}

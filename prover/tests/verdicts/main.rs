//! What the prover says of generated programs, next to runs of these in the simulator.
//!
//! ```text
//! seed --generate--> a case: a program, the files around it, what is an input of it
//!      --properties, edits--> questions --judge--> proved, the same --runs--> a run that contradicts it: an error
//! ```
//!
//! What is an input the generator knows, and not the analysis: so an input that the prover takes for a constant is found. The planted
//! errors are judges that see another program than the one that runs.
//!
//! What decides these verdicts is compared with the simulator cell by cell in [`followed`].
//!
//! `GENERATED_PROGRAMS=20000 cargo test -p ladder-prover --test verdicts` tries more; what fails names its seed.

mod case;
mod edits;
mod followed;
mod followed_profiles;
mod generate;
mod judge;
mod planted;
mod properties;
mod runs;
mod same_networks;
mod same_programs;

use case::Case;
use judge::{Sees, Tally};
use ladder_analysis::program::Program;
use ladder_generator::generator::{Dice, Mode, program};
use std::sync::Arc;

/// The program of a text; none if it has errors.
fn compile(text: &str) -> Option<Arc<Program>> {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(text)), "program");
    ladder_analysis::link(&Arc::new(analysis), &|_| None).ok()
}

/// How many edits of a program are compared with it.
const EDITS: usize = 4;

fn programs() -> u64 {
    let asked = std::env::var("GENERATED_PROGRAMS").ok();
    asked.and_then(|asked| asked.parse().ok()).unwrap_or(60)
}

/// Asks a judge all about a program: what it says that runs contradict.
fn ask(case: &Case, seed: u64, sees: Sees, tally: &mut Tally) -> Vec<String> {
    let mut dice = Dice::new(seed ^ 0x5EED);
    let Some(properties) = properties::properties(case, &mut dice) else {
        tally.refused += 1;
        return Vec::new();
    };
    let mut wrong: Vec<String> = judge::wrong_proof(case, &properties, seed, sees, tally)
        .into_iter()
        .collect();
    for _ in 0..EDITS {
        if let Some(new) = edits::edited(case, &mut dice) {
            wrong.extend(judge::wrong_sameness(case, &new, seed, sees, tally));
        }
    }
    wrong
}

/// Asks about as many programs as `made` makes: the verdicts on them.
fn no_run_contradicts(programs: u64, made: impl Fn(u64) -> Option<Case>) -> Tally {
    let mut tally = Tally::default();
    // So that several nights try different programs.
    let first = std::env::var("FIRST_PROGRAM").ok();
    let first: u64 = first.and_then(|first| first.parse().ok()).unwrap_or(0);
    for seed in first..first + programs {
        let Some(case) = made(seed) else { continue };
        let wrong = ask(&case, seed, judge::all, &mut tally);
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
    println!("{tally:?}");
    tally
}

#[test]
fn no_run_contradicts_a_verdict() {
    let tally = no_run_contradicts(programs(), |seed| Some(generate::case(seed)));
    let programs = programs() as usize;
    assert!(tally.refused * 4 < programs, "{tally:?}");
    assert!(
        tally.never >= programs / 2 && tally.found >= programs / 4,
        "{tally:?}"
    );
    assert!(
        tally.same >= programs / 8 && tally.differs >= programs / 8,
        "{tally:?}"
    );
}

/// Programs with any wiring and every instruction.
#[test]
fn no_run_contradicts_a_verdict_of_wild_programs() {
    let modes = [Mode::Boolean, Mode::Sensible, Mode::Wild, Mode::Typed];
    let tally = no_run_contradicts(programs() / 5, |seed| {
        Case::of_text(&program(seed, modes[seed as usize % modes.len()]))
    });
    let programs = programs() as usize;
    assert!(
        tally.never >= programs / 10 && tally.found >= programs / 10,
        "{tally:?}"
    );
    assert!(
        tally.same >= programs / 40 && tally.differs >= programs / 40,
        "{tally:?}"
    );
}

//! Whether two whole programs do the same: as far as their networks say it one by one, and then by their runs.

use crate::comparison::{Change, Comparison};
use crate::meaning::number;
use crate::outline::Kind;
use crate::used::Used;
use crate::verdict::Verdict;
use crate::words::{heading, reason};
use ladder_prover::{
    Compared, Divergence, Limits, Meaning, Which, compare_programs, outputs_of_one, rows_of,
};
use ladder_simulator::value_text::duration;
use ladder_simulator::{Options, Simulation};

/// If more networks have moved, each is not asked whether its place matters: runs say it sooner.
const MOST_MOVED: usize = 8;

/// What is known of two programs.
#[derive(Debug, Clone, PartialEq)]
pub enum Whole {
    /// They do the same.
    Same,
    /// They do not: a run shows it.
    Differs(Box<Divergence>),
    /// They have other outputs: which.
    Outputs(Vec<String>),
    /// It is not known: why.
    NotDecided(Vec<String>),
    /// A run was found that the simulator does not have: an error of the prover.
    Refuted,
}

/// What is said of [`Whole::Refuted`].
pub const REFUTED: &str = "a run was found that the simulator does not have: this is an error of the prover";

impl Comparison<'_> {
    /// Asks whether the programs do the same, once that was [asked](Comparison::decide) of their edited networks: where these do
    /// not settle it, whether some run shows a difference. Programs of more `networks` than these are not run.
    pub fn decide_whole(&mut self, limits: Limits, networks: usize) {
        let is_network = |change: &&Change<'_>| change.entry().kind == Kind::Network;
        let count = self.changes.iter().filter(is_network).count();
        self.whole = match by_networks(self) {
            Ok(()) => Some(Whole::Same),
            Err(open) => (count <= networks).then(|| self.by_runs(limits, open)),
        };
    }

    fn by_runs(&self, limits: Limits, mut open: Vec<String>) -> Whole {
        let asked = self.programs().and_then(|[old, new]| {
            let options = Options {
                interval: interval_of_both(old.cycle, new.cycle)?,
                ..Options::default()
            };
            let simulation = |program| Simulation::new(program, options).map_err(|error| error.message);
            let (mut old, mut new) = (simulation(old)?, simulation(new)?);
            let outputs = outputs_of_one(&old, &new);
            if !outputs.is_empty() {
                return Ok(Whole::Outputs(outputs.into_iter().map(only_one_has).collect()));
            }
            match compare_programs(&mut old, &mut new, limits) {
                Ok(ladder_prover::Whole::Same) => Ok(Whole::Same),
                Ok(ladder_prover::Whole::Differs(run)) => Ok(Whole::Differs(run)),
                Ok(ladder_prover::Whole::Unknown(why)) => Err(why),
                Err(ladder_prover::NotReproduced) => Ok(Whole::Refuted),
            }
        });
        asked.unwrap_or_else(|why| {
            if !open.contains(&why) {
                open.push(why);
            }
            Whole::NotDecided(open)
        })
    }
}

/// The time between scans for which both programs are made, in nanoseconds: one that does not say runs as the other.
fn interval_of_both(old: Option<i64>, new: Option<i64>) -> Result<i64, String> {
    match (old, new) {
        (Some(old), Some(new)) if old != new => Err("they are made for other times between scans".into()),
        (old, new) => Ok(old.or(new).unwrap_or(Options::default().interval)),
    }
}

fn only_one_has((which, name): (Which, String)) -> String {
    let which = match which {
        Which::Old => "old",
        Which::New => "new",
    };
    format!("only the {which} program has the output {name}")
}

/// What is said of a run in which two programs differ, and its rows.
pub fn said(run: &Divergence) -> (String, Vec<String>) {
    let scan = run.scans.saturating_sub(1);
    let time = duration(run.interval.saturating_mul(scan as i64));
    let mut said = format!("the programs differ in scan {scan}, at {time}");
    let which = |is_old: bool| if is_old { "old" } else { "new" };
    if run.differs.is_empty() {
        let faulted = run.faults.each_ref().map(|faults| faults.last() == Some(&true));
        said.push_str(&match run.ended {
            Some(ended) => format!(": only the {} program ends", which(ended == Which::Old)),
            None => format!(": a fault happens only in the {} program", which(faulted[0])),
        });
    }
    (said, rows_of(run))
}

/// Whether the networks say it one by one: all must be there in both and do the same, in an order that is the same or does not
/// matter.
///
/// # Errors
/// They do not: why.
fn by_networks(comparison: &Comparison<'_>) -> Result<(), Vec<String>> {
    let is_as_written = |change: &Change<'_>| is_harmless(change) && change.meaning.is_none();
    if comparison.uses.is_empty() && comparison.changes.iter().all(is_as_written) {
        return Ok(());
    }
    let compared = comparison
        .compared()
        .as_ref()
        .map_err(|cause| vec![cause.clone()])?;
    let mut open: Vec<String> = comparison.uses.iter().map(Used::to_string).collect();
    let moved = comparison.changes.iter().filter(|change| change.moved).count();
    for change in &comparison.changes {
        let is_asked = change.moved && moved <= MOST_MOVED;
        if is_harmless(change) || (is_asked && may_move(comparison, change, compared)) {
            continue;
        }
        let mut said = heading(comparison, change);
        if let Some(reason) = reason(change) {
            said.push_str(&format!(": {reason}"));
        }
        if change.moved && says_the_same(change) {
            said.push_str(": it has passed networks, and the order may matter");
        }
        open.push(said);
    }
    for tag in compared.declared_differently() {
        open.push(format!("{tag} is declared or used differently"));
    }
    if open.is_empty() { Ok(()) } else { Err(open) }
}

/// Whether a change cannot matter by itself.
pub(crate) fn is_harmless(change: &Change<'_>) -> bool {
    let kind = change.entry().kind;
    if kind == Kind::Comment {
        return true;
    }
    let is_in_structure = change.entry().place.starts_with(Kind::Structure.text());
    if change.moved && (kind == Kind::Network || is_in_structure) {
        return false;
    }
    says_the_same(change)
}

fn says_the_same(change: &Change<'_>) -> bool {
    matches!(
        change.verdict,
        Verdict::Same | Verdict::Redrawn | Verdict::Commented
    ) || change.meaning == Some(Meaning::Same)
}

/// Whether a network that has moved may change places with each of those that it has passed.
fn may_move(comparison: &Comparison<'_>, change: &Change<'_>, compared: &Compared) -> bool {
    let of = |change: &Change<'_>| {
        let old = number((comparison.old, change.old?))?;
        Some((old, number((comparison.new, change.new?))?))
    };
    let Some((old, new)) = of(change).filter(|_| says_the_same(change)) else {
        return false;
    };
    let others = comparison
        .changes
        .iter()
        .filter(|other| other.entry().kind == Kind::Network);
    others.filter_map(of).all(|(other_old, other_new)| {
        let has_passed = (old < other_old) != (new < other_new);
        !has_passed || old == other_old || compared.may_swap(new, other_new)
    })
}

//! Whether two whole programs do the same: as far as their networks say it one by one, and then by their runs.

use crate::by_networks::by_networks;
use crate::comparison::{Change, Comparison};
use crate::outline::{Kind, Outline, UnreadPart};
use ladder_analysis::names::scope::{Origin, SectionKind};
use ladder_prover::{Divergence, Limits, Which, compare_programs, outputs_of_one, rows_of};
use ladder_simulator::value_text::duration;
use ladder_simulator::{Options, Simulation};
use ladder_syntax::Name;
use std::collections::BTreeMap;
use std::sync::Arc;

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

/// What is reported about [`Whole::Refuted`].
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
                Ok(ladder_prover::Whole::Same) => {
                    let mut open = other_unread(self);
                    open.extend(shared_by_one(self));
                    Ok(if open.is_empty() {
                        Whole::Same
                    } else {
                        Whole::NotDecided(open)
                    })
                }
                Ok(ladder_prover::Whole::Differs(run)) => Ok(Whole::Differs(run)),
                Ok(ladder_prover::Whole::Unknown(why)) => Err(why),
                Err(ladder_prover::NotReproduced) => Ok(Whole::Refuted),
            }
        });
        asked.unwrap_or_else(|why| {
            // What was not read is the reason.
            if !open.contains(&why) && other_unread(self).is_empty() {
                open.push(why);
            }
            Whole::NotDecided(open)
        })
    }
}

/// The time between scans for which both programs are made, in nanoseconds.
fn interval_of_both(old: Option<i64>, new: Option<i64>) -> Result<i64, String> {
    let [old, new] = [old, new].map(|cycle| cycle.unwrap_or(Options::default().interval));
    if old != new {
        return Err("they are made for other times between scans".into());
    }
    Ok(old)
}

/// What is reported about tags that only one of two programs shares with other programs, which these runs do not have.
fn shared_by_one(comparison: &Comparison<'_>) -> Vec<String> {
    let shared = |outline: &Outline| -> BTreeMap<Name, String> {
        let tags = outline.context.scopes.iter().flat_map(|scope| &scope.tags);
        let shared = tags.filter(|tag| {
            let sections = [SectionKind::Global, SectionKind::External].map(Origin::Declared);
            sections.contains(&tag.origin) || tag.cold.foreign.is_some()
        });
        shared
            .map(|tag| (Name::new(&tag.name), tag.name.to_string()))
            .collect()
    };
    let [old, new] = [comparison.old, comparison.new].map(shared);
    let of_one = |which: &str, own: &BTreeMap<Name, String>, other: &BTreeMap<Name, String>| -> Vec<String> {
        let names = own.iter().filter(|(name, _)| !other.contains_key(*name));
        names
            .map(|(_, name)| format!("only the {which} program shares {name} with other programs"))
            .collect()
    };
    [of_one("old", &old, &new), of_one("new", &new, &old)].concat()
}

fn only_one_has((which, name): (Which, String)) -> String {
    let which = match which {
        Which::Old => "old",
        Which::New => "new",
    };
    format!("only the {which} program has the output {name}")
}

/// What is reported about a run in which two programs differ, and its rows.
pub fn told(run: &Divergence) -> (String, Vec<String>) {
    let scan = run.scans.saturating_sub(1);
    let time = duration(run.interval.saturating_mul(scan as i64));
    let mut told = format!("the programs differ in scan {scan}, at {time}");
    let which = |is_old: bool| if is_old { "old" } else { "new" };
    if run.differs.is_empty() {
        let faulted = run.faults.each_ref().map(|faults| faults.last() == Some(&true));
        told.push_str(&match run.ended {
            Some(ended) => format!(": only the {} program ends", which(ended == Which::Old)),
            None => format!(": a fault happens only in the {} program", which(faulted[0])),
        });
    }
    (told, rows_of(run))
}

/// What is reported about unread parts that are not the same in both programs, and in the files that they use.
pub(crate) fn other_unread(comparison: &Comparison<'_>) -> Vec<String> {
    let [old, new] = [comparison.old, comparison.new].map(unread_of);
    let gone = old.iter().filter(|part| !new.contains(part));
    let added = new.iter().filter(|part| !old.contains(part));
    let mut other: Vec<String> = added.chain(gone).map(|part| part.about.clone()).collect();
    other.dedup();
    other
}

/// The unread parts of a program and of the files that it uses.
pub(crate) fn unread_of(outline: &Outline) -> Vec<UnreadPart> {
    let files = outline.files.values();
    let used = files.flat_map(|file| Outline::new(Arc::clone(file)).unread());
    outline.unread().into_iter().chain(used).collect()
}

//! What edited networks do, next to what they did.

use crate::comparison::{Change, Comparison};
use crate::outline::{Entry, Kind, Outline};
use crate::verdict::Verdict;
use ladder_analysis::Cancel;
use ladder_analysis::program::Program;
use ladder_prover::{Compared, Meaning};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// For one network.
const TIME: Duration = Duration::from_secs(2);

impl Comparison<'_> {
    /// Asks of each edited network whether it does the same, for no longer than `time` in all, unless it is cancelled.
    pub fn decide(&mut self, time: Duration, cancel: &Cancel) {
        let end = Instant::now() + time;
        let is_asked =
            |change: &Change<'_>| change.verdict == Verdict::Edited && change.entry().kind == Kind::Network;
        if !self.changes.iter().any(is_asked) {
            return;
        }
        let mut changes = std::mem::take(&mut self.changes);
        let compared = self.compared();
        let asked = changes.iter_mut().filter(|change| is_asked(change));
        for change in asked.take_while(|_| !cancel.is_cancelled()) {
            let left = end.saturating_duration_since(Instant::now());
            let (old, new) = (
                change.old.map(|entry| (self.old, entry)),
                change.new.map(|entry| (self.new, entry)),
            );
            let numbers = || Some((number(old?)?, number(new?)?));
            change.meaning = Some(match (compared, numbers()) {
                (Err(cause), _) => Meaning::NotDecided(cause.clone()),
                (Ok(_), None) => continue,
                (Ok(_), _) if left.is_zero() => {
                    Meaning::NotDecided("the edits of all programs together take too long".into())
                }
                (Ok(compared), Some((old, new))) => compared.networks(old, new, left.min(TIME), cancel),
            });
        }
        self.changes = changes;
    }

    /// Both programs, compiled. An error says which of them does not run, and why.
    pub(crate) fn compared(&self) -> &Result<Compared, String> {
        self.compiled.get_or_init(|| {
            let [old, new] = self.programs()?;
            Compared::new(&old, &new)
        })
    }

    /// Both programs, as they run.
    ///
    /// # Errors
    /// One of them does not run: why.
    pub(crate) fn programs(&self) -> Result<[Arc<Program>; 2], String> {
        let program = |outline: &Outline, which| {
            let program = outline
                .program()
                .as_ref()
                .map(|running| Arc::clone(&running.program));
            program.map_err(|why| format!("the {which} program {why}"))
        };
        let (old, new) = (program(self.old, "old")?, program(self.new, "new")?);
        Ok([self.with_new_values(old, &new), new])
    }
}

/// The number of a network in its program.
pub(crate) fn number((outline, entry): (&Outline, &Entry)) -> Option<usize> {
    outline.program().as_ref().ok()?.number(outline, entry)
}

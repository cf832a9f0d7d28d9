//! A run in which two programs do not do the same: played in both simulators, and made readable.

use crate::decide::Run;
use crate::encode::Input;
use crate::replay::value;
use crate::shown_tags::Shared;
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::scenario::Watched as Assumed;
use ladder_simulator::{Point, Simulation, Status};

/// Inputs under which two programs differ, and what each of them shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Divergence {
    /// How many scans the run has: the programs differ after the last one.
    pub scans: usize,
    /// From one scan to the next, in nanoseconds.
    pub interval: i64,
    /// The tags that go in, with their values in each scan. One that is not among them holds its initial value.
    pub given: Vec<Row>,
    /// What differs after the last scan.
    pub differs: Vec<Differing>,
    /// In which scans a block recorded a fault: in the old program, and in the new one.
    pub faults: [Vec<bool>; 2],
    /// Which of them came to its end in the last scan, if only one did.
    pub ended: Option<Which>,
}

/// One of two programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Which {
    /// The one before the change.
    Old,
    /// The one after it.
    New,
}

/// A tag with its values in each scan.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// As the simulator resolves it.
    pub name: String,
    /// Its type.
    pub ty: Scalar,
    /// One a scan.
    pub values: Vec<Value>,
}

/// A tag with its values after each scan in both programs.
#[derive(Debug, Clone, PartialEq)]
pub struct Differing {
    /// As the simulator resolves it.
    pub name: String,
    /// Its type.
    pub ty: Scalar,
    /// In the old program.
    pub old: Vec<Value>,
    /// In the new program.
    pub new: Vec<Value>,
}

/// Both programs, to be played with the same inputs.
pub(crate) struct Stage<'s> {
    pub(crate) old: &'s mut Simulation,
    pub(crate) new: &'s mut Simulation,
    pub(crate) shared: &'s Shared,
    /// What is assumed of the runs, as the old program has it.
    pub(crate) assumed: &'s mut Assumed,
    /// How many blocks have run.
    pub(crate) blocks: u64,
    /// Of each value that is compared, of faults and of the end: a difference in it counts for nothing.
    pub(crate) doubtful: Vec<bool>,
    /// A scan of a run did not come to its end: the watchdog, which the model does not have, stopped it.
    pub(crate) was_stopped: bool,
}

/// A tag that goes in: where it does, and what it holds if nothing is given.
struct Given {
    name: String,
    ty: Scalar,
    points: [Option<Point>; 2],
    initial: Value,
    /// The programs begin with different values.
    is_shown: bool,
    values: Vec<Value>,
}

impl Stage<'_> {
    /// Plays a run that was found, and makes it readable with about so many `blocks`. None: both programs do the same in it.
    pub(crate) fn play(&mut self, run: &Run, inputs: &[Input], blocks: u64) -> Option<Divergence> {
        let mut given = self.given(run, inputs);
        let mut scans = self.first_difference(&given, run.scans)?;
        let most = self.blocks.saturating_add(blocks);
        self.shorten(&mut given, &mut scans, most);
        self.calm(&mut given, &mut scans, most);
        given.retain(|given| {
            given.is_shown || given.values[..scans].iter().any(|value| *value != given.initial)
        });
        Some(self.shown(&given, scans))
    }

    fn begin(&mut self) {
        for simulation in [&mut *self.old, &mut *self.new] {
            simulation.unforce_all();
            simulation.reset();
            simulation.take_faults();
        }
        self.assumed.restart();
    }

    fn given(&mut self, run: &Run, inputs: &[Input]) -> Vec<Given> {
        self.begin();
        let mut all = Vec::new();
        for (input, scans) in inputs.iter().zip(&run.inputs) {
            let name = input.tag.name.as_str();
            let sides = [(&*self.old, name), (&*self.new, self.shared.renamed.now(name))];
            let points = sides.map(|(simulation, name)| {
                let point = simulation.resolve(name).ok()?;
                point.is_input.then_some(point)
            });
            let held = sides.iter().zip(&points);
            let held = held.filter_map(|((simulation, _), point)| Some(simulation.value(point.as_ref()?)));
            let held: Vec<Value> = held.collect();
            let (Some(point), Some(initial)) = (points.iter().flatten().next(), held.first()) else {
                continue;
            };
            if scans.is_empty() {
                continue;
            }
            all.push(Given {
                name: point.name.clone(),
                ty: point.ty,
                is_shown: held.iter().any(|value| value != initial),
                initial: initial.clone(),
                values: scans.iter().map(|bits| value(point.ty, bits)).collect(),
                points,
            });
        }
        all
    }

    /// After how many scans of a run the programs differ first.
    fn first_difference(&mut self, given: &[Given], scans: usize) -> Option<usize> {
        self.begin();
        (0..scans).find_map(|scan| match self.scan(given, scan) {
            None => Some(None),
            Some(false) => None,
            Some(true) => Some(Some(scan + 1)),
        })?
    }

    /// Runs a scan: whether the programs differ after it. None: it cannot be run, or leaves what is assumed.
    fn scan(&mut self, given: &[Given], scan: usize) -> Option<bool> {
        for (n, simulation) in [&mut *self.old, &mut *self.new].into_iter().enumerate() {
            for given in given {
                let Some(point) = &given.points[n] else { continue };
                simulation.set(point, given.values[scan].clone()).ok()?;
            }
            let before = simulation.work();
            if simulation.status() != Status::Ready || !simulation.scan() {
                self.was_stopped = true;
                return None;
            }
            self.blocks += simulation.work().saturating_sub(before);
        }
        if self.assumed.broken_assumption(self.old).is_some() {
            return None;
        }
        let faulted = [&mut *self.old, &mut *self.new].map(|simulation| !simulation.take_faults().is_empty());
        let ends = faulted[0] != faulted[1] || self.old.status() != self.new.status();
        let ends_count = !self.doubtful[self.shared.watched.len()..].contains(&true);
        Some(self.different().next().is_some() || ends_count && ends)
    }

    /// The values that differ now, by their numbers.
    fn different(&self) -> impl Iterator<Item = usize> {
        let watched = self.shared.watched.iter().zip(&self.doubtful).enumerate();
        let counts = watched.filter(|(_, (_, doubtful))| !**doubtful);
        let differ =
            counts.filter(|(_, (watched, _))| self.old.value(&watched.old) != self.new.value(&watched.new));
        differ.map(|(number, _)| number)
    }

    /// Leaves out scans.
    fn shorten(&mut self, given: &mut [Given], scans: &mut usize, most: u64) {
        let mut size = *scans / 2;
        while size > 0 {
            let mut at = 0;
            while at + size <= *scans && *scans > 1 {
                if self.blocks >= most {
                    return;
                }
                let removed: Vec<Vec<Value>> = (given.iter_mut())
                    .map(|given| given.values.drain(at..at + size).collect())
                    .collect();
                match self.first_difference(given, *scans - size) {
                    Some(found) => *scans = found,
                    None => {
                        for (given, removed) in given.iter_mut().zip(removed) {
                            given.values.splice(at..at, removed);
                        }
                        at += size;
                    }
                }
            }
            size /= 2;
        }
    }

    /// Lets inputs stay what they were, one after the other.
    fn calm(&mut self, given: &mut [Given], scans: &mut usize, most: u64) {
        for n in 0..given.len() {
            let mut size = *scans;
            while size > 0 {
                let mut at = 0;
                while at < *scans {
                    if self.blocks >= most {
                        return;
                    }
                    let to = (at + size).min(*scans);
                    let before = match at.checked_sub(1) {
                        None => given[n].initial.clone(),
                        Some(before) => given[n].values[before].clone(),
                    };
                    if given[n].values[at..to].iter().any(|value| *value != before) {
                        let kept = given[n].values[at..to].to_vec();
                        given[n].values[at..to].fill(before);
                        match self.first_difference(given, *scans) {
                            Some(found) => *scans = found,
                            None => {
                                given[n].values.splice(at..to, kept);
                            }
                        }
                    }
                    at = to;
                }
                size /= 2;
            }
        }
    }

    fn shown(&mut self, given: &[Given], scans: usize) -> Divergence {
        self.begin();
        let mut values: Vec<[Vec<Value>; 2]> = vec![Default::default(); self.shared.watched.len()];
        let mut faults = [Vec::new(), Vec::new()];
        // Which tags differ is known after the last scan: until then only that many values are kept.
        let mut differs: Vec<usize> = Vec::new();
        for last in [true, false] {
            self.begin();
            for scan in 0..scans {
                for (n, simulation) in [&mut *self.old, &mut *self.new].into_iter().enumerate() {
                    for given in given {
                        if let Some(point) = &given.points[n] {
                            // It was set before.
                            let _ = simulation.set(point, given.values[scan].clone());
                        }
                    }
                    simulation.scan();
                    let faulted = !simulation.take_faults().is_empty();
                    if last {
                        faults[n].push(faulted);
                    }
                }
                if !last {
                    for &number in &differs {
                        let watched = &self.shared.watched[number];
                        values[number][0].push(self.old.value(&watched.old));
                        values[number][1].push(self.new.value(&watched.new));
                    }
                }
            }
            if last {
                differs = self.different().collect();
            }
        }
        let ended = match (self.old.status(), self.new.status()) {
            (Status::Ended, Status::Ended) => None,
            (Status::Ended, _) => Some(Which::Old),
            (_, Status::Ended) => Some(Which::New),
            _ => None,
        };
        let differing = differs.into_iter().map(|number| {
            let point = &self.shared.watched[number].old;
            let [old, new] = std::mem::take(&mut values[number]);
            Differing {
                name: point.name.clone(),
                ty: point.ty,
                old,
                new,
            }
        });
        Divergence {
            scans,
            interval: self.old.options().interval,
            given: given
                .iter()
                .map(|given| Row {
                    name: given.name.clone(),
                    ty: given.ty,
                    values: given.values[..scans].to_vec(),
                })
                .collect(),
            differs: differing.collect(),
            faults,
            ended,
        }
    }
}

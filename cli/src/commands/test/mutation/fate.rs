//! What is known of a change: whether a scenario notices it, whether it changes anything at all, and a run that shows it.

use super::held;
use super::subject::Subject;
use ladder_analysis::program::{Program, Role};
use ladder_analysis::values::value::Value;
use ladder_prover::{Divergence, Limits, Whole, compare_programs_assuming};
use ladder_simulator::scenario::{self, Case, Columns, Given, Line, LineKind, Ran, Suite};
use ladder_simulator::{Point, Simulation};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// What is known of a change.
pub(super) enum Fate {
    /// A scenario fails.
    Caught,
    /// None fails, and this run shows what it changes.
    Missed(Box<Run>),
    /// The program does the same, whatever goes in.
    Same,
    /// No scenario fails, and it is not known whether it changes anything: why.
    Unknown(String),
}

/// A run in which the changed program does another thing.
pub(super) struct Run {
    given: Vec<Given>,
    shown: Vec<Point>,
    pub(super) scans: usize,
    columns: Columns,
    /// What the changed program does in it, drawn.
    pub(super) drawing: Vec<Line>,
}

/// A single comparison may take so long.
const EACH: Duration = Duration::from_secs(5);
/// With more rows than this only those are expected that differ.
const MOST_ROWS: usize = 8;
/// A run of more scans is not made longer, so that each of them is a step; nor is one whose steps are longer than this.
const MOST_STEPS: usize = 40;
const MOST_SCANS_OF_STEP: usize = 1_000;
/// A name that scenarios do not have.
const NAME: &str = "\u{1}";

/// What is known of a change that no scenario notices.
pub(super) fn of_uncaught(subject: &Subject, changed: &Arc<Program>, end: Instant, width: usize) -> Fate {
    let left = end.saturating_duration_since(Instant::now());
    if left.is_zero() {
        return Fate::Unknown("there was no time left to compare it".into());
    }
    let start = |program: &Arc<Program>| Simulation::new(Arc::clone(program), subject.options());
    let (Ok(mut old), Ok(mut new)) = (start(&subject.program), start(changed)) else {
        return Fate::Caught;
    };
    let limits = Limits {
        time: left.min(EACH),
        ..Limits::default()
    };
    let shown = |run: Run| run.shown_to_differ(subject, changed, width);
    let (mut watched, _) = scenario::bind_properties(&subject.tested[0].suite, &old);
    let found = match compare_programs_assuming(&mut old, &mut new, &mut watched, limits) {
        Ok(Whole::Same) => return Fate::Same,
        Ok(Whole::Differs(divergence)) => {
            let found = Run::of(&mut old, &divergence);
            let found = found.ok_or("it differs in a run that is no scenario".to_owned());
            match found.and_then(shown) {
                Ok(run) if divergence.scans <= MOST_STEPS => return Fate::Missed(run),
                other => other,
            }
        }
        // What the simulator shows may rest on values that it does not have.
        Ok(Whole::Unknown(why)) if changed.unread_parts().next().is_some() => return Fate::Unknown(why),
        Ok(Whole::Unknown(why)) => Err(why),
        Err(_) => Err("a difference was found that the simulator does not have: please report this".into()),
    };
    let (found, why) = match found {
        Ok(run) => (Some(run), String::new()),
        Err(why) => (None, why),
    };
    // What a person wrote, held on, is easier to read than a long run that was found by chance.
    let held = held::differences(subject, (old, new)).filter_map(|run| shown(run).ok());
    let held = held.map(|run| (run.changes(), run.scans, run));
    let easiest = held
        .chain(found.map(|run| (run.changes(), usize::MAX, run)))
        .min_by_key(|(changes, scans, _)| (*changes, *scans));
    easiest.map_or(Fate::Unknown(why), |(.., run)| Fate::Missed(run))
}

impl Run {
    /// The run of a difference, with the tags that are worth a row: what differs, and the outputs that move.
    fn of(old: &mut Simulation, divergence: &Divergence) -> Option<Run> {
        let mut scans = divergence.scans;
        let mut given: Vec<Given> = Vec::new();
        for row in &divergence.given {
            given.push((old.resolve(&row.name).ok()?, row.values.clone()));
        }
        let differing = divergence
            .differs
            .iter()
            .map(|differing| old.resolve(&differing.name));
        let mut shown: Vec<Point> = differing.collect::<Result<_, _>>().ok()?;
        if shown.is_empty() {
            // A fault is seen in the scan after it.
            scans += 1;
            for (_, values) in &mut given {
                values.extend(values.last().cloned());
            }
            shown.push(old.resolve("SYS.FAULT").ok()?);
        }
        let outputs = outputs(old);
        let moving = moving(old, &given, scans, outputs)?.into_iter();
        let more: Vec<Point> = moving
            .filter(|point| !shown.iter().any(|known| known.name == point.name))
            .collect();
        if shown.len() + more.len() <= MOST_ROWS {
            shown.extend(more);
        }
        Some(Run::new(given, scans, shown))
    }

    pub(super) const fn new(given: Vec<Given>, scans: usize, shown: Vec<Point>) -> Run {
        Run {
            given,
            shown,
            scans,
            columns: Columns::Stretches,
            drawing: Vec::new(),
        }
    }

    /// How often what is given changes.
    fn changes(&self) -> usize {
        let changes = |values: &[Value]| values.windows(2).filter(|pair| pair[0] != pair[1]).count();
        self.given.iter().map(|(_, values)| changes(values)).sum()
    }

    /// The drawing as plain text.
    pub(super) fn drawn_text(&self) -> String {
        let lines: Vec<&str> = self.drawing.iter().map(|line| line.text.as_str()).collect();
        lines.join("\n")
    }

    /// As a scenario of what the program does today. None: it cannot be written.
    pub(super) fn scenario(&self, subject: &Subject, name: &str) -> Option<String> {
        let tested = &subject.tested[0];
        let mut simulation = Simulation::new(Arc::clone(&subject.program), tested.options).ok()?;
        let given = (&self.given[..], self.scans);
        let columns = (tested.scans_of_step(), self.columns);
        scenario::scenario_of_inputs(&mut simulation, given, &self.shown, name, columns)
    }

    /// The file of scenarios with this run as its last one.
    pub(super) fn suite(&self, subject: &Subject) -> Option<Suite> {
        let tested = &subject.tested[0];
        let scenario = self.scenario(subject, NAME)?;
        let suite = scenario::parse(&format!("{}\n\n{scenario}", tested.text));
        suite.errors.is_empty().then_some(suite)
    }

    /// The run, or one like it that is easier to read, as a scenario that passes today and fails in the changed program.
    ///
    /// # Errors
    /// There is none: why.
    fn shown_to_differ(
        self,
        subject: &Subject,
        changed: &Arc<Program>,
        width: usize,
    ) -> Result<Box<Run>, String> {
        let by_steps = self.by_steps(subject.tested[0].scans_of_step());
        let tries = by_steps.into_iter().chain([self]);
        let mut why = String::new();
        for mut run in tries {
            match run.drawn(subject, changed, width) {
                Ok(drawing) => {
                    run.drawing = drawing;
                    return Ok(Box::new(run));
                }
                Err(other) => why = other,
            }
        }
        Err(why)
    }

    /// The same with each scan as long as a step of the file.
    fn by_steps(&self, step: u64) -> Option<Run> {
        let step = usize::try_from(step).ok()?;
        if self.scans > MOST_STEPS || step > MOST_SCANS_OF_STEP {
            return None;
        }
        let longer = |values: &Vec<Value>| {
            let each = values.iter().take(self.scans);
            each.flat_map(|value| std::iter::repeat_n(value.clone(), step))
                .collect()
        };
        Some(Run {
            given: self
                .given
                .iter()
                .map(|(point, values)| (point.clone(), longer(values)))
                .collect(),
            shown: self.shown.clone(),
            scans: self.scans * step,
            columns: Columns::Steps,
            drawing: Vec::new(),
        })
    }

    /// What comes of it in the changed program, drawn. It passes in the program as it is.
    fn drawn(&self, subject: &Subject, changed: &Arc<Program>, width: usize) -> Result<Vec<Line>, String> {
        let unfit = || "it differs in a run that does not show it as a scenario".to_owned();
        let suite = self.suite(subject).ok_or_else(unfit)?;
        let today = last_of(&suite, &subject.program, subject).ok_or_else(unfit)?;
        if today.ran.outside.is_some() {
            return Err(
                "it differs where what is assumed does not hold; nothing is known where it does".into(),
            );
        }
        if !today.ran.passed() {
            return Err(unfit());
        }
        let mut then = last_of(&suite, changed, subject).ok_or_else(unfit)?;
        if then.ran.passed() {
            return Err(unfit());
        }
        if !then.ran.differences.is_empty() {
            then.ran.violations.clear();
        }
        let mut drawn = scenario::draw(&then.case, &then.ran, subject.options().interval, width);
        if !then.ran.differences.is_empty() {
            drawn.retain(|line| line.kind != LineKind::Sentence);
        }
        Ok(drawn)
    }
}

/// The outputs of a program, but for members.
pub(super) fn outputs(simulation: &Simulation) -> Vec<Point> {
    let points = simulation.points().iter();
    let outputs = points.filter(|point| point.role == Role::Output && !point.read_only);
    outputs
        .filter(|point| !point.name.contains('.'))
        .cloned()
        .collect()
}

/// Those of the points that hold another value in a run than at its cold start.
fn moving(old: &mut Simulation, given: &[Given], scans: usize, points: Vec<Point>) -> Option<Vec<Point>> {
    old.unforce_all();
    old.reset();
    let cold: Vec<_> = points.iter().map(|point| old.value(point)).collect();
    let mut moves = vec![false; points.len()];
    for scan in 0..scans {
        for (point, values) in given {
            old.set(point, values.get(scan)?.clone()).ok()?;
        }
        if !old.scan() {
            return None;
        }
        for (n, point) in points.iter().enumerate() {
            moves[n] |= old.value(point) != cold[n];
        }
    }
    let points = points.into_iter().zip(moves);
    Some(
        points
            .filter(|(_, moves)| *moves)
            .map(|(point, _)| point)
            .collect(),
    )
}

struct Last {
    case: Case,
    ran: Ran,
}

/// Runs the last scenario of a suite.
fn last_of(suite: &Suite, program: &Arc<Program>, subject: &Subject) -> Option<Last> {
    let mut simulation = Simulation::new(Arc::clone(program), subject.options()).ok()?;
    let (cases, errors) = scenario::bind(suite, &simulation);
    let (mut watched, of_properties) = scenario::bind_properties(suite, &simulation);
    if !errors.is_empty() || !of_properties.is_empty() {
        return None;
    }
    let case = cases.into_iter().next_back()?;
    let ran = scenario::run(&case, &mut watched, &mut simulation, Simulation::scan);
    Some(Last { case, ran })
}

/// Whether the run that a suite ends with notices a change.
pub(super) fn catches(suite: &Suite, changed: &Arc<Program>, subject: &Subject) -> bool {
    last_of(suite, changed, subject).is_none_or(|last| !last.ran.passed())
}

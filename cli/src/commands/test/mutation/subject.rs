//! A program with the scenarios that test it, which may be of several files.

use super::super::suite::Wishes;
use crate::findings::{Problem, Source};
use crate::ready::{Ready, program_alone};
use ladder_analysis::program::Program;
use ladder_prover::resting_on_unread;
use ladder_simulator::scenario::{self, Suite};
use ladder_simulator::{Options, Simulation, value_text};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// See the module.
pub(in super::super) struct Subject {
    pub(super) program: Arc<Program>,
    pub(in super::super) source: Arc<Source>,
    /// Its files of scenarios, in the order of the search.
    pub(super) tested: Vec<Tested>,
    /// The first scenario that fails though nothing was changed.
    pub(super) fails: Option<String>,
    /// What of it rests on unread parts, and why.
    resting: BTreeMap<String, String>,
}

/// The scenarios of a file.
pub(super) struct Tested {
    pub(super) file: PathBuf,
    pub(super) text: String,
    pub(super) suite: Suite,
    pub(super) options: Options,
    /// For each scenario how much work it may do, in blocks; none of one that is not wanted.
    limits: Vec<Option<u64>>,
}

/// A change makes a scenario run for longer if it comes to no end.
const MORE_WORK: u64 = 20;
const LEAST_WORK: u64 = 100_000;

/// The programs that files of scenarios test, each once. Files with errors are left out: what is wrong with them is reported elsewhere.
pub(super) fn subjects(files: &[PathBuf], wishes: &Wishes) -> Vec<Subject> {
    let mut subjects: Vec<Subject> = Vec::new();
    for file in files {
        let Ok(text) = ladder_workspace::read(file) else {
            continue;
        };
        let source = Source::new(file.display().to_string(), text);
        let Ok(ready) = Ready::new(file, &source, &wishes.renderer, &wishes.workspaces) else {
            continue;
        };
        let known = subjects
            .iter()
            .position(|subject| is_one_file(&subject.source.file, &ready.program.file));
        let at = known.unwrap_or_else(|| {
            subjects.push(Subject {
                resting: resting_on_unread(&ready.simulation),
                program: Arc::clone(ready.simulation.program()),
                source: Arc::clone(&ready.program),
                tested: Vec::new(),
                fails: None,
            });
            subjects.len() - 1
        });
        let (tested, fails) = Tested::new(file, source.text, ready, wishes);
        subjects[at].tested.push(tested);
        subjects[at].fails = subjects[at].fails.take().or(fails);
    }
    subjects
}

fn is_one_file(one: &str, other: &str) -> bool {
    one == other
        || matches!((Path::new(one).canonicalize(), Path::new(other).canonicalize()), (Ok(one), Ok(other)) if one == other)
}

/// Whether scenarios notice a change.
pub(super) enum Notice {
    Yes,
    No,
    /// One fails, and that may be otherwise where an unread part runs: why.
    Rests(String),
}

impl Subject {
    /// A program without scenarios.
    ///
    /// # Errors
    /// It cannot be read, or has errors.
    pub(super) fn of_program(file: &Path, wishes: &Wishes) -> Result<Subject, Vec<Problem>> {
        let (source, simulation) = program_alone(file, &wishes.renderer, &wishes.workspaces)?;
        let name = file.file_name().unwrap_or_default().display().to_string();
        let text = heading(&name, None, simulation.options());
        let tested = Tested {
            file: file.with_extension(ladder_workspace::SCENARIO_EXTENSION),
            suite: scenario::parse(&text),
            text,
            options: simulation.options(),
            limits: Vec::new(),
        };
        Ok(Subject {
            resting: resting_on_unread(&simulation),
            program: Arc::clone(simulation.program()),
            source,
            tested: vec![tested],
            fails: None,
        })
    }

    /// Whether a scenario notices that this program is in the place of the one that it tests: what cannot even run is noticed.
    pub(super) fn notice(&self, changed: &Arc<Program>) -> Notice {
        let mut notice = Notice::No;
        for tested in &self.tested {
            match tested.notice(changed, &self.resting) {
                Notice::Yes => return Notice::Yes,
                Notice::No => {}
                resting @ Notice::Rests(_) => notice = resting,
            }
        }
        notice
    }

    /// How the program runs: as the first file of scenarios says.
    pub(super) fn options(&self) -> Options {
        self.tested
            .first()
            .map_or_else(Options::default, |tested| tested.options)
    }
}

/// What a file of scenarios begins with.
fn heading(program: &str, step: Option<i64>, options: Options) -> String {
    let step = step.map_or_else(String::new, |step| {
        format!("step {}\n", value_text::duration(step))
    });
    let interval = value_text::duration(options.interval);
    format!("{}{step}interval {interval}\n", scenario::program_line(program))
}

impl Tested {
    /// What another file begins with whose scenarios have the same program and the same steps.
    pub(super) fn heading(&self) -> String {
        let name = self.suite.program.as_ref().map_or("", |(name, _)| name);
        heading(name, self.suite.step.map(|(step, _)| step), self.options)
    }

    fn new(file: &Path, text: String, ready: Ready, wishes: &Wishes) -> (Tested, Option<String>) {
        let Ready {
            suite,
            cases,
            mut watched,
            mut simulation,
            ..
        } = ready;
        let mut fails = None;
        let limits = cases.iter().map(|case| {
            if !wishes.wants(&case.name) {
                return None;
            }
            let before = simulation.work();
            let ran = scenario::run(case, &mut watched, &mut simulation, Simulation::scan);
            if !ran.passed() {
                fails.get_or_insert_with(|| case.name.clone());
            }
            let work = simulation.work() - before;
            Some(work.saturating_mul(MORE_WORK).saturating_add(LEAST_WORK))
        });
        let tested = Tested {
            limits: limits.collect(),
            file: file.to_owned(),
            text,
            suite,
            options: simulation.options(),
        };
        (tested, fails)
    }

    /// How many scans a step of the file has.
    pub(super) fn scans_of_step(&self) -> u64 {
        let step = self
            .suite
            .step
            .map_or(1, |(step, _)| step / self.options.interval.max(1));
        step.max(1).unsigned_abs()
    }

    /// `resting` is what of the program as it is rests on unread parts.
    fn notice(&self, changed: &Arc<Program>, resting: &BTreeMap<String, String>) -> Notice {
        let Ok(mut simulation) = Simulation::new(Arc::clone(changed), self.options) else {
            return Notice::Yes;
        };
        let (cases, _) = scenario::bind(&self.suite, &simulation);
        let (mut watched, _) = scenario::bind_properties(&self.suite, &simulation);
        let also = OnceCell::new();
        let mut notice = Notice::No;
        for (case, limit) in cases.iter().zip(&self.limits) {
            let Some(limit) = *limit else { continue };
            let ran = scenario::run_within(limit, case, &mut watched, &mut simulation, Simulation::scan);
            if ran.passed() {
                continue;
            }
            let also = also.get_or_init(|| resting_on_unread(&simulation));
            let rests = |name: &str| {
                let name = name.to_lowercase();
                resting.get(&name).or_else(|| also.get(&name))
            };
            let mut whys = Vec::new();
            whys.extend(ran.differences.iter().map(|difference| rests(&difference.tag)));
            for violation in &ran.violations {
                let mut properties = watched.properties.iter();
                let property = properties.find(|property| property.name == violation.name);
                let points = property
                    .map(ladder_simulator::scenario::Monitor::points)
                    .unwrap_or_default();
                whys.push(points.iter().find_map(|point| rests(&point.name)));
            }
            match whys.into_iter().collect::<Option<Vec<&String>>>() {
                Some(whys) if ran.stopped.is_none() && !whys.is_empty() => {
                    notice = Notice::Rests(whys[0].clone());
                }
                _ => return Notice::Yes,
            }
        }
        notice
    }
}

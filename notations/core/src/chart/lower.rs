//! From a chart to networks.

use super::actions;
use super::mentions;
use super::model::{Act, Chart, Qualifier};
use super::networks::{Networks, block, contact};
use super::transitions;
use super::whole_seconds;
use ladder_format::program::{Declaration, Expression, Item, Path};
use ladder_instructions::Op;
use std::collections::HashSet;

/// Charts have no more steps, transitions and actions.
const MOST: usize = 5_000;

/// How a chart knows what time has passed since it ran last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clock {
    /// It runs once in each scan.
    EachScan,
    /// It runs when something calls it: it remembers when.
    AtCalls,
}

/// What a chart is as ladder.
#[derive(Debug, Default)]
pub struct Lowered {
    /// Its networks.
    pub items: Vec<Item>,
    /// The tags that they need besides those of the unit.
    pub tags: Vec<Declaration>,
}

/// The networks of a chart. `fresh` is a name that begins so and that nothing has.
///
/// # Errors
///
/// What keeps it from being read.
pub fn lower(chart: Chart, clock: Clock, fresh: &mut dyn FnMut(&str) -> String) -> Result<Lowered, String> {
    check(&chart)?;
    let mut chart = chart;
    if chart.counts_late {
        counted_late(&mut chart);
    }
    let needs_elapsed = needs_elapsed(&chart);
    let mut lowering = Lowering {
        clock,
        counts_late: chart.counts_late,
        fresh,
        before: vec![None; chart.steps.len()],
        needs_elapsed,
        passed: None,
        first: Networks::default(),
        tags: Vec::new(),
    };
    lowering.steps(&chart);
    let mut rest = Networks::default();
    let Chart {
        steps,
        transitions,
        actions,
        counts_late: _,
    } = chart;
    transitions::lower(&mut lowering, &steps, transitions, &mut rest)?;
    actions::lower(&mut lowering, &steps, actions, &mut rest)?;
    lowering.begin(&steps)?;
    let Lowering { first, tags, .. } = lowering;
    let mut items = first.items();
    items.extend(rest.items());
    Ok(Lowered { items, tags })
}

fn check(chart: &Chart) -> Result<(), String> {
    let largest = chart
        .steps
        .len()
        .max(chart.transitions.len())
        .max(chart.actions.len());
    if largest > MOST {
        return Err(format!("it has more than {MOST} steps, transitions or actions"));
    }
    let mut names = HashSet::new();
    for step in &chart.steps {
        if !names.insert(step.name.to_lowercase()) {
            return Err(format!("two steps are called {}", step.name));
        }
    }
    if !chart.steps.iter().any(|step| step.is_initial) {
        return Err("no step is the first".to_owned());
    }
    let is_open = |ends: &[usize]| ends.is_empty();
    if chart
        .transitions
        .iter()
        .any(|one| is_open(&one.from) || is_open(&one.to))
    {
        return Err("a transition leads from no step, or to none".to_owned());
    }
    Ok(())
}

/// Comparisons of the time of a step with whole seconds, as generators count them.
fn counted_late(chart: &mut Chart) {
    let elapsed: HashSet<String> = chart
        .steps
        .iter()
        .map(|step| step.elapsed.to_lowercase())
        .collect();
    for transition in &mut chart.transitions {
        let condition = &mut transition.condition;
        whole_seconds::in_items(&mut condition.before, &elapsed);
        let power = condition.power.iter_mut();
        power.for_each(|part| whole_seconds::in_circuit(part, &elapsed));
    }
    for action in &mut chart.actions {
        if let Act::Body(items) = &mut action.act {
            whole_seconds::in_items(items, &elapsed);
        }
    }
}

/// Which steps something asks how long they are active.
fn needs_elapsed(chart: &Chart) -> Vec<bool> {
    let mut mentioned = HashSet::new();
    for transition in &chart.transitions {
        let condition = &transition.condition;
        mentions::of_items(&condition.before, &mut mentioned);
        let power = condition.power.iter();
        power.for_each(|part| mentions::of_circuit(part, &mut mentioned));
    }
    for action in &chart.actions {
        if let Act::Body(items) = &action.act {
            mentions::of_items(items, &mut mentioned);
        }
    }
    let is_needed = |qualifier: &Qualifier| qualifier.reads_elapsed();
    let steps = chart.steps.iter();
    steps
        .map(|step| {
            mentioned.contains(&step.elapsed.to_lowercase())
                || step.associations.iter().any(|one| is_needed(&one.qualifier))
        })
        .collect()
}

/// A chart on its way.
pub(super) struct Lowering<'f> {
    clock: Clock,
    /// See [`Chart::counts_late`].
    pub(super) counts_late: bool,
    fresh: &'f mut dyn FnMut(&str) -> String,
    /// Tags that hold what steps were in the scan before, where something asks.
    before: Vec<Option<String>>,
    /// Steps of which something asks how long they are active.
    pub(super) needs_elapsed: Vec<bool>,
    /// The tag of what time has passed since the chart ran last.
    passed: Option<String>,
    /// What a scan begins with: timers of actions.
    pub(super) first: Networks,
    tags: Vec<Declaration>,
}

impl Lowering<'_> {
    /// A tag that the source does not have.
    pub(super) fn tag(&mut self, like: &str, ty: &str, comment: impl Into<String>) -> String {
        let name = (self.fresh)(like);
        self.tags.push(Declaration {
            comment: Some(comment.into()),
            ..Declaration::new(name.clone(), ty)
        });
        name
    }

    /// A label.
    pub(super) fn fresh(&mut self, like: &str) -> String {
        (self.fresh)(like)
    }

    /// The tag that holds whether a step was active in the scan before.
    pub(super) fn before(&mut self, step: usize, name: &str) -> String {
        if let Some(tag) = &self.before[step] {
            return tag.clone();
        }
        let tag = self.tag(
            &format!("{name}_before"),
            "BOOL",
            format!("step {name} in the scan before"),
        );
        self.before[step] = Some(tag.clone());
        tag
    }

    /// What time has passed since the chart ran last.
    pub(super) fn passed(&mut self) -> Expression {
        if self.clock == Clock::EachScan {
            return Path::system("SCAN_TIME").into();
        }
        let name = match self.passed.take() {
            Some(name) => name,
            None => self.tag("passed", "TIME", "time since the chart ran last"),
        };
        self.passed = Some(name.clone());
        Path::tag(name).into()
    }

    fn steps(&mut self, chart: &Chart) {
        for (step, needs_elapsed) in chart.steps.iter().zip(&self.needs_elapsed) {
            self.tags.push(Declaration {
                initial: step.is_initial.then(|| "TRUE".to_owned()),
                comment: Some(format!("step {}", step.name)),
                origin: step.origin,
                ..Declaration::new(step.active.clone(), "BOOL")
            });
            if *needs_elapsed {
                self.tags.push(Declaration {
                    comment: Some(format!("how long step {} is active", step.name)),
                    ..Declaration::new(step.elapsed.clone(), "TIME")
                });
            }
        }
    }

    /// What a scan begins with: the time, what steps were, how long they are active, and then the timers of actions.
    fn begin(&mut self, steps: &[super::model::Step]) -> Result<(), String> {
        let timers = std::mem::take(&mut self.first).items();
        let passed = self.needs_elapsed.contains(&true).then(|| self.passed());
        let mut networks = Networks::default();
        if let Some(tag) = self.passed.clone() {
            let last = self.tag("ran_at", "TIME", "when the chart ran last");
            let now = || Expression::from(Path::system("TIME"));
            networks.comment("the time since the chart ran last");
            networks.push(vec![
                block(
                    Op::Sub,
                    [Path::tag(tag).into(), now(), Path::tag(&last).into()],
                    None,
                )?,
                block(Op::Mov, [Path::tag(&last).into(), now()], None)?,
            ]);
        }
        let mut is_told = false;
        for (number, step) in steps.iter().enumerate() {
            let mut parts = vec![contact(&step.active, step.origin)];
            if let Some(before) = &self.before[number] {
                parts.push(block(Op::Coil, [Path::tag(before).into()], step.origin)?);
            }
            if let (Some(passed), true) = (&passed, self.needs_elapsed[number]) {
                let elapsed = || Expression::from(Path::tag(&step.elapsed));
                parts.push(block(
                    Op::Add,
                    [elapsed(), elapsed(), passed.clone()],
                    step.origin,
                )?);
            }
            if parts.len() == 1 {
                continue;
            }
            if !std::mem::replace(&mut is_told, true) {
                networks.comment("steps in the scan before");
            }
            networks.push(parts);
        }
        networks.extend(timers);
        self.first = networks;
        Ok(())
    }
}

//! A chart (SFC) as a file draws it, and what its lines mean: which steps each transition leads from and to.

use super::graph::Graph;
use super::model::Body;
use ladder_notation::LineColumn;
use std::collections::HashMap;

/// Steps and transitions one after the other are followed no further.
const LONGEST: usize = 1_000;

/// A chart as it is drawn.
#[derive(Debug, Clone, Default)]
pub struct Drawn {
    /// Its elements as they are written, with their places.
    pub shown: Vec<(LineColumn, String)>,
    /// Steps, transitions, and what joins them.
    pub elements: Vec<Element>,
    /// What is drawn for the conditions of its transitions.
    pub conditions: Graph,
}

/// An element.
#[derive(Debug, Clone)]
pub struct Element {
    /// Where.
    pub place: LineColumn,
    /// What lines call it.
    pub id: String,
    /// The elements that lines come from, for each point where they end.
    pub from: Vec<Vec<String>>,
    /// What it is.
    pub kind: Kind,
}

/// What an element is.
#[derive(Debug, Clone)]
pub enum Kind {
    /// A step.
    Step {
        /// Its name.
        name: String,
        /// Whether it is active from the beginning.
        is_initial: bool,
    },
    /// A transition.
    Transition {
        /// As it is written.
        priority: Option<String>,
        /// When it may happen.
        condition: Condition,
    },
    /// To the step of this name.
    Jump(String),
    /// From one to one of several, or back.
    Selection,
    /// From one to several at once.
    SimultaneousDivergence,
    /// From several at once to one.
    SimultaneousConvergence,
    /// What a step does.
    Actions(Vec<Action>),
    /// What is not known.
    Other(String),
}

/// The condition of a transition.
#[derive(Debug, Clone)]
pub enum Condition {
    /// A text.
    Text(&'static str, String, LineColumn),
    /// The transition of this name of the unit.
    Named(String),
    /// The element of the drawing that all of it ends at.
    Drawn(usize),
    /// What is not known, or nothing.
    Other(String),
}

/// What a step does.
#[derive(Debug, Clone)]
pub struct Action {
    /// Where.
    pub place: LineColumn,
    /// `N`, `SD`
    pub qualifier: String,
    /// `T#5s`
    pub duration: Option<String>,
    /// What is done.
    pub what: What,
}

/// What a step does something with.
#[derive(Debug, Clone)]
pub enum What {
    /// An action of the unit, or a BOOL.
    Named(String),
    /// It is written here.
    Inline(Body),
}

/// What the lines of a chart mean; elements are named by their places in its list.
#[derive(Debug, Default)]
pub struct Flow {
    /// The steps in the order in which a generator writes them, each with its lists of actions.
    pub steps: Vec<(usize, Vec<usize>)>,
    /// The transitions in that order, with the steps that they lead from and to.
    pub transitions: Vec<(usize, Vec<usize>, Vec<usize>)>,
    /// The transitions in the order in which a generator meets them.
    pub met: Vec<usize>,
    /// The steps and transitions that nothing leads to, which are not compiled there.
    pub unreached: Vec<usize>,
}

/// Why a chart is not read, and where.
pub type Unclear = (LineColumn, String);

/// Finds out what the lines of a chart mean. The order is that of the generators of Beremiz and OpenPLC: from each initial step on, each
/// step is followed by all that its transitions lead to.
///
/// # Errors
///
/// Which element is not clear, and why.
pub fn flow(chart: &Drawn) -> Result<Flow, Unclear> {
    let mut by_id = HashMap::new();
    let mut by_name = HashMap::new();
    for (number, element) in chart.elements.iter().enumerate() {
        by_id.entry(element.id.as_str()).or_insert(number);
        if let Kind::Step { name, .. } = &element.kind
            && by_name.insert(name.to_lowercase(), number).is_some()
        {
            return Err((element.place, format!("two steps are called {name}")));
        }
    }
    let mut found = Found {
        chart,
        by_id,
        by_name,
        steps: HashMap::new(),
        transitions: HashMap::new(),
        initial: Vec::new(),
        met: Vec::new(),
        depth: 0,
    };
    for (number, element) in chart.elements.iter().enumerate() {
        match &element.kind {
            Kind::Step { .. } => found.step(number)?,
            Kind::Transition { .. } => found.transition(number)?,
            Kind::Jump(target) => found.jump(number, target)?,
            Kind::Actions(_) => found.actions(number)?,
            Kind::Selection | Kind::SimultaneousDivergence | Kind::SimultaneousConvergence => {}
            Kind::Other(what) => {
                return Err((element.place, format!("`{what}` is not read")));
            }
        }
    }
    let mut flow = Flow::default();
    for step in std::mem::take(&mut found.initial) {
        found.follow(step, &mut flow)?;
    }
    flow.met = found.met;
    let left = found.steps.into_keys().chain(found.transitions.into_keys());
    flow.unreached = left.collect();
    flow.unreached.sort_unstable();
    Ok(flow)
}

#[derive(Default)]
struct Step {
    actions: Vec<usize>,
    transitions: Vec<usize>,
}

#[derive(Default)]
struct Ends {
    from: Vec<usize>,
    to: Vec<usize>,
}

struct Found<'c> {
    chart: &'c Drawn,
    by_id: HashMap<&'c str, usize>,
    by_name: HashMap<String, usize>,
    steps: HashMap<usize, Step>,
    transitions: HashMap<usize, Ends>,
    initial: Vec<usize>,
    met: Vec<usize>,
    depth: usize,
}

impl Found<'_> {
    fn element(&self, number: usize) -> &Element {
        &self.chart.elements[number]
    }

    fn unclear<T>(&self, number: usize, why: &str) -> Result<T, Unclear> {
        Err((self.element(number).place, why.to_owned()))
    }

    /// Counts how deep something is followed.
    fn deeper(&mut self, number: usize) -> Result<(), Unclear> {
        self.depth += 1;
        if self.depth > LONGEST {
            return self.unclear(
                number,
                &format!("more than {LONGEST} elements are one after the other"),
            );
        }
        Ok(())
    }

    /// A step, and what leads to it.
    fn step(&mut self, number: usize) -> Result<(), Unclear> {
        if self.steps.contains_key(&number) {
            return Ok(());
        }
        if let Kind::Step { is_initial: true, .. } = self.element(number).kind {
            self.initial.push(number);
        }
        self.steps.insert(number, Step::default());
        self.deeper(number)?;
        for transition in self.before(number)? {
            self.transition(transition)?;
            self.leads_to(transition, number);
        }
        self.depth -= 1;
        Ok(())
    }

    fn jump(&mut self, number: usize, target: &str) -> Result<(), Unclear> {
        let Some(&step) = self.by_name.get(&target.to_lowercase()) else {
            return self.unclear(number, &format!("there is no step {target}"));
        };
        for transition in self.before(number)? {
            self.transition(transition)?;
            self.leads_to(transition, step);
        }
        Ok(())
    }

    fn leads_to(&mut self, transition: usize, step: usize) {
        let to = &mut self.transitions.entry(transition).or_default().to;
        if !to.contains(&step) {
            to.push(step);
        }
    }

    /// A transition, and the steps that it leads from.
    fn transition(&mut self, number: usize) -> Result<(), Unclear> {
        if self.transitions.contains_key(&number) {
            return Ok(());
        }
        self.transitions.insert(number, Ends::default());
        self.met.push(number);
        self.deeper(number)?;
        for step in self.after(number)? {
            self.step(step)?;
            self.transitions.entry(number).or_default().from.push(step);
            self.steps.entry(step).or_default().transitions.push(number);
        }
        self.depth -= 1;
        Ok(())
    }

    fn actions(&mut self, number: usize) -> Result<(), Unclear> {
        let lines: Vec<usize> = self.lines(number)?;
        let [step] = lines[..] else {
            return self.unclear(number, "a list of actions is not at one step");
        };
        if !matches!(self.element(step).kind, Kind::Step { .. }) {
            return self.unclear(number, "a list of actions is not at a step");
        }
        self.step(step)?;
        self.steps.entry(step).or_default().actions.push(number);
        Ok(())
    }

    /// The elements that lines come from.
    fn lines(&self, number: usize) -> Result<Vec<usize>, Unclear> {
        let ends = self.element(number).from.iter().flatten();
        let ends = ends.map(|id| match self.by_id.get(id.as_str()) {
            Some(end) => Ok(*end),
            None => self.unclear(number, &format!("a line comes from {id}, which is not there")),
        });
        ends.collect()
    }

    /// The transitions that lead to a step or a jump.
    fn before(&self, number: usize) -> Result<Vec<usize>, Unclear> {
        let mut waiting = self.lines(number)?;
        waiting.reverse();
        let mut transitions = Vec::new();
        let mut count = 0;
        while let Some(element) = waiting.pop() {
            count += 1;
            if count > LONGEST {
                return self.unclear(number, "its lines have no end");
            }
            match &self.element(element).kind {
                Kind::Transition { .. } => transitions.push(element),
                Kind::Selection => waiting.extend(self.lines(element)?.into_iter().rev()),
                Kind::SimultaneousDivergence => {
                    let lines = self.lines(element)?;
                    if lines.len() != 1 {
                        return self.unclear(element, "several lines end at it");
                    }
                    waiting.extend(lines);
                }
                _ => return self.unclear(number, "no transition is before it"),
            }
        }
        Ok(transitions)
    }

    /// The steps that a transition leads from.
    fn after(&self, number: usize) -> Result<Vec<usize>, Unclear> {
        let mut waiting = vec![number];
        let mut steps = Vec::new();
        let mut count = 0;
        while let Some(element) = waiting.pop() {
            count += 1;
            if count > LONGEST {
                return self.unclear(number, "its lines have no end");
            }
            match &self.element(element).kind {
                Kind::Step { .. } => {
                    if !steps.contains(&element) {
                        steps.push(element);
                    }
                    continue;
                }
                Kind::Transition { .. } if element != number => {
                    return self.unclear(number, "a transition follows another without a step between them");
                }
                Kind::Transition { .. } | Kind::Selection => {
                    if self.lines(element)?.len() != 1 {
                        return self.unclear(element, "not one line leads to it");
                    }
                }
                Kind::SimultaneousConvergence => {
                    if self.element(element).from.iter().any(|lines| lines.len() != 1) {
                        return self.unclear(element, "not one line leads to each of its points");
                    }
                }
                _ => return self.unclear(number, "no step is before it"),
            }
            waiting.extend(self.lines(element)?.into_iter().rev());
        }
        Ok(steps)
    }

    /// A step, and all that its transitions lead to, once.
    fn follow(&mut self, number: usize, flow: &mut Flow) -> Result<(), Unclear> {
        let Some(step) = self.steps.remove(&number) else {
            return Ok(());
        };
        self.deeper(number)?;
        flow.steps.push((number, step.actions));
        for transition in step.transitions {
            let Some(Ends { from, to }) = self.transitions.remove(&transition) else {
                continue;
            };
            if to.is_empty() {
                return self.unclear(transition, "no step is after it");
            }
            flow.transitions.push((transition, from, to.clone()));
            for step in to {
                self.follow(step, flow)?;
            }
        }
        self.depth -= 1;
        Ok(())
    }
}

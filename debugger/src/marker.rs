//! One breakpoint with what is written next to it: its conditions and its log message.

use std::collections::HashMap;

use ladder_analysis::program::Location;
use ladder_simulator::Breakpoint;
use ladder_simulator::expression::{Expression, Problem, Scope, Typed};

use crate::condition::{HitCondition, Piece, pieces};
use crate::messages::SourceBreakpoint;
use crate::target::Target;

/// An expression next to a breakpoint. In a body it means the tags of the place that runs, so it is compiled for each.
#[derive(Debug)]
struct Attached {
    text: String,
    compiled: HashMap<Option<String>, Expression>,
}

impl Attached {
    /// Compiles it for the place where it will be asked, as far as that is known, to find its errors.
    fn new(text: &str, target: &Target, location: Option<Location>) -> Result<Attached, Problem> {
        let block = location.and_then(|location| body_of(target, location));
        let simulation = target.simulation();
        let instance = block.and_then(|block| simulation.instances().iter().find(|it| it.block == block));
        let watch = Expression::new(text, Scope { simulation, instance })?;
        Ok(Attached {
            text: text.to_owned(),
            compiled: HashMap::from([(instance.map(|instance| instance.name.clone()), watch)]),
        })
    }

    /// The expression for the place that runs.
    fn watch(&mut self, target: &Target) -> Result<&mut Expression, Problem> {
        let scope = target.scope(None);
        let place = scope.instance.map(|instance| instance.name.clone());
        match self.compiled.entry(place) {
            std::collections::hash_map::Entry::Occupied(known) => Ok(known.into_mut()),
            std::collections::hash_map::Entry::Vacant(free) => {
                Ok(free.insert(Expression::new(&self.text, scope)?))
            }
        }
    }

    fn watch_any(&mut self) -> Option<&mut Expression> {
        self.compiled.values_mut().next()
    }

    fn holds(&mut self, target: &Target) -> Result<bool, Problem> {
        self.watch(target)?.holds(target.simulation())
    }

    fn evaluate(&mut self, target: &Target) -> Result<Typed, Problem> {
        self.watch(target)?.evaluate(target.simulation())
    }
}

/// The user-defined block in whose body a place lies.
fn body_of(target: &Target, location: Location) -> Option<usize> {
    let program = target.simulation().program();
    let is_around = |network: usize| {
        let around = program.networks[network].location;
        around.file == location.file && around.range.contains_range(location.range)
    };
    let mut blocks = program.blocks.iter();
    blocks.position(|block| block.networks.clone().any(is_around))
}

#[derive(Debug)]
enum LogPiece {
    Text(String),
    Expression(Attached),
}

/// A breakpoint with its conditions.
#[derive(Debug)]
pub(crate) struct Marker {
    /// The client's number of it.
    pub id: i64,
    pub breakpoint: Breakpoint,
    condition: Option<Attached>,
    hit_condition: Option<HitCondition>,
    log: Option<Vec<LogPiece>>,
    /// How often it was met.
    hits: u64,
}

/// What a breakpoint that is met asks for.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Verdict {
    /// To go on.
    Pass,
    /// To write this and go on.
    Log(String),
    /// To stop; with a remark if a condition cannot be evaluated.
    Stop(Option<String>),
}

impl Marker {
    pub(crate) fn new(
        id: i64,
        breakpoint: Breakpoint,
        target: &Target,
        location: Option<Location>,
        wanted: &SourceBreakpoint,
    ) -> Result<Marker, Problem> {
        let given = |text: &Option<String>| {
            text.as_deref()
                .map(str::trim)
                .filter(|text| !text.is_empty())
                .map(str::to_owned)
        };
        let condition = given(&wanted.condition).map(|text| {
            let next_to = Attached::new(&text, target, location);
            next_to.and_then(|mut next_to| {
                // A condition that is not a BOOL is found now; a fault is for later.
                let watch = next_to.watch_any();
                match watch.map(|watch| watch.evaluate(target.simulation())) {
                    Some(Ok(Typed { ty, .. })) if ty != ladder_analysis::values::types::Scalar::Bool => Err(
                        format!("`{text}` is of type {ty}; a condition is TRUE or FALSE, as in {text} > 0"),
                    ),
                    _ => Ok(next_to),
                }
            })
        });
        let hit_condition = given(&wanted.hit_condition).map(|text| HitCondition::read(&text));
        let log = given(&wanted.log_message).map(|message| {
            let pieces = pieces(&message)?.into_iter().map(|piece| match piece {
                Piece::Text(text) => Ok(LogPiece::Text(text)),
                Piece::Expression(text) => Attached::new(&text, target, location).map(LogPiece::Expression),
            });
            pieces.collect::<Result<Vec<_>, Problem>>()
        });
        Ok(Marker {
            id,
            breakpoint,
            condition: condition.transpose()?,
            hit_condition: hit_condition.transpose()?,
            log: log.transpose()?,
            hits: 0,
        })
    }

    /// What is to be done when it is met; `counts` if this is a hit of its own, not one that is met again.
    pub(crate) fn judge(&mut self, target: &Target, counts: bool) -> Verdict {
        match self.condition.as_mut().map(|condition| condition.holds(target)) {
            None | Some(Ok(true)) => {}
            Some(Ok(false)) => return Verdict::Pass,
            Some(Err(problem)) => {
                return Verdict::Stop(Some(format!("the condition cannot be evaluated: {problem}")));
            }
        }
        if counts {
            self.hits += 1;
            if self
                .hit_condition
                .is_some_and(|condition| !condition.holds(self.hits))
            {
                return Verdict::Pass;
            }
        }
        let Some(pieces) = &mut self.log else {
            return Verdict::Stop(None);
        };
        if !counts {
            return Verdict::Pass;
        }
        let mut line = String::new();
        for piece in pieces {
            match piece {
                LogPiece::Text(text) => line.push_str(text),
                LogPiece::Expression(next_to) => match next_to.evaluate(target) {
                    Ok(value) => line.push_str(&value.shown()),
                    Err(problem) => line.push_str(&format!("<{problem}>")),
                },
            }
        }
        line.push('\n');
        Verdict::Log(line)
    }
}

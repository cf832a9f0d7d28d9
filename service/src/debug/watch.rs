//! Expressions over the tags of a running program, in the language's own grammar.
//!
//! An expression is compiled by the engine itself: what it names is replaced by tags of a small program of its own, which has
//! the one block `[CALC]( result, expression )`. To evaluate it these tags are given what the running program holds, and
//! the small program runs one scan. So arithmetic, conversions and faults are those of the language.

use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_simulator::{Instance, Point, Simulation, value_text};
use ladder_syntax::Name;

use super::small_program::Small;

/// Why an expression cannot be evaluated, in words.
pub(super) type Problem = String;

/// Where names are looked up: in a body first among its own tags.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scope<'s> {
    pub simulation: &'s Simulation,
    pub instance: Option<&'s Instance>,
}

impl Scope<'_> {
    /// The place that a text names.
    pub(super) fn resolve(self, text: &str) -> Result<Point, Problem> {
        if let Some(instance) = self.instance {
            let own = self.simulation.resolve_within(instance, text);
            // What is not a tag of the body may be a global.
            if let Ok(point) = own {
                return Ok(point);
            }
        }
        self.simulation.resolve(text).map_err(|unknown| unknown.message)
    }

    /// A whole tag by its name, and the name that its parts begin with.
    pub(super) fn tag(self, text: &str) -> Option<(String, Type)> {
        let program = self.simulation.program();
        let (instance, rest) = match text.trim().rsplit_once('.') {
            Some((place, rest)) if place.starts_with('$') => {
                let place = Name::new(place);
                let mut all = self.simulation.instances().iter();
                (all.find(|instance| Name::new(&instance.name) == place), rest)
            }
            _ => (self.instance, text.trim()),
        };
        let wanted = Name::new(rest);
        let of_instance = instance.and_then(|instance| {
            let mut tags = instance.tags().map(|tag| &program.tags[tag.0 as usize]);
            let tag = tags.find(|tag| Name::new(&tag.name) == wanted)?;
            Some((format!("{}.{}", instance.name, tag.name), tag.ty))
        });
        of_instance.or_else(|| {
            let mut tags = program.tags.iter().filter(|tag| tag.block.is_none());
            let tag = tags.find(|tag| Name::new(&tag.name) == wanted)?;
            Some((tag.name.clone(), tag.ty))
        })
    }
}

/// An expression that can be evaluated again and again.
#[derive(Debug)]
pub(super) struct Watch {
    pub(super) kind: Kind,
}

#[derive(Debug)]
pub(super) enum Kind {
    /// One value.
    Point(Box<Point>),
    /// More than that.
    Computed {
        small: Box<Simulation>,
        /// What is read, and the tag of the small program that it goes to.
        inputs: Vec<(Point, Point)>,
        result: Box<Point>,
    },
}

/// A value with its type.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Typed {
    pub value: Value,
    pub ty: Scalar,
}

impl Typed {
    /// As people write it.
    pub(super) fn shown(&self) -> String {
        value_text::display(&self.value, self.ty)
    }
}

impl Watch {
    /// Compiles an expression.
    pub(super) fn new(text: &str, scope: Scope<'_>) -> Result<Watch, Problem> {
        let text = text.trim();
        if text.is_empty() {
            return Err("write an expression, such as count > 5".into());
        }
        if let Ok(point) = scope.resolve(text) {
            return Ok(Watch {
                kind: Kind::Point(Box::new(point)),
            });
        }
        Small::of(text, scope)?.compile(text)
    }

    /// The place that the expression is, if it is one.
    pub(super) fn point(&self) -> Option<&Point> {
        match &self.kind {
            Kind::Point(point) => Some(point),
            Kind::Computed { .. } => None,
        }
    }

    /// What it is now.
    pub(super) fn evaluate(&mut self, simulation: &Simulation) -> Result<Typed, Problem> {
        match &mut self.kind {
            Kind::Point(point) => Ok(Typed {
                value: simulation.value(point),
                ty: point.ty,
            }),
            Kind::Computed {
                small,
                inputs,
                result,
            } => {
                small.reset();
                for (from, to) in inputs {
                    // A real that is not finite is refused.
                    small
                        .set(to, simulation.value(from))
                        .map_err(|refused| refused.message.replace(&to.name, &from.name))?;
                }
                small.scan();
                match small.take_faults().into_iter().next() {
                    Some(fault) => Err(fault.message),
                    None => Ok(Typed {
                        value: small.value(result),
                        ty: result.ty,
                    }),
                }
            }
        }
    }

    /// Whether it is true. An expression that is not a BOOL is an error.
    pub(super) fn holds(&mut self, simulation: &Simulation) -> Result<bool, Problem> {
        match self.evaluate(simulation)? {
            Typed {
                value: Value::Bool(high),
                ..
            } => Ok(high),
            Typed { ty, .. } => Err(format!("a condition is TRUE or FALSE, and this is of type {ty}")),
        }
    }
}

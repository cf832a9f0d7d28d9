//! Expressions over the tags of a running program, in the language's own grammar.
//!
//! An expression is compiled by the engine itself: what it names is replaced by tags of a small program of its own, which has
//! the one block `[CALC]( result, expression )`. To evaluate it these tags are given what the running program holds, and
//! the small program runs one scan. So arithmetic, conversions and faults are those of the language.
//!
//! Those of properties may name the past, too: `rises(e)`, `falls(e)`, `was(e)`.

mod elements;
mod enumerations;
mod past;
mod small_program;

use crate::simulation::{Instance, Simulation};
use crate::tags::Point;
use crate::value_text;
use ladder_analysis::program::Tag;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_syntax::Name;
pub use past::{Past, PastKind};
use small_program::Small;
pub(crate) use small_program::expression_end;
pub use small_program::names;

/// Why an expression cannot be evaluated, in words.
pub type Problem = String;

/// Where names are looked up: in a body first among its own tags.
#[derive(Debug, Clone, Copy)]
pub struct Scope<'s> {
    /// The program that runs.
    pub simulation: &'s Simulation,
    /// The place of the body that is looked from, if it is one.
    pub instance: Option<&'s Instance>,
}

impl<'s> Scope<'s> {
    /// The place that a text names.
    ///
    /// # Errors
    /// It names none: why.
    pub fn resolve(self, text: &str) -> Result<Point, Problem> {
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
    pub fn tag(self, text: &str) -> Option<(String, Type)> {
        let (before, tag) = self.find(text)?;
        Some((format!("{before}{}", tag.name), tag.ty))
    }

    /// A tag by its name, and what is before its name in those of its parts.
    fn find(self, text: &str) -> Option<(String, &'s Tag)> {
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
            Some((format!("{}.", instance.name), tag))
        });
        of_instance.or_else(|| {
            let mut tags = program.tags.iter().filter(|tag| tag.block.is_none());
            let tag = tags.find(|tag| Name::new(&tag.name) == wanted)?;
            Some((String::new(), tag))
        })
    }
}

/// An expression that can be evaluated again and again.
#[derive(Debug)]
pub struct Expression {
    kind: Kind,
}

/// What an expression is made of.
#[derive(Debug)]
pub enum Kind {
    /// One value.
    Point(Box<Point>),
    /// More than that.
    Computed {
        /// The small program.
        small: Box<Simulation>,
        /// What is read, and the tag of the small program that it goes to.
        inputs: Vec<(Source, Point)>,
        /// The tag of the small program that has the value after a scan.
        result: Box<Point>,
    },
}

/// What an operand of an expression is read from.
#[derive(Debug)]
pub enum Source {
    /// A value of the running program.
    Point(Point),
    /// What another expression was before.
    Past(Box<Past>),
}

/// A value with its type.
#[derive(Debug, Clone, PartialEq)]
pub struct Typed {
    /// The value.
    pub value: Value,
    /// Its type.
    pub ty: Scalar,
}

impl Typed {
    /// As people write it.
    pub fn shown(&self) -> String {
        value_text::display(&self.value, self.ty)
    }
}

impl Expression {
    /// Compiles an expression.
    ///
    /// # Errors
    /// It is not an expression, names what is not there, or its types do not go together.
    pub fn new(text: &str, scope: Scope<'_>) -> Result<Expression, Problem> {
        let text = text.trim();
        if text.is_empty() {
            return Err("write an expression, such as count > 5".into());
        }
        if let Ok(point) = scope.resolve(text) {
            return Ok(Expression::of_point(point));
        }
        Small::of(text, scope, false)?.compile(text, None)
    }

    /// Compiles a condition that may name the past.
    ///
    /// # Errors
    /// The same, or it is not a BOOL.
    pub fn condition(text: &str, simulation: &Simulation) -> Result<Expression, Problem> {
        let scope = Scope {
            simulation,
            instance: None,
        };
        let expression = Expression::of_type(text, scope, Some(Scalar::Bool))?;
        match expression.ty() {
            Scalar::Bool => Ok(expression),
            ty => Err(format!("a condition is TRUE or FALSE, and this is of type {ty}")),
        }
    }

    /// Compiles an expression that may name the past. What is wrong is told of the type that is wanted.
    fn of_type(text: &str, scope: Scope<'_>, wanted: Option<Scalar>) -> Result<Expression, Problem> {
        let text = text.trim();
        if text.is_empty() {
            return Err("write an expression, such as count > 5".into());
        }
        match scope.resolve(text) {
            Ok(point) => Ok(Expression::of_point(point)),
            Err(_) => Small::of(text, scope, true)?.compile(text, wanted),
        }
    }

    fn of_point(point: Point) -> Expression {
        Expression {
            kind: Kind::Point(Box::new(point)),
        }
    }

    /// What it is made of.
    pub fn kind(&self) -> &Kind {
        &self.kind
    }

    /// The type of its value.
    pub fn ty(&self) -> Scalar {
        match &self.kind {
            Kind::Point(point) => point.ty,
            Kind::Computed { result, .. } => result.ty,
        }
    }

    /// The place that the expression is, if it is one.
    pub fn point(&self) -> Option<&Point> {
        match &self.kind {
            Kind::Point(point) => Some(point),
            Kind::Computed { .. } => None,
        }
    }

    /// The values of the running program that it reads, those of the past included.
    pub fn for_each_point(&self, read: &mut dyn FnMut(&Point)) {
        match &self.kind {
            Kind::Point(point) => read(point),
            Kind::Computed { inputs, .. } => {
                for (source, _) in inputs {
                    match source {
                        Source::Point(point) => read(point),
                        Source::Past(past) => past.of.for_each_point(read),
                    }
                }
            }
        }
    }

    /// Forgets what was before: the program starts cold.
    pub fn forget(&mut self) {
        self.for_each_before(&mut |before| *before = None);
    }

    /// What is remembered of the scan before, always in the same order: who goes back in a run puts back what it was there.
    pub fn for_each_before(&mut self, each: &mut dyn FnMut(&mut Option<Value>)) {
        if let Kind::Computed { inputs, .. } = &mut self.kind {
            for (source, _) in inputs {
                if let Source::Past(past) = source {
                    past.for_each_before(each);
                }
            }
        }
    }

    /// What it is now. Where it names the past, this is to be asked once after each scan.
    ///
    /// # Errors
    /// A fault happens in it.
    pub fn evaluate(&mut self, simulation: &Simulation) -> Result<Typed, Problem> {
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
                    let (value, name) = match from {
                        Source::Point(point) => (simulation.value(point), point.name.as_str()),
                        Source::Past(past) => (past.step(simulation), "what was"),
                    };
                    // A real that is not finite is refused.
                    small
                        .set(to, value)
                        .map_err(|refused| refused.message.replace(&to.name, name))?;
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

    /// Whether it is true.
    ///
    /// # Errors
    /// It is not a BOOL, or a fault happens in it.
    pub fn holds(&mut self, simulation: &Simulation) -> Result<bool, Problem> {
        match self.evaluate(simulation)? {
            Typed {
                value: Value::Bool(high),
                ..
            } => Ok(high),
            Typed { ty, .. } => Err(format!("a condition is TRUE or FALSE, and this is of type {ty}")),
        }
    }
}

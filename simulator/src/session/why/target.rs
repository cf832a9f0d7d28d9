//! What a block is about to write: the names, as its indices and its body's instance make them then.

use super::place;
use crate::simulation::{Scope, Simulation};
use crate::tags::Point;
use ladder_analysis::program::{Argument, Block, BlockKind, Bound, ParameterKind, UserBlock};
use ladder_analysis::values::value::Value;
use ladder_instructions::Direction;

/// More elements of a range than this are not compared by name: then only a change tells that one was written.
const MOST_ELEMENTS: i64 = 4096;

/// What a block is about to write.
#[derive(Debug, Default)]
pub(super) struct Target(Vec<Goal>);

#[derive(Debug)]
struct Goal {
    name: String,
    /// What the indices are made of.
    indices: Vec<(Point, Value)>,
    made_of: MadeOf,
}

#[derive(Debug)]
enum MadeOf {
    /// The operands of an instruction.
    Operands,
    /// These values, which are handed to a body before it runs.
    Input(Vec<(Point, Value)>),
    /// The output of a body, by its name in the instance.
    Output(String),
}

/// A point among what a block writes.
pub(super) struct Aim {
    /// The result is made of these; without them of the operands.
    pub(super) read: Option<Vec<(Point, Value)>>,
    pub(super) indices: Vec<(Point, Value)>,
    pub(super) moment: Written,
}

/// When a block writes something.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Written {
    /// As an input, before its body runs.
    BeforeBody,
    /// While it runs.
    ByItself,
    /// As an output, after its body has run.
    AfterBody,
}

impl Target {
    /// Of a block of a run with these names, and the names in its body.
    pub(super) fn of(
        simulation: &Simulation,
        (scope, inside): (&Scope, Option<&Scope>),
        block: &Block,
    ) -> Target {
        let mut target = Target::default();
        match (block.kind, inside) {
            (BlockKind::User(user), Some(inside)) => {
                let user = &simulation.program().blocks[user];
                // What an unread part does is not known.
                if user.unread.is_some() {
                    return target;
                }
                let en = MadeOf::Input(Vec::new());
                target.add(inside.tag(simulation, user.en), Vec::new(), en);
                for bound in &block.arguments {
                    target.add_parameter(simulation, (scope, inside), user, bound);
                }
            }
            _ => {
                let is_written = |bound: &&Bound| {
                    bound
                        .operand
                        .is_some_and(|operand| operand.direction != Direction::In)
                };
                for bound in block.arguments.iter().filter(is_written) {
                    target.add_operand(simulation, scope, &bound.argument);
                }
            }
        }
        target
    }

    fn add(&mut self, name: String, indices: Vec<(Point, Value)>, made_of: MadeOf) {
        self.0.push(Goal {
            name,
            indices,
            made_of,
        });
    }

    fn add_operand(&mut self, simulation: &Simulation, scope: &Scope, argument: &Argument) {
        match argument {
            Argument::Parts(parts) => {
                for part in parts {
                    self.add_operand(simulation, scope, part);
                }
            }
            Argument::Range(range) => {
                for name in place::range_names(simulation, scope, range, MOST_ELEMENTS) {
                    self.add(name, Vec::new(), MadeOf::Operands);
                }
            }
            argument => {
                if let Some(name) = scope.argument_name(simulation, argument) {
                    let indices = place::index_values(simulation, scope, argument);
                    self.add(name, indices, MadeOf::Operands);
                }
            }
        }
    }

    fn add_parameter(
        &mut self,
        simulation: &Simulation,
        (scope, inside): (&Scope, &Scope),
        user: &UserBlock,
        bound: &Bound,
    ) {
        let Some(parameter) = bound.parameter else { return };
        let (tag, kind) = user.parameters[parameter];
        let mut add = |inner: String, argument: &Argument| match kind {
            ParameterKind::Input => {
                let values = place::argument_values(simulation, scope, argument);
                self.add(inner, Vec::new(), MadeOf::Input(values));
            }
            ParameterKind::Output => {
                if let Some(name) = scope.argument_name(simulation, argument) {
                    let indices = place::index_values(simulation, scope, argument);
                    self.add(name, indices, MadeOf::Output(inner));
                }
            }
            // The body itself writes it.
            ParameterKind::InOut => {}
        };
        if let Argument::Parts(given) = &bound.argument {
            for (part, given) in user.parts[parameter].iter().zip(given) {
                if let Some(inner) = inside.name(simulation, part) {
                    add(inner, given);
                }
            }
        } else {
            add(inside.tag(simulation, tag), &bound.argument);
        }
    }

    /// A point, if it is what the block writes, or a part of it.
    pub(super) fn at(&self, simulation: &Simulation, point: &Point) -> Option<Aim> {
        let covering = self.0.iter().rev().find_map(|goal| {
            let rest = point.name.strip_prefix(&goal.name)?;
            (rest.is_empty() || rest.starts_with(['.', '['])).then_some((goal, rest))
        });
        let (goal, rest) = covering?;
        Some(Aim {
            read: match &goal.made_of {
                MadeOf::Operands => None,
                MadeOf::Input(values) => Some(values.clone()),
                MadeOf::Output(inner) => {
                    let output = simulation.resolve(&format!("{inner}{rest}")).ok();
                    let output = output.map(|output| (output.clone(), simulation.value(&output)));
                    Some(output.into_iter().collect())
                }
            },
            indices: goal.indices.clone(),
            moment: match goal.made_of {
                MadeOf::Operands => Written::ByItself,
                MadeOf::Input(_) => Written::BeforeBody,
                MadeOf::Output(_) => Written::AfterBody,
            },
        })
    }
}

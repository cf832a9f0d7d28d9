//! What the names in a program mean where it runs: in the body of a user-defined block those of one instance, and what
//! its in-outs stand for.

use super::Simulation;
use crate::places::BlockAt;
use ladder_analysis::program::{
    Argument, BinaryOperator, BlockKind, Chosen, Expr, ExprKind, ParameterKind, Place, TagId,
};
use ladder_analysis::values::value::Value;
use std::collections::HashMap;

/// The names of a run. Those of no body are the program's own.
#[derive(Debug, Clone, Default)]
pub(crate) struct Scope {
    /// The blocks in whose bodies it is, the outermost first.
    path: Vec<BlockAt>,
    /// What the instance is called: `m1`, `$RAMP#2`.
    instance: Option<String>,
    in_outs: HashMap<TagId, Meant>,
}

/// What an in-out stands for.
#[derive(Debug, Clone)]
enum Meant {
    /// This.
    Name(String),
    /// An array; of which instance, if it is of one.
    Array(TagId, Option<String>),
}

impl Scope {
    /// The names in the body of a block that is about to run.
    pub(crate) fn inside(&self, simulation: &Simulation, at: BlockAt) -> Scope {
        let program = simulation.program();
        let drawn = &program.networks[at.network].blocks[at.block];
        let BlockKind::User(user) = drawn.kind else {
            return self.clone();
        };
        let user = &program.blocks[user];
        let mut path = self.path.clone();
        path.push(at);
        let state = drawn.arguments.iter().find(|bound| bound.parameter.is_none());
        let mut instance = state.and_then(|bound| self.argument_name(simulation, &bound.argument));
        if state.is_none() {
            let mut known = simulation.instances().iter();
            let known = known.find(|instance| instance.path == path);
            instance = known.map(|instance| instance.name.clone());
        }
        let mut in_outs = HashMap::new();
        for bound in &drawn.arguments {
            let Some(parameter) = bound.parameter else {
                continue;
            };
            let (tag, kind) = user.parameters[parameter];
            if kind != ParameterKind::InOut {
                continue;
            }
            if let Argument::Parts(given) = &bound.argument {
                let parts = user.parts[parameter].iter().filter_map(Place::root);
                for (part, given) in parts.zip(given) {
                    in_outs.extend(self.meant(simulation, given).map(|meant| (part, meant)));
                }
            } else {
                in_outs.extend(self.meant(simulation, &bound.argument).map(|meant| (tag, meant)));
            }
        }
        Scope {
            path,
            instance: instance.or_else(|| Some(user.name.clone())),
            in_outs,
        }
    }

    /// Whether it is that of a body.
    pub(crate) fn is_of_body(&self) -> bool {
        !self.path.is_empty()
    }

    fn meant(&self, simulation: &Simulation, argument: &Argument) -> Option<Meant> {
        match argument {
            Argument::Range(range) => Some(match self.in_outs.get(&range.tag) {
                Some(meant) => meant.clone(),
                None => Meant::Array(range.tag, self.instance_of(simulation, range.tag)),
            }),
            argument => self.argument_name(simulation, argument).map(Meant::Name),
        }
    }

    /// What an argument is called that is written, or is a state.
    pub(crate) fn argument_name(&self, simulation: &Simulation, argument: &Argument) -> Option<String> {
        match argument {
            Argument::Place(place, _) => self.name(simulation, place),
            Argument::State(tag) => Some(self.tag(simulation, *tag)),
            Argument::ChosenState(chosen) => Some(self.tag(simulation, self.chosen_tag(simulation, chosen)?)),
            _ => None,
        }
    }

    fn instance_of(&self, simulation: &Simulation, tag: TagId) -> Option<String> {
        let is_of_body = simulation.program().tags[tag.0 as usize].block.is_some();
        self.instance.clone().filter(|_| is_of_body)
    }

    /// What a tag is called.
    pub(crate) fn tag(&self, simulation: &Simulation, tag: TagId) -> String {
        let own = &simulation.program().tags[tag.0 as usize].name;
        match (self.in_outs.get(&tag), self.instance_of(simulation, tag)) {
            (Some(Meant::Name(name)), _) => name.clone(),
            (Some(Meant::Array(array, instance)), _) => within(
                instance.as_deref(),
                &simulation.program().tags[array.0 as usize].name,
            ),
            (None, instance) => within(instance.as_deref(), own),
        }
    }

    /// What an element of an array is called.
    pub(crate) fn element(&self, simulation: &Simulation, array: TagId, index: i64) -> String {
        let tags = &simulation.program().tags;
        let (array, instance) = match self.in_outs.get(&array) {
            Some(Meant::Array(meant, instance)) => (*meant, instance.clone()),
            _ => (array, self.instance_of(simulation, array)),
        };
        within(instance.as_deref(), &tags[array.0 as usize].element_name(index))
    }

    /// The name of a place as a person writes it.
    pub(crate) fn name(&self, simulation: &Simulation, place: &Place) -> Option<String> {
        Some(match place {
            Place::Tag(it) => self.tag(simulation, *it),
            Place::Member(it, member) => format!("{}.{}", self.tag(simulation, *it), member.name()),
            Place::Element(it, index) => self.element(simulation, *it, self.number(simulation, index)?),
            Place::Chosen(chosen) => self.tag(simulation, self.chosen_tag(simulation, chosen)?),
            Place::ChosenMember(chosen, member) => {
                let tag = self.chosen_tag(simulation, chosen)?;
                format!("{}.{}", self.tag(simulation, tag), member.name())
            }
            Place::Bit(word, _, bit) => format!("{}.{bit}", self.name(simulation, word)?),
            Place::As(inner, ..) => self.name(simulation, inner)?,
            Place::System(system) => format!("SYS.{}", system.name()),
        })
    }

    /// The tag that an index chooses now.
    pub(crate) fn chosen_tag(&self, simulation: &Simulation, chosen: &Chosen) -> Option<TagId> {
        let number = u32::try_from(self.number(simulation, &chosen.number)?).ok()?;
        Some(TagId(chosen.first.0 + chosen.step * number))
    }

    /// What an index is now.
    pub(crate) fn number(&self, simulation: &Simulation, index: &Expr) -> Option<i64> {
        let value = match &index.kind {
            ExprKind::Constant(value) => value.clone(),
            ExprKind::Read(place) => {
                let point = simulation.resolve(&self.name(simulation, place)?).ok()?;
                simulation.value(&point)
            }
            ExprKind::Pass(inner) => return self.number(simulation, inner),
            ExprKind::Offset(subscripts) => {
                let mut offset = 0i64;
                for subscript in subscripts {
                    let index = self.number(simulation, &subscript.index)?;
                    if !(subscript.first..=subscript.last).contains(&index) {
                        return None;
                    }
                    offset += (index - subscript.first) * subscript.stride;
                }
                return Some(offset);
            }
            ExprKind::Binary(operator, left, right) => {
                let (left, right) = (self.number(simulation, left)?, self.number(simulation, right)?);
                return match operator {
                    BinaryOperator::Add => left.checked_add(right),
                    BinaryOperator::Sub => left.checked_sub(right),
                    BinaryOperator::Mul => left.checked_mul(right),
                    _ => None,
                };
            }
            _ => return None,
        };
        match value {
            Value::Int(number) => Some(number),
            _ => None,
        }
    }
}

/// The name of a tag of an instance.
fn within(instance: Option<&str>, name: &str) -> String {
    match instance {
        Some(instance) => format!("{instance}.{name}"),
        None => name.to_owned(),
    }
}

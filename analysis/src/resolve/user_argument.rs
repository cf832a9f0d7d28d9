//! Arguments of user-defined blocks.

use super::{OperandAt, Resolver};
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::program::Access;
use crate::program::{Argument, Bound, ParameterKind};
use crate::rules::type_mismatch;
use crate::values::types::{Scalar, Type, passes};
use crate::values::value::Value;
use crate::written::facts::Node;
use crate::written::user_block::Parameter;

impl<'c> Resolver<'c, '_> {
    /// The arguments of a user-defined block, in the order of its parameters.
    pub(super) fn user_arguments(&mut self, block: usize, bound: BlockAt<'c>) -> Vec<Bound> {
        let context = self.context;
        let facts = &context.user_blocks[block];
        let mut arguments: Vec<Bound> = Vec::with_capacity(facts.parameters.len());
        let mut given = vec![false; facts.parameters.len()];
        for (written, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            if let Formal::Instance = formal {
                if let Some(argument) = self.state(&written.value) {
                    arguments.push(Bound {
                        operand: None,
                        parameter: None,
                        argument,
                        range: bound.absolute(written.range),
                    });
                }
                continue;
            }
            let Formal::Parameter(index) = *formal else {
                continue;
            };
            // Given twice: the first one counts.
            if std::mem::replace(&mut given[index], true) {
                continue;
            }
            let parameter = &facts.parameters[index];
            // One whose type cannot be read is an error of its own.
            let Some(ty) = parameter.ty else { continue };
            self.operand = Some(OperandAt {
                range: bound.absolute(written.value.range),
                name: &parameter.name,
                block: bound,
            });
            let argument = self.user_argument(&written.value, ty, parameter);
            self.operand = None;
            if let Some(argument) = argument {
                let range = bound.absolute(written.range);
                arguments.push(Bound {
                    operand: None,
                    parameter: Some(index),
                    argument,
                    range,
                });
            }
        }
        arguments.sort_by_key(|bound| bound.parameter);
        arguments
    }

    fn user_argument(&mut self, node: &Node, ty: Type, parameter: &Parameter) -> Option<Argument> {
        let kind = parameter.kind;
        let range = self.at(node.range);
        let is_one_tag =
            matches!(ty, Type::Array { .. }) && kind == ParameterKind::InOut && !self.is_in_parts(node);
        if matches!(ty, Type::Compound(_) | Type::Array { .. }) && !is_one_tag {
            return self.whole_argument(node, ty, parameter);
        }
        if let (Type::State(state), ParameterKind::InOut) = (ty, kind)
            && self.is_in_parts(node)
            && self.state_type(node) == Some(state)
        {
            return self.state(node);
        }
        let Type::Scalar(scalar) = ty else {
            // Arrays and states go as what they are, by reference.
            let tag = self
                .named_tag(node)
                .filter(|&tag| self.tag_type(tag) == ty && kind == ParameterKind::InOut);
            return match (tag, ty) {
                (Some(tag), Type::Array { first, last, element }) => {
                    let index = |n| Box::new(self.constant_expr(Value::Int(n), Scalar::Lint, node.range));
                    let (tag, first, last) = (self.tag_id(tag), index(first), Some(index(last)));
                    Some(Argument::Range(crate::program::RangeRef {
                        tag,
                        element,
                        first,
                        last,
                        row: None,
                        per_index: 1,
                    }))
                }
                (Some(tag), _) => Some(Argument::State(self.tag_id(tag))),
                (None, _) => {
                    let message =
                        format!("a tag of type {ty} is expected here, for a VAR_IN_OUT of the block");
                    self.report(type_mismatch::wrong(range, message));
                    None
                }
            };
        };
        if kind == ParameterKind::Input {
            return self.value(node, scalar).map(Argument::Value);
        }
        let (place, found) = self.place_or_say(node)?;
        if !self.check_writable(&place, node, Access::Write) {
            return None;
        }
        let fits = match kind {
            ParameterKind::InOut => found == scalar,
            _ => passes(scalar, found),
        };
        if !fits {
            let given = self.given(node);
            let way = match kind {
                ParameterKind::InOut => "in-out",
                _ => "output",
            };
            let what = format!("the {way} `{}`", parameter.name);
            self.report(type_mismatch::does_not_take(
                &given,
                found,
                (&what, scalar),
                range,
            ));
            return None;
        }
        Some(Argument::Place(place, found))
    }
}

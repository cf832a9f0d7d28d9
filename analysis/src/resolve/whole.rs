//! Whole structures and arrays as operands: `[MOV]( line, recipe[k] )`.

use super::Resolver;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::program::Access;
use crate::program::{Argument, Bound, Place};
use crate::rules::type_mismatch;
use crate::values::types::Type;
use crate::written::facts::{Node, NodeKind};
use ladder_instructions::{Accepts, Instruction, Op};

impl<'c> Resolver<'c, '_> {
    /// The type of a node that names a whole structure or array.
    pub(super) fn whole(&self, node: &Node) -> Option<Type> {
        match self.part_type(node)? {
            (ty @ (Type::Compound(_) | Type::Array { .. }), 0) => Some(ty),
            _ => None,
        }
    }

    /// The type that a block copies as a whole, if it is one that can and its result is a structure or an array.
    pub(super) fn whole_type(&self, row: &Instruction, bound: BlockAt<'c>) -> Option<Type> {
        let values = match row.op {
            Op::Mov => 1,
            Op::Sel | Op::Mux => 2,
            Op::Fill | Op::Bmov => return self.whole_element(&bound.facts.operands.first()?.value),
            _ => return None,
        };
        let (result, value) = (bound.facts.operands.first()?, bound.facts.operands.get(values)?);
        let ty = self.whole(&result.value)?;
        // An array next to a value is an error of its own.
        let is_whole = self.whole(&value.value).is_some() || matches!(ty, Type::Compound(_));
        is_whole.then_some(ty)
    }

    /// The type of the elements that a range has, if they are structures.
    fn whole_element(&self, node: &Node) -> Option<Type> {
        let (mut ty, _) = match &node.kind {
            NodeKind::Paren(inner) => return self.whole_element(inner),
            NodeKind::Range(base, ..) => self.part_type(base)?,
            _ => self.part_type(node)?,
        };
        while let Some((_, element)) = ty.array() {
            ty = element;
        }
        matches!(ty, Type::Compound(_)).then_some(ty)
    }

    /// The arguments of a block that copies a whole structure or array.
    pub(super) fn whole_arguments(
        &mut self,
        row: &'static Instruction,
        bound: BlockAt<'c>,
        ty: Type,
    ) -> Vec<Bound> {
        let mut arguments = Vec::new();
        for (number, (written, formal)) in bound.facts.operands.iter().zip(bound.formals.iter()).enumerate() {
            let Formal::Operand(operand) = *formal else {
                continue;
            };
            let node = &written.value;
            let range = self.at(node.range);
            let is_range = operand.accepts == Accepts::Range;
            if !is_range && !matches!(operand.accepts, Accepts::Result(_) | Accepts::Value) {
                // What SEL and MUX choose by.
                arguments.extend(self.argument(node, operand).map(|argument| Bound {
                    operand: Some(operand),
                    parameter: None,
                    argument,
                    range: bound.absolute(written.range),
                }));
                continue;
            }
            let found = if is_range {
                self.whole_element(node)
            } else {
                self.whole(node)
            };
            if found != Some(ty) {
                // What it is instead may be an error of its own.
                let found = found.or_else(|| self.part_type(node).map(|(ty, _)| ty));
                let message = match found {
                    Some(found) => format!("this is {found}, {ty} is expected here"),
                    None => format!("a tag of type {ty} is expected here"),
                };
                self.report(type_mismatch::wrong(range, message));
                continue;
            }
            if ty.keeps_state() {
                let message = format!(
                    "{ty} holds a timer, counter or block, whose state is not copied: give it as a VAR_IN_OUT, or copy \
                     members"
                );
                self.report(type_mismatch::wrong(range, message));
                continue;
            }
            let parts = if is_range {
                self.part_ranges(node, row.op == Op::Bmov)
            } else {
                self.copied_parts(node)
            };
            let Some(parts) = parts else { continue };
            let is_result = number == 0;
            if is_result
                && let Some(tag) = parts.first().and_then(Argument::root)
                && !self.check_writable(&Place::Tag(tag), node, Access::Write)
            {
                continue;
            }
            arguments.push(Bound {
                operand: Some(operand),
                parameter: None,
                argument: Argument::Parts(parts),
                range: bound.absolute(written.range),
            });
        }
        arguments
    }
}

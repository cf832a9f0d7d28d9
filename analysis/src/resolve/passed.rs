//! Whole structures and arrays as parameters of user-defined blocks: values are copied one by one, an in-out is each of its
//! columns by reference.

use super::Resolver;
use super::tags::Ids;
use crate::program::Access;
use crate::program::{Argument, Expr, ExprKind, ParameterKind, Place, TagId};
use crate::rules::type_mismatch;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::facts::Node;
use crate::written::user_block::Parameter;
use ladder_syntax::TextRange;

/// More values than this are not copied: they go by reference.
const MOST_COPIED: u64 = 1_000;

/// The parts of a parameter in its body; none of one that is passed as one tag.
pub(super) fn parts_in_body(parameter: &Parameter, ids: &Ids) -> Vec<Place> {
    let Some(ty) = parameter.ty else { return Vec::new() };
    let own;
    let columns: &[TagId] = match ids.columns.get(&parameter.tag) {
        Some(columns) => columns,
        None => {
            own = [ids.of_tags[parameter.tag]];
            &own
        }
    };
    match (ty, parameter.kind) {
        (Type::Scalar(_) | Type::State(_), _) | (Type::Array { .. }, ParameterKind::InOut) => Vec::new(),
        (_, ParameterKind::InOut) => {
            let mut parts = Vec::new();
            for (column, id) in ty.column_list().into_iter().zip(columns) {
                let tags = match column.ty {
                    Type::Scalar(_) => 1,
                    _ => column.count() as u32,
                };
                parts.extend((0..tags).map(|number| Place::Tag(TagId(id.0 + number))));
            }
            parts
        }
        _ if ty.value_count() > MOST_COPIED => Vec::new(),
        _ => {
            let mut parts = Vec::new();
            for (column, id) in ty.column_list().into_iter().zip(columns) {
                let (first, count) = match *column.dimensions {
                    [] => {
                        parts.push(Place::Tag(*id));
                        continue;
                    }
                    [(first, _)] => (first, column.count()),
                    _ => (0, column.count()),
                };
                parts.extend((first..first + count as i64).map(|index| {
                    let index = Expr {
                        ty: Scalar::Lint,
                        kind: ExprKind::Constant(Value::Int(index)),
                        range: TextRange::default(),
                    };
                    Place::Element(*id, Box::new(index))
                }));
            }
            parts
        }
    }
}

impl Resolver<'_, '_> {
    /// What is given for a parameter that is a structure or an array.
    pub(super) fn whole_argument(
        &mut self,
        node: &Node,
        ty: Type,
        parameter: &Parameter,
    ) -> Option<Argument> {
        let range = self.at(node.range);
        let is_in_out = parameter.kind == ParameterKind::InOut;
        if self.whole(node) != Some(ty) {
            let message = if is_in_out {
                format!("a tag of type {ty} is expected here, for a VAR_IN_OUT of the block")
            } else {
                format!("a tag of type {ty} is expected here")
            };
            self.report(type_mismatch::wrong(range, message));
            return None;
        }
        if !is_in_out && ty.keeps_state() {
            let message = format!(
                "{ty} holds a timer, counter or block, whose state is not copied: declare `{}` in VAR_IN_OUT",
                parameter.name
            );
            self.report(type_mismatch::wrong(range, message));
            return None;
        }
        if !is_in_out && ty.value_count() > MOST_COPIED {
            let message = format!(
                "{ty} has more than {MOST_COPIED} values to copy: declare `{}` in VAR_IN_OUT",
                parameter.name
            );
            self.report(type_mismatch::wrong(range, message));
            return None;
        }
        let parts = if is_in_out {
            self.referred_parts(node)?
        } else {
            self.copied_values(node)?
        };
        let access = if parameter.kind == ParameterKind::Input {
            Access::Read
        } else {
            Access::ReadWrite
        };
        if let Some(tag) = parts.first().and_then(Argument::root)
            && !self.check_writable(&Place::Tag(tag), node, access)
        {
            return None;
        }
        Some(Argument::Parts(parts))
    }
}

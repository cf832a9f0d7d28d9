//! Two operands that are given in each other's place: one finding for both.

use super::Resolver;
use crate::findings::diagnostic::{Applicability, Diagnostic, Fix};
use crate::findings::excerpt;
use crate::findings::rule::Rule;
use crate::networks::BlockAt;
use crate::networks::network::Formal;
use crate::program::ParameterKind;
use crate::rules::{bad_operand, type_mismatch};
use crate::values::literal::Literal;
use crate::values::types::{Type, passes};
use crate::written::constant::signed_literal;
use crate::written::facts::{Node, NodeKind};
use crate::written::user_block::Parameter;
use ladder_format::Edit;
use ladder_instructions::{Accepts, Instruction, Operand};
use ladder_syntax::{Name, TextRange};

impl Resolver<'_, '_> {
    /// The two operands of a user-defined block that do not pass where they are, and would in each other's place.
    pub(super) fn swapped_arguments(&self, block: usize, bound: BlockAt<'_>) -> Option<Diagnostic> {
        let facts = &self.context.user_blocks[block];
        let operands = bound.facts.operands.iter().zip(bound.formals.iter());
        let given = operands
            .take(bound.positional_count())
            .filter_map(|(written, formal)| {
                let Formal::Parameter(index) = *formal else {
                    return None;
                };
                let parameter = &facts.parameters[index];
                Some((&written.value, parameter, self.fits(&written.value, parameter)?))
            });
        let mut wrong = given.filter(|(_, _, fits)| !fits);
        let (first, of_first, _) = wrong.next()?;
        let (second, of_second, _) = wrong.next()?;
        let is_two = wrong.next().is_none();
        let would_fit =
            self.fits(first, of_second) == Some(true) && self.fits(second, of_first) == Some(true);
        (is_two && would_fit).then(|| {
            let order = format!(
                "`{}` of [{}] comes before `{}`",
                of_first.name, facts.name, of_second.name
            );
            self.swap(type_mismatch::RULE, first, second, order)
        })
    }

    /// A value in the place of a result or of the tag that keeps a block's state, and that last: as other systems have them.
    pub(super) fn swapped_operands(
        &self,
        row: &'static Instruction,
        bound: BlockAt<'_>,
    ) -> Option<Diagnostic> {
        let [first, .., last] = &bound.facts.operands[..] else {
            return None;
        };
        let count = bound.positional_count();
        if count != bound.facts.operands.len() || !self.is_only_read(&first.value) {
            return None;
        }
        let is_tag = matches!(
            last.value.kind,
            NodeKind::Name(_) | NodeKind::Address(_) | NodeKind::Member(..) | NodeKind::Index(..)
        );
        if !is_tag || self.is_only_read(&last.value) {
            return None;
        }
        let order = match row.operands.first()?.accepts {
            Accepts::Result(_) => "the result comes first".to_owned(),
            Accepts::State(state) if count == 2 => {
                format!("the tag that keeps the state of the {} comes first", state.name())
            }
            _ => return None,
        };
        if count == 2 {
            return Some(self.swap(bad_operand::RULE, &first.value, &last.value, order));
        }
        let is_value = |operand: &Operand| {
            matches!(
                operand.accepts,
                Accepts::Value | Accepts::Number | Accepts::Integer
            )
        };
        let is_calculated = row.operands.iter().skip(1).all(is_value);
        is_calculated.then(|| self.result_last(bound, order))
    }

    /// Whether a value can be read and not be written: a literal, a constant, what is calculated, the value of an enumeration.
    fn is_only_read(&self, node: &Node) -> bool {
        if signed_literal(node).is_some() {
            return true;
        }
        let types = &self.context.types;
        match &node.kind {
            NodeKind::Unary(..) | NodeKind::Binary(..) | NodeKind::Call(..) => true,
            NodeKind::Name(name) => match self.named_tag(node) {
                Some(tag) => self.scope.tags[tag].constant,
                None => types.has_value(&Name::new(name)),
            },
            NodeKind::Member(base, member) => {
                let is_type = |name: &str| self.named_tag(base).is_none() && types.find(name).is_some();
                matches!(&base.kind, NodeKind::Name(name) if is_type(name))
                    && types.has_value(&Name::new(&member.text))
            }
            _ => false,
        }
    }

    /// The result is after the values that it is calculated from.
    fn result_last(&self, bound: BlockAt<'_>, order: String) -> Diagnostic {
        let nodes: Vec<&Node> = bound
            .facts
            .operands
            .iter()
            .map(|operand| &operand.value)
            .collect();
        let texts = nodes
            .iter()
            .map(|node| excerpt::text(&self.context.parse, self.at(node.range)));
        let mut texts: Vec<String> = texts.collect();
        texts.rotate_right(1);
        let result = texts[0].clone();
        let edits = nodes.iter().zip(texts).map(|(node, text)| Edit {
            range: self.at(node.range),
            text,
        });
        let all = nodes
            .iter()
            .map(|node| self.at(node.range))
            .reduce(TextRange::cover);
        let message = format!("the result `{result}` is last here");
        Diagnostic::new(bad_operand::RULE, all.unwrap_or_else(|| bound.range()), message)
            .help(order)
            .with(Fix::new(
                Applicability::Unsafe,
                format!("Put `{result}` first"),
                edits.collect(),
            ))
    }

    fn swap(&self, rule: Rule, first: &Node, second: &Node, order: String) -> Diagnostic {
        let text = |node: &Node| excerpt::text(&self.context.parse, self.at(node.range));
        type_mismatch::swapped(
            rule,
            (self.at(first.range), &text(first)),
            (self.at(second.range), &text(second)),
            order,
        )
    }

    /// Whether an operand passes to a parameter; none if that cannot be expressed.
    fn fits(&self, node: &Node, parameter: &Parameter) -> Option<bool> {
        let Some(Type::Scalar(wanted)) = parameter.ty else {
            return None;
        };
        if let Some((literal, _)) = signed_literal(node) {
            if parameter.kind != ParameterKind::Input {
                return Some(false);
            }
            return Some(match literal.as_ref().ok()? {
                Literal::Int(_) => wanted.is_number() || wanted.is_bits(),
                Literal::Real(_) => wanted.is_real(),
                _ => passes(self.own_type(node)?, wanted),
            });
        }
        let found = self.own_type(node)?;
        let is_text = found.is_string() && wanted.is_string();
        Some(match parameter.kind {
            ParameterKind::Input => passes(found, wanted) || is_text,
            ParameterKind::Output => passes(wanted, found) || is_text,
            ParameterKind::InOut => found == wanted,
        })
    }

    /// As a message calls what is given.
    pub(super) fn given(&self, node: &Node) -> String {
        format!("`{}`", excerpt::text(&self.context.parse, self.at(node.range)))
    }
}

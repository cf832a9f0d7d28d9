//! Definitions of user-defined blocks, and their calls.

use super::dice::Dice;
use super::drawing::Pen;
use super::flow::Region;
use super::operand::{place, read};
use super::scope::{Scope, Section, Tag, Type};
use super::value::{SCALARS, literal};
use ladder_analysis::values::types::{Scalar, passes};
use ladder_instructions::Shape;

/// A user-defined block.
#[derive(Debug, Clone)]
pub(super) struct Definition {
    name: String,
    shape: Shape,
    parameters: Vec<(String, Section, Scalar, bool)>,
}

impl Definition {
    /// Makes a block and writes its definition. `blocks` are those that it may use, `shared` the global tags.
    pub(super) fn make(
        dice: &mut Dice,
        number: usize,
        blocks: &[Definition],
        shared: &[Tag],
        pen: Pen,
        text: &mut String,
    ) -> Definition {
        let shape = dice.of(&Shape::ALL);
        let name = dice.of(&["$Block", "$FB_Block"]).to_owned() + &number.to_string();
        let mut scope = Scope {
            is_body: true,
            ..Scope::default()
        };
        let mut parameters = Vec::new();
        for section in [Section::Input, Section::Output, Section::InOut] {
            for _ in 0..dice.below(3) {
                let ty = dice.of(&SCALARS);
                let parameter = format!("p{}", parameters.len());
                // Those with a default are last.
                let initial = (section == Section::Input && dice.one_in(3)).then(|| literal(dice, ty));
                parameters.push((parameter.clone(), section, ty, initial.is_some()));
                scope.add(Tag {
                    name: parameter,
                    ty: Type::Scalar(ty),
                    section,
                    initial,
                    address: None,
                });
            }
        }
        for tag in shared {
            scope.add(Tag {
                section: Section::Undeclared,
                ..tag.clone()
            });
        }
        let region = Region {
            functions: &[],
            blocks,
            may_end: shape == Shape::Function,
            is_boolean: false,
        };
        let first = if dice.one_in(2) {
            vec!["[ ]( EN )".to_owned(), "( )( ENO )".to_owned()]
        } else {
            Vec::new()
        };
        let count = 1 + dice.below(3);
        let networks = region.networks(dice, &mut scope, &first, count);
        let (open, close) = shape.brackets();
        text.push_str(&format!("FUNCTION_BLOCK {open}{name}{close}{}", pen.line_end));
        scope.declare(dice, pen.line_end, text);
        for network in &networks {
            pen.draw(dice, network, text);
        }
        text.push_str("END_FUNCTION_BLOCK");
        text.push_str(pen.line_end);
        Definition {
            name,
            shape,
            parameters,
        }
    }

    /// The block in its place, with operands by place, or its inputs by name.
    pub(super) fn call(&self, dice: &mut Dice, scope: &mut Scope) -> String {
        let (open, close) = self.shape.brackets();
        let by_name = dice.one_in(3);
        let operands: Vec<String> = self
            .parameters
            .iter()
            .filter_map(|(name, section, ty, has_default)| {
                if by_name && *has_default && dice.one_in(2) {
                    return None;
                }
                let value = match section {
                    Section::Input => read(dice, scope, *ty),
                    Section::InOut => scope.scalar(dice, *ty, true),
                    _ => {
                        let wider: Vec<Scalar> = SCALARS.into_iter().filter(|&to| passes(*ty, to)).collect();
                        let to = dice.of(&wider);
                        place(dice, scope, to)
                    }
                };
                let arrow = if *section == Section::Output { "=>" } else { ":=" };
                Some(if by_name {
                    format!("{name} {arrow} {value}")
                } else {
                    value
                })
            })
            .collect();
        if operands.is_empty() {
            return format!("{open}{}{close}", self.name);
        }
        format!("{open}{}{close}( {} )", self.name, operands.join(", "))
    }
}

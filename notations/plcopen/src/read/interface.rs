//! Variables, types and initial values.

use super::Reader;
use crate::model::{Initial, Role, Type, TypeDeclaration, Variable};
use ladder_format::program::Qualifier;
use ladder_notation::xml::Element;
use roxmltree::Node;

/// Types and values nest no deeper.
const DEEPEST: usize = 32;

/// An initial value with more parts is not read.
const MOST_VALUES: usize = 10_000;

impl<'x> Reader<'x, '_> {
    pub(super) fn data_type(&mut self, node: Node<'x, '_>) {
        let place = self.xml.place(node);
        let name = node.attribute("name").unwrap_or_default().to_owned();
        let base = node.child("baseType").and_then(|base| base.elements().next());
        let ty = match base {
            Some(base) => self.ty(base, 0),
            None => Type::Other("nothing".to_owned()),
        };
        let declaration = TypeDeclaration {
            place,
            name,
            ty,
            initial: initial(node, 0),
            comment: comment(node),
        };
        self.project.types.push(declaration);
    }

    /// The variables of a list.
    pub(super) fn variable_list(&mut self, list: Node<'x, '_>, role: Role, depth: usize) -> Vec<Variable> {
        let qualifier = if list.flag("constant") {
            Some(Qualifier::Constant)
        } else if list.flag("retain") || list.flag("persistent") {
            Some(Qualifier::Retain)
        } else {
            None
        };
        let mut variables = Vec::new();
        for node in list.children_of("variable") {
            let ty = node.child("type").and_then(|ty| ty.elements().next());
            variables.push(Variable {
                place: self.xml.place(node),
                name: node.attribute("name").unwrap_or_default().to_owned(),
                role,
                qualifier,
                address: node
                    .attribute("address")
                    .map(str::to_owned)
                    .filter(|it| !it.is_empty()),
                ty: match ty {
                    Some(ty) => self.ty(ty, depth + 1),
                    None => Type::Other("a variable without type".to_owned()),
                },
                initial: initial(node, 0),
                comment: comment(node),
            });
        }
        variables
    }

    /// The type that an element stands for.
    pub(super) fn ty(&mut self, node: Node<'x, '_>, depth: usize) -> Type {
        let name = Element::name(&node);
        if depth > DEEPEST {
            return Type::Other(format!("a type in more than {DEEPEST} others"));
        }
        let inner = |node: Node<'x, '_>| node.child("baseType").and_then(|base| base.elements().next());
        match name {
            "derived" => Type::Named(node.attribute("name").unwrap_or_default().to_owned()),
            "string" | "wstring" | "STRING" | "WSTRING" => {
                Type::Text(node.attribute("length").and_then(|length| length.parse().ok()))
            }
            "array" => {
                let bounds = node.children_of("dimension").map(|dimension| {
                    let bound = |name| dimension.attribute(name).unwrap_or("0").trim().to_owned();
                    (bound("lower"), bound("upper"))
                });
                let bounds = bounds.collect();
                match inner(node) {
                    Some(of) => Type::Array(bounds, Box::new(self.ty(of, depth + 1))),
                    None => Type::Other("an array of nothing".to_owned()),
                }
            }
            "enum" => {
                let values = node.child("values");
                let values = values
                    .iter()
                    .flat_map(|values| values.children_of("value"))
                    .map(|value| {
                        let name = value.attribute("name").unwrap_or_default().to_owned();
                        (
                            name,
                            value
                                .attribute("value")
                                .map(str::to_owned)
                                .filter(|it| !it.is_empty()),
                        )
                    });
                Type::Enumeration(values.collect())
            }
            "struct" => Type::Structure(self.variable_list(node, Role::Local, depth + 1)),
            "subrangeSigned" | "subrangeUnsigned" => {
                let range = node.child("range");
                let bound = |name| {
                    let bound = range.and_then(|range| range.attribute(name));
                    bound.unwrap_or("0").trim().to_owned()
                };
                let base = match inner(node).map(|base| self.ty(base, depth + 1)) {
                    Some(Type::Named(base)) => base,
                    _ => "INT".to_owned(),
                };
                Type::Range(base, bound("lower"), bound("upper"))
            }
            "pointer" | "reference" => Type::Other("a pointer".to_owned()),
            name => Type::Named(name.to_owned()),
        }
    }
}

pub(super) fn comment(node: Node<'_, '_>) -> Option<String> {
    let told = node.child("documentation")?.words();
    (!told.is_empty()).then_some(told)
}

/// The initial value of a variable, a type or a member.
pub(super) fn initial(node: Node<'_, '_>, depth: usize) -> Option<Initial> {
    let value = node.child("initialValue")?;
    let mut left = MOST_VALUES;
    value_in(value, depth, &mut left)
}

/// The value that is in an element.
fn value_in(node: Node<'_, '_>, depth: usize, left: &mut usize) -> Option<Initial> {
    let value = node.elements().find(|child| !child.is("addData"))?;
    *left = left.checked_sub(1)?;
    if depth > DEEPEST {
        return None;
    }
    if value.is("simpleValue") {
        let value = value.attribute("value")?.trim();
        return (!value.is_empty()).then(|| Initial::Simple(value.to_owned()));
    }
    if value.is("arrayValue") {
        let values = value.children_of("value").filter_map(|value| {
            let times = value
                .attribute("repetitionValue")
                .and_then(|times| times.parse().ok());
            Some((times.unwrap_or(1), value_in(value, depth + 1, left)?))
        });
        return Some(Initial::Array(values.collect()));
    }
    if value.is("structValue") {
        let values = value.children_of("value").filter_map(|value| {
            let member = value.attribute("member")?.to_owned();
            Some((member, value_in(value, depth + 1, left)?))
        });
        return Some(Initial::Structure(values.collect()));
    }
    None
}

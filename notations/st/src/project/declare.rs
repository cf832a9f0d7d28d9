//! Declarations: types, and the variables of the program and its blocks.

use crate::names;
use crate::project::{Declared, Project, root};
use ladder_analysis::program::{ParameterKind, Program, Tag, TagId};
use ladder_analysis::values::compound::{Compound, EnumId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use std::collections::HashMap;

/// A tag as it is declared, which may have several parts.
pub(crate) struct Variable<'p> {
    pub(crate) root: &'p str,
    pub(crate) ty: Type,
    /// The first of its parts.
    pub(crate) tag: &'p Tag,
    pub(crate) index: usize,
}

/// The tags of the program, or of the body of a block, as they are declared.
pub(crate) fn variables(program: &Program, block: Option<usize>) -> Vec<Variable<'_>> {
    let mut found: Vec<Variable<'_>> = Vec::new();
    let mut known: HashMap<&str, usize> = HashMap::new();
    for (index, tag) in program
        .tags
        .iter()
        .enumerate()
        .filter(|(_, tag)| tag.block == block)
    {
        let root = root(tag);
        let ty = match &tag.column {
            // The inside of a block that is a tag.
            Some(column) if column.declared.0 != column.root => continue,
            Some(column) => column.declared.1,
            None => tag.ty,
        };
        if let std::collections::hash_map::Entry::Vacant(entry) = known.entry(root) {
            entry.insert(found.len());
            found.push(Variable { root, ty, tag, index });
        }
    }
    found
}

impl Project<'_> {
    /// The sections with the types, and the functions that make numbers of enumerations.
    pub(crate) fn types(&self) -> String {
        let mut out = String::new();
        for declared in &self.type_order {
            match declared {
                Declared::Enumeration(id) => {
                    let values = id
                        .get()
                        .values
                        .iter()
                        .map(|(_, number)| i64::from(*number))
                        .collect::<Vec<_>>();
                    let names: Vec<&str> = values
                        .iter()
                        .filter_map(|number| self.value_name(*id, *number))
                        .map(String::as_str)
                        .collect();
                    let name = self.scalar_name(Scalar::Enum(*id));
                    out.push_str(&format!(
                        "TYPE\n    {name} : ({});\nEND_TYPE\n\n",
                        names.join(", ")
                    ));
                }
                Declared::Array(ty) => {
                    let (name, array) = (self.type_name(*ty), self.spelled(*ty));
                    out.push_str(&format!("TYPE\n    {name} : {array};\nEND_TYPE\n\n"));
                }
                Declared::Structure(id) => {
                    let Compound::Structure(structure) = id.get() else {
                        continue;
                    };
                    let name = self.type_name(Type::Compound(*id));
                    out.push_str(&format!("TYPE\n    {name} : STRUCT\n"));
                    for member in &structure.members {
                        let ty = self.type_name(member.ty);
                        out.push_str(&format!("        {} : {ty};\n", names::member(&member.name)));
                    }
                    out.push_str("    END_STRUCT;\nEND_TYPE\n\n");
                }
            }
        }
        for id in &self.enumerations_as_numbers {
            out.push_str(&self.number_of(*id));
        }
        for id in &self.enumerations_from_numbers {
            out.push_str(&self.value_of(*id));
        }
        out
    }

    fn number_of(&self, id: EnumId) -> String {
        let name = self.scalar_name(Scalar::Enum(id));
        let head = format!("FUNCTION {name}_NUMBER : DINT\nVAR_INPUT\n    X : {name};\nEND_VAR\n");
        let line = |value: &str, number| format!("X = {value} THEN\n        {name}_NUMBER := {number}");
        self.function_of_enumeration(id, head, line)
    }

    fn value_of(&self, id: EnumId) -> String {
        let name = self.scalar_name(Scalar::Enum(id));
        let head = format!("FUNCTION {name}_VALUE : {name}\nVAR_INPUT\n    X : LINT;\nEND_VAR\n");
        let line = |value: &str, number| format!("X = {number} THEN\n        {name}_VALUE := {value}");
        self.function_of_enumeration(id, head, line)
    }

    /// A function that finds out which value it is; `case` is a condition, and what it has for a result.
    fn function_of_enumeration(
        &self,
        id: EnumId,
        mut out: String,
        case: impl Fn(&str, i32) -> String,
    ) -> String {
        for (n, (_, number)) in id.get().values.iter().enumerate() {
            let value = self.value_name(id, i64::from(*number));
            let word = if n == 0 { "IF" } else { "ELSIF" };
            let case = case(value.map_or("", String::as_str), *number);
            out.push_str(&format!("    {word} {case};\n"));
        }
        out.push_str("    END_IF;\nEND_FUNCTION\n\n");
        out
    }

    /// The value that a variable starts with; none where it is its type's own, or that of what a caller passes.
    pub(crate) fn initial(&self, variable: &Variable<'_>) -> Option<String> {
        let program = self.program;
        let parameters = (variable.tag.block).map_or(&[][..], |block| &program.blocks[block].parameters);
        let is_passed = |(tag, kind): &(TagId, ParameterKind)| {
            *kind == ParameterKind::InOut && root(&program.tags[tag.0 as usize]) == variable.root
        };
        if parameters.iter().any(is_passed) {
            return None;
        }
        let parts = self
            .parts
            .get(&(variable.tag.block, variable.root))
            .into_iter()
            .flatten();
        let parts: HashMap<&str, &Tag> = parts.map(|tag| (tag.name.as_str(), *tag)).collect();
        let mut place = Vec::new();
        self.value_at(variable.ty, variable.root.to_owned(), &parts, &mut place)
    }

    /// The same of a part; the place is where it is in the arrays around it, with the length of each.
    fn value_at(
        &self,
        ty: Type,
        path: String,
        parts: &HashMap<&str, &Tag>,
        place: &mut Vec<(i64, i64)>,
    ) -> Option<String> {
        match ty {
            Type::Scalar(scalar) => {
                let tag = parts
                    .get(path.as_str())
                    .or_else(|| parts.get(path.trim_end_matches("[]")))?;
                let at = place.iter().fold(0, |at, (number, length)| at * length + number);
                let value = tag.initial.get(usize::try_from(at).ok()?)?;
                (*value != Value::zero(scalar)).then(|| self.literal(value, scalar))
            }
            Type::State(_) => None,
            Type::Array { first, last, element } => {
                self.elements_at(&[(first, last)], Type::Scalar(element), path, parts, place)
            }
            Type::Compound(id) => match id.get() {
                Compound::Block(_) => None,
                Compound::Array(array) => {
                    self.elements_at(&array.dimensions, array.element, path, parts, place)
                }
                Compound::Structure(structure) => {
                    let members: Vec<String> = (structure.members.iter())
                        .filter_map(|member| {
                            let value =
                                self.value_at(member.ty, format!("{path}.{}", member.name), parts, place)?;
                            Some(format!("{} := {value}", names::member(&member.name)))
                        })
                        .collect();
                    (!members.is_empty()).then(|| format!("({})", members.join(", ")))
                }
            },
        }
    }

    fn elements_at(
        &self,
        dimensions: &[(i64, i64)],
        element: Type,
        mut path: String,
        parts: &HashMap<&str, &Tag>,
        place: &mut Vec<(i64, i64)>,
    ) -> Option<String> {
        path.push_str(&"[]".repeat(dimensions.len()));
        let count: i64 = dimensions.iter().map(|(first, last)| last - first + 1).product();
        let mut values: Vec<(Option<String>, i64)> = Vec::new();
        for number in 0..count {
            place.push((number, count));
            let value = self.value_at(element, path.clone(), parts, place);
            place.pop();
            match values.last_mut() {
                Some((last, times)) if *last == value => *times += 1,
                _ => values.push((value, 1)),
            }
        }
        if values.iter().all(|(value, _)| value.is_none()) {
            return None;
        }
        let texts: Option<Vec<String>> = values
            .into_iter()
            .map(|(value, times)| {
                let value = value.or_else(|| self.zero(element))?;
                Some(if times == 1 {
                    value
                } else {
                    format!("{times}({value})")
                })
            })
            .collect();
        texts.map(|texts| format!("[{}]", texts.join(", ")))
    }

    /// What a type starts with.
    fn zero(&self, ty: Type) -> Option<String> {
        match ty {
            Type::Scalar(scalar) => Some(self.literal(&Value::zero(scalar), scalar)),
            Type::State(_) => None,
            Type::Array { first, last, element } => Some(format!(
                "[{}({})]",
                last - first + 1,
                self.zero(Type::Scalar(element))?
            )),
            Type::Compound(id) => match id.get() {
                Compound::Block(_) => None,
                Compound::Array(array) => {
                    let count: i64 = array
                        .dimensions
                        .iter()
                        .map(|(first, last)| last - first + 1)
                        .product();
                    Some(format!("[{count}({})]", self.zero(array.element)?))
                }
                Compound::Structure(structure) => structure.members.iter().find_map(|member| {
                    Some(format!(
                        "({} := {})",
                        names::member(&member.name),
                        self.zero(member.ty)?
                    ))
                }),
            },
        }
    }
}

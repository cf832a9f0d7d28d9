//! Declarations: types, and the variables of the program and its blocks.

use crate::comment;
use crate::names;
use crate::project::types::is_of_blocks;
use crate::project::{Declared, Project, tag_ids};
use ladder_analysis::program::{Tag, TagId};
use ladder_analysis::values::compound::{Compound, EnumId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::written::type_spec::SpecKind;
use std::collections::HashSet;

/// A tag as it is declared, which may have several parts.
pub(crate) struct Variable<'p> {
    pub(crate) root: &'p str,
    pub(crate) ty: Type,
    /// The first of its parts.
    pub(crate) tag: &'p Tag,
    pub(crate) id: TagId,
}

impl Variable<'_> {
    /// Whether it is a timer, counter or block in an array or structure.
    pub(crate) fn is_part(&self) -> bool {
        let column = self.tag.column.as_ref();
        column.is_some_and(|column| column.root < self.root.len())
    }
}

impl<'p> Project<'p> {
    /// The tags of the program, or of the body of a block, as they are declared.
    pub(crate) fn variables(&self, block: Option<usize>) -> Vec<Variable<'p>> {
        let mut found: Vec<Variable<'p>> = Vec::new();
        let mut known: HashSet<&str> = HashSet::new();
        for (id, tag) in tag_ids(self.source.program).filter(|(_, tag)| tag.block == block) {
            let root = self.root(id);
            let ty = match &tag.column {
                // The inside of a block that is a tag.
                Some(column) if column.declared.0 != column.root => continue,
                Some(column) if root.len() == column.root => column.declared.1,
                _ => tag.ty,
            };
            if known.insert(root) {
                found.push(Variable { root, ty, tag, id });
            }
        }
        found
    }
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
                    for member in structure.members.iter().filter(|member| !is_of_blocks(member.ty)) {
                        let ty = self.type_name(member.ty);
                        let told = self.said_of_member(&structure.name, &member.name);
                        let value = self.of_type(member).map(|value| format!(" := {value}"));
                        out.push_str(&format!(
                            "        {} : {ty}{};{told}\n",
                            names::member(&member.name),
                            value.unwrap_or_default()
                        ));
                    }
                    out.push_str("    END_STRUCT;\nEND_TYPE\n\n");
                }
            }
        }
        for id in &self.used.enumerations_as_numbers {
            out.push_str(&self.number_of(*id));
        }
        for id in &self.used.enumerations_from_numbers {
            out.push_str(&self.value_of(*id));
        }
        out
    }

    /// What the comment on the line of a member says, as a comment.
    fn said_of_member(&self, ty: &str, member: &str) -> String {
        let own = self
            .source
            .named
            .own()
            .iter()
            .find(|own| own.declaration.name.eq_ignore_ascii_case(ty));
        let members = own.map(|own| &own.declaration.declared.spec.kind);
        let Some(SpecKind::Structure(members)) = members else {
            return String::new();
        };
        let found = members.iter().find(|own| own.name.eq_ignore_ascii_case(member));
        let told = found.and_then(|found| comment::of_line(self.source.parse, found.at.start()));
        told.map_or_else(String::new, |told| format!("  {}", comment::comment(&told)))
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
}

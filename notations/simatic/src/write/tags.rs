//! The tags of a unit: those of its text, and those that it needs besides.

use super::Project;
use crate::model::{self, Role, Variable};
use ladder_analysis::values::compound::Enumeration;
use ladder_analysis::values::types::Type;
use std::collections::HashMap;

/// The tags of a unit.
pub(super) struct Tags<'p> {
    pub(super) project: &'p Project<'p>,
    /// By their names in small letters. What has no form there says why.
    known: HashMap<String, Result<Type, String>>,
    /// Those that the text does not have.
    pub(super) made: Vec<Variable>,
    /// How many of these have a name that begins so.
    counts: HashMap<String, usize>,
}

impl<'p> Tags<'p> {
    pub(super) fn new(project: &'p Project<'p>) -> Tags<'p> {
        Tags {
            project,
            known: HashMap::new(),
            made: Vec::new(),
            counts: HashMap::new(),
        }
    }

    /// The type of a tag.
    pub(super) fn known(&self, name: &str) -> Option<&Result<Type, String>> {
        self.known.get(&name.to_lowercase())
    }

    /// Makes a tag known. Returns what it was before.
    pub(super) fn insert(&mut self, name: &str, ty: Result<Type, String>) -> Option<Result<Type, String>> {
        self.known.insert(name.to_lowercase(), ty)
    }

    /// A tag that the text does not have.
    pub(super) fn make(&mut self, like: &str, ty: model::Type) -> String {
        let count = self.counts.entry(like.to_lowercase()).or_default();
        let name = loop {
            *count += 1;
            let name = format!("{like}_{count}");
            if !self.known.contains_key(&name.to_lowercase()) {
                break name;
            }
        };
        let operand = format!("#\"{name}\"");
        self.made.push(Variable {
            name,
            ty,
            ..Variable::default()
        });
        operand
    }

    /// A value of an enumeration: a constant with the name of both, `Phase_RUN`, or its number where that is another tag.
    pub(super) fn named_value(&mut self, of: &Enumeration, number: i64) -> String {
        let found = of.name_of(number).map(|value| format!("{}_{value}", of.name));
        let Some(name) = found.filter(|name| self.known(name).is_none()) else {
            return number.to_string();
        };
        let is_made = self.made.iter().any(|made| made.name == name);
        let operand = format!("#\"{name}\"");
        if !is_made {
            self.made.push(Variable {
                name,
                role: Role::Constant,
                ty: model::Type::Named("DInt".to_owned()),
                initial: Some(number.to_string()),
                ..Variable::default()
            });
        }
        operand
    }

    /// A bit that the text does not have.
    pub(super) fn bit(&mut self, like: &str) -> String {
        self.make(like, model::Type::default())
    }

    /// A bit that remembers an edge.
    pub(super) fn memory(&mut self) -> String {
        self.bit("edge")
    }
}

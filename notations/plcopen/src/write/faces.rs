//! Blocks of one's own as those that use them see them.

use ladder_analysis::program::ParameterKind;
use ladder_syntax::Name;
use std::collections::{HashMap, HashSet};

/// How blocks of one's own are called from outside, by their names.
#[derive(Default)]
pub(super) struct Faces(HashMap<Name, Face>);

/// Blocks that cannot be called, with why.
pub(super) type Broken = Vec<(Name, String)>;

/// A block of one's own as those that use it see it.
pub(super) struct Face {
    pub(super) name: String,
    pub(super) power_in: String,
    pub(super) power_out: String,
    pub(super) parameters: Vec<Parameter>,
    /// Why a call of it is not written.
    pub(super) broken: Option<String>,
}

/// A parameter of a block.
pub(super) struct Parameter {
    pub(super) name: String,
    pub(super) kind: ParameterKind,
    /// It is a global: see [`shared`](crate::shared).
    pub(super) is_shared: bool,
}

impl Faces {
    pub(super) fn get(&self, block: &str) -> Option<&Face> {
        self.0.get(&Name::new(block))
    }

    pub(super) fn insert(&mut self, block: &str, face: Face) {
        self.0.insert(Name::new(block), face);
    }

    /// The names of what functions share.
    pub(super) fn shared(&self) -> HashSet<String> {
        let parameters = self.0.values().flat_map(|face| &face.parameters);
        let shared = parameters.filter(|parameter| parameter.is_shared);
        shared.map(|parameter| parameter.name.clone()).collect()
    }

    /// Marks these as not whole, and all that use them. `users` has for each block those that use it.
    pub(super) fn break_with(&mut self, broken: Broken, users: &HashMap<Name, Broken>) {
        let mut waiting = broken;
        while let Some((name, why)) = waiting.pop() {
            let Some(face) = self.0.get_mut(&name) else {
                continue;
            };
            if face.broken.is_some() {
                continue;
            }
            waiting.extend(users.get(&name).into_iter().flatten().cloned());
            face.broken = Some(why);
        }
    }
}

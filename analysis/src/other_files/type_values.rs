//! What all files of a workspace declare of enumerations, found when it is first asked for: whether a name that no tag has may be a
//! value.

use super::exports::Exports;
use crate::written::type_spec::SpecKind;
use ladder_syntax::Name;
use rustc_hash::{FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// The enumerations that files declare.
#[derive(Debug, Default)]
pub(crate) struct TypeValues {
    names: FxHashSet<Name>,
    /// Stands for all of them, and for the types that are other names of some.
    pub(crate) stamp: u64,
}

impl TypeValues {
    pub(super) fn of(files: &[Arc<Exports>]) -> TypeValues {
        let mut names = FxHashSet::default();
        let mut hasher = FxHasher::default();
        for ty in files.iter().flat_map(|file| &file.types) {
            match &ty.declared.spec.kind {
                SpecKind::Enumeration(values) => {
                    ty.key.hash(&mut hasher);
                    for (name, _, number) in values {
                        (name, number).hash(&mut hasher);
                        names.insert(Name::new(name));
                    }
                }
                SpecKind::Named(of) => (&ty.key, of).hash(&mut hasher),
                _ => {}
            }
        }
        TypeValues {
            names,
            stamp: hasher.finish(),
        }
    }

    pub(crate) fn contains(&self, name: &Name) -> bool {
        self.names.contains(name)
    }

    pub(crate) fn have_values(&self) -> bool {
        !self.names.is_empty()
    }
}

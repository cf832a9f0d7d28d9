//! What is wrong with tags for all files, kept while no edit concerns the tags that it is about.

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::findings::Anchored;
use ladder_syntax::Name;
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// What is wrong with tags for all files.
#[derive(Debug, Default)]
pub(crate) struct WrongGlobals {
    found: Vec<Arc<Anchored>>,
    /// The names of the tags that it is about.
    names: FxHashSet<Name>,
}

impl WrongGlobals {
    /// Keeps what is found in a text, about tags of these names.
    pub(crate) fn new(found: Vec<Diagnostic>, names: FxHashSet<Name>, context: &Context) -> WrongGlobals {
        let found = found.into_iter();
        WrongGlobals {
            found: found
                .map(|found| Arc::new(Anchored::anywhere(found, context)))
                .collect(),
            names,
        }
    }

    /// All of it.
    pub(crate) fn found(&self) -> impl Iterator<Item = &Arc<Anchored>> {
        self.found.iter()
    }

    /// Whether all its places stay true when text comes or goes elsewhere.
    pub(crate) fn follows_edits(&self) -> bool {
        !self.found.iter().any(|found| found.is_volatile())
    }

    /// Whether some of it is about a tag of this name.
    pub(crate) fn is_about(&self, name: &Name) -> bool {
        self.names.contains(name)
    }
}

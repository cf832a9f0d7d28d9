//! Other files that programs use, and what became of them.

use crate::by_networks::is_harmless;
use crate::comparison::compare;
use crate::outline::Outline;

use ladder_analysis::context::Context;
use ladder_prover::other_tags;
use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

/// A file that a program uses, or a tag that another file declares, and what is different about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Used {
    /// The file or tag.
    pub name: String,
    /// What is different.
    pub difference: Difference,
}

/// What is different about a file that is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Difference {
    /// What is in it.
    Content,
    /// Only the new program uses it.
    New,
    /// Only the old program uses it.
    Gone,
    /// The declaration of a tag, in another file.
    Declaration,
}

impl Difference {
    /// As it is called in JSON: one word.
    pub const fn word(self) -> &'static str {
        match self {
            Difference::Content => "content",
            Difference::New => "new",
            Difference::Gone => "gone",
            Difference::Declaration => "declaration",
        }
    }
}

impl fmt::Display for Used {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = &self.name;
        match self.difference {
            Difference::Content => write!(f, "it uses {name}, which is different"),
            Difference::New => write!(f, "it uses {name} now"),
            Difference::Gone => write!(f, "it no longer uses {name}"),
            Difference::Declaration => write!(f, "it uses {name}, which another file declares differently"),
        }
    }
}

/// The files that are not the same on both sides in all that matters to a run.
pub(crate) fn used(old: &Outline, new: &Outline) -> Vec<Used> {
    let names: BTreeSet<&String> = old.files.keys().chain(new.files.keys()).collect();
    let difference = |name: &str| match (old.files.get(name), new.files.get(name)) {
        (Some(old), Some(new)) => (!do_the_same(old, new)).then_some(Difference::Content),
        (Some(_), None) => Some(Difference::Gone),
        (None, Some(_)) => Some(Difference::New),
        (None, None) => None,
    };
    let used = names.into_iter().filter_map(|name| {
        Some(Used {
            name: name.clone(),
            difference: difference(name)?,
        })
    });
    used.collect()
}

/// Of two programs with the same text the tags that are different, for other files declare them.
pub(crate) fn declared_elsewhere(old: &Outline, new: &Outline) -> Vec<Used> {
    let (Some(old), Some(new)) = (old.known_program(), new.known_program()) else {
        return Vec::new();
    };
    let used = other_tags(old, new).into_iter().map(|name| Used {
        name,
        difference: Difference::Declaration,
    });
    used.collect()
}

/// Whether two forms of a file say the same but for layout and comments.
fn do_the_same(old: &Arc<Context>, new: &Arc<Context>) -> bool {
    if old.parse.to_string() == new.parse.to_string() {
        return true;
    }
    let (old, new) = (Outline::new(Arc::clone(old)), Outline::new(Arc::clone(new)));
    let comparison = compare(&old, &new);
    comparison.changes.iter().all(is_harmless)
}

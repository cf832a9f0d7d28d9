//! The other files of a workspace, as features read them that look beyond one file: of each its names are enough.

use ladder_analysis::context::Context;
use ladder_syntax::Name;
use std::sync::Arc;

/// Where a feature finds the other files of the workspace. It never gives the file that is asked about itself.
pub trait Workspace {
    /// The file of a name.
    fn file(&self, name: &str) -> Option<Arc<Context>>;

    /// At least all files whose text [`mentions`] a name.
    fn mentioning(&self, name: &Name) -> Vec<Arc<Context>>;

    /// All of them.
    fn all(&self) -> Vec<Arc<Context>>;

    /// The files of scenarios, which name tags too.
    fn scenarios(&self) -> Vec<ScenarioFile> {
        Vec::new()
    }
}

/// A file of scenarios.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScenarioFile {
    /// Its name in the workspace.
    pub name: Arc<str>,
    /// The name of the program that it is about, if there is one.
    pub program: Option<Arc<str>>,
    /// What it says.
    pub text: String,
}

/// A file that is alone.
#[derive(Debug, Clone, Copy)]
pub struct Alone;

impl Workspace for Alone {
    fn file(&self, _: &str) -> Option<Arc<Context>> {
        None
    }

    fn mentioning(&self, _: &Name) -> Vec<Arc<Context>> {
        Vec::new()
    }

    fn all(&self) -> Vec<Arc<Context>> {
        Vec::new()
    }
}

/// Whether a name is somewhere in a text, in whatever case, if only as a part of another one.
pub fn mentions(text: &str, name: &Name) -> bool {
    // Folded as a whole, every name in it is folded.
    Name::new(text).as_str().contains(name.as_str())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_found_in_every_spelling() {
        let ma = |text, name| mentions(text, &Name::new(name));
        assert!(ma("+--[ ]( START )--+", "start"));
        assert!(ma("+--[ ]( \u{212a}ipp )--+", "kipp"));
        assert!(ma("+--[ ]( A\u{308}b )--+", "ÄB"));
        assert!(!ma("+--[ ]( star )--+", "start"));
    }
}

//! The other files of a workspace, as features read them that look beyond one file.

use ladder_analysis::Analysis;
use ladder_analysis::context::Context;
use ladder_syntax::Name;
use std::sync::Arc;

/// Another file of the workspace: its name, as exports and findings know it, and what it says.
#[derive(Debug, Clone)]
pub struct Neighbour {
    name: Arc<str>,
    facts: Facts,
}

#[derive(Debug, Clone)]
enum Facts {
    /// A file that an editor shows is analysed anyway.
    Analysed(Arc<Analysis>),
    /// Of any other the names are enough.
    Read(Arc<Context>),
}

impl Neighbour {
    /// A file that was analysed.
    pub fn analysed(analysis: Arc<Analysis>) -> Neighbour {
        Neighbour {
            name: Arc::clone(&analysis.name),
            facts: Facts::Analysed(analysis),
        }
    }

    /// A file of which only the names were read.
    pub fn read(name: Arc<str>, context: Arc<Context>) -> Neighbour {
        Neighbour {
            name,
            facts: Facts::Read(context),
        }
    }

    pub(crate) fn file(&self) -> File<'_> {
        let context = match &self.facts {
            Facts::Analysed(analysis) => &analysis.context,
            Facts::Read(context) => context,
        };
        File {
            name: &self.name,
            context,
        }
    }
}

/// One file, whichever it is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct File<'f> {
    pub(crate) name: &'f Arc<str>,
    pub(crate) context: &'f Context,
}

impl<'f> File<'f> {
    pub(crate) fn own(analysis: &'f Analysis) -> File<'f> {
        File {
            name: &analysis.name,
            context: &analysis.context,
        }
    }

    pub(crate) fn is_called(self, name: &str) -> bool {
        **self.name == *name
    }
}

/// Where a feature finds the other files of the workspace. It never gives the file that is asked about itself.
pub trait Workspace {
    /// The file of a name.
    fn file(&self, name: &str) -> Option<Neighbour>;

    /// At least all files whose text [`mentions`] a name.
    fn mentioning(&self, name: &Name) -> Vec<Neighbour>;

    /// All of them.
    fn all(&self) -> Vec<Neighbour>;

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

/// A file that stands alone.
#[derive(Debug, Clone, Copy)]
pub struct Alone;

impl Workspace for Alone {
    fn file(&self, _: &str) -> Option<Neighbour> {
        None
    }

    fn mentioning(&self, _: &Name) -> Vec<Neighbour> {
        Vec::new()
    }

    fn all(&self) -> Vec<Neighbour> {
        Vec::new()
    }
}

/// Whether a name stands somewhere in a text, in whatever case, if only as a part of another one.
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

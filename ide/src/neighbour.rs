//! The other files of a workspace, as features read them that look beyond one file: of each its names are enough.

use ladder_analysis::context::Context;
use ladder_analysis::library_analysis;
use ladder_simulator::scenario::Suite;
use ladder_syntax::Name;
use std::borrow::Cow;
use std::sync::{Arc, Mutex, PoisonError};

/// Where a feature finds the other files of the workspace. It never gives the file that is asked about itself.
pub trait Workspace {
    /// The file of a name.
    fn file(&self, name: &str) -> Option<Arc<Context>>;

    /// Shows files with their numbers in the order of the workspace, in any order and several at once. They may be
    /// thousands: what is known of one takes much more memory than its text, and is dropped after use.
    fn show(&self, which: Which<'_>, look: &(dyn Fn(usize, &Arc<Context>) + Sync));

    /// The files of scenarios, which name tags too.
    fn scenarios(&self) -> Vec<ScenarioFile> {
        Vec::new()
    }
}

/// Which files of a workspace are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Which<'n> {
    /// At least all whose text has one of these names somewhere.
    Mentioning(&'n [Name]),
    /// All of them.
    All,
}

impl Which<'_> {
    /// Whether a file is among them, whose text is only put together where it is asked for.
    pub fn takes<'t>(self, text: impl FnOnce() -> Cow<'t, str>) -> bool {
        match self {
            Which::All => true,
            Which::Mentioning(names) => {
                let text = text();
                names.iter().any(|name| mentions(&text, name))
            }
        }
    }
}

/// The file of a name: of the workspace, or of the library, which every workspace sees.
pub(crate) fn named(workspace: &dyn Workspace, name: &str) -> Option<Arc<Context>> {
    let of_library = library_analysis(name).map(|analysis| Arc::clone(&analysis.context));
    of_library.or_else(|| workspace.file(name))
}

/// What is found in files of a workspace, in its order.
pub(crate) fn in_each<T: Send>(
    workspace: &dyn Workspace,
    which: Which<'_>,
    look: impl Fn(&Context) -> T + Sync,
) -> Vec<T> {
    gathered(|take| workspace.show(which, &|number, file| take(number, look(file))))
}

/// What several threads find, in the order of the numbers that they give with it.
pub fn gathered<T: Send>(find: impl FnOnce(&(dyn Fn(usize, T) + Sync))) -> Vec<T> {
    let found = Mutex::new(Vec::new());
    find(&|number, one| {
        let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
        found.push((number, one));
    });
    let mut found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
    found.sort_unstable_by_key(|(number, _)| *number);
    found.into_iter().map(|(_, one)| one).collect()
}

/// The first of the files, in the order of the workspace, that is the wanted one.
pub(crate) fn first_that(
    workspace: &dyn Workspace,
    which: Which<'_>,
    is_it: impl Fn(&Context) -> bool + Sync,
) -> Option<Arc<Context>> {
    let first: Mutex<Option<(usize, Arc<Context>)>> = Mutex::new(None);
    workspace.show(which, &|number, file| {
        if !is_it(file) {
            return;
        }
        let mut first = first.lock().unwrap_or_else(PoisonError::into_inner);
        if first.as_ref().is_none_or(|(known, _)| number < *known) {
            *first = Some((number, Arc::clone(file)));
        }
    });
    let first = first.into_inner().unwrap_or_else(PoisonError::into_inner);
    first.map(|(_, file)| file)
}

/// A file of scenarios.
#[derive(Debug, Clone)]
pub struct ScenarioFile {
    /// Its name in the workspace.
    pub name: Arc<str>,
    /// The name of the program that it is about, if there is one.
    pub program: Option<Arc<str>>,
    /// What it says.
    pub text: String,
    /// What was read from that.
    pub suite: Arc<Suite>,
}

/// A file that is alone.
#[derive(Debug, Clone, Copy)]
pub struct Alone;

impl Workspace for Alone {
    fn file(&self, _: &str) -> Option<Arc<Context>> {
        None
    }

    fn show(&self, _: Which<'_>, _: &(dyn Fn(usize, &Arc<Context>) + Sync)) {}
}

/// Whether a name is somewhere in a text, in whatever case, if only as a part of another one.
pub(crate) fn mentions(text: &str, name: &Name) -> bool {
    if text.is_ascii() {
        return name.as_str().is_ascii() && contains_in_any_case(text.as_bytes(), name.as_str().as_bytes());
    }
    // Folded as a whole, every name in it is folded.
    Name::new(text).as_str().contains(name.as_str())
}

fn contains_in_any_case(text: &[u8], name: &[u8]) -> bool {
    let Some(&first) = name.first() else { return true };
    let mut begins = memchr::memchr2_iter(first.to_ascii_lowercase(), first.to_ascii_uppercase(), text);
    begins.any(|at| {
        text.get(at..at + name.len())
            .is_some_and(|it| it.eq_ignore_ascii_case(name))
    })
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
        assert!(ma("+--[ ]( s_Start )--+", "START"));
        assert!(!ma("+--[ ]( star", "start"));
        assert!(!ma("+--[ ]( a )--+", "ä"));
    }
}

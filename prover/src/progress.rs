//! How far a search has come.

use std::fmt;
use std::rc::Rc;

/// How far a search has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// The scan that is searched.
    pub scan: usize,
    /// How many questions are answered.
    pub decided: usize,
    /// Of how many.
    pub of: usize,
}

/// Who is told, in each scan that is searched; by default nobody is.
#[derive(Clone, Default)]
pub struct Listener(Option<Rc<dyn Fn(Progress)>>);

impl Listener {
    /// Tells this.
    pub fn new(tell: impl Fn(Progress) + 'static) -> Listener {
        Listener(Some(Rc::new(tell)))
    }

    pub(crate) fn tell(&self, progress: Progress) {
        if let Some(tell) = &self.0 {
            tell(progress);
        }
    }
}

impl fmt::Debug for Listener {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Listener")
    }
}

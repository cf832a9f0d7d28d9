//! Who waits for a proof: whether anybody still does, as an editor whose text has changed does not, and how far it has come.

use std::cell::RefCell;

type IsWanted = Box<dyn Fn() -> bool>;
type Tell = Box<dyn Fn(Progress)>;

thread_local! {
    /// Of the proof that this thread is about.
    static WANTED: RefCell<Option<IsWanted>> = const { RefCell::new(None) };
    static TOLD: RefCell<Option<Tell>> = const { RefCell::new(None) };
}

/// Forgets at the end of a job, and after a panic in it, too.
struct Forget;

impl Drop for Forget {
    fn drop(&mut self) {
        WANTED.set(None);
        TOLD.set(None);
    }
}

/// Does a job on this thread whose proofs are given up once this says that they are not wanted any more: it is asked often.
/// What is not decided by then is unknown.
pub fn while_wanted<T>(is_wanted: impl Fn() -> bool + 'static, job: impl FnOnce() -> T) -> T {
    WANTED.set(Some(Box::new(is_wanted)));
    let _forget = Forget;
    job()
}

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

/// Does a job on this thread, and tells in each scan that is searched how far it is.
pub fn telling<T>(tell: impl Fn(Progress) + 'static, job: impl FnOnce() -> T) -> T {
    TOLD.set(Some(Box::new(tell)));
    let _forget = Forget;
    job()
}

/// Tells who waits for what this thread does.
pub(crate) fn tell(progress: Progress) {
    TOLD.with_borrow(|tell| {
        if let Some(tell) = tell {
            tell(progress);
        }
    });
}

/// Whether anybody waits for what this thread does.
pub fn is_wanted() -> bool {
    let ask = |wanted: &Option<IsWanted>| wanted.as_ref().is_none_or(|wanted| wanted());
    WANTED.with_borrow(ask)
}

#[cfg(test)]
mod tests {
    use crate::limits::End;
    use crate::wanted::while_wanted;
    use std::time::Duration;

    #[test]
    fn it_is_over_when_nobody_waits() {
        let end = End::after(Duration::from_secs(60));
        assert!(!end.is_over());
        assert!(while_wanted(|| false, || end.is_over()));
        assert!(!while_wanted(|| true, || end.is_over()));
        assert!(!end.is_over(), "the next proof is wanted");
        assert!(End::after(Duration::ZERO).is_over());
    }
}

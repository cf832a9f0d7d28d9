//! Whether anybody still waits for a proof: an editor whose text has changed does not.

use std::cell::RefCell;

type IsWanted = Box<dyn Fn() -> bool>;

thread_local! {
    /// Of the proof that this thread is about.
    static WANTED: RefCell<Option<IsWanted>> = const { RefCell::new(None) };
}

/// Forgets at the end of a job, and after a panic in it, too.
struct Forget;

impl Drop for Forget {
    fn drop(&mut self) {
        WANTED.set(None);
    }
}

/// Does a job on this thread whose proofs are given up once this says that they are not wanted any more: it is asked often.
/// What is not decided by then is unknown.
pub fn while_wanted<T>(is_wanted: impl Fn() -> bool + 'static, job: impl FnOnce() -> T) -> T {
    WANTED.set(Some(Box::new(is_wanted)));
    let _forget = Forget;
    job()
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
    use std::time::{Duration, Instant};

    #[test]
    fn it_is_over_when_nobody_waits() {
        let end = End::from(Instant::now() + Duration::from_secs(60));
        assert!(!end.is_over());
        assert!(while_wanted(|| false, || end.is_over()));
        assert!(!while_wanted(|| true, || end.is_over()));
        assert!(!end.is_over(), "the next proof is wanted");
        assert!(End::from(Instant::now()).is_over());
    }
}

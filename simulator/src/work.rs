//! What counts for the watchdog: blocks, and what a block does to many elements, characters or operands.

use std::fmt;
use std::sync::Arc;

/// This many elements of an array, characters of a text, or operands count as one block.
pub(crate) const ELEMENTS: usize = 100;

/// A scan that has done the work of this many blocks asks its [`Brake`]; a shorter one always comes to its end.
pub(crate) const UNBRAKED: u64 = 100_000;

/// How deep calls may nest (LANGUAGE §5.5).
pub const CALL_DEPTH: usize = 64;

/// For how many further blocks these elements count.
pub(crate) fn blocks(elements: usize) -> u32 {
    u32::try_from(elements / ELEMENTS).unwrap_or(u32::MAX)
}

/// Stops a scan that takes long: asked now and then while it runs, from the thread that runs it.
#[derive(Clone)]
pub struct Brake(Arc<dyn Fn() -> bool + Send + Sync>);

impl Brake {
    /// A brake that is on while `is_on` says so.
    pub fn new(is_on: impl Fn() -> bool + Send + Sync + 'static) -> Brake {
        Brake(Arc::new(is_on))
    }

    pub(crate) fn is_on(&self) -> bool {
        (self.0)()
    }
}

impl fmt::Debug for Brake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Brake")
    }
}

//! Ctrl-C while properties are decided: the first asks for the answers that are there, the second ends the program.

use std::sync::atomic::AtomicBool;

/// High once the answers that are there are wanted.
#[cfg(feature = "screen")]
pub(super) fn watched() -> Option<&'static AtomicBool> {
    use signal_hook::consts::SIGINT;
    use std::sync::Arc;

    /// As a shell says that a signal ended a program.
    const INTERRUPTED: i32 = 130;
    let came = Arc::<AtomicBool>::default();
    // In this order: the first one does not see what it brought itself.
    signal_hook::flag::register_conditional_shutdown(SIGINT, INTERRUPTED, Arc::clone(&came)).ok()?;
    signal_hook::flag::register(SIGINT, Arc::clone(&came)).ok()?;
    // It is there for as long as the program is.
    Some(&**Box::leak(Box::new(came)))
}

/// Without signals the program just ends.
#[cfg(not(feature = "screen"))]
pub(super) fn watched() -> Option<&'static AtomicBool> {
    None
}

//! Ctrl-C while properties are decided: the first asks for the answers that are there, the second ends the program.

use ladder_analysis::Cancel;

/// Cancelled once the answers that are there are wanted.
#[cfg(feature = "screen")]
pub(super) fn watched() -> Cancel {
    use signal_hook::consts::SIGINT;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// As a shell says that a signal ended a program.
    const INTERRUPTED: i32 = 130;
    let came = Arc::<AtomicBool>::default();
    // In this order: the first one does not see what it brought itself.
    let ended = signal_hook::flag::register_conditional_shutdown(SIGINT, INTERRUPTED, Arc::clone(&came));
    // Where nothing can be registered, the program just ends.
    if ended.is_ok() {
        let _ = signal_hook::flag::register(SIGINT, Arc::clone(&came));
    }
    Cancel::when(move || came.load(Ordering::Relaxed))
}

/// Without signals the program just ends.
#[cfg(not(feature = "screen"))]
pub(super) fn watched() -> Cancel {
    Cancel::default()
}

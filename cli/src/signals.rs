//! Signals, and the end of the time, as what a run is asked for.

use ladder_devices::real::Asked;
use signal_hook::consts::{SIGINT, SIGTERM};
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How often signals are checked: what a person does not feel.
const CHECK: Duration = Duration::from_millis(50);

/// What the process is asked for from now on. A second signal to end ends it at once.
pub(crate) fn asked(length: Option<Duration>) -> io::Result<Receiver<Asked>> {
    let ending = Arc::<AtomicBool>::default();
    for signal in [SIGINT, SIGTERM] {
        // In this order: the first signal finds the flag low, and sets it.
        signal_hook::flag::register_conditional_shutdown(signal, 128 + signal, ending.clone())?;
        signal_hook::flag::register(signal, ending.clone())?;
    }
    #[cfg(unix)]
    let (reload, report) = {
        use signal_hook::consts::{SIGHUP, SIGUSR1};
        (watched(SIGHUP)?, watched(SIGUSR1)?)
    };
    #[cfg(not(unix))]
    let (reload, report) = (Arc::<AtomicBool>::default(), Arc::<AtomicBool>::default());
    let (ask, asked) = channel();
    let end = length.map(|length| Instant::now() + length);
    let watch = move || {
        loop {
            let is_over = end.is_some_and(|end| Instant::now() >= end);
            let mut next = Vec::new();
            if report.swap(false, Ordering::SeqCst) {
                next.push(Asked::Report);
            }
            if reload.swap(false, Ordering::SeqCst) {
                next.push(Asked::Reload);
            }
            if is_over || ending.load(Ordering::SeqCst) {
                next.push(Asked::End);
            }
            let is_ending = next.contains(&Asked::End);
            if next.into_iter().any(|next| ask.send(next).is_err()) || is_ending {
                return;
            }
            let left = end.map_or(CHECK, |end| end.saturating_duration_since(Instant::now()));
            std::thread::sleep(CHECK.min(left));
        }
    };
    std::thread::Builder::new()
        .name("signals".to_owned())
        .spawn(watch)?;
    Ok(asked)
}

/// A flag that is set when a signal comes.
#[cfg(unix)]
fn watched(signal: i32) -> io::Result<Arc<AtomicBool>> {
    let came = Arc::<AtomicBool>::default();
    signal_hook::flag::register(signal, came.clone())?;
    Ok(came)
}

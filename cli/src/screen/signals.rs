//! Signals that end or stop the program: the terminal is given back first.

use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use signal_hook::consts::{SIGINT, SIGTERM};

/// The signals that ask a program to end.
#[cfg(unix)]
const ENDING: [i32; 4] = [
    SIGINT,
    SIGTERM,
    signal_hook::consts::SIGHUP,
    signal_hook::consts::SIGQUIT,
];
#[cfg(not(unix))]
const ENDING: [i32; 2] = [SIGINT, SIGTERM];

/// Within about this time a sound program ends on a signal.
const PATIENCE: Duration = Duration::from_secs(1);

/// The signal that came, if one did.
#[derive(Clone)]
pub(super) struct Signals(Arc<AtomicUsize>);

impl Signals {
    /// From now on signals are kept here.
    pub(super) fn watch() -> io::Result<Signals> {
        let came = Arc::<AtomicUsize>::default();
        for signal in ENDING {
            signal_hook::flag::register_usize(signal, came.clone(), signal as usize)?;
        }
        let signals = Signals(came);
        signals.insist()?;
        Ok(signals)
    }

    /// Ends the process if it has not ended on a signal within a second. Reading from a terminal that is gone never
    /// comes back: without this the program would go on for ever, and keep a processor busy.
    fn insist(&self) -> io::Result<()> {
        let signals = Signals(self.0.clone());
        let watch = move || {
            loop {
                std::thread::sleep(PATIENCE);
                if let Some(signal) = signals.ending() {
                    std::thread::sleep(PATIENCE);
                    super::guard::leave();
                    obey(signal);
                }
            }
        };
        std::thread::Builder::new()
            .name("signals".to_owned())
            .spawn(watch)?;
        Ok(())
    }

    /// The signal that asks the program to end.
    pub(super) fn ending(&self) -> Option<i32> {
        match self.0.load(Ordering::SeqCst) {
            0 => None,
            signal => Some(signal as i32),
        }
    }
}

/// Does what the signal would have done. For those that end programs: does not come back.
pub(super) fn obey(signal: i32) {
    let _ = signal_hook::low_level::emulate_default_handler(signal);
}

/// Stops the process until the shell lets it go on.
#[cfg(unix)]
pub(super) fn stop() {
    obey(signal_hook::consts::SIGTSTP);
}

/// There is no such thing.
#[cfg(not(unix))]
pub(super) fn stop() {}

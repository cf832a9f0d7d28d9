//! The terminal while the screen is on it, and as it was before: after quitting, after a panic, after a signal.

use crate::terminal::raw_stdout;
use ratatui::crossterm::cursor::Show;
use ratatui::crossterm::event::{DisableMouseCapture, EnableMouseCapture};
use ratatui::crossterm::execute;
use ratatui::crossterm::terminal::{
    EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode, enable_raw_mode,
};
use std::io;
use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the terminal shows the screen.
static ON: AtomicBool = AtomicBool::new(false);

/// Restores the terminal when it is dropped.
pub(super) struct Guard(());

impl Guard {
    /// Takes the terminal over.
    pub(super) fn enter() -> io::Result<Guard> {
        static HOOK: Once = Once::new();
        HOOK.call_once(|| {
            let before = std::panic::take_hook();
            std::panic::set_hook(Box::new(move |panic| {
                // The message must not go down with the screen.
                leave();
                before(panic);
            }));
        });
        enable_raw_mode()?;
        ON.store(true, Ordering::SeqCst);
        let guard = Guard(());
        execute!(raw_stdout(), EnterAlternateScreen, EnableMouseCapture)?;
        Ok(guard)
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        leave();
    }
}

/// Makes the terminal as it was. A second call does nothing.
pub(super) fn leave() {
    if ON.swap(false, Ordering::SeqCst) {
        // A user who has closed the terminal does not want to see it cleaned up.
        let _ = execute!(raw_stdout(), DisableMouseCapture, LeaveAlternateScreen, Show);
        let _ = disable_raw_mode();
    }
}

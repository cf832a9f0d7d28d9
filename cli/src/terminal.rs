//! What reaches the person: stdout for what was asked for, stderr for messages.

use anstyle::{AnsiColor, Style};
use ladder_workspace::shown;
use std::fmt::Display;
use std::io::{self, BufWriter, ErrorKind, IsTerminal, StdoutLock, Write};
use std::sync::Mutex;
use std::time::{Duration, Instant};

const ERROR: Style = AnsiColor::BrightRed.on_default().bold();
const WARNING: Style = AnsiColor::BrightYellow.on_default().bold();
const NOTE: Style = AnsiColor::BrightGreen.on_default().bold();

/// Says on stderr why something was not done.
pub(crate) fn error(message: &dyn Display) {
    say(ERROR, "error", message);
}

/// Says on stderr what a person should look at, though the work goes on.
pub(crate) fn warning(message: &dyn Display) {
    say(WARNING, "warning", message);
}

/// Says on stderr what else is worth knowing.
pub(crate) fn note(message: &dyn Display) {
    say(NOTE, "note", message);
}

/// Says something on stderr as it is, on lines of its own: what others wrote in it is written out already.
pub(crate) fn plain(message: &dyn Display) {
    let _ = writeln!(io::stderr().lock(), "{message}");
}

/// Stderr for a whole report, as it is.
pub(crate) fn stderr() -> BufWriter<io::Stderr> {
    BufWriter::new(io::stderr())
}

/// Empties the screen, with what could be scrolled back to, if stdout is one.
pub(crate) fn clear() {
    let mut stdout = io::stdout().lock();
    if stdout.is_terminal() {
        // Nobody reads a stdout that was closed.
        let _ = stdout
            .write_all(b"\x1b[2J\x1b[3J\x1b[H")
            .and_then(|()| stdout.flush());
    }
}

/// Says on stderr what is being done, on a line that the next such text replaces; an empty one takes it away.
pub(crate) fn passing(text: &str) {
    let mut stderr = io::stderr().lock();
    if stderr.is_terminal() {
        let text: String = text.chars().take(width() - 1).collect();
        // Nobody reads a stderr that was closed.
        let _ = write!(stderr, "\r\x1b[K{text}").and_then(|()| stderr.flush());
    }
}

fn say(style: Style, kind: &str, message: &dyn Display) {
    let mut stderr = anstream::stderr();
    // Nobody reads a stderr that was closed.
    let message = message.to_string();
    let _ = writeln!(stderr, "{style}{kind}:{style:#} {}", shown::text(&message));
}

/// Whether stdout shows colours: it is a terminal, and `NO_COLOR` is not set.
pub(crate) fn stdout_has_colours() -> bool {
    anstream::AutoStream::choice(&io::stdout()) != anstream::ColorChoice::Never
}

/// Whether stderr shows colours.
pub(crate) fn stderr_has_colours() -> bool {
    anstream::AutoStream::choice(&io::stderr()) != anstream::ColorChoice::Never
}

/// Whether a person sits there: keys can be read, and a screen be shown.
pub(crate) fn is_interactive() -> bool {
    io::stdin().is_terminal() && io::stdout().is_terminal()
}

/// The terminal for a screen that draws itself.
#[cfg(feature = "screen")]
pub(crate) fn raw_stdout() -> io::Stdout {
    io::stdout()
}

/// A line on stderr that says how far something is that takes long. It is shown only on a terminal, and gone at the end.
pub(crate) struct Progress {
    /// When it was last written.
    last: Option<Mutex<Instant>>,
}

/// It is written no more often.
const BETWEEN: Duration = Duration::from_millis(100);

impl Progress {
    pub(crate) fn new() -> Progress {
        let is_seen = io::stderr().is_terminal();
        Progress {
            last: is_seen.then(|| Mutex::new(Instant::now())),
        }
    }

    /// Says how far it is, unless it did a moment ago.
    pub(crate) fn say(&self, text: impl FnOnce() -> String) {
        // Whoever comes while another one writes has nothing newer to say.
        let Some(Ok(mut last)) = self.last.as_ref().map(Mutex::try_lock) else {
            return;
        };
        if last.elapsed() >= BETWEEN {
            let _ = write!(io::stderr(), "\r{}\x1b[K", text());
            *last = Instant::now();
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.last.is_some() {
            let _ = write!(io::stderr(), "\r\x1b[K");
        }
    }
}

/// How wide lines may be: what the environment says, else what the terminal has, else 100.
pub(crate) fn width() -> usize {
    let columns = std::env::var("COLUMNS").ok();
    let told = columns.and_then(|columns| columns.parse().ok());
    let terminal = || terminal_size::terminal_size_of(io::stdout()).map(|(columns, _)| columns.0.into());
    told.or_else(terminal).unwrap_or(100).max(40)
}

/// Standard output, buffered. A reader that goes away (`ladder check . | head`) is not an error: what follows is
/// dropped, and the command still ends with its true status.
pub(crate) struct Stdout {
    inner: BufWriter<StdoutLock<'static>>,
    closed: bool,
}

impl Stdout {
    pub(crate) fn new() -> Stdout {
        Stdout {
            inner: BufWriter::with_capacity(1 << 16, io::stdout().lock()),
            closed: false,
        }
    }

    /// Whether nobody reads any more, so that further work for the output's sake is idle.
    pub(crate) fn is_closed(&self) -> bool {
        self.closed
    }

    fn unless_closed<T>(&mut self, result: io::Result<T>, dropped: T) -> io::Result<T> {
        match result {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                self.closed = true;
                Ok(dropped)
            }
            other => other,
        }
    }
}

impl Write for Stdout {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.closed {
            return Ok(bytes.len());
        }
        let result = self.inner.write(bytes);
        self.unless_closed(result, bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        if self.closed {
            return Ok(());
        }
        let result = self.inner.flush();
        self.unless_closed(result, ())
    }
}

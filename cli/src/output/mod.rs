//! Where a run writes to: stdout, or a file that is there whole or not at all.

mod existing;
mod made;

pub(crate) use existing::{Existing, may_write};
pub(crate) use made::DRAWN_BY;
#[cfg(feature = "png")]
pub(crate) use made::SOFTWARE;

use crate::outcome::Failure;
use crate::terminal::Stdout;
use ladder_workspace::{Replacement, shown};
use std::io::{self, IsTerminal, Write};
use std::path::Path;

/// The output of a run.
pub(crate) enum Output {
    Stdout(Stdout),
    File(Replacement),
}

impl Output {
    pub(crate) fn open(file: Option<&Path>, existing: Existing) -> Result<Output, Failure> {
        Ok(match file {
            Some(file) if file != Path::new("-") => {
                may_write(file, existing)?;
                Output::File(Replacement::made(file)?)
            }
            _ => Output::Stdout(Stdout::new()),
        })
    }

    /// Whether it is a file, and not what a person or a log sees.
    pub(crate) fn is_file(&self) -> bool {
        matches!(self, Output::File(_))
    }

    /// Whether a person sees it at once: what is sent on is a file in the end.
    pub(crate) fn is_on_screen(&self) -> bool {
        matches!(self, Output::Stdout(_)) && io::stdout().is_terminal()
    }

    /// Writes a text that others wrote parts of: into a file as it is, on stdout with what a terminal would interpret escaped.
    pub(crate) fn write_text(&mut self, text: &str) -> io::Result<()> {
        match self {
            Output::Stdout(out) => out.write_all(shown::text(text).as_bytes()),
            Output::File(file) => file.write_all(text.as_bytes()),
        }
    }

    /// Whether nobody reads any more, so that going on is idle.
    pub(crate) fn is_closed(&self) -> bool {
        match self {
            Output::Stdout(out) => out.is_closed(),
            Output::File(_) => false,
        }
    }

    /// Puts what was written where it belongs.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        match self {
            Output::Stdout(mut out) => out.flush()?,
            Output::File(file) => file.commit()?,
        }
        Ok(())
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Output::Stdout(out) => out.write(bytes),
            Output::File(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Output::Stdout(out) => out.flush(),
            Output::File(file) => file.flush(),
        }
    }
}

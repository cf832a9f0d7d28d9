//! Where a run writes to: stdout, or a file that is there whole or not at all.

use crate::outcome::Failure;
use crate::terminal::Stdout;
use ladder_workspace::Replacement;
use std::io::{self, Write};
use std::path::Path;

/// The output of a run.
pub(crate) enum Output {
    Stdout(Stdout),
    File(Replacement),
}

impl Output {
    pub(crate) fn open(file: Option<&Path>) -> Result<Output, Failure> {
        Ok(match file {
            Some(file) if file != Path::new("-") => Output::File(Replacement::of(file)?),
            _ => Output::Stdout(Stdout::new()),
        })
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

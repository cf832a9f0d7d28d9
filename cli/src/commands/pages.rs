//! The programs as completions and manual pages describe them.

use crate::arguments::{Ladder, Ldfmt};
use clap::{Command, CommandFactory, ValueEnum};

/// One of the two programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Program {
    /// All commands
    Ladder,
    /// The formatter alone
    Ldfmt,
}

/// Its arguments.
pub(super) fn command(program: Program) -> Command {
    match program {
        Program::Ladder => Ladder::command(),
        Program::Ldfmt => Ldfmt::command(),
    }
}

//! The programs as completions and manual pages describe them.

use clap::{Command, ValueEnum};

/// One of the two programs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Program {
    /// All commands
    Ladder,
    /// The formatter alone
    Ldfmt,
}

/// The arguments of each.
pub(crate) type Described = fn(Program) -> Command;

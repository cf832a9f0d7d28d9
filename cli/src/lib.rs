//! The programs `ladder` and `ldfmt`.
//!
//! ```text
//! arguments --clap--> a command --run--> Ok(Outcome) ----------> exit status 0 or 1
//!                       |   |           Err(Failure) -> stderr -> exit status 2
//!                       |   +-- Stdout: what was asked for, and nothing else
//!                       +------ ladder-workspace: every file that is read or written
//! ```
//!
//! One file under `commands/` is one command: its arguments, with the help that people see, and what it does
//! with them. A command does its work through the library crates and only decides what to show; it never ends
//! the process itself.
//!
//! - `outcome` has the exit status: 0 fine, 1 findings, 2 the command could not do its work.
//! - `features` has what a command says whose part was left out of the build.
//! - `findings` shows what is wrong in a program. Programs come in there, those of other systems too.
//! - `form` is what a program is written in.
//! - `found_runs` is what `--write` writes: runs that were found, next to their program.
//! - `git` reads what git knows.
//! - `json` writes what machines read.
//! - `settings` has what the `ladder.toml` of a program's workspace asks for.
//! - `signals` is what a run is asked for by signals.
//! - `ready` is a scenario file with its program.
//! - `run` is a program on its way through its scans, with what the world outside gives to it.
//! - `diff` shows what would change.
//! - `output` is a file that is there whole or not at all, or stdout.
//! - `small_pages` keeps a program small that stays.
//! - `stdin` is standard input in the place of a file.
//! - `terminal` is the only module that names stdout and stderr: messages go to stderr as `error: ...`, colours
//!   only to a terminal, and a reader that closes the pipe early is not an error.
//!
//! - `screen` is `ladder sim` on a terminal: the diagram with live power.
//!
//! `ldfmt` is the command `fmt` alone: a small program that starts `ladder ldfmt`, which speaks of itself under that name.

mod arguments;
mod commands;
mod diff;
#[cfg(any(
    test,
    not(all(
        feature = "server",
        feature = "screen",
        feature = "run",
        feature = "png",
        feature = "pdf",
        feature = "pages"
    ))
))]
mod features;
mod findings;
mod form;
mod found_runs;
mod git;
mod json;
mod outcome;
mod output;
mod ready;
mod run;
#[cfg(feature = "screen")]
mod screen;
mod seen;
mod settings;
#[cfg(feature = "run")]
mod signals;
#[cfg(feature = "server")]
mod small_pages;
mod stdin;
mod terminal;
mod values;
mod xml;

use clap::Parser;
use std::process::ExitCode;

/// The program `ladder`, or `ldfmt` if that has started it, with the process's arguments.
pub fn ladder() -> ExitCode {
    let mut own = std::env::args_os().skip(1).peekable();
    if own.next_if(|first| first == "ldfmt").is_some() {
        return arguments::Ldfmt::parse_from(std::iter::once("ldfmt".into()).chain(own)).run();
    }
    arguments::Ladder::parse().run()
}

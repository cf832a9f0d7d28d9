//! What stands on the command line.

#[cfg(feature = "server")]
use crate::commands::lsp;
use crate::commands::{check, explain, fmt, render, sim, test, tree};
use crate::outcome::exit;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  ladder check motor.clad                       look for mistakes
  ladder fmt .                                  align all diagrams in this folder
  ladder sim motor.clad --scans 100 --set start=1
                                                run 100 scans with `start` high
  ladder test .                                 run all scenarios in this folder
  ladder explain TON                            how the on-delay timer works

Exit status: 0 fine, 1 findings, 2 the command could not do its work.";

/// Ladder logic as plain text: check it, align it, run it.
#[derive(Debug, Parser)]
#[command(name = "ladder", version, after_help = EXAMPLES, disable_help_subcommand = true)]
pub(crate) struct Ladder {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Check(check::Arguments),
    Fmt(fmt::Arguments),
    Sim(sim::Arguments),
    Test(test::Arguments),
    Render(render::Arguments),
    Explain(explain::Arguments),
    #[cfg(feature = "server")]
    Lsp(lsp::Arguments),
    Tree(tree::Arguments),
}

impl Ladder {
    pub(crate) fn run(self) -> ExitCode {
        let result = match self.command {
            // The server has an exit status of its own, which the protocol asks for.
            #[cfg(feature = "server")]
            Command::Lsp(arguments) => return lsp::run(&arguments),
            Command::Check(arguments) => check::run(&arguments),
            Command::Fmt(arguments) => fmt::run(&arguments),
            Command::Sim(arguments) => sim::run(&arguments),
            Command::Test(arguments) => test::run(&arguments),
            Command::Render(arguments) => render::run(&arguments),
            Command::Explain(arguments) => explain::run(&arguments),
            Command::Tree(arguments) => tree::run(&arguments),
        };
        exit(result)
    }
}

/// The formatter alone.
#[derive(Debug, Parser)]
#[command(name = "ldfmt", version)]
pub(crate) struct Ldfmt {
    #[command(flatten)]
    arguments: fmt::Arguments,
}

impl Ldfmt {
    pub(crate) fn run(self) -> ExitCode {
        exit(fmt::run(&self.arguments))
    }
}

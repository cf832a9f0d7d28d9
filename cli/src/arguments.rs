//! What is on the command line.

#[cfg(feature = "mcp")]
use crate::commands::mcp;
use crate::commands::{
    check, convert, dap, diff, explain, fmt, git, lsp, merge, new, prove, render, sim, tags, test, tree, why,
};
#[cfg(feature = "pages")]
use crate::commands::{completions, man, pages};
#[cfg(feature = "run")]
use crate::commands::{online, run};
#[cfg(not(all(feature = "mcp", feature = "pages", feature = "run")))]
use crate::features::{Feature, LeftOut};
use crate::outcome::exit;
#[cfg(feature = "pages")]
use clap::CommandFactory;
use clap::{Parser, Subcommand};
use std::process::ExitCode;

const EXAMPLES: &str = "\
Examples:
  ladder new press                make a folder to begin in
  ladder check motor.clad         look for errors
  ladder fmt .                    align all diagrams in this folder
  ladder sim motor.clad           run it, live, on this terminal
  ladder sim motor.clad --scans 100 --set start=1
                                  run 100 scans with `start` high
  ladder run motor.clad           run it in real time, as a controller
  ladder online motor.clad        see what a running controller is doing
  ladder test .                   run all scenarios in this folder
  ladder prove .                  prove what must hold in every run
  ladder convert old.cplc -o motor.clad
                                  programs of other systems
  ladder diff HEAD:motor.clad motor.clad
                                  what changed, network by network
  ladder explain TON              how the on-delay timer works
  ladder help sim                 all about one of the commands

Exit status: 0 fine, 1 findings, 2 the command could not do its work.";

/// What `--version` prints: the version, and of which commit and for which target the program is. `-V` is the version alone.
const VERSION: &str = concat!(env!("CARGO_PKG_VERSION"), " (", env!("LADDER_BUILT_FROM"), ")");

/// Ladder logic as plain text: check it, align it, run it.
#[derive(Debug, Parser)]
#[command(name = "ladder", version, long_version = VERSION, after_help = EXAMPLES)]
pub(crate) struct Ladder {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Check(check::Arguments),
    Fmt(fmt::Arguments),
    Sim(sim::Arguments),
    #[cfg(feature = "run")]
    Run(run::Arguments),
    /// Run a program in real time (not in this build)
    #[cfg(not(feature = "run"))]
    Run(LeftOut),
    #[cfg(feature = "run")]
    Online(online::Arguments),
    /// Show what a running controller is doing (not in this build)
    #[cfg(not(feature = "run"))]
    Online(LeftOut),
    Test(test::Arguments),
    Prove(prove::Arguments),
    Render(render::Arguments),
    Diff(diff::Arguments),
    Merge(merge::Arguments),
    Git(git::Arguments),
    Tags(tags::Arguments),
    Why(why::Arguments),
    Convert(convert::Arguments),
    Explain(explain::Arguments),
    Lsp(lsp::Arguments),
    Dap(dap::Arguments),
    #[cfg(feature = "mcp")]
    Mcp(mcp::Arguments),
    /// Be a server of tools for assistants (not in this build)
    #[cfg(not(feature = "mcp"))]
    Mcp(LeftOut),
    Tree(tree::Arguments),
    #[cfg(feature = "pages")]
    Completions(completions::Arguments),
    #[cfg(feature = "pages")]
    Man(man::Arguments),
    /// Print a script for a shell (not in this build)
    #[cfg(not(feature = "pages"))]
    Completions(LeftOut),
    /// Print a manual page (not in this build)
    #[cfg(not(feature = "pages"))]
    Man(LeftOut),
}

impl Ladder {
    pub(crate) fn run(self) -> ExitCode {
        let result = match self.command {
            // They have exit statuses of their own.
            Command::Lsp(arguments) => return lsp::run(&arguments),
            Command::Dap(arguments) => return dap::run(&arguments),
            Command::New(arguments) => new::run(&arguments),
            Command::Check(arguments) => check::run(&arguments),
            Command::Fmt(arguments) => fmt::run(&arguments),
            Command::Sim(arguments) => sim::run(&arguments),
            #[cfg(feature = "run")]
            Command::Run(arguments) => run::run(&arguments),
            #[cfg(not(feature = "run"))]
            Command::Run(_) | Command::Online(_) => Err(Feature::Run.left_out()),
            #[cfg(feature = "run")]
            Command::Online(arguments) => online::run(&arguments),
            #[cfg(feature = "mcp")]
            Command::Mcp(arguments) => mcp::run(&arguments),
            #[cfg(not(feature = "mcp"))]
            Command::Mcp(_) => Err(Feature::Mcp.left_out()),
            Command::Test(arguments) => test::run(&arguments),
            Command::Prove(arguments) => prove::run(&arguments),
            Command::Render(arguments) => render::run(&arguments),
            Command::Diff(arguments) => diff::run(&arguments),
            Command::Merge(arguments) => merge::run(&arguments),
            Command::Git(arguments) => git::run(&arguments),
            Command::Tags(arguments) => tags::run(&arguments),
            Command::Why(arguments) => why::run(&arguments),
            Command::Convert(arguments) => convert::run(&arguments),
            Command::Explain(arguments) => explain::run(&arguments),
            Command::Tree(arguments) => tree::run(&arguments),
            #[cfg(feature = "pages")]
            Command::Completions(arguments) => completions::run(&arguments, described),
            #[cfg(feature = "pages")]
            Command::Man(arguments) => man::run(&arguments, described),
            #[cfg(not(feature = "pages"))]
            Command::Completions(_) | Command::Man(_) => Err(Feature::Pages.left_out()),
        };
        exit(result)
    }
}

/// The arguments of a program, as completions and manual pages describe them.
#[cfg(feature = "pages")]
fn described(program: pages::Program) -> clap::Command {
    match program {
        pages::Program::Ladder => Ladder::command(),
        pages::Program::Ldfmt => Ldfmt::command(),
    }
}

/// The formatter alone.
#[derive(Debug, Parser)]
#[command(name = "ldfmt", version, long_version = VERSION)]
pub(crate) struct Ldfmt {
    #[command(flatten)]
    arguments: fmt::Arguments,
}

impl Ldfmt {
    pub(crate) fn run(self) -> ExitCode {
        exit(fmt::run(&self.arguments))
    }
}

//! `ladder completions`: what a shell reads to complete commands, options and names.

use super::pages::{Described, Program};
use crate::outcome::{Failure, Outcome};
use crate::terminal::Stdout;
use clap::Args;
use clap_complete::Shell;
use std::io::Write;

const EXAMPLES: &str = "\
Examples:
  ladder completions bash > ~/.local/share/bash-completion/completions/ladder
  ladder completions zsh > ~/.zfunc/_ladder
                          ~/.zshrc has `fpath+=~/.zfunc` before `compinit`
  ladder completions fish > ~/.config/fish/completions/ladder.fish
  ladder completions powershell >> $PROFILE
  ladder completions zsh --program ldfmt > ~/.zfunc/_ldfmt

Exit status: 0 fine, 2 the shell is not known.";

/// Print what a shell needs to complete commands
///
/// Put it where your shell looks for it, and Tab completes commands, options and their values; in bash and zsh also the
/// names that `ladder explain` knows.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The shell that reads it
    #[arg(value_enum)]
    shell: Shell,

    /// The program that is completed
    #[arg(long, value_enum, default_value_t = Program::Ladder)]
    program: Program,
}

pub(crate) fn run(arguments: &Arguments, described: Described) -> Result<Outcome, Failure> {
    let mut script = Vec::new();
    let mut command = described(arguments.program);
    let name = command.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    let mut out = Stdout::new();
    out.write_all(&script)?;
    out.flush()?;
    Ok(Outcome::Fine)
}

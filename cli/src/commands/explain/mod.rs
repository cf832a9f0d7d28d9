//! `ladder explain`: the reference page of a rule or an instruction.

mod instruction;
mod look;
mod markdown;
mod rule;

use crate::outcome::{Failure, Outcome};
use crate::terminal::Stdout;
use clap::Args;
use ladder_instructions::{Shape, closest};
use look::Look;
use std::io::Write;

const EXAMPLES: &str = "\
Examples:
  ladder explain TON
  ladder explain '[/]'              the quotes keep the shell from reading the brackets
  ladder explain '( S )'            the coil, where a name alone has several meanings
  ladder explain double-coil        the name that a finding shows in brackets";

/// Show what a rule is about, or how an instruction works
///
/// Of a rule: what is wrong, a rung that has it and one that does not, and what to do. Of an instruction: its
/// operands, what it does, what power leaves it, and a rung that shows it.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The name of a rule, or of an instruction, with its brackets or without
    #[arg(value_name = "RULE-OR-INSTRUCTION")]
    name: String,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let name = &arguments.name;
    let look = Look::of_stdout();
    let mut out = Stdout::new();
    if let Some(rule) = rule::find(name) {
        rule::print(rule, &look, &mut out)?;
        out.flush()?;
        return Ok(Outcome::Fine);
    }
    let rows = instruction::find(name);
    if rows.is_empty() {
        return Err(unknown(name));
    }
    for (index, row) in rows.into_iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        instruction::print(row, &look, &mut out)?;
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

fn unknown(name: &str) -> Failure {
    let (shape, mnemonic) = instruction::bracketed(name).unwrap_or((Shape::Logical, name));
    let help = match (rule::closest(name), closest(shape, mnemonic)) {
        (Some(rule), _) => format!("; did you mean `{rule}`?"),
        (_, Some(row)) => format!("; did you mean `{}` ({})?", row.block(), row.title.to_lowercase()),
        (None, None) => String::new(),
    };
    Failure::new(format!("no rule or instruction is called `{name}`{help}"))
}

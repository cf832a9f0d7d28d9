//! `ladder explain`: the reference page of a rule, an instruction, or a block of a program.

mod block;
mod instruction;
mod list;
mod look;
mod markdown;
mod names;
mod rule;
mod wrap;

use crate::outcome::{Failure, Outcome};
use crate::terminal::Stdout;
use clap::Args;
use ladder_instructions::{Instruction, Shape, closest};
use look::Look;
use names::Names;
use std::io::Write;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  ladder explain                    all instructions and rules, a line each
  ladder explain TON                an instruction
  ladder explain double-coil        a rule: a finding shows its name in brackets
  ladder explain '[/]'              the quotes keep the shell from the brackets
  ladder explain '$Alarm'           a block of the programs in this folder
  ladder explain '$Alarm' plant.clad
                                    of this program or its workspace
  ladder explain '( S )'            the coil, where a name means several things

Exit status: 0 fine, 2 nothing has this name.";

/// Show what a rule is about, or how an instruction works
///
/// Of a rule: what is wrong, a rung that has it and one that does not, and what to do. Of an instruction: its
/// operands, what it does, what power leaves it, and a rung that shows it. Of a block of a program: its operands with their
/// types. Without a name: what there is.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The name of a rule, of an instruction with its brackets or without, or of a block of a program
    #[arg(value_name = "RULE-OR-INSTRUCTION", value_parser = Names, hide_possible_values = true)]
    name: Option<String>,

    /// The program whose block is explained; without it those in this folder are searched
    #[arg(value_name = "PROGRAM")]
    program: Option<PathBuf>,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let look = Look::of_stdout();
    let mut out = Stdout::new();
    let Some(name) = &arguments.name else {
        list::print(&look, &mut out)?;
        out.flush()?;
        return Ok(Outcome::Fine);
    };
    if let Some(block) = block::named(name) {
        let page = block::page(block, arguments.program.as_deref())?;
        block::print(&page, &look, &mut out)?;
        out.flush()?;
        return Ok(Outcome::Fine);
    }
    if arguments.program.is_some() {
        return Err(Failure::new(format!(
            "a program is only asked for a block, whose name begins with `$`; `{name}` is the same in all"
        )));
    }
    if let Some(rule) = rule::find(name) {
        rule::print(rule, &look, &mut out)?;
        out.flush()?;
        return Ok(Outcome::Fine);
    }
    let rows = instruction::find(name);
    if rows.is_empty() {
        // A block, without its `$`.
        let Some(page) = block::without_sign(name) else {
            return Err(unknown(name));
        };
        block::print(&page, &look, &mut out)?;
        out.flush()?;
        return Ok(Outcome::Fine);
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
    let meant = meant(name);
    let help = match meant.split_last() {
        Some((only, [])) => format!("did you mean {only}?"),
        Some((last, others)) => format!("did you mean {} or {last}?", others.join(", ")),
        None => "`ladder explain` lists all".to_owned(),
    };
    Failure::new(format!("no rule or instruction is called `{name}`; {help}"))
}

/// More than these are not offered.
const MOST: usize = 6;

/// What a person may have meant: a rule that is spelt almost so, what has this word in its name, or an instruction that is
/// spelt almost so (last, for most words are near to some short name).
fn meant(name: &str) -> Vec<String> {
    let (shape, mnemonic) = instruction::bracketed(name).unwrap_or((Shape::Logical, name));
    let named = |row: &Instruction| format!("`{}` ({})", row.block(), row.title.to_lowercase());
    let quoted = |rule: &str| format!("`{rule}`");
    if let Some(rule) = rule::closest(name) {
        return vec![quoted(rule)];
    }
    let rows = instruction::with_word(name).map(named);
    let by_word: Vec<String> = rows.chain(rule::with_word(name).map(quoted)).take(MOST).collect();
    if by_word.is_empty() {
        closest(shape, mnemonic).map(named).into_iter().collect()
    } else {
        by_word
    }
}

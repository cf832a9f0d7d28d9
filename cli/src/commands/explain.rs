//! `ladder explain`: the reference page of an instruction.

use crate::outcome::{Failure, Outcome};
use crate::terminal::{Stdout, stdout_has_colours};
use anstyle::{AnsiColor, Style};
use clap::Args;
use ladder_instructions::{Acts, Direction, Instruction, Presence, Shape, closest, lookup};
use std::io::{self, Write};

const EXAMPLES: &str = "\
Examples:
  ladder explain TON
  ladder explain '[/]'        the quotes keep the shell from reading the brackets
  ladder explain '( S )'      the coil, where a name alone has several meanings";

/// Show how an instruction works
///
/// Its operands, what it does, what power leaves it, and a rung that shows it.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// An instruction's name, with its brackets or without
    name: String,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let pages = find(&arguments.name);
    if pages.is_empty() {
        return Err(unknown(&arguments.name));
    }
    let mut out = Stdout::new();
    let style = Look::of_stdout();
    for (index, page) in pages.into_iter().enumerate() {
        if index > 0 {
            writeln!(out)?;
        }
        print(page, &style, &mut out)?;
    }
    out.flush()?;
    Ok(Outcome::Fine)
}

/// All rows that go by the name; brackets around it narrow them down.
fn find(name: &str) -> Vec<&'static Instruction> {
    match bracketed(name) {
        Some((shape, mnemonic)) => lookup(shape, mnemonic).collect(),
        // A blank names the open contact and the coil, but only between brackets: as a whole name it is a slip.
        None if name.trim().is_empty() => Vec::new(),
        None => Shape::ALL
            .into_iter()
            .flat_map(|shape| lookup(shape, name))
            .collect(),
    }
}

/// `[TON]` and `[ ]( tag )` name their brackets too.
fn bracketed(name: &str) -> Option<(Shape, &str)> {
    let name = name.trim();
    Shape::ALL.into_iter().find_map(|shape| {
        let (open, close) = shape.brackets();
        let (mnemonic, _operands) = name.strip_prefix(open)?.split_once(close)?;
        Some((shape, mnemonic))
    })
}

fn unknown(name: &str) -> Failure {
    let (shape, mnemonic) = bracketed(name).unwrap_or((Shape::Logical, name));
    let help = match closest(shape, mnemonic) {
        Some(row) => format!("; did you mean `{}` ({})?", row.block(), row.title.to_lowercase()),
        None => String::new(),
    };
    Failure::new(format!("no instruction is called `{name}`{help}"))
}

/// How the parts of a page look; empty where no colours are shown.
struct Look {
    heading: Style,
    code: Style,
}

impl Look {
    fn of_stdout() -> Look {
        if !stdout_has_colours() {
            return Look {
                heading: Style::new(),
                code: Style::new(),
            };
        }
        Look {
            heading: Style::new().bold(),
            code: AnsiColor::Cyan.on_default(),
        }
    }
}

fn print(row: &Instruction, look: &Look, out: &mut impl Write) -> io::Result<()> {
    let Look { heading, code } = look;
    writeln!(
        out,
        "{code}{}{code:#}  {heading}{}{heading:#}",
        row.signature(),
        row.title
    )?;
    writeln!(out)?;
    text(row.doc.trim(), out)?;
    if !row.operands.is_empty() {
        writeln!(out, "\n{heading}Operands{heading:#}")?;
        let width = row
            .operands
            .iter()
            .map(|operand| operand.name.len())
            .max()
            .unwrap_or(0);
        for operand in row.operands {
            let direction = match operand.direction {
                Direction::In => "in",
                Direction::Out => "out",
                Direction::InOut => "in/out",
            };
            let presence = match operand.presence {
                Presence::Required => "",
                Presence::Repeated { .. } => " May be repeated.",
                Presence::Trailing => " May be left out.",
                Presence::Named => " Given by name; may be left out.",
            };
            writeln!(
                out,
                "  {code}{:width$}{code:#}  {direction:6}  {}{presence}",
                operand.name, operand.doc
            )?;
        }
    }
    writeln!(out, "\n{heading}Power out{heading:#}\n  {}", row.eno)?;
    let acts = match row.acts {
        Acts::Always => "at every evaluation, powered or not",
        Acts::WhenPowered => "only while power enters it",
    };
    writeln!(out, "\n{heading}Acts{heading:#}\n  {acts}")?;
    let others: Vec<&str> = row.synonyms.iter().chain(row.aliases).copied().collect();
    if !others.is_empty() {
        writeln!(out, "\n{heading}Also written{heading:#}\n  {}", others.join(" "))?;
    }
    writeln!(out, "\n{heading}Example{heading:#}")?;
    for line in row.example.trim_end().lines() {
        if line.is_empty() {
            writeln!(out)?;
        } else {
            writeln!(out, "  {code}{line}{code:#}")?;
        }
    }
    Ok(())
}

/// Markdown as it is, but for fenced blocks: they are set in, without their fences.
fn text(markdown: &str, out: &mut impl Write) -> io::Result<()> {
    let mut fenced = false;
    for line in markdown.lines() {
        if line.starts_with("```") {
            fenced = !fenced;
        } else if fenced && !line.is_empty() {
            writeln!(out, "    {line}")?;
        } else {
            writeln!(out, "{line}")?;
        }
    }
    Ok(())
}

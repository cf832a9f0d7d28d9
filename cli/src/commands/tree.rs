//! `ladder tree`: the syntax tree, for people who work on the tool.

use crate::outcome::{Failure, Outcome};
use crate::terminal::Stdout;
use clap::Args;
use ladder_syntax::rowan::WalkEvent;
use ladder_syntax::{NodeOrToken, Parse, parse};
use std::io::{self, Write};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  ladder tree motor.clad                  the whole tree
  ladder tree motor.clad | grep error     what the parser found wrong

Exit status: 0 fine, 2 the file cannot be read.";

/// Print the syntax tree of a program
///
/// One line for each node and token, with its range in bytes; the errors that the parser found are after
/// the tree. Every text has a tree, so the exit status is 0 whatever the text holds.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The program
    file: PathBuf,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let text = ladder_workspace::read(&arguments.file)?;
    let mut out = Stdout::new();
    print(&parse(&text), &mut out)?;
    out.flush()?;
    Ok(Outcome::Fine)
}

fn print(parse: &Parse, out: &mut Stdout) -> io::Result<()> {
    let mut depth = 0;
    for event in parse.syntax().preorder_with_tokens() {
        if out.is_closed() {
            return Ok(());
        }
        match event {
            WalkEvent::Enter(element) => {
                let (kind, range) = (element.kind(), element.text_range());
                write!(out, "{:width$}{kind:?}@{range:?}", "", width = depth * 2)?;
                match element {
                    NodeOrToken::Token(token) => writeln!(out, " {:?}", token.text())?,
                    NodeOrToken::Node(_) => writeln!(out)?,
                }
                depth += 1;
            }
            WalkEvent::Leave(_) => depth -= 1,
        }
    }
    for error in parse.errors() {
        writeln!(out, "error@{:?} {:?}", error.range, error.kind)?;
    }
    Ok(())
}

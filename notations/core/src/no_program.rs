//! Why a file has no program of its own that could be written in another notation.

use crate::{Lines, WriteError};
use ladder_analysis::context::Callee;
use ladder_analysis::networks::NetworkAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::written::facts::NodeKind;
use ladder_analysis::{Analysis, library};
use ladder_syntax::{Name, TextRange};

/// The first error of the program, else what it uses of another file: no other notation has blocks or files that it could be
/// written as.
pub fn no_program(analysis: &Analysis, text: &str) -> WriteError {
    let place = |range: TextRange| Lines::of(text).place(text, range.start().into());
    if let Some(error) = analysis.errors().next() {
        let (place, message) = (place(error.range), &error.message);
        return WriteError::new(format!("the program has errors: {place}: {message}"));
    }
    let context = &analysis.context;
    let blocks = context.networks.iter().flat_map(NetworkAt::blocks);
    for block in blocks {
        let head = block.head_text();
        let place = place(block.range());
        match block.meaning {
            Meaning::User(user) => {
                if let Some(import) = &context.user_blocks[user].import {
                    let file = &import.file;
                    return WriteError::new(match library::source(file) {
                        Some(_) => format!(
                            "{place}: {head} is a block of the library, and the notation has no blocks of one's own: draw what it does on rungs of the program"
                        ),
                        None => format!(
                            "{place}: {head} is a block of {file}, and the notation has one file: put it into this one"
                        ),
                    });
                }
            }
            Meaning::Instruction(_) if head.eq_ignore_ascii_case("<CALL>") => {
                if let Some(operand) = block.facts.operands.first()
                    && let NodeKind::Name(name) = &operand.value.kind
                    && let Some(Callee::Other(import)) = context.callee(&Name::new(name))
                {
                    let file = &import.file;
                    return WriteError::new(format!(
                        "{place}: the function `{name}` is in {file}, and the notation has one file: put it into this one"
                    ));
                }
            }
            _ => {}
        }
    }
    WriteError::new("the program needs another file of its workspace, and the notation has one file")
}

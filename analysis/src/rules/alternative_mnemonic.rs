//! `alternative-mnemonic`: an instruction is written in one of the spellings that are also accepted.

use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::rule::Rule;
use crate::networks::BlockAt;
use ladder_instructions::Instruction;

pub(super) fn check(row: &Instruction, bound: BlockAt<'_>, out: &mut Vec<Diagnostic>) {
    let text = bound.facts.head.text();
    if row.aliases.iter().any(|alias| alias.eq_ignore_ascii_case(text)) {
        let block = row.block();
        out.push(
            Diagnostic::new(
                Rule::AlternativeMnemonic,
                bound.head_range(),
                format!("{} is another spelling of {block}", bound.head_text()),
            )
            .help("one spelling for one instruction makes a program easy to search")
            .fix(
                Applicability::Safe,
                format!("Write {block}"),
                bound.head_range(),
                block,
            ),
        );
    }
}

//! `wrong-place`: `<END>` or `<FUN>` in the body of a `[$B]` or `($B)` block, a second `<FUN>` in one network, types in a
//! block, or `VAR_IN_OUT` in none.

use super::form::Form;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use ladder_instructions::{Op, Shape};
use ladder_syntax::TextRange;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(RuleGroup::Names, "wrong-place", Severity::Error));

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    let body = network.scope.checked_sub(1).map(|block| &form.user_blocks[block]);
    let mut functions = 0;
    for bound in network.blocks() {
        match (bound.op(), body) {
            (Some(Op::End), Some(block)) if block.shape != Shape::Function => out.push(
                wrong(
                    bound,
                    "<END> cannot be in this block",
                    "<RET> ends the body of the block",
                )
                .related(block.at, "this is the block"),
            ),
            (Some(Op::Fun), Some(block)) => out.push(
                wrong(
                    bound,
                    "<FUN> cannot be in this block",
                    "write the function in the program, or in the body of a <$B> block",
                )
                .related(block.at, "this is the block"),
            ),
            (Some(Op::Fun), None) => {
                functions += 1;
                if functions > 1 {
                    out.push(wrong(
                        bound,
                        "this network begins two functions",
                        "give each function a network of its own to begin with",
                    ));
                }
            }
            _ => {}
        }
    }
}

fn wrong(bound: BlockAt<'_>, message: &str, help: &'static str) -> Diagnostic {
    Diagnostic::new(RULE, bound.head_range(), message).help(help)
}

/// A section of types in the definition of a block.
pub(crate) fn types_in_block(header: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, header, "types are not declared in a block")
        .help("move the section before FUNCTION_BLOCK: every block sees the types of the workspace")
}

/// A section of in-outs in a program (LANGUAGE §4).
pub(crate) fn in_outs_of_program(header: TextRange) -> Diagnostic {
    Diagnostic::new(RULE, header, "VAR_IN_OUT belongs in the body of a block")
        .help("a program has no caller that could hand it a tag: write VAR, or move the section into FUNCTION_BLOCK")
}

//! Operands by name: those of the row or block that are not given yet.

use super::item::{Completion, CompletionKind, Snippet, Topic};
use super::proposals::Proposals;
use crate::typing::{Operand, Typing};
use crate::wanted::Called;
use ladder_analysis::program::ParameterKind;
use ladder_instructions::{Direction, Presence};

/// After the operands that must be given by place; of a user-defined block also instead of them.
pub(super) fn propose(
    typing: &Typing<'_>,
    operand: &Operand,
    called: &[Called<'_>],
    out: &mut Proposals<'_>,
) {
    let index = operand.before.len();
    let given = |name: &str| operand.given.iter().any(|given| given.eq_ignore_ascii_case(name));
    for called in called {
        match called {
            Called::Row(row) if index >= row.required() => {
                let named = row.operands.iter().filter(|o| o.presence == Presence::Named);
                for formal in named.filter(|o| !given(o.name) && o.profiles.contain(typing.context.profile)) {
                    let arrow = if formal.direction == Direction::Out {
                        "=>"
                    } else {
                        ":="
                    };
                    add(typing, formal.name, arrow, formal.doc, out);
                }
            }
            Called::User(block) => {
                // After operands by place none is given by name.
                let by_name = index == 0 || !operand.given.is_empty();
                let free = block.parameters.iter().filter(|p| by_name && !given(&p.name));
                for parameter in free {
                    let arrow = if parameter.kind == ParameterKind::Output {
                        "=>"
                    } else {
                        ":="
                    };
                    let ty = parameter.ty.map(|ty| ty.to_string()).unwrap_or_default();
                    add(typing, &parameter.name, arrow, &ty, out);
                }
            }
            Called::Row(_) => {}
        }
    }
}

fn add(typing: &Typing<'_>, name: &str, arrow: &str, detail: &str, out: &mut Proposals<'_>) {
    let written = typing.rest(typing.word.end).trim_start();
    let has_arrow = written.starts_with(":=") || written.starts_with("=>");
    let text = if has_arrow {
        Snippet::plain_text(name)
    } else {
        Snippet::default().text(&format!("{name} {arrow} ")).stop("tag")
    };
    out.add_at(
        (3, 9),
        Completion {
            label: format!("{name} {arrow}"),
            detail: detail.to_owned(),
            kind: CompletionKind::Operand,
            range: typing.absolute(typing.word.clone()),
            filter: name.to_owned(),
            text,
            topic: Topic::Nothing,
        },
    );
}

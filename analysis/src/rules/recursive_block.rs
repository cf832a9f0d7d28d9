//! `recursive-block`: a user-defined block that uses itself, directly or through others.
//!
//! Each use has a state of its own, so such a block would need state without end.

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::network::Meaning;
use crate::rule::Rule;
use ladder_syntax::TextRange;

/// A block that is used, and where.
type Use = (usize, TextRange);

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.user_blocks.is_empty() {
        return;
    }
    let mut uses: Vec<Vec<Use>> = vec![Vec::new(); context.user_blocks.len()];
    for network in context.networks.iter().filter(|network| network.scope > 0) {
        for bound in &network.blocks {
            if let Meaning::User(used) = bound.meaning {
                uses[network.scope - 1].push((used, bound.head_range()));
            }
        }
    }
    for circle in circles(&uses) {
        out.push(recursive(context, &circle));
    }
}

/// The circles that a walk through all uses closes: each as the uses that lead around it, and the block that it
/// begins with.
fn circles(uses: &[Vec<Use>]) -> Vec<(usize, Vec<Use>)> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        Open,
        Done,
    }
    let mut marks = vec![Mark::New; uses.len()];
    let mut circles = Vec::new();
    for start in 0..uses.len() {
        if marks[start] != Mark::New {
            continue;
        }
        // A stack of its own: definitions may be nested as deeply as the file is long.
        let mut stack = vec![(start, 0)];
        marks[start] = Mark::Open;
        while let Some((block, next)) = stack.last_mut() {
            let Some(&(used, _)) = uses[*block].get(*next) else {
                marks[*block] = Mark::Done;
                stack.pop();
                continue;
            };
            *next += 1;
            match marks[used] {
                Mark::New => {
                    marks[used] = Mark::Open;
                    stack.push((used, 0));
                }
                Mark::Open => {
                    let from = stack.iter().position(|(block, _)| *block == used).unwrap_or(0);
                    let around = stack[from..]
                        .iter()
                        .map(|&(block, next)| uses[block][next - 1])
                        .collect();
                    circles.push((used, around));
                }
                Mark::Done => {}
            }
        }
    }
    circles
}

fn recursive(context: &Context, (first, around): &(usize, Vec<Use>)) -> Diagnostic {
    let name = |block: usize| context.user_blocks[block].name.as_str();
    let message = match around.as_slice() {
        [_] => format!("the block `{}` uses itself", name(*first)),
        _ => {
            let way: Vec<String> = around
                .iter()
                .map(|&(block, _)| format!("`{}`", name(block)))
                .collect();
            format!(
                "the block `{}` uses itself: it uses {}",
                name(*first),
                way.join(", which uses ")
            )
        }
    };
    let mut found = Diagnostic::new(Rule::RecursiveBlock, context.user_blocks[*first].at, message).help(
        "every place of a block has a state of its own, so a block cannot contain itself: break the circle",
    );
    for &(block, at) in around {
        found = found.related(at, format!("`{}` is used here", name(block)));
    }
    found
}

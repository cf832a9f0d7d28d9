//! Circles in what uses what: blocks that use themselves, functions that call themselves.

use ladder_syntax::TextRange;

/// What is used, and where.
pub(super) type Use = (usize, TextRange);

/// Once the circles that are reported have this many uses together, no more of them are reported. A file can hold as many circles as
/// it has uses, each as long as the file.
const MOST_USES: usize = 100_000;

/// At most this many names are listed on the way around a circle.
const MOST_NAMES: usize = 20;

/// The names of a way around, the first of them if there are many.
pub(super) fn way(names: impl ExactSizeIterator<Item = String>, between: &str) -> String {
    let more = names.len().saturating_sub(MOST_NAMES);
    let shown: Vec<String> = names.take(MOST_NAMES).collect();
    let shown = shown.join(between);
    match more {
        0 => shown,
        more => format!("{shown}{between}{more} more"),
    }
}

/// The circles that a walk through all uses closes: each as the uses that lead around it, and the block that it
/// begins with. Only those that go through one of the `own` first blocks: others are reported where they are.
pub(super) fn circles(uses: &[Vec<Use>], own: usize) -> Vec<(usize, Vec<Use>)> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        Open,
        Done,
    }
    let mut marks = vec![Mark::New; uses.len()];
    // Where on the stack an open one is.
    let mut depths = vec![0; uses.len()];
    let mut circles = Vec::new();
    let mut reported = 0;
    for start in 0..own {
        if marks[start] != Mark::New {
            continue;
        }
        // A stack of its own: definitions may be nested as deeply as the file is long.
        let mut stack = vec![(start, 0)];
        marks[start] = Mark::Open;
        depths[start] = 0;
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
                    depths[used] = stack.len();
                    stack.push((used, 0));
                }
                Mark::Open => {
                    if reported > MOST_USES {
                        continue;
                    }
                    let from = depths[used];
                    reported += stack.len() - from;
                    let mut around: Vec<Use> = stack[from..]
                        .iter()
                        .map(|&(block, next)| uses[block][next - 1])
                        .collect();
                    // Reported at a block of this file.
                    let Some(at) = around.iter().rposition(|&(block, _)| block < own) else {
                        continue;
                    };
                    around.rotate_left(at + 1);
                    let first = around.last().map_or(used, |&(block, _)| block);
                    circles.push((first, around));
                }
                Mark::Done => {}
            }
        }
    }
    circles
}

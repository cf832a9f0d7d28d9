//! Circles in what uses what: blocks that use themselves, functions that call themselves.

use ladder_syntax::TextRange;

/// What is used, and where.
pub(super) type Use = (usize, TextRange);

/// The circles that a walk through all uses closes: each as the uses that lead around it, and the block that it
/// begins with. Only those that go through one of the `own` first blocks: others are told where they stand.
pub(super) fn circles(uses: &[Vec<Use>], own: usize) -> Vec<(usize, Vec<Use>)> {
    #[derive(Clone, Copy, PartialEq)]
    enum Mark {
        New,
        Open,
        Done,
    }
    let mut marks = vec![Mark::New; uses.len()];
    let mut circles = Vec::new();
    for start in 0..own {
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
                    let mut around: Vec<Use> = stack[from..]
                        .iter()
                        .map(|&(block, next)| uses[block][next - 1])
                        .collect();
                    // Told at a block of this file.
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

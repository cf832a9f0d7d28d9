//! Which functions can come back to each other.

use super::flow::is;
use ladder_analysis::program::{Argument, Program};
use ladder_instructions::Op;

/// The cycles of calls: functions with the same number can reach each other.
#[derive(Debug, Default)]
pub(super) struct Cycles {
    group: Vec<u32>,
}

/// A function that has not been visited yet.
const NEW: u32 = u32::MAX;

impl Cycles {
    /// Tarjan's strongly connected components, with a stack of its own: calls may form long chains.
    pub(super) fn of(program: &Program) -> Cycles {
        let calls: Vec<Vec<usize>> = program
            .functions
            .iter()
            .map(|function| {
                let networks = &program.networks[function.networks.clone()];
                let blocks = networks.iter().flat_map(|network| &network.blocks);
                // `<FUN>` names its function too.
                let calls = blocks.filter(|block| is(&block.kind, Op::Call));
                let arguments = calls.flat_map(|block| &block.arguments);
                arguments
                    .filter_map(|bound| match bound.argument {
                        Argument::Function(function) => Some(function),
                        _ => None,
                    })
                    .collect()
            })
            .collect();
        let count = calls.len();
        let (mut number, mut low) = (vec![NEW; count], vec![0; count]);
        let (mut group, mut open) = (vec![NEW; count], Vec::new());
        let mut next = 0;
        let mut work: Vec<(usize, usize)> = Vec::new();
        for root in 0..count {
            if number[root] != NEW {
                continue;
            }
            work.push((root, 0));
            while let Some((node, edge)) = work.pop() {
                if edge == 0 {
                    (number[node], low[node]) = (next, next);
                    next += 1;
                    open.push(node);
                }
                match calls[node].get(edge) {
                    Some(&to) => {
                        work.push((node, edge + 1));
                        if number[to] == NEW {
                            work.push((to, 0));
                        } else if group[to] == NEW {
                            low[node] = low[node].min(number[to]);
                        }
                    }
                    None => {
                        if low[node] == number[node] {
                            while let Some(member) = open.pop() {
                                group[member] = node as u32;
                                if member == node {
                                    break;
                                }
                            }
                        }
                        if let Some(&(parent, _)) = work.last() {
                            low[parent] = low[parent].min(low[node]);
                        }
                    }
                }
            }
        }
        Cycles { group }
    }

    /// Whether each of two functions can reach the other, or they are one.
    pub(super) fn share_a_cycle(&self, a: usize, b: usize) -> bool {
        self.group[a] == self.group[b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn groups(calls: &[&[usize]]) -> Vec<u32> {
        use ladder_analysis::program::{Block, BlockKind, Bound, Function, Location, Network};
        let location = Location {
            file: 0,
            range: ladder_syntax::TextRange::default(),
        };
        let bound = |&function: &usize| Bound {
            operand: None,
            parameter: None,
            argument: Argument::Function(function),
            range: location.range,
        };
        let network = |calls: &[usize]| Network {
            location,
            steps: Vec::new(),
            blocks: vec![Block {
                kind: BlockKind::Instruction(ladder_instructions::by_op(ladder_instructions::Op::Call)),
                location,
                arguments: calls.iter().map(bound).collect(),
                works_in: None,
                unread: None,
            }],
            elements: Vec::new(),
        };
        let program = Program {
            networks: calls.iter().map(|calls| network(calls)).collect(),
            functions: (0..calls.len())
                .map(|n| Function {
                    every: None,
                    name: n.to_string(),
                    networks: n..n + 1,
                })
                .collect(),
            ..Program::default()
        };
        Cycles::of(&program).group
    }

    #[test]
    fn cycles_are_found() {
        assert_eq!(groups(&[&[1], &[2], &[]]), [0, 1, 2]);
        assert_eq!(groups(&[&[0]]), [0]);
        assert_eq!(groups(&[&[1, 3], &[2], &[1], &[0]]), [0, 1, 1, 0]);
        assert_eq!(groups(&[&[1], &[2], &[0, 3], &[3]]), [0, 0, 0, 3]);
    }
}

//! A network of the program model as wires between points.

use crate::model::RAIL;
use ladder_analysis::program::{BlockKind, Network, Step};
use ladder_instructions::Op;

/// A wire: the blocks on it, from a point to another.
#[derive(Debug)]
pub(super) struct Wiring {
    pub(super) from: usize,
    pub(super) to: Option<usize>,
    pub(super) blocks: Vec<usize>,
}

struct Edge {
    from: usize,
    to: usize,
    block: Option<usize>,
}

/// The wires of a network.
///
/// # Errors
///
/// If no power reaches a block, or a label is where a document cannot have it.
pub(super) fn of(network: &Network) -> Result<Vec<Wiring>, String> {
    let mut points: Vec<Option<usize>> = Vec::with_capacity(network.steps.len());
    let mut edges: Vec<Edge> = Vec::new();
    let mut is_marked = false;
    for (number, step) in network.steps.iter().enumerate() {
        let own = number + 1;
        points.push(match *step {
            Step::Start { rail } => rail.then_some(RAIL),
            Step::Block { block, en } => {
                let from = points[en].ok_or("no power reaches a block of it")?;
                let is_label =
                    matches!(network.blocks[block].kind, BlockKind::Instruction(row) if row.op == Op::Lbl);
                if is_label {
                    if from != RAIL || is_marked || !edges.is_empty() {
                        return Err("a label stands at the beginning of its network there".to_owned());
                    }
                    is_marked = true;
                    Some(RAIL)
                } else {
                    edges.push(Edge {
                        from,
                        to: own,
                        block: Some(block),
                    });
                    Some(own)
                }
            }
            Step::Join { upper, lower } => match (points[upper], points[lower]) {
                (Some(upper), Some(lower)) if upper != lower => {
                    edges.extend([upper, lower].map(|from| Edge {
                        from,
                        to: own,
                        block: None,
                    }));
                    Some(own)
                }
                (one, other) => one.or(other),
            },
        });
    }
    Ok(wires(&mut edges, network.steps.len() + 1))
}

/// Edges as wires, each as long as nothing joins it or parts from it.
fn wires(edges: &mut Vec<Edge>, count: usize) -> Vec<Wiring> {
    let mut into = vec![0usize; count];
    let mut out_of: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut leaves = vec![0usize; count];
    for edge in edges.iter() {
        leaves[edge.from] += 1;
    }
    // Where power only ends together, it ends: an edge ends at a point with a larger number.
    let mut goes_on = vec![true; edges.len()];
    for (at, edge) in edges.iter().enumerate().rev() {
        if edge.block.is_none() && leaves[edge.to] == 0 {
            leaves[edge.from] -= 1;
            goes_on[at] = false;
        }
    }
    let mut goes_on = goes_on.into_iter();
    edges.retain(|_| goes_on.next().unwrap_or_default());
    for (number, edge) in edges.iter().enumerate() {
        into[edge.to] += 1;
        out_of[edge.from].push(number);
    }
    let is_through = |point: usize| point != RAIL && into[point] == 1 && out_of[point].len() == 1;
    let mut wires = Vec::new();
    for edge in edges.iter() {
        if is_through(edge.from) {
            continue;
        }
        let mut wire = Wiring {
            from: edge.from,
            to: None,
            blocks: edge.block.into_iter().collect(),
        };
        let mut to = edge.to;
        while is_through(to) {
            let next = &edges[out_of[to][0]];
            wire.blocks.extend(next.block);
            to = next.to;
        }
        wire.to = (!out_of[to].is_empty()).then_some(to);
        wires.push(wire);
    }
    wires
}

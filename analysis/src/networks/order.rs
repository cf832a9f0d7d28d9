//! The order in which a network's elements are evaluated (LANGUAGE §6), as one function.
//!
//! `run(i, k)` of the language's definition is a frame on a stack here: networks may have any number of rungs.
//! The order depends on the wiring alone, never on columns.

use crate::program::{ElementKind, Step};
use ladder_syntax::wiring::{PartKind, Wiring};

/// A network's steps, and which part of which rung shows the power of which step.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Order {
    /// The steps in the order of evaluation. Blocks are numbered from left to right, top to bottom.
    pub steps: Vec<Step>,
    /// Parts that carry power: rung, part, step, what it is. In the order of evaluation.
    pub elements: Vec<(usize, usize, usize, ElementKind)>,
}

/// How far the evaluation of one rung has come.
#[derive(Clone, Default)]
struct Progress {
    part: usize,
    segment: Option<u32>,
    /// The step that gives the power here.
    power: usize,
    downs: usize,
    ups: usize,
}

/// One activation of `run`.
struct Frame {
    rung: usize,
    /// Up to, but not including, this `/` (from 0); none: to the end of the line.
    until: Option<usize>,
}

/// The order of evaluation of a network. Connectors without a partner are passed over.
pub fn order(wiring: &Wiring) -> Order {
    let rungs = &wiring.rungs;
    let mut order = Order::default();
    let mut progress = vec![Progress::default(); rungs.len()];
    // Numbers of a rung's first block, so that blocks count from left to right, top to bottom.
    let mut first_block = Vec::with_capacity(rungs.len());
    let mut blocks = 0;
    for rung in rungs {
        first_block.push(blocks);
        blocks += rung.connectors(PartKind::Block).count();
    }
    let mut next_block = first_block;
    let mut pairs = vec![0; rungs.len()];
    for point in &wiring.points {
        pairs[point.upper] += 1;
    }

    for start in 0..rungs.len() {
        let mut stack = vec![Frame {
            rung: start,
            until: None,
        }];
        while let Some(frame) = stack.last() {
            let (rung, until) = (frame.rung, frame.until);
            let at = &mut progress[rung];
            let Some(part) = rungs[rung].parts.get(at.part) else {
                stack.pop();
                join_if_waiting(&mut order, wiring, &mut progress, &stack, until);
                continue;
            };
            let Some(segment) = part.segment else {
                at.part += 1;
                continue;
            };
            if at.segment != Some(segment) {
                at.segment = Some(segment);
                at.power = order.steps.len();
                order.steps.push(Step::Start {
                    rail: rungs[rung].segments[segment as usize].powered,
                });
            }
            let (index, power) = (at.part, at.power);
            match part.kind {
                PartKind::Up => {
                    if until == Some(at.ups) {
                        stack.pop();
                        join_if_waiting(&mut order, wiring, &mut progress, &stack, until);
                        continue;
                    }
                    // One without a partner.
                    at.ups += 1;
                    order.elements.push((rung, index, power, ElementKind::Connector));
                }
                PartKind::Down => {
                    if at.downs < pairs[rung] {
                        stack.push(Frame {
                            rung: rung + 1,
                            until: Some(progress[rung].downs),
                        });
                        continue;
                    }
                    at.downs += 1;
                    order.elements.push((rung, index, power, ElementKind::Connector));
                }
                PartKind::Block => {
                    let step = order.steps.len();
                    order.steps.push(Step::Block {
                        block: next_block[rung],
                        en: power,
                    });
                    next_block[rung] += 1;
                    at.power = step;
                    order.elements.push((rung, index, step, ElementKind::Block));
                }
                PartKind::LeftRail | PartKind::RightRail | PartKind::StrayRail => {
                    order.elements.push((rung, index, power, ElementKind::Rail));
                }
                _ => order.elements.push((rung, index, power, ElementKind::Wire)),
            }
            progress[rung].part += 1;
        }
    }
    order
}

/// When a frame with a `/` to reach has ended, the frame below waits at the `\` of the pair: the point is made
/// and both lines go on with it.
fn join_if_waiting(
    order: &mut Order,
    wiring: &Wiring,
    progress: &mut [Progress],
    stack: &[Frame],
    until: Option<usize>,
) {
    let (Some(upper), Some(ordinal)) = (stack.last().map(|frame| frame.rung), until) else {
        return;
    };
    let lower = upper + 1;
    let step = order.steps.len();
    order.steps.push(Step::Join {
        upper: progress[upper].power,
        lower: progress[lower].power,
    });
    order
        .elements
        .push((upper, progress[upper].part, step, ElementKind::Connector));
    progress[upper].power = step;
    progress[upper].part += 1;
    progress[upper].downs = ordinal + 1;
    let below = &mut progress[lower];
    if wiring.rungs[lower]
        .parts
        .get(below.part)
        .is_some_and(|part| part.kind == PartKind::Up)
    {
        order
            .elements
            .push((lower, below.part, step, ElementKind::Connector));
        below.power = step;
        below.part += 1;
        below.ups = ordinal + 1;
    }
}

//! What is at an offset: the network, the rung, the part of its drawing, the block and the operand.

use ladder_analysis::context::Context;
use ladder_analysis::networks::BlockAt;
use ladder_analysis::written::facts::{Node, NodeKind};
use ladder_syntax::TextSize;
use ladder_syntax::wiring::RungPart;

/// A place on a rung.
#[derive(Clone, Copy)]
pub(crate) struct OnRung<'c> {
    /// The network, as in the context.
    pub(crate) network: usize,
    /// The rung in it.
    pub(crate) rung: usize,
    /// The part of the rung's drawing.
    pub(crate) part: usize,
    /// The part itself.
    pub(crate) drawn: &'c RungPart,
    /// The block, if the part is one.
    pub(crate) block: Option<BlockAt<'c>>,
}

/// The part of the drawing at an offset. Between two parts that touch the right one wins, unless it is wire:
/// with the cursor after a block's last parenthesis the block is meant.
pub(crate) fn on_rung(context: &Context, offset: TextSize) -> Option<OnRung<'_>> {
    let parse = &context.parse;
    let line = parse.line_at(offset)?;
    let network = context.networks.on_line(line)?;
    let below = line - network.first_line;
    let rung = network.wiring.line_offsets.binary_search(&below).ok()?;
    let within = offset - parse.line_start(line);
    let parts = &network.facts().wiring.rungs[rung].parts;
    let first = parts.partition_point(|part| part.range.end() < within);
    let candidates = parts[first..]
        .iter()
        .enumerate()
        .take_while(|(_, part)| part.range.start() <= within)
        .take(2);
    let (index, drawn) = candidates
        .map(|(n, part)| (first + n, part))
        .max_by_key(|(index, part)| (preference(part), *index))?;
    let block = network
        .blocks()
        .find(|block| block.facts.rung == rung && block.facts.part == index);
    Some(OnRung {
        network: network.index,
        rung,
        part: index,
        drawn,
        block,
    })
}

fn preference(part: &RungPart) -> u8 {
    use ladder_syntax::wiring::PartKind;
    match part.kind {
        PartKind::Block => 2,
        PartKind::Down | PartKind::Up => 1,
        _ => 0,
    }
}

/// The innermost node of an expression at an offset that counts from the start of the block's line.
pub(crate) fn node_at(node: &Node, offset: TextSize) -> Option<&Node> {
    if !node.range.contains_inclusive(offset) {
        return None;
    }
    let inner = match &node.kind {
        NodeKind::Index(base, index) => node_at(base, offset).or_else(|| node_at(index, offset)),
        NodeKind::Range(base, first, last) => node_at(base, offset)
            .or_else(|| node_at(first, offset))
            .or_else(|| node_at(last, offset)),
        // The member's word belongs to the whole: `t1.Q`.
        NodeKind::Member(base, word) if !word.range.contains_inclusive(offset) => node_at(base, offset),
        NodeKind::Unary(_, inner) | NodeKind::Paren(inner) => node_at(inner, offset),
        NodeKind::Binary(_, left, right) => node_at(left, offset).or_else(|| node_at(right, offset)),
        NodeKind::Call(_, values) | NodeKind::Array(values) | NodeKind::Repeat(_, values) => {
            values.iter().find_map(|value| node_at(value, offset))
        }
        _ => None,
    };
    Some(inner.unwrap_or(node))
}

//! How long a step is active is a sum of seconds and nanoseconds in the C that generators make. A sum that comes to a whole second is
//! kept as a second less and 1000000000 nanoseconds, so that it is smaller than that second until the scan after.

use super::networks::Part;
use ladder_analysis::values::literal::{Literal, literal};
use ladder_format::program::{Block, Drawing, Element, Expression, Item, Network, Path};
use ladder_instructions::Op;
use std::collections::HashSet;

const SECOND: i64 = 1_000_000_000;

/// Whether a time is whole seconds, as it is written.
pub(super) fn is_whole(time: &Expression) -> bool {
    let Expression::Literal(written) = time else {
        return false;
    };
    matches!(literal(written.as_str()), Ok(Literal::Time(time)) if time >= SECOND && time % SECOND == 0)
}

/// The comparison of a step's time with whole seconds that says the same of a time that is exact.
pub(super) const fn compared(op: Op) -> Op {
    match op {
        Op::Ge => Op::Gt,
        Op::Lt => Op::Le,
        other => other,
    }
}

/// Changes the comparisons in networks. `elapsed` are the tags of the steps' times in small letters.
pub(super) fn in_items(items: &mut [Item], elapsed: &HashSet<String>) {
    for item in items {
        if let Item::Network(Network {
            drawing: Drawing::Circuit(circuit),
            ..
        }) = item
        {
            in_circuit(circuit, elapsed);
        }
    }
}

/// The same on a rung.
pub(super) fn in_circuit(circuit: &mut Part, elapsed: &HashSet<String>) {
    circuit.for_each_mut(&mut |element| {
        if let Some(block) = element.as_block().and_then(|block| changed(block, elapsed)) {
            *element = Element::of(block, element.origin);
        }
    });
}

fn changed(block: &Block, elapsed: &HashSet<String>) -> Option<Block> {
    let [one, two] = block.operands() else { return None };
    let (one, two) = (one.value(), two.value());
    let is_elapsed = |value: &Expression| {
        let tag = value.path().and_then(Path::whole);
        tag.is_some_and(|tag| elapsed.contains(&tag.to_lowercase()))
    };
    let op = block.op()?;
    let other = if is_elapsed(one) && is_whole(two) {
        compared(op)
    } else if is_elapsed(two) && is_whole(one) {
        match op {
            Op::Le => Op::Lt,
            Op::Gt => Op::Ge,
            other => other,
        }
    } else {
        return None;
    };
    Block::of(other, [one.clone(), two.clone()]).ok()
}

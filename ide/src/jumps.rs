//! The jumps on a network: which name each block names.

use ladder_analysis::networks::NetworkAt;
use ladder_analysis::written::facts::NodeKind;
use ladder_instructions::Op;
use ladder_syntax::{Name, TextRange};

/// The labels that a network jumps to: as written, as compared, and where.
pub(crate) fn jumps(network: NetworkAt<'_>) -> impl Iterator<Item = (&str, Name, TextRange)> {
    named(network, Op::Jmp)
}

fn named(network: NetworkAt<'_>, op: Op) -> impl Iterator<Item = (&str, Name, TextRange)> {
    let blocks = network.blocks().filter(move |block| block.op() == Some(op));
    blocks.filter_map(|block| {
        let value = &block.bound().facts.operands.first()?.value;
        match &value.kind {
            NodeKind::Name(name) => Some((name.as_str(), Name::new(name), block.absolute(value.range))),
            _ => None,
        }
    })
}

//! What a block is given, by place and by name.

use ladder_analysis::program::{Argument, Block, Expr, Place};
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Presence;

/// Those given by place.
pub(crate) fn by_place(block: &Block) -> Vec<&Argument> {
    let is_named = |operand: Option<&'static ladder_instructions::Operand>| {
        operand.is_some_and(|operand| operand.presence == Presence::Named)
    };
    let given = block.arguments.iter().filter(|bound| !is_named(bound.operand));
    given.map(|bound| &bound.argument).collect()
}

/// The one given under a name.
pub(crate) fn named<'b>(block: &'b Block, name: &str) -> Option<&'b Argument> {
    let mut all = block.arguments.iter();
    let found = all.find(|bound| {
        bound
            .operand
            .is_some_and(|operand| operand.presence == Presence::Named && operand.name == name)
    });
    found.map(|bound| &bound.argument)
}

/// The values among them, from the n-th on.
pub(crate) fn values(block: &Block, from: usize) -> Option<Vec<&Expr>> {
    let values = by_place(block)
        .into_iter()
        .skip(from)
        .map(|argument| match argument {
            Argument::Value(value) => Some(value),
            _ => None,
        });
    values.collect()
}

/// The second operand, if this and all after it are values.
pub(crate) fn second(block: &Block) -> Option<&Expr> {
    values(block, 1)?.first().copied()
}

pub(crate) fn place(argument: Option<&Argument>) -> Option<(&Place, Scalar)> {
    match argument {
        Some(Argument::Place(place, ty)) => Some((place, *ty)),
        _ => None,
    }
}

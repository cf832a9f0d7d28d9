//! The blocks of networks that were read.

use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Expression, Item, Network, Operand, Part, RungPiece};
use ladder_syntax::Name;
use std::collections::HashMap;

/// What a network holds, if it is one rung of blocks without branches.
pub(crate) fn series(network: &Network) -> Option<Vec<&Block>> {
    let mut found = Vec::new();
    let is_series = match &network.drawing {
        Drawing::Circuit(circuit) => in_series(circuit, &mut found),
        Drawing::Rungs(rungs) => match &rungs[..] {
            [rung] => rung.iter().all(|piece| match piece {
                RungPiece::Rail => true,
                RungPiece::Element(element) => {
                    found.push(element);
                    true
                }
                _ => false,
            }),
            _ => false,
        },
    };
    let blocks = found.into_iter().map(Element::as_block);
    is_series.then(|| blocks.collect()).flatten()
}

/// Whether a circuit has no branches: then its elements are found, a series in another one as part of that.
fn in_series<'c>(circuit: &'c Circuit<Element>, found: &mut Vec<&'c Element>) -> bool {
    match circuit {
        Circuit::Element(element) => {
            found.push(element);
            true
        }
        Circuit::Series(parts) => parts.iter().all(|part| in_series(part, found)),
        Circuit::Parallel(_) => false,
    }
}

/// Calls something with each block on a rung, those in the definitions of blocks among them.
pub fn blocks<'i>(items: &'i [Item], found: &mut impl FnMut(&'i Block)) {
    for item in items {
        match item {
            Item::Block { items, .. } => blocks(items, found),
            Item::Network(network) => match &network.drawing {
                Drawing::Circuit(circuit) => in_circuit(circuit, found),
                Drawing::Rungs(rungs) => rungs.iter().flatten().for_each(|piece| {
                    if let RungPiece::Element(element) = piece {
                        element.as_block().into_iter().for_each(&mut *found);
                    }
                }),
            },
            _ => {}
        }
    }
}

fn in_circuit<'c>(circuit: &'c Circuit<Element>, found: &mut impl FnMut(&'c Block)) {
    match circuit {
        Circuit::Element(element) => element.as_block().into_iter().for_each(found),
        Circuit::Series(parts) | Circuit::Parallel(parts) => {
            for part in parts {
                in_circuit(part, found);
            }
        }
    }
}

/// Changes each block on a rung.
pub(crate) fn change(items: &mut [Item], with: &impl Fn(&mut Block)) {
    let change_one = |element: &mut Element| {
        if let Part::Block(block) = &mut element.part {
            with(block);
        }
    };
    for item in items {
        match item {
            Item::Block { items, .. } => change(items, with),
            Item::Network(network) => match &mut network.drawing {
                Drawing::Circuit(circuit) => circuit.for_each_mut(&mut |element| change_one(element)),
                Drawing::Rungs(rungs) => rungs.iter_mut().flatten().for_each(|piece| {
                    if let RungPiece::Element(element) = piece {
                        change_one(element);
                    }
                }),
            },
            _ => {}
        }
    }
}

/// Names other tags in a block.
pub(crate) fn rename(block: &mut Block, names: &HashMap<Name, String>) {
    block.change_paths(|path| {
        if let Some(name) = names.get(&Name::new(&path.root)) {
            path.root.clone_from(name);
        }
    });
}

/// A call of a block: `[$Rinse]( Rinse_state, go := go )`.
pub(crate) struct Call {
    /// With its `$`.
    pub(crate) block: Name,
    pub(crate) state: Option<String>,
    pub(crate) given: Vec<(String, Expression)>,
}

impl Call {
    pub(crate) fn of(block: &Block) -> Option<Call> {
        let name = block.user_name()?;
        let given = block.operands().iter().filter_map(|operand| match operand {
            Operand::Given(name, value) => Some((name.clone(), value.clone())),
            _ => None,
        });
        Some(Call {
            block: Name::new(&format!("${name}")),
            state: block.state().map(ToString::to_string),
            given: given.collect(),
        })
    }
}

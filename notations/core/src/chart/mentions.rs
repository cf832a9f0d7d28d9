//! Which tags networks name.

use super::networks::Part;
use ladder_format::Circuit;
use ladder_format::program::{Drawing, Element, Item, Network, RungPiece};
use std::collections::HashSet;

/// The tags that items name, each without members and indices, in small letters.
pub(super) fn of_items(items: &[Item], found: &mut HashSet<String>) {
    for item in items {
        let Item::Network(Network { drawing, .. }) = item else {
            continue;
        };
        match drawing {
            Drawing::Circuit(circuit) => of_circuit(circuit, found),
            Drawing::Rungs(rungs) => {
                for piece in rungs.iter().flatten() {
                    if let RungPiece::Element(element) = piece {
                        of_element(element, found);
                    }
                }
            }
        }
    }
}

/// The same of what is on a rung.
pub(super) fn of_circuit(circuit: &Part, found: &mut HashSet<String>) {
    match circuit {
        Circuit::Element(element) => of_element(element, found),
        Circuit::Series(parts) | Circuit::Parallel(parts) => {
            for part in parts {
                of_circuit(part, found);
            }
        }
    }
}

fn of_element(element: &Element, found: &mut HashSet<String>) {
    if let Some(block) = element.as_block() {
        block.paths(|path| {
            found.insert(path.root.to_lowercase());
        });
    }
}

//! The blocks of networks that were read.

use ladder_analysis::context::Body;
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Declaration, Drawing, Element, Expression, Item, Network, Operand, Origin, Part, RungPiece,
    Section, SectionKind,
};
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
    for network in networks(items) {
        elements(network, &mut |element| {
            element.as_block().into_iter().for_each(&mut *found);
        });
    }
}

/// The networks in the order of the text, those in the definitions of blocks among them.
pub(crate) fn networks(items: &[Item]) -> Vec<&Network> {
    let mut found = Vec::new();
    for item in items {
        match item {
            Item::Block { items, .. } => found.extend(networks(items)),
            Item::Network(network) => found.push(network),
            _ => {}
        }
    }
    found
}

/// Calls something with each element of a network.
pub(crate) fn elements<'n>(network: &'n Network, found: &mut impl FnMut(&'n Element)) {
    match &network.drawing {
        Drawing::Circuit(circuit) => in_circuit(circuit, found),
        Drawing::Rungs(rungs) => rungs.iter().flatten().for_each(|piece| {
            if let RungPiece::Element(element) = piece {
                found(element);
            }
        }),
    }
}

fn in_circuit<'c>(circuit: &'c Circuit<Element>, found: &mut impl FnMut(&'c Element)) {
    match circuit {
        Circuit::Element(element) => found(element),
        Circuit::Series(parts) | Circuit::Parallel(parts) => {
            for part in parts {
                in_circuit(part, found);
            }
        }
    }
}

/// Changes each block on a rung; it is handed in with the number of its network, in the order of the text.
pub(crate) fn change(items: &mut [Item], with: &mut impl FnMut(usize, &mut Block)) {
    fn go_on(items: &mut [Item], number: &mut usize, with: &mut impl FnMut(usize, &mut Block)) {
        for item in items {
            let network = match item {
                Item::Block { items, .. } => {
                    go_on(items, number, with);
                    continue;
                }
                Item::Network(network) => network,
                _ => continue,
            };
            let mut change_one = |element: &mut Element| {
                if let Part::Block(block) = &mut element.part {
                    with(*number, block);
                }
            };
            match &mut network.drawing {
                Drawing::Circuit(circuit) => circuit.for_each_mut(&mut change_one),
                Drawing::Rungs(rungs) => rungs.iter_mut().flatten().for_each(|piece| {
                    if let RungPiece::Element(element) = piece {
                        change_one(element);
                    }
                }),
            }
            *number += 1;
        }
    }
    go_on(items, &mut 0, with);
}

/// The blocks on rungs by their origins.
pub(crate) fn by_origin(items: &[Item]) -> HashMap<Origin, &Block> {
    let mut found = HashMap::new();
    for network in networks(items) {
        elements(network, &mut |element| {
            found.extend(element.origin.zip(element.as_block()));
        });
    }
    found
}

/// Blocks in series in the place of those with some origins, which go on to them.
pub(crate) type Replaced = HashMap<Origin, Vec<Block>>;

/// Puts other blocks into the place of some. In that of a block without any is wire.
pub(crate) fn replace(items: &mut [Item], by: &Replaced) {
    for item in items {
        match item {
            Item::Block { items, .. } => replace(items, by),
            Item::Network(Network {
                drawing: Drawing::Rungs(rungs),
                ..
            }) => {
                for rung in rungs {
                    let pieces = std::mem::take(rung).into_iter();
                    rung.extend(pieces.flat_map(|piece| {
                        match &piece {
                            RungPiece::Element(Element {
                                origin: Some(origin), ..
                            }) if by.contains_key(origin) => by[origin]
                                .iter()
                                .map(|block| RungPiece::Element(Element::of(block.clone(), Some(*origin))))
                                .collect(),
                            _ => vec![piece],
                        }
                    }));
                }
            }
            _ => {}
        }
    }
}

/// A network of one rung, from rail to rail.
pub(crate) fn rung(blocks: impl IntoIterator<Item = Block>, origin: Option<Origin>) -> Item {
    let elements = blocks
        .into_iter()
        .map(|block| Circuit::Element(Element::of(block, origin)));
    Item::Network(Network {
        comments: Vec::new(),
        drawing: Drawing::Circuit(Circuit::Series(elements.collect())),
    })
}

/// What a pass does around a network.
#[derive(Default)]
pub(crate) struct Around {
    /// Above it and its comments.
    pub(crate) above: Vec<Item>,
    pub(crate) below: Vec<Item>,
    /// The network itself goes.
    pub(crate) is_gone: bool,
}

/// Puts something around networks, which are numbered in the order of the text.
pub(crate) fn put_around(items: &mut Vec<Item>, by: &mut HashMap<usize, Around>) {
    fn put(items: &mut Vec<Item>, by: &mut HashMap<usize, Around>, number: &mut usize) {
        for mut item in std::mem::take(items) {
            if let Item::Block { items, .. } = &mut item {
                put(items, by, number);
            }
            if !matches!(item, Item::Network(_)) {
                items.push(item);
                continue;
            }
            let around = by.remove(number).unwrap_or_default();
            *number += 1;
            let comments = items.iter().rev().take_while(|item| is_comment(item)).count();
            let above = items.len() - comments;
            items.splice(above..above, around.above);
            items.extend((!around.is_gone).then_some(item));
            items.extend(around.below);
        }
    }
    put(items, by, &mut 0);
}

/// The comments in the wires of a network, on lines of their own.
pub(crate) fn comments(network: &Network) -> Vec<Item> {
    let mut found = Vec::new();
    elements(network, &mut |element| {
        if let Part::Comment(text) = &element.part {
            found.push(Item::Comment(text.clone()));
        }
    });
    found
}

/// Whether a line of ladder text is a comment.
pub(crate) fn is_comment(item: &Item) -> bool {
    matches!(item, Item::Kept(line, _) if line.starts_with('#'))
}

/// Tags that are declared where the networks of a body see them.
#[derive(Default)]
pub(crate) struct Declared(Vec<(Body, Section)>);

impl Declared {
    pub(crate) fn add(&mut self, body: Body, tags: impl IntoIterator<Item = Declaration>) {
        let at = self
            .0
            .iter()
            .rposition(|(other, _)| *other == body)
            .unwrap_or_else(|| {
                self.0.push((body, Section::new(SectionKind::Var)));
                self.0.len() - 1
            });
        self.0[at].1.declarations.extend(tags);
    }

    /// Puts them into a program: at the beginning of blocks, and at its end.
    pub(crate) fn put(self, items: &mut Vec<Item>) {
        for (body, section) in self.0 {
            let Body::Block(block) = body else {
                items.extend([Item::Blank, Item::Section(section)]);
                continue;
            };
            let mut blocks = items.iter_mut().filter_map(|item| match item {
                Item::Block { items, .. } => Some(items),
                _ => None,
            });
            if let Some(items) = blocks.nth(block) {
                items.insert(0, Item::Section(section));
            }
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

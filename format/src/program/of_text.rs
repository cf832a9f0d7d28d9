//! From a text to the sketch of it: the other way of [`ProgramSketch::write`].

use super::read::block_of;
use super::{Drawing, Element, Item, Network, Part, ProgramSketch, RungPiece};
use ladder_syntax::ast::{self, AstNode, NodeView};
use ladder_syntax::wiring::{self, PartKind, RungPart};
use ladder_syntax::{LineKind, Parse};

impl ProgramSketch {
    /// The sketch of a text without errors. Its origins are offsets in the text, in bytes. The networks come in the order of the
    /// text, and so do the blocks; sections, and comments that are in no wire, are [kept](Item::Kept) line by line: what is inside
    /// of a network is above it, and comments between operands are left out.
    pub fn of_text(parse: &Parse) -> ProgramSketch {
        let mut items = Vec::new();
        let mut outside = None;
        for item in &parse.structure().items {
            match *item {
                ladder_syntax::Item::Network(network) => self::network(parse, network, &mut items),
                ladder_syntax::Item::Section(section) => {
                    let lines = parse.structure().sections[section].lines.clone();
                    items.extend(lines.map(|line| kept(parse, line)));
                }
                ladder_syntax::Item::BlockHeader(block) => {
                    let line = parse.structure().blocks[block].lines.start;
                    let text = parse.lines()[line].text().trim();
                    // In the brackets that its calls have.
                    let header = text.find(['[', '(', '<']).map_or("", |at| &text[at..]);
                    outside = Some((header.to_owned(), std::mem::take(&mut items)));
                }
                ladder_syntax::Item::BlockEnd(_) => {
                    if let Some((header, before)) = outside.take() {
                        let inside = std::mem::replace(&mut items, before);
                        items.push(Item::Block {
                            header,
                            origin: None,
                            items: inside,
                        });
                    }
                }
                ladder_syntax::Item::Decoration(line) | ladder_syntax::Item::Stray(line) => {
                    items.push(kept(parse, line));
                }
            }
        }
        ProgramSketch { items }
    }
}

/// A line as it is, without the rails next to a comment. Rails without one are a blank line.
fn kept(parse: &Parse, line: usize) -> Item {
    let text = parse.lines()[line].text();
    let around: &[char] = match parse.lines()[line].kind {
        LineKind::Rail => &['\u{feff}', ' ', '\t', '|'],
        _ => &['\u{feff}', ' ', '\t'],
    };
    let own = text.trim_start_matches(around);
    let origin = u32::from(parse.line_start(line)) + (text.len() - own.len()) as u32;
    match own.trim_end().trim_end_matches(around) {
        "" => Item::Blank,
        own => Item::Kept(own.to_owned(), origin),
    }
}

/// A network, after the comments that are in it and in no wire.
fn network(parse: &Parse, number: usize, items: &mut Vec<Item>) {
    let network = &parse.structure().networks[number];
    let mut rungs = Vec::new();
    for line in network.lines.clone() {
        match parse.lines()[line].kind {
            LineKind::Rung => rungs.push(rung(parse, line, items)),
            LineKind::Comment => items.push(kept(parse, line)),
            _ => {}
        }
    }
    items.push(Item::Network(Network {
        comments: Vec::new(),
        drawing: Drawing::Rungs(rungs),
    }));
}

/// A wire that ends at nothing.
fn wire() -> RungPiece {
    RungPiece::Element(Element {
        part: Part::Text("--".to_owned()),
        origin: None,
    })
}

fn rung(parse: &Parse, line: usize, items: &mut Vec<Item>) -> Vec<RungPiece> {
    let (text, start) = (parse.lines()[line].text(), parse.line_start(line));
    let tree = parse.lines()[line].tree();
    let mut blocks = NodeView::root(&tree).children().filter_map(ast::Block::cast);
    let mut pieces = Vec::new();
    let mut before: Option<&RungPart> = None;
    let wiring::Rung { parts, segments } = wiring::rung(&tree);
    for (number, part) in parts.iter().enumerate() {
        let ends = part
            .segment
            .is_some_and(|segment| segments[segment as usize].parts.end == number + 1);
        let own = &text[part.range];
        let at = u32::from(start + part.range.start());
        let origin = Some(at);
        let piece = match part.kind {
            PartKind::LeftRail | PartKind::RightRail => Some(RungPiece::Rail),
            PartKind::Down => Some(RungPiece::Down),
            PartKind::Up => Some(RungPiece::Up),
            PartKind::Wire => ends.then(wire),
            PartKind::Block => {
                let part = match blocks.next().and_then(block_of) {
                    Some(Ok(block)) => Part::Block(block),
                    _ => Part::Text(own.to_owned()),
                };
                Some(RungPiece::Element(Element { part, origin }))
            }
            PartKind::Comment if part.segment.is_some() => {
                let comment = Element::comment(own.trim_matches('#').trim(), origin);
                Some(RungPiece::Element(comment))
            }
            PartKind::Comment => {
                items.push(Item::Kept(own.to_owned(), at));
                continue;
            }
            PartKind::Bar | PartKind::StrayBar | PartKind::StrayRail | PartKind::Junk => continue,
        };
        if before.is_none_or(|before| before.segment != part.segment) {
            pieces.extend(before.map(|_| RungPiece::Gap));
            // What begins without power is not taken for a rail, or for the operands of the block before it.
            if !matches!(part.kind, PartKind::LeftRail | PartKind::Down | PartKind::Up) {
                pieces.push(wire());
            }
        }
        before = Some(part);
        pieces.extend(piece);
    }
    pieces
}

//! What was written as jumps is a loop again: where two tags say so, and every network of the loop is as it was written.

use super::MARK;
use crate::elements::{blocks, change, series};
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Expression, Item, Network, Operand, Path, Section};
use ladder_instructions::Op;

/// Of more loops none is looked for: each is looked for in the whole text.
const MOST: usize = 50;

/// Makes loops of the jumps in some items, and in the blocks among them.
pub(crate) fn loops_again(items: &mut Vec<Item>) {
    for item in items.iter_mut() {
        if let Item::Block { items, .. } = item {
            loops_again(items);
        }
    }
    let sections = items.iter().filter_map(|item| match item {
        Item::Section(section) => Some(section),
        _ => None,
    });
    let marked = sections.flat_map(|section: &Section| &section.declarations);
    let marked = marked.filter(|declared| declared.comment.as_deref() == Some(MARK));
    let names: Vec<String> = marked
        .filter_map(|declared| match &declared.names[..] {
            [name] => Some(name.strip_suffix("_count")?.to_owned()),
            _ => None,
        })
        .collect();
    if names.len() > MOST {
        return;
    }
    for name in names {
        let parts = Parts::of(&name);
        if let Some(found) = Found::of(items, &parts) {
            found.restore(items, &parts);
        }
    }
}

/// What a loop is called, and the blocks that it is written with.
struct Parts {
    count: Path,
    turn: Path,
    label: String,
    end: String,
}

impl Parts {
    fn of(name: &str) -> Parts {
        Parts {
            count: Path::tag(format!("{name}_count")),
            turn: Path::tag(format!("{name}_turn")),
            label: name.to_owned(),
            end: format!("{name}_end"),
        }
    }

    /// How many turns there are, if a block puts that into the tag for it.
    fn counted<'b>(&self, block: &'b Block) -> Option<&'b Expression> {
        moved(block).and_then(|(to, from)| (to.path() == Some(&self.count)).then_some(from))
    }
}

/// What a `[MOV]` writes, and what it reads.
fn moved(block: &Block) -> Option<(&Expression, &Expression)> {
    match block.operands() {
        [Operand::Value(to), Operand::Value(from)] if block.op() == Some(Op::Mov) => Some((to, from)),
        _ => None,
    }
}

fn made<const N: usize>(op: Op, operands: [Expression; N]) -> Option<Block> {
    Block::of(op, operands).ok()
}

/// A loop among items: which of them are its networks.
struct Found {
    /// Those that are there for the jumps alone.
    gone: Vec<usize>,
    /// The network with the FOR, how many turns there are, and the tag that has their number.
    head: usize,
    count: Expression,
    turn: Option<Expression>,
    /// The first of the networks at its end.
    end: usize,
}

impl Found {
    /// The loop of a name. None: it is not as it was written.
    fn of(items: &[Item], parts: &Parts) -> Option<Found> {
        let own: Vec<(usize, &Network)> = items
            .iter()
            .enumerate()
            .filter_map(|(at, item)| match item {
                Item::Network(network) => Some((at, network)),
                _ => None,
            })
            .collect();
        let of = |block: &Block| {
            let is_it = |network: &Network| series(network).is_some_and(|own| own == [block]);
            own.iter().position(|(_, network)| is_it(network))
        };
        let [count, turn] = [&parts.count, &parts.turn].map(Expression::from);
        let no_count = made(Op::Mov, [count.clone(), 0.into()])?;
        let no_turn = made(Op::Mov, [turn.clone(), 0.into()])?;
        let start = of(&no_count)?;
        let end = of(&Block::jump(&parts.label))?;
        let mut starts = Followed {
            own: &own,
            at: start,
            gone: Vec::new(),
        };
        starts.takes(&[no_count, no_turn])?;
        // The network with the FOR is any.
        let head = starts.at;
        let mut heads = Vec::new();
        let (at, _) = *own.get(head)?;
        blocks(&items[at..=at], &mut |block| heads.extend(parts.counted(block)));
        let [turns] = heads[..] else { return None };
        let mut rest_of = Followed {
            own: &own,
            at: head + 1,
            gone: Vec::new(),
        };
        rest_of.takes(&[
            Block::label(&parts.label),
            made(Op::Ge, [turn.clone(), count])?,
            Block::jump(&parts.end),
        ])?;
        rest_of.takes(&[made(Op::Add, [turn.clone(), turn.clone(), 1.into()])?])?;
        let number = rest_of.takes_turn(&turn);
        let body = rest_of.at;
        let mut ends = Followed {
            own: &own,
            at: end,
            gone: Vec::new(),
        };
        ends.takes(&[Block::jump(&parts.label), Block::label(&parts.end)])?;
        if body > end {
            return None;
        }
        let gone = [starts.gone, rest_of.gone, ends.gone].concat();
        // Nothing else may know of it.
        let mut uses = 0;
        let jumps = [&parts.label, &parts.end].map(|label| Block::jump(label));
        blocks(items, &mut |block| {
            let mut is_use = jumps.contains(block);
            block.paths(|path| is_use |= [&parts.count.root, &parts.turn.root].contains(&&path.root));
            uses += usize::from(is_use);
        });
        let expected = 7 + usize::from(number.is_some());
        (uses == expected).then(|| Found {
            gone: gone.into_iter().map(|number| own[number].0).collect(),
            head: own[head].0,
            count: turns.clone(),
            turn: number,
            end: own[end].0,
        })
    }

    fn restore(self, items: &mut Vec<Item>, parts: &Parts) {
        let turn = self.turn.map(|turn| Operand::Taken("I".to_owned(), turn));
        let operands = std::iter::once(Operand::Value(self.count)).chain(turn);
        let (Ok(head), Ok(next)) = (Block::of(Op::For, operands), Block::of(Op::Next, Operand::NONE)) else {
            return;
        };
        change(&mut items[self.head..=self.head], &mut |_, block| {
            if parts.counted(block).is_some() {
                *block = head.clone();
            }
        });
        let mut out: Vec<Item> = Vec::new();
        for (at, item) in std::mem::take(items).into_iter().enumerate() {
            if at == self.end {
                let comments = match item {
                    Item::Network(network) => network.comments,
                    _ => Vec::new(),
                };
                let drawing = Drawing::Circuit(Circuit::Element(Element::of(next.clone(), None)));
                out.push(Item::Network(Network { comments, drawing }));
            } else if !self.gone.contains(&at) {
                out.push(item);
            } else if let Item::Network(network) = item {
                // A comment there stays.
                out.extend(network.comments.into_iter().map(Item::Comment));
            }
        }
        let tags = [&parts.count.root, &parts.turn.root];
        for item in &mut out {
            if let Item::Section(section) = item {
                section
                    .declarations
                    .retain(|declared| !declared.names.iter().any(|name| tags.contains(&name)));
            }
        }
        out.retain(|item| !matches!(item, Item::Section(section) if section.declarations.is_empty()));
        out.dedup_by(|next, item| (&*next, &*item) == (&Item::Blank, &Item::Blank));
        *items = out;
    }
}

/// Networks that follow each other.
struct Followed<'o> {
    own: &'o [(usize, &'o Network)],
    at: usize,
    gone: Vec<usize>,
}

impl Followed<'_> {
    /// Takes networks that hold these, each one or more of them and nothing else.
    fn takes(&mut self, expected: &[Block]) -> Option<()> {
        let mut waiting = expected;
        while !waiting.is_empty() {
            for block in series(self.own.get(self.at)?.1)? {
                let [first, more @ ..] = waiting else { return None };
                if block != first {
                    return None;
                }
                waiting = more;
            }
            self.gone.push(self.at);
            self.at += 1;
        }
        Some(())
    }

    /// Takes the network that hands on the number of the turn.
    fn takes_turn(&mut self, turn: &Expression) -> Option<Expression> {
        let found = series(self.own.get(self.at)?.1)?;
        let [only] = &found[..] else { return None };
        let (to, _) = moved(only).filter(|(_, from)| *from == turn)?;
        self.gone.push(self.at);
        self.at += 1;
        Some(to.clone())
    }
}

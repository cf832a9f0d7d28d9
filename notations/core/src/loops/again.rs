//! What was written as jumps is a loop again: where two tags say so, and every network of the loop is as it was written.

use super::MARK;
use crate::elements::{change, elements, series};
use ladder_format::Circuit;
use ladder_format::program::{Drawing, Element, Item, Network, Section};

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
        if let Some(found) = Found::of(items, &name) {
            found.restore(items, &name);
        }
    }
}

/// A loop among items: which of them are its networks.
struct Found {
    /// Those that are there for the jumps alone.
    gone: Vec<usize>,
    /// The network with the FOR, how many turns there are, and the tag that has their number.
    head: usize,
    count: String,
    turn: Option<String>,
    /// The first of the networks at its end.
    end: usize,
}

impl Found {
    /// The loop of a name. None: it is not as it was written.
    fn of(items: &[Item], name: &str) -> Option<Found> {
        let own: Vec<(usize, &Network)> = items
            .iter()
            .enumerate()
            .filter_map(|(at, item)| match item {
                Item::Network(network) => Some((at, network)),
                _ => None,
            })
            .collect();
        let of = |text: String| {
            let mut places = own.iter().enumerate();
            let is_it = |network: &Network| series(network).is_some_and(|own| own == [text.as_str()]);
            places
                .find(|(_, (_, network))| is_it(network))
                .map(|(number, _)| number)
        };
        let start = of(format!("[MOV]( {name}_count, 0 )"))?;
        let end = of(format!("<JMP>( {name} )"))?;
        let begins = format!("[MOV]( {name}_count, ");
        let mut starts = Followed {
            own: &own,
            at: start,
            gone: Vec::new(),
        };
        starts.takes(&[
            format!("[MOV]( {name}_count, 0 )"),
            format!("[MOV]( {name}_turn, 0 )"),
        ])?;
        // The network with the FOR is any.
        let head = starts.at;
        let mut heads = Vec::new();
        let (at, _) = *own.get(head)?;
        elements(&items[at..=at], &mut |text| {
            if let Some(count) = text.strip_prefix(&begins) {
                heads.push(count.trim_end_matches(')').trim().to_owned());
            }
        });
        let [count] = &heads[..] else { return None };
        let mut rest_of = Followed {
            own: &own,
            at: head + 1,
            gone: Vec::new(),
        };
        rest_of.takes(&[
            format!("<LBL>( {name} )"),
            format!("[GE]( {name}_turn, {name}_count )"),
            format!("<JMP>( {name}_end )"),
        ])?;
        rest_of.takes(&[format!("[ADD]( {name}_turn, {name}_turn, 1 )")])?;
        let turn = rest_of.takes_turn(&format!(", {name}_turn )"));
        let body = rest_of.at;
        let mut ends = Followed {
            own: &own,
            at: end,
            gone: Vec::new(),
        };
        ends.takes(&[format!("<JMP>( {name} )"), format!("<LBL>( {name}_end )")])?;
        if body > end {
            return None;
        }
        let gone = [starts.gone, rest_of.gone, ends.gone].concat();
        // Nothing else may know of it.
        let mut uses = 0;
        let tags = [format!("{name}_count"), format!("{name}_turn")];
        elements(items, &mut |text| {
            let is_jump =
                [format!("<JMP>( {name} )"), format!("<JMP>( {name}_end )")].contains(&text.to_owned());
            uses += usize::from(
                is_jump || crate::elements::words(text).any(|word| tags.iter().any(|tag| tag == word)),
            );
        });
        let expected = 7 + usize::from(turn.is_some());
        (uses == expected).then(|| Found {
            gone: gone.into_iter().map(|number| own[number].0).collect(),
            head: own[head].0,
            count: count.clone(),
            turn,
            end: own[end].0,
        })
    }

    fn restore(self, items: &mut Vec<Item>, name: &str) {
        let begins = format!("[MOV]( {name}_count, ");
        let head = match &self.turn {
            Some(turn) => format!("<FOR>( {}, I => {turn} )", self.count),
            None => format!("<FOR>( {} )", self.count),
        };
        change(&mut items[self.head..=self.head], &|text: &mut String| {
            if text.starts_with(&begins) {
                head.clone_into(text);
            }
        });
        let mut out: Vec<Item> = Vec::new();
        for (at, item) in std::mem::take(items).into_iter().enumerate() {
            if at == self.end {
                let comments = match item {
                    Item::Network(network) => network.comments,
                    _ => Vec::new(),
                };
                let drawing = Drawing::Circuit(Circuit::Element(Element::block("<NEXT>", None)));
                out.push(Item::Network(Network { comments, drawing }));
            } else if !self.gone.contains(&at) {
                out.push(item);
            } else if let Item::Network(network) = item {
                // What is said there stays.
                out.extend(network.comments.into_iter().map(Item::Comment));
            }
        }
        let tags = [format!("{name}_count"), format!("{name}_turn")];
        for item in &mut out {
            if let Item::Section(section) = item {
                section
                    .declarations
                    .retain(|declared| !declared.names.iter().any(|name| tags.contains(name)));
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
    fn takes(&mut self, expected: &[String]) -> Option<()> {
        let mut waiting = expected;
        while !waiting.is_empty() {
            for text in series(self.own.get(self.at)?.1)? {
                let [first, more @ ..] = waiting else { return None };
                if text != first.as_str() {
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
    fn takes_turn(&mut self, ends: &str) -> Option<String> {
        let found = series(self.own.get(self.at)?.1)?;
        let [only] = &found[..] else { return None };
        let turn = only.strip_prefix("[MOV]( ")?.strip_suffix(ends)?.to_owned();
        self.gone.push(self.at);
        self.at += 1;
        Some(turn)
    }
}

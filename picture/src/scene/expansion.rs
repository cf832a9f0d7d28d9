//! How much is drawn in all: with a few `use` elements that refer to each other a small file draws more than any page can.

use super::allow::{local, urls};
use super::{Node, NodeKind};
use std::collections::HashMap;

/// No more elements than this are drawn, those included that are drawn again.
pub(super) const MOST_DRAWN: u64 = 200_000;

/// References lead to what has references itself, but not further than this.
const MOST_STEPS: usize = 16;

struct Count<'n> {
    nodes: &'n [Node],
    children: Vec<Vec<usize>>,
    ids: HashMap<&'n str, usize>,
    /// What is known; none while it is counted.
    known: HashMap<usize, Option<u64>>,
}

/// Whether a drawing is too large, or never ends.
pub(super) fn is_too_large(nodes: &[Node]) -> bool {
    let mut children = vec![Vec::new(); nodes.len()];
    let mut ids = HashMap::new();
    for (at, node) in nodes.iter().enumerate() {
        if let Some(parent) = node.parent {
            children[parent].push(at);
        }
        if let Some(id) = node.attribute("id") {
            ids.entry(id).or_insert(at);
        }
    }
    let mut count = Count {
        nodes,
        children,
        ids,
        known: HashMap::new(),
    };
    !nodes.is_empty() && count.of(0, 0).is_none_or(|drawn| drawn > MOST_DRAWN)
}

impl Count<'_> {
    /// How many elements are drawn for one. None: it has no end.
    fn of(&mut self, at: usize, steps: usize) -> Option<u64> {
        if steps > MOST_STEPS {
            return None;
        }
        if let Some(known) = self.known.get(&at) {
            return *known;
        }
        self.known.insert(at, None);
        let mut drawn: u64 = 1;
        for child in std::mem::take(&mut self.children[at]) {
            drawn = drawn.saturating_add(self.of(child, steps)?);
        }
        if let NodeKind::Element { attributes, .. } = &self.nodes[at].kind {
            let points = self.nodes[at]
                .attribute("d")
                .or(self.nodes[at].attribute("points"));
            let points = points.map_or(0, |points| points.len() as u64 / 2);
            for (name, value) in attributes {
                let times = if name.starts_with("marker") { points + 1 } else { 1 };
                let to: Vec<&str> = match *name {
                    "href" => local(value).into_iter().collect(),
                    _ => urls(value).collect(),
                };
                for to in to {
                    if let Some(target) = self.ids.get(to).copied() {
                        drawn = drawn.saturating_add(self.of(target, steps + 1)?.saturating_mul(times));
                    }
                }
            }
        }
        self.known.insert(at, Some(drawn));
        Some(drawn)
    }
}

//! Which networks depend on each other in a circle, by way of the tags that one writes and the other reads, in
//! one scan or over several.

use super::at_tags::TagKey;
use crate::context::Context;
use crate::scope::{TagFacts, UseRef};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// What networks depend on, kept from one text to the next.
#[derive(Debug)]
pub(super) struct Dependencies {
    /// The tags by way of which networks depend on others.
    links: FxHashMap<TagKey, Box<[Link]>>,
    /// For the number of each network the circle to which it belongs: itself, if it is in none.
    circle_of: Vec<usize>,
}

/// How a network uses a tag.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Link {
    /// Its number.
    network: u32,
    reads: bool,
    writes: bool,
}

impl Dependencies {
    pub(super) fn new(context: &Context) -> Dependencies {
        let scopes = context.scopes.iter().enumerate();
        let tags = scopes.flat_map(|(number, scope)| scope.tags.iter().map(move |tag| (number, tag)));
        let tags = tags.filter(|(_, tag)| !tag.leads_elsewhere());
        let links = tags.filter_map(|(scope, tag)| Some(((scope, Name::new(&tag.name)), links_of(tag)?)));
        let mut all = Dependencies {
            links: links.collect(),
            circle_of: Vec::new(),
        };
        all.find_circles(context);
        all
    }

    /// Looks at these tags again, which may be gone. Gives whether other networks depend on each other than before.
    pub(super) fn follow(&mut self, context: &Context, tags: impl Iterator<Item = TagKey>) -> bool {
        let mut is_other = false;
        for key in tags {
            let tag = context.find_tag(&key).filter(|tag| !tag.leads_elsewhere());
            let links = tag.and_then(links_of);
            if self.links.get(&key) == links.as_ref() {
                continue;
            }
            is_other = true;
            match links {
                Some(links) => self.links.insert(key, links),
                None => self.links.remove(&key),
            };
        }
        if is_other {
            self.find_circles(context);
        }
        is_other
    }

    /// Whether two networks, by their numbers, depend on each other.
    pub(super) fn are_in_a_circle(&self, one: u32, other: u32) -> bool {
        let circle = self.circle_of.get(one as usize);
        circle.is_some() && circle == self.circle_of.get(other as usize)
    }

    fn find_circles(&mut self, context: &Context) {
        // Networks first, then tags.
        let networks = context.networks.numbers();
        let mut edges: Vec<Vec<usize>> = vec![Vec::new(); networks];
        for links in self.links.values() {
            let node = edges.len();
            for link in links.iter().filter(|link| link.writes) {
                edges[link.network as usize].push(node);
            }
            let readers = links.iter().filter(|link| link.reads);
            edges.push(readers.map(|link| link.network as usize).collect());
        }
        self.circle_of = components(&edges);
        self.circle_of.truncate(networks);
    }
}

/// How each network uses a tag, from top to bottom; none if no network depends on another by way of it.
fn links_of(tag: &TagFacts) -> Option<Box<[Link]>> {
    let uses = &tag.uses.0;
    let first = uses.first()?;
    let has = |wanted: fn(&UseRef) -> bool| uses.iter().any(wanted);
    if !has(|place| place.access().reads())
        || !has(|place| place.access().writes())
        || uses.iter().all(|place| place.network == first.network)
    {
        return None;
    }
    let mut links: Vec<Link> = Vec::with_capacity(uses.len());
    for place in uses {
        let (reads, writes) = (place.access().reads(), place.access().writes());
        match links.last_mut().filter(|last| last.network == place.network) {
            Some(last) => {
                last.reads |= reads;
                last.writes |= writes;
            }
            None => links.push(Link {
                network: place.network,
                reads,
                writes,
            }),
        }
    }
    Some(links.into())
}

/// For each node the number of its strongly connected component (Tarjan, with a stack of its own).
fn components(edges: &[Vec<usize>]) -> Vec<usize> {
    const NEW: usize = usize::MAX;
    let mut index = vec![NEW; edges.len()];
    let mut low = vec![0; edges.len()];
    let mut component = vec![NEW; edges.len()];
    let mut open = Vec::new();
    let (mut counter, mut components) = (0, 0);
    for start in 0..edges.len() {
        if index[start] != NEW {
            continue;
        }
        let mut stack = vec![(start, 0)];
        while let Some(&mut (node, ref mut next)) = stack.last_mut() {
            if *next == 0 && index[node] == NEW {
                (index[node], low[node]) = (counter, counter);
                counter += 1;
                open.push(node);
            }
            if let Some(&to) = edges[node].get(*next) {
                *next += 1;
                if index[to] == NEW {
                    stack.push((to, 0));
                } else if component[to] == NEW {
                    low[node] = low[node].min(index[to]);
                }
                continue;
            }
            if low[node] == index[node] {
                while let Some(member) = open.pop() {
                    component[member] = components;
                    if member == node {
                        break;
                    }
                }
                components += 1;
            }
            stack.pop();
            if let Some(&(above, _)) = stack.last() {
                low[above] = low[above].min(low[node]);
            }
        }
    }
    component
}

#[cfg(test)]
mod tests {
    use super::components;

    #[test]
    fn circles_are_components() {
        let numbers = components(&[vec![1], vec![2], vec![0, 3], vec![4], vec![]]);
        assert_eq!(numbers[0], numbers[1]);
        assert_eq!(numbers[1], numbers[2]);
        assert_ne!(numbers[2], numbers[3]);
        assert_ne!(numbers[3], numbers[4]);
    }
}

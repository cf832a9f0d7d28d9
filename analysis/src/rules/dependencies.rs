//! Which networks depend on each other in a circle, by way of the tags that one writes and the other reads, in
//! one scan or over several.

use super::parts::{Parts, Touched};
use crate::names::context::Context;
use crate::names::scope::TagFacts;

/// For each network the circle to which it belongs; two that are in none have different ones.
pub(super) struct Circles(Vec<usize>);

impl Circles {
    pub(super) fn of(context: &Context) -> Circles {
        // Networks first, then tags.
        let networks = context.networks.len();
        let mut edges: Vec<Vec<usize>> = vec![Vec::new(); networks];
        let tags = context.scopes.iter().flat_map(|scope| &scope.tags);
        for tag in tags.filter(|tag| !tag.is_alias() && links_networks(tag)) {
            let parts = Parts::of(context, tag, &Touched::of(context, tag));
            for group in parts.groups() {
                let node = edges.len();
                let mut readers = Vec::new();
                for place in group {
                    if place.access().writes() {
                        edges[place.network as usize].push(node);
                    }
                    if place.access().reads() {
                        readers.push(place.network as usize);
                    }
                }
                edges.push(readers);
            }
        }
        let mut circles = components(&edges);
        circles.truncate(networks);
        Circles(circles)
    }

    /// Whether two networks depend on each other.
    pub(super) fn hold_both(&self, one: usize, other: usize) -> bool {
        self.0[one] == self.0[other]
    }
}

/// Whether a network depends on another by way of a tag.
fn links_networks(tag: &TagFacts) -> bool {
    let uses = &tag.uses.0;
    uses.iter().any(|place| place.access().reads())
        && uses.iter().any(|place| place.access().writes())
        && uses.iter().any(|place| place.network != uses[0].network)
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

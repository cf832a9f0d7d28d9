//! `read-before-write`: a rung reads what a rung below it writes, and so sees the value of the scan before,
//! although the two could be in the other order.

use super::survey::Survey;
use crate::context::{Body, Context};
use crate::control_flow::ControlFlow;
use crate::diagnostic::Diagnostic;
use crate::operand_value::{each_tag, tag};
use crate::program::Role;
use crate::rule::Rule;
use crate::scope::{Access, Origin, SectionKind, TagFacts, Use, UseRef};
use crate::uses::access;
use rustc_hash::FxHashSet;

/// Looks at the tags that are [read above](is_read_above) where they are written.
pub(crate) fn check<'c>(
    context: &'c Context,
    survey: &Survey<'_>,
    read_above: impl Iterator<Item = &'c TagFacts>,
    out: &mut Vec<Diagnostic>,
) {
    if !survey.whole {
        return;
    }
    let mut late: Vec<Late<'_>> = read_above.filter_map(|tag| Late::of(context, tag)).collect();
    if late.is_empty() {
        return;
    }
    let jumping = bodies_that_jump(context, survey);
    late.retain(|late| !jumping.contains(&context.bodies[late.write.network]));
    if late.is_empty() {
        return;
    }
    let circles = Circles::new(context);
    for late in late {
        // Somebody has to read the old value where each rung depends on the other.
        if circles.together(late.read.network, late.write.network) || compares_old_and_new(context, &late) {
            continue;
        }
        out.push(found(context, &late));
    }
}

/// A tag that is read above the first rung that writes it.
struct Late<'c> {
    tag: &'c TagFacts,
    read: Use,
    write: Use,
}

/// Whether a tag is read above the first rung that writes it, all of it in one body.
pub(crate) fn is_read_above(context: &Context, tag: &TagFacts) -> bool {
    Late::of(context, tag).is_some()
}

/// The bodies in which the straight way down is not the only one.
fn bodies_that_jump(context: &Context, survey: &Survey<'_>) -> FxHashSet<Body> {
    let unclear = ControlFlow::LEAVES.with(ControlFlow::FOR);
    if !survey.any.has(unclear) {
        return FxHashSet::default();
    }
    let networks = 0..context.networks.len();
    let jumping = networks.filter(|&network| survey.control_flow(network).has(unclear));
    jumping.map(|network| context.bodies[network]).collect()
}

impl<'c> Late<'c> {
    fn of(context: &Context, tag: &'c TagFacts) -> Option<Late<'c>> {
        // A function or block of another file may write what is shared.
        let shared = matches!(
            tag.origin,
            Origin::Shared
                | Origin::Declared(SectionKind::Global | SectionKind::External | SectionKind::InOut)
        );
        if shared || tag.role == Role::Input || tag.retain || tag.constant || !tag.rare.initial.is_empty() {
            return None;
        }
        // What is done by another name of its address may come first.
        if context.others_at_address(tag).next().is_some() {
            return None;
        }
        let network = |place: &UseRef| context.networks.index_of(place.network);
        let write = tag.uses.writers().min_by_key(network)?;
        let above = network(&write);
        let mut reads = tag.uses.0.iter().filter(|place| place.access().reads());
        let read = *reads.find(|place| network(place) < above)?;
        let (read, write) = (context.networks.use_of(read), context.networks.use_of(write));
        let body = context.bodies[write.network];
        let clear = |place: Use| context.bodies[place.network] == body && !place.indexed;
        context.uses(tag).all(clear).then_some(Late { tag, read, write })
    }
}

/// Whether the reading rung also reads what the value is made of: it compares old and new on purpose.
fn compares_old_and_new(context: &Context, late: &Late<'_>) -> bool {
    let own = tag(
        context,
        context.networks.at(late.read.network).scope,
        &late.tag.name,
    )
    .map(|(id, _)| id);
    let read_by_writer = tags_read(context, late.write.network);
    let read = tags_read(context, late.read.network);
    read.iter()
        .any(|tag| Some(*tag) != own && read_by_writer.contains(tag))
}

fn tags_read(context: &Context, network: usize) -> FxHashSet<(usize, usize)> {
    let network = context.networks.at(network);
    let mut found = FxHashSet::default();
    for bound in network.blocks() {
        for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
            if access(&bound, *formal, &context.user_blocks).is_some_and(Access::reads) {
                each_tag(&operand.value, &mut |name| {
                    found.extend(tag(context, network.scope, name).map(|(id, _)| id));
                });
            }
        }
    }
    found
}

fn found(context: &Context, late: &Late<'_>) -> Diagnostic {
    let name = &late.tag.name;
    let line = |place: &Use| context.line_number(place.range.start());
    let (reads, writes) = (line(&late.read), line(&late.write));
    Diagnostic::new(
        Rule::ReadBeforeWrite,
        late.read.range,
        format!(
            "`{name}` is written further down, on line {writes}: this rung sees its value of the scan before"
        ),
    )
    .help(format!(
        "move the rung that writes `{name}` above line {reads}, so that it acts in the same scan"
    ))
    .related(late.write.range, format!("`{name}` is written here"))
}

/// Which networks depend on each other in a circle, by way of the tags that one writes and the other reads, in
/// one scan or over several.
struct Circles {
    of_network: Vec<usize>,
}

impl Circles {
    fn new(context: &Context) -> Circles {
        // Networks first, then tags.
        let networks = context.networks.len();
        let mut edges: Vec<Vec<usize>> = vec![Vec::new(); networks];
        for tag in context.own_tags() {
            let node = edges.len();
            let mut readers = Vec::new();
            for place in context.uses(tag) {
                if place.access.writes() && edges[place.network].last() != Some(&node) {
                    edges[place.network].push(node);
                }
                if place.access.reads() && readers.last() != Some(&place.network) {
                    readers.push(place.network);
                }
            }
            edges.push(readers);
        }
        let mut of_network = components(&edges);
        of_network.truncate(networks);
        Circles { of_network }
    }

    fn together(&self, a: usize, b: usize) -> bool {
        self.of_network[a] == self.of_network[b]
    }
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

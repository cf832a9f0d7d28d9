//! `recursive-block`: a user-defined block that uses itself, directly or through others.
//!
//! Each use has a state of its own, so such a block would need state without end.

use super::circles::{Use, circles, way};
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::names::context::{Body, Context};
use crate::networks::network::Meaning;
use crate::other_files::exports::{ExportedBlock, Exports};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::sync::Arc;

pub(crate) const RULE: Rule = Rule(&RuleFacts::new(
    RuleGroup::Names,
    "recursive-block",
    Severity::Error,
));

pub(crate) fn check(context: &Context, out: &mut Vec<Diagnostic>) {
    if context.own_blocks == 0 {
        return;
    }
    let graph = Graph::of(context);
    for circle in circles(&graph.uses, context.own_blocks) {
        out.push(recursive(context, &graph, circle));
    }
}

/// Which block uses which: the file's own first, then those of other files that they lead to.
struct Graph {
    uses: Vec<Vec<Use>>,
    /// The name, and for a block of another file that file.
    nodes: Vec<(String, Option<Arc<str>>)>,
}

impl Graph {
    fn of(context: &Context) -> Graph {
        let own = &context.user_blocks[..context.own_blocks];
        let mut graph = Graph {
            uses: vec![Vec::new(); own.len()],
            nodes: own.iter().map(|block| (block.name.clone(), None)).collect(),
        };
        let mut foreign: FxHashMap<(Arc<str>, usize), usize> = FxHashMap::default();
        let mut open: Vec<(usize, Arc<str>, &ExportedBlock)> = Vec::new();
        for (network, body) in context.bodies.iter().enumerate() {
            let Body::Block(user) = *body else { continue };
            for bound in context.networks.at(network).blocks() {
                let Meaning::User(used) = bound.meaning else {
                    continue;
                };
                let used = match &context.user_blocks[used].import {
                    None => used,
                    Some(_) => {
                        let key = &context.user_blocks[used].key;
                        let Some((file, block)) = context.others.blocks(key).next() else {
                            continue;
                        };
                        graph.enter(&mut foreign, &mut open, file, block)
                    }
                };
                graph.uses[user].push((used, bound.head_range()));
            }
        }
        for user in 0..own.len() {
            for (name, at) in context.scopes[user + 1].block_states() {
                let here = Arc::clone(&context.name);
                let used = graph.used_by(context, &mut foreign, &mut open, &here, &name);
                graph.uses[user].extend(used.map(|used| (used, at)));
            }
        }
        while let Some((node, file, block)) = open.pop() {
            for (name, at) in &block.uses {
                let used = graph.used_by(context, &mut foreign, &mut open, &file, name);
                graph.uses[node].extend(used.map(|used| (used, *at)));
            }
        }
        graph
    }

    /// The block that a name in another file means: one of that file, else one of the rest of the workspace, to
    /// which this file belongs too.
    fn used_by<'c>(
        &mut self,
        context: &'c Context,
        foreign: &mut FxHashMap<(Arc<str>, usize), usize>,
        open: &mut Vec<(usize, Arc<str>, &'c ExportedBlock)>,
        file: &Arc<str>,
        name: &Name,
    ) -> Option<usize> {
        let mut there = context.others.blocks(name);
        if let Some((found, block)) = there.find(|(other, _)| other.file == *file) {
            return Some(self.enter(foreign, open, found, block));
        }
        let own = &context.user_blocks[..context.own_blocks];
        if let Some(own) = own.iter().position(|block| block.key == *name) {
            return Some(own);
        }
        let (found, block) = context.others.blocks(name).next()?;
        Some(self.enter(foreign, open, found, block))
    }

    fn enter<'c>(
        &mut self,
        foreign: &mut FxHashMap<(Arc<str>, usize), usize>,
        open: &mut Vec<(usize, Arc<str>, &'c ExportedBlock)>,
        file: &Exports,
        block: &'c ExportedBlock,
    ) -> usize {
        let key = (Arc::clone(&file.file), block.item);
        *foreign.entry(key).or_insert_with(|| {
            let node = self.uses.len();
            self.uses.push(Vec::new());
            self.nodes
                .push((block.facts.name.clone(), Some(Arc::clone(&file.file))));
            open.push((node, Arc::clone(&file.file), block));
            node
        })
    }
}

fn recursive(context: &Context, graph: &Graph, (first, around): (usize, Vec<Use>)) -> Diagnostic {
    let name = |block: usize| graph.nodes[block].0.as_str();
    let message = match around.as_slice() {
        [_] => format!("the block `{}` uses itself", name(first)),
        _ => {
            let names = around.iter().map(|&(block, _)| format!("`{}`", name(block)));
            format!(
                "the block `{}` uses itself: it uses {}",
                name(first),
                way(names, ", which uses ")
            )
        }
    };
    let mut found = Diagnostic::new(RULE, context.user_blocks[first].at, message).help(
        "every place of a block has a state of its own, so a block cannot contain itself: break the circle",
    );
    // Each use is in the block that the use before it leads to.
    let mut user = first;
    for &(block, at) in &around {
        let file = graph.nodes[user].1.as_ref();
        found = found.related_at(file, at, format!("`{}` is used here", name(block)));
        user = block;
    }
    found
}

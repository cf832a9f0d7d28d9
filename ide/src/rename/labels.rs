//! Labels that must go by one name: a jump in a `<$B>` block to a label that the block does not have goes to the
//! label of that name wherever the block is (LANGUAGE §5.7).

use crate::neighbour::{Which, Workspace, in_each};
use crate::symbol::{Symbol, Usage, occurrences};
use ladder_analysis::context::{Body, Context};
use ladder_analysis::networks::network::Meaning;
use ladder_instructions::Shape;
use ladder_syntax::Name;
use std::sync::Arc;

/// A body of a file.
type FileBody = (Arc<str>, Body);

/// A symbol with all others that must keep its name; they are more than one for labels only.
pub(super) fn of_one_name(own: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Vec<Symbol> {
    let Symbol::Label { file, body, name } = symbol else {
        return vec![symbol.clone()];
    };
    let search = Search { own, name, workspace };
    let mut found: Vec<FileBody> = vec![(Arc::clone(file), *body)];
    let mut next = 0;
    while let Some(place) = found.get(next).cloned() {
        next += 1;
        for linked in search.linked(&place) {
            if !found.contains(&linked) {
                found.push(linked);
            }
        }
    }
    let label = |(file, body)| Symbol::Label {
        file,
        body,
        name: name.clone(),
    };
    found.into_iter().map(label).collect()
}

struct Search<'s> {
    own: &'s Context,
    name: &'s Name,
    workspace: &'s dyn Workspace,
}

impl Search<'_> {
    /// The bodies that share the label with one, directly.
    fn linked(&self, (file, body): &FileBody) -> Vec<FileBody> {
        let mut linked = Vec::new();
        // The blocks that are in it and jump out.
        self.with(file, &mut |file| {
            for block in blocks_in(file, *body) {
                if self.passes(&block, 0) {
                    linked.push(block);
                }
            }
        });
        // The places where it is itself.
        let Body::Block(item) = *body else { return linked };
        if !self.passes(&(Arc::clone(file), *body), 0) {
            return linked;
        }
        let mut key = None;
        self.with(file, &mut |file| {
            key = file.user_blocks.get(item).map(|block| block.key.clone());
        });
        let Some(key) = key else { return linked };
        let wanted = (Arc::clone(file), *body);
        let holding = |file: &Context| {
            let mut bodies = bodies(file);
            bodies.retain(|body| blocks_in(file, *body).contains(&wanted));
            let of_file = |body| (Arc::clone(&file.name), body);
            bodies.into_iter().map(of_file).collect::<Vec<FileBody>>()
        };
        linked.extend(holding(self.own));
        let which = Which::Mentioning(std::slice::from_ref(&key));
        let others = in_each(self.workspace, which, holding);
        linked.extend(others.into_iter().flatten());
        linked
    }

    /// Whether jumps to the label leave a block: it has none, and it, or a block in it, jumps there. `depth`
    /// bounds the walk through blocks that hold themselves, which is an error.
    fn passes(&self, (file, body): &FileBody, depth: usize) -> bool {
        let label = Symbol::Label {
            file: Arc::clone(file),
            body: *body,
            name: self.name.clone(),
        };
        let mut passes = false;
        self.with(file, &mut |file| {
            let places = occurrences(file, &label);
            if places.iter().any(|place| place.usage == Usage::Definition) {
                return;
            }
            passes = !places.is_empty()
                || (depth < 16
                    && blocks_in(file, *body)
                        .iter()
                        .any(|inner| self.passes(inner, depth + 1)));
        });
        passes
    }

    fn with(&self, name: &str, act: &mut dyn FnMut(&Context)) {
        if self.own.is_called(name) {
            act(self.own);
        } else if let Some(neighbour) = self.workspace.file(name) {
            act(&neighbour);
        }
    }
}

/// The `<$B>` blocks that are in a body.
fn blocks_in(file: &Context, body: Body) -> Vec<FileBody> {
    let context = file;
    let mut places: Vec<FileBody> = Vec::new();
    if context
        .user_blocks
        .iter()
        .all(|block| block.shape != Shape::Function)
    {
        return places;
    }
    for (network, of) in context.networks.iter().zip(context.bodies.iter()) {
        for block in network.blocks().filter(|_| *of == body) {
            let Meaning::User(user) = block.meaning else {
                continue;
            };
            let facts = &context.user_blocks[user];
            if facts.shape != Shape::Function {
                continue;
            }
            let place = match &facts.import {
                Some(import) => (Arc::clone(&import.file), Body::Block(import.item)),
                None => (Arc::clone(&file.name), Body::Block(user)),
            };
            if !places.contains(&place) {
                places.push(place);
            }
        }
    }
    places
}

fn bodies(context: &Context) -> Vec<Body> {
    let mut bodies = context.bodies.clone();
    bodies.sort_unstable();
    bodies.dedup();
    bodies
}

//! What a program needs of other files.

use super::Needed;
use crate::Lines;
use ladder_analysis::Analysis;
use ladder_analysis::context::{Body, Callee, Context};
use ladder_analysis::networks::BlockAt;
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::values::types::Type;
use ladder_analysis::written::facts::NodeKind;
use ladder_format::program;
use ladder_instructions::Op;
use ladder_syntax::{LineColumn, Name};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// A block in the list of a file, or a function.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Used {
    Block(usize),
    Function(Callee),
}

/// Looks for the blocks and functions of other files that a program needs.
pub(super) struct Search<'a> {
    own: &'a Context,
    files: &'a [Arc<Analysis>],
    by_name: HashMap<&'a str, usize>,
    /// For each file that was asked what each of its own bodies uses.
    uses: HashMap<usize, HashMap<Body, Vec<Used>>>,
    found: Vec<(Needed, LineColumn)>,
    seen: HashSet<Needed>,
}

impl<'a> Search<'a> {
    /// What it needs, each after what uses it, with the first of the program's own calls that does.
    pub(super) fn found(own: &'a Context, files: &'a [Arc<Analysis>]) -> Vec<(Needed, LineColumn)> {
        let by_name = files.iter().enumerate();
        let mut search = Search {
            own,
            files,
            by_name: by_name
                .map(|(number, file)| (&*file.context.name, number))
                .collect(),
            uses: HashMap::new(),
            found: Vec::new(),
            seen: HashSet::new(),
        };
        search.of_program();
        search.found
    }

    fn of_program(&mut self) {
        let text = self.own.parse.to_string();
        let lines = Lines::of(&text);
        for network in &self.own.networks {
            for call in network.blocks() {
                if let Some(used) = used_by(self.own, call) {
                    self.used(&used, lines.place(&text, call.range().start().into()));
                }
            }
        }
        // Those that only declarations name.
        for user in self.own.own_blocks..self.own.user_blocks.len() {
            self.used(&Used::Block(user), LineColumn::START);
        }
    }

    /// Something that the program uses, and all that this uses.
    fn used(&mut self, used: &Used, at: LineColumn) {
        let mut waiting: Vec<Needed> = self.needed(self.own, None, used).into_iter().collect();
        while let Some(needed) = waiting.pop() {
            if !self.seen.insert(needed.clone()) {
                continue;
            }
            let (file, body) = (needed.0, body(&needed.1));
            self.found.push((needed, at));
            let other = Arc::clone(&self.files[file].context);
            let uses = self.uses.entry(file).or_insert_with(|| uses(&other));
            let used = uses.get(&body).cloned().unwrap_or_default();
            waiting.extend(
                used.iter()
                    .filter_map(|used| self.needed(&other, Some(file), used)),
            );
        }
    }

    /// What is used in a file, if it is in one of the others; `from`: the file is one of these.
    fn needed(&self, context: &Context, from: Option<usize>, used: &Used) -> Option<Needed> {
        let import = match used {
            Used::Block(user) => context.user_blocks[*user].import.as_ref(),
            Used::Function(Callee::Other(import)) => Some(import),
            Used::Function(Callee::Own(_)) => None,
        };
        let Some(import) = import else {
            return from.map(|from| (from, used.clone()));
        };
        let item = match used {
            Used::Block(_) => Used::Block(import.item),
            Used::Function(_) => Used::Function(Callee::Own(import.item)),
        };
        Some((*self.by_name.get(&*import.file)?, item))
    }
}

fn body(used: &Used) -> Body {
    match used {
        Used::Block(block) => Body::Block(*block),
        Used::Function(Callee::Own(function)) => Body::Function(*function),
        Used::Function(Callee::Other(_)) => Body::Main,
    }
}

/// What a block of a network calls.
pub(crate) fn used_by(context: &Context, block: BlockAt<'_>) -> Option<Used> {
    match block.meaning {
        Meaning::User(user) => Some(Used::Block(user)),
        Meaning::Instruction(row) if row.block() == "<CALL>" => {
            match &block.facts.operands.first()?.value.kind {
                NodeKind::Name(name) => context.callee(&Name::new(name)).map(Used::Function),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The function that a block of a sketch begins or calls.
pub(crate) fn called_name(block: &program::Block) -> Option<&str> {
    match block.op()? {
        Op::Fun | Op::Call => block.only()?.path()?.whole(),
        _ => None,
    }
}

/// What each body of a file calls, or has a tag of.
fn uses(context: &Context) -> HashMap<Body, Vec<Used>> {
    let mut uses: HashMap<Body, Vec<Used>> = HashMap::new();
    for network in &context.networks {
        let used = network.blocks().filter_map(|block| used_by(context, block));
        uses.entry(context.bodies[network.index])
            .or_default()
            .extend(used);
    }
    let blocks = context.user_blocks.iter().enumerate();
    let by_name: HashMap<&Name, usize> = blocks.map(|(number, block)| (&block.key, number)).collect();
    let number = |name: &str| by_name.get(&Name::new(name)).copied().map(Used::Block);
    for scope in &context.scopes {
        for tag in &scope.tags {
            let Some(ty) = tag.ty else { continue };
            let held: Vec<Used> = Type::blocks(ty).iter().filter_map(|name| number(name)).collect();
            if held.is_empty() {
                continue;
            }
            match scope.block {
                Some(block) => uses.entry(Body::Block(block)).or_default().extend(held),
                None => {
                    for place in context.uses(tag) {
                        let own = uses.entry(context.bodies[place.network]).or_default();
                        own.extend(held.iter().cloned());
                    }
                }
            }
        }
    }
    uses
}

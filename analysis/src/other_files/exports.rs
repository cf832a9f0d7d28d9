//! What a file shows to the others of its workspace (LANGUAGE §4): functions, user-defined blocks and VAR_GLOBAL
//! tags. It follows from the file's own text alone, so that an edit which leaves it as it was concerns no other
//! file.

use crate::context::{Body, Context};
use crate::facts::{Node, NodeKind};
use crate::network::Formal;
use crate::others::Others;
use crate::outward::Outward;
use crate::outward_jumps::outward_jumps;
use crate::program::Role;
use crate::scope::{Origin, Scope, SectionKind};
use crate::skeleton::skeleton;
use crate::still_wanted::StillWanted;
use crate::types::Type;
use crate::user_block::UserBlockFacts;
use crate::uses;
use crate::value::Value;
use ladder_instructions::Accepts;
use ladder_syntax::{Name, Parse, TextRange};
use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use std::sync::Arc;

/// The summary of a file.
#[derive(Debug, Clone)]
pub struct Exports {
    /// The file's name, as messages call it. No two files of a workspace have one name.
    pub file: Arc<str>,
    /// Its functions in the order of the text; of one name only the first.
    pub functions: Vec<ExportedFunction>,
    /// Its user-defined blocks in the order of the text.
    pub blocks: Vec<ExportedBlock>,
    /// Its VAR_GLOBAL tags; of one name only the first.
    pub globals: Vec<Global>,
    /// Tags that it does not declare for itself and on which a block keeps its state.
    pub states: Vec<(Name, TextRange)>,
    /// What it does with names that it does not hold.
    pub(crate) outward: Outward,
}

/// A function as other files see it.
#[derive(Debug, Clone)]
pub struct ExportedFunction {
    /// As written.
    pub name: SmolStr,
    /// As it is compared.
    pub key: Name,
    /// Its index in the file's own context.
    pub item: usize,
    /// Where its name is.
    pub at: TextRange,
}

/// A user-defined block as other files see it.
#[derive(Debug, Clone)]
pub struct ExportedBlock {
    /// Its header and parameters.
    pub facts: UserBlockFacts,
    /// Its index in the file's own context.
    pub item: usize,
    /// The user-defined blocks that are in its body.
    pub uses: Vec<(Name, TextRange)>,
    /// Of a `<$B>`: the labels that its body jumps to and does not have.
    pub labels: Vec<(Name, TextRange)>,
    /// The labels that its body has.
    pub own_labels: Vec<Name>,
}

/// A VAR_GLOBAL tag as other files see it.
#[derive(Debug, Clone)]
pub struct Global {
    /// As declared.
    pub name: String,
    /// As it is compared.
    pub key: Name,
    /// Its type; none if that cannot be read.
    pub ty: Option<Type>,
    /// What its address says.
    pub role: Role,
    /// Declared CONSTANT.
    pub constant: bool,
    /// Declared RETAIN.
    pub retain: bool,
    /// Initial values; empty for the type's own.
    pub initial: Vec<Value>,
    /// The direct address that it is declared at.
    pub address: Option<Box<str>>,
    /// Where its name is.
    pub at: TextRange,
}

impl Global {
    /// Whether it is declared in the same way.
    fn is_same(&self, other: &Global) -> bool {
        (
            &self.name,
            self.ty,
            self.role,
            self.constant,
            self.retain,
            &self.initial,
            &self.address,
        ) == (
            &other.name,
            other.ty,
            other.role,
            other.constant,
            other.retain,
            &other.initial,
            &other.address,
        )
    }

    /// Whether two declarations are of one tag: they agree in type and initial value, and lie at one address if both
    /// have one.
    pub fn agrees(&self, other: &Global) -> bool {
        // One that cannot be read is a mistake of its own.
        self.ty.is_none()
            || other.ty.is_none()
            || (self.ty == other.ty
                && self.initial == other.initial
                && is_one_address(self.address.as_deref(), other.address.as_deref()))
    }
}

/// Whether two declarations may be of one tag as far as their addresses say.
pub(crate) fn is_one_address(one: Option<&str>, other: Option<&str>) -> bool {
    one.zip(other)
        .is_none_or(|(one, other)| Name::new(one) == Name::new(other))
}

/// What a file shows to the others. `file` is its name in messages.
pub fn exports(parse: &Arc<Parse>, file: &str) -> Exports {
    let always = StillWanted::new(&|| true);
    match skeleton(parse, file, &Others::default(), None, &always) {
        Some(context) => Exports::of(&context, file),
        None => unreachable!("it is always wanted"),
    }
}

impl Exports {
    /// The same, of a file that is analysed already.
    pub fn of(context: &Context, file: &str) -> Exports {
        Exports {
            file: Arc::from(file),
            functions: functions(context),
            blocks: blocks(context),
            globals: globals(context),
            states: states(context),
            outward: Outward::of(context),
        }
    }

    /// Whether other files see the same; places do not count.
    pub fn says_the_same(&self, other: &Exports) -> bool {
        self.offers_the_same(other) && self.outward == other.outward
    }

    /// Whether the same functions, blocks, tags and states are seen, whatever the file does with those of others.
    pub(crate) fn offers_the_same(&self, other: &Exports) -> bool {
        fn same<T>(a: &[T], b: &[T], equal: impl Fn(&T, &T) -> bool) -> bool {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| equal(a, b))
        }
        let name = |a: &(Name, TextRange), b: &(Name, TextRange)| a.0 == b.0;
        self.file == other.file
            && same(&self.functions, &other.functions, |a, b| {
                (&a.name, a.item) == (&b.name, b.item)
            })
            && same(&self.blocks, &other.blocks, |a, b| {
                a.item == b.item
                    && a.facts.looks_like(&b.facts)
                    && same(&a.uses, &b.uses, name)
                    && same(&a.labels, &b.labels, name)
                    && a.own_labels == b.own_labels
            })
            && same(&self.globals, &other.globals, Global::is_same)
            && same(&self.states, &other.states, name)
    }
}

fn functions(context: &Context) -> Vec<ExportedFunction> {
    let first = |(item, key): (usize, &Name)| context.function(key) == Some(item);
    let all = context.functions.iter().enumerate();
    all.filter(|(item, function)| first((*item, &function.key)))
        .map(|(item, function)| ExportedFunction {
            name: function.name.clone(),
            key: function.key.clone(),
            item,
            at: function.at,
        })
        .collect()
}

fn blocks(context: &Context) -> Vec<ExportedBlock> {
    let mut blocks: Vec<ExportedBlock> = context.user_blocks[..context.own_blocks]
        .iter()
        .enumerate()
        .map(|(item, facts)| ExportedBlock {
            facts: facts.clone(),
            item,
            uses: Vec::new(),
            labels: Vec::new(),
            own_labels: Vec::new(),
        })
        .collect();
    if blocks.is_empty() {
        return blocks;
    }
    for (network, block) in context.networks_of_blocks() {
        for bound in network.blocks() {
            if let Some(name) = bound.user_name() {
                blocks[block].uses.push((Name::new(name), bound.head_range()));
            }
        }
    }
    for jump in outward_jumps(context) {
        blocks[jump.block].labels.push((jump.key, jump.at));
    }
    for label in &context.labels {
        if let Body::Block(block) = context.bodies[label.network] {
            blocks[block].own_labels.push(label.key.clone());
        }
    }
    blocks.retain(|block| !block.facts.name.is_empty());
    blocks
}

/// The VAR_GLOBAL tags of a file.
fn globals(context: &Context) -> Vec<Global> {
    let mut globals: Vec<Global> = Vec::new();
    for tag in context.scopes.iter().flat_map(|scope| &scope.tags) {
        if tag.origin != Origin::Declared(SectionKind::Global) {
            continue;
        }
        let key = Name::new(&tag.name);
        globals.push(Global {
            name: tag.name.to_string(),
            key,
            ty: if tag.mistyped { None } else { tag.ty },
            role: tag.role,
            constant: tag.constant,
            retain: tag.retain,
            initial: tag.rare.initial.clone(),
            address: tag.rare.address.clone(),
            at: tag.declared_at,
        });
    }
    // Two scopes of the file may introduce one tag.
    if context.scopes.len() > 1 {
        let mut seen = FxHashSet::default();
        globals.retain(|global| seen.insert(global.key.clone()));
    }
    globals
}

fn states(context: &Context) -> Vec<(Name, TextRange)> {
    let mut states = Vec::new();
    for network in context.networks.iter().filter(|network| network.keeps_state) {
        let scope = &context.scopes[network.scope];
        for bound in network.blocks() {
            for (operand, formal) in bound.facts.operands.iter().zip(bound.formals.iter()) {
                let Some(name) = state_in(&operand.value, *formal) else {
                    continue;
                };
                let key = Name::new(name);
                if may_be_shared(context, scope, &key) {
                    states.push((key, bound.absolute(operand.value.range)));
                }
            }
        }
    }
    states
}

/// The name of the tag on which a block keeps its state, if the operand is that.
fn state_in(operand: &Node, formal: Formal) -> Option<&str> {
    match (formal, &operand.kind) {
        (Formal::Operand(row), NodeKind::Name(name)) if matches!(row.accepts, Accepts::State(_)) => {
            Some(name)
        }
        _ => None,
    }
}

/// Whether a name may be that of a tag of another file: without a declaration one that says its type is not.
fn may_be_shared(context: &Context, scope: &Scope, name: &Name) -> bool {
    match scope.find(name).map(|tag| &scope.tags[tag]) {
        Some(tag) if tag.is_declared() || tag.origin == Origin::Implicit => tag.is_outward(),
        _ => uses::undeclared(name.as_str(), context.profile.law()).origin == Origin::Undeclared,
    }
}

//! What a file shows to the others of its workspace (LANGUAGE §4): functions, user-defined blocks and VAR_GLOBAL
//! tags. It follows from the file's own text alone, so that an edit which leaves it as it was concerns no other
//! file.

use super::outward::Outward;
use crate::program::Role;
use crate::values::types::Type;
use crate::values::value::Value;
use crate::written::import::Import;
use crate::written::type_spec::{Declared, DeclaredType};
use crate::written::user_block::UserBlockFacts;
use ladder_syntax::{Name, TextRange};
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
    /// Its types, in the order of the text.
    pub types: Vec<DeclaredType>,
    /// The names of types that its declarations and operands mention.
    pub(crate) mentioned_types: Vec<Name>,
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

impl ExportedBlock {
    /// As a file knows it that uses it.
    pub fn imported_from(&self, file: &Exports) -> UserBlockFacts {
        UserBlockFacts {
            import: Some(Import {
                file: Arc::clone(&file.file),
                item: self.item,
            }),
            ..self.facts.clone()
        }
    }
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
    /// What its declaration says of its type, if that is more than an elementary type, a state or an array of elementary values;
    /// then it is what counts, and not type and initial values.
    pub declared: Option<Arc<Declared>>,
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
            &self.declared,
            self.role,
            self.constant,
            self.retain,
            &self.initial,
            &self.address,
        ) == (
            &other.name,
            other.ty,
            &other.declared,
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
        // One that cannot be read is an error of its own.
        let is_read = |global: &Global| global.ty.is_some() || global.declared.is_some();
        !is_read(self)
            || !is_read(other)
            || (self.ty == other.ty
                && self.declared == other.declared
                && self.initial == other.initial
                && is_one_address(self.address.as_deref(), other.address.as_deref()))
    }
}

/// Whether two declarations may be of one tag as far as their addresses say.
pub(crate) fn is_one_address(one: Option<&str>, other: Option<&str>) -> bool {
    one.zip(other)
        .is_none_or(|(one, other)| Name::new(one) == Name::new(other))
}

impl Exports {
    /// Whether other files see the same; places do not count.
    pub fn says_the_same(&self, other: &Exports) -> bool {
        self.offers_the_same(other) && self.outward == other.outward
    }

    /// Whether what they see of it lies at the same places, where they see the same.
    pub fn lies_the_same(&self, other: &Exports) -> bool {
        let places = |exports: &Exports| {
            let functions = exports.functions.iter().map(|function| function.at);
            let blocks = exports.blocks.iter().map(|block| block.facts.at);
            let globals = exports.globals.iter().map(|global| global.at);
            let types = exports.types.iter().map(|ty| ty.at);
            let states = exports.states.iter().map(|(_, at)| *at);
            let all = functions.chain(blocks).chain(globals).chain(types).chain(states);
            all.collect::<Vec<_>>()
        };
        places(self) == places(other)
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
            && same(&self.types, &other.types, |a, b| {
                (&a.name, &a.declared) == (&b.name, &b.declared)
            })
            && self.mentioned_types == other.mentioned_types
            && same(&self.states, &other.states, name)
    }
}

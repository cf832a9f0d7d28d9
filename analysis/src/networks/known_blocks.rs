//! The user-defined blocks that a file can use: its own, then those of other files that it does use.

use crate::names::named_types::NamedTypes;
use crate::names::path_type::path_type;
use crate::names::scope::{Origin, Scope, SectionKind};
use crate::networks::facts::Node;
use crate::networks::user_block::UserBlockFacts;
use crate::other_files::others::Others;
use crate::values::types::Type;
use ladder_instructions::{Semantics, Shape};
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// Blocks by name. What other files define is taken in when it is first asked for.
pub(crate) struct KnownBlocks<'o> {
    list: Vec<UserBlockFacts>,
    first: FxHashMap<Name, usize>,
    others: &'o Others,
    types: &'o mut NamedTypes,
    /// The tags that are declared, if one of them is the state of a block.
    instances: Option<&'o [Scope]>,
    /// The scope whose networks are being read.
    pub(crate) scope: usize,
    semantics: &'static Semantics,
}

impl<'o> KnownBlocks<'o> {
    pub(crate) fn new(
        own: Vec<UserBlockFacts>,
        others: &'o Others,
        types: &'o mut NamedTypes,
        (instances, semantics): (Option<&'o [Scope]>, &'static Semantics),
    ) -> KnownBlocks<'o> {
        let mut first = FxHashMap::default();
        for (index, block) in own.iter().enumerate() {
            first.entry(block.key.clone()).or_insert(index);
        }
        KnownBlocks {
            list: own,
            first,
            others,
            types,
            instances,
            scope: 0,
            semantics,
        }
    }

    /// The block of a name in a shape. A name of the file's own is looked up nowhere else.
    pub(crate) fn find(&mut self, name: &str, shape: Shape) -> Option<usize> {
        let key = Name::new(name);
        if let Some(&index) = self.first.get(&key) {
            if self.list[index].shape == shape {
                return Some(index);
            }
            // Defined twice, in two shapes: an error, of which each use takes its side.
            let mut all = self.list.iter();
            return all.position(|block| block.key == key && block.shape == shape);
        }
        let (file, block) = self.others.blocks(&key).next()?;
        let index = self.list.len();
        let mut facts = block.imported_from(file);
        for parameter in &mut facts.parameters {
            if let Some(declared) = &parameter.declared {
                let meaning = self.types.meaning_in(declared, &file.file);
                parameter.ty = meaning.map(|(ty, _)| ty);
            }
        }
        self.list.push(facts);
        self.first.insert(key, index);
        (block.facts.shape == shape).then_some(index)
    }

    /// Whether an operand is the state of a block, which is known by this index.
    pub(crate) fn is_instance(&mut self, node: &Node, index: usize) -> bool {
        let Some(scopes) = self.instances else {
            return false;
        };
        let (scope, others) = (self.scope, self.others);
        let types = &mut *self.types;
        let mut root = |node: &Node| {
            let key = Name::new(node.name()?);
            let own = scopes[scope].find(&key).map(|tag| &scopes[scope].tags[tag]);
            let global = || {
                let mut all = scopes
                    .iter()
                    .filter_map(|scope| Some(&scope.tags[scope.find(&key)?]));
                all.find(|tag| tag.origin == Origin::Declared(SectionKind::Global))
            };
            match own.or_else(global) {
                Some(tag) => tag.ty,
                None => {
                    let (file, global) = others.globals(&key).next()?;
                    let declared = global.declared.as_ref()?;
                    types.meaning_in(declared, &file.file).map(|(ty, _)| ty)
                }
            }
        };
        match path_type(node, self.semantics, &mut root) {
            Some((Type::Compound(id), 0)) => id
                .block()
                .is_some_and(|block| Name::new(&block) == self.list[index].key),
            _ => false,
        }
    }

    pub(crate) fn get(&self, index: usize) -> &UserBlockFacts {
        &self.list[index]
    }

    /// All of them, as their indices say.
    pub(crate) fn list(&self) -> &[UserBlockFacts] {
        &self.list
    }

    pub(crate) fn into_list(self) -> Vec<UserBlockFacts> {
        self.list
    }
}

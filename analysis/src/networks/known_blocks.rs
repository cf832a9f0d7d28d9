//! The user-defined blocks that a file can use: its own, then those of other files that it does use.

use crate::other_files::others::Others;
use crate::values::types::Type;
use crate::written::facts::Node;
use crate::written::type_spec::Declared;
use crate::written::user_block::UserBlockFacts;
use ladder_instructions::Shape;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// What is declared around the networks that are read.
pub(crate) trait Declarations {
    /// The type that a declaration of another file means.
    fn type_in(&mut self, declared: &Declared, file: &Arc<str>) -> Option<Type>;

    /// Whether an operand of a network in a scope is the state of a block.
    fn is_instance(&mut self, scope: usize, node: &Node, block: &Name) -> bool;
}

/// Blocks by name. What other files define is taken in when it is first asked for.
pub(crate) struct KnownBlocks<'o> {
    list: Vec<UserBlockFacts>,
    first: FxHashMap<Name, usize>,
    others: &'o Others,
    declarations: &'o mut dyn Declarations,
    /// The scope whose networks are being read.
    pub(crate) scope: usize,
}

impl<'o> KnownBlocks<'o> {
    pub(crate) fn new(
        own: Vec<UserBlockFacts>,
        others: &'o Others,
        declarations: &'o mut dyn Declarations,
    ) -> KnownBlocks<'o> {
        let mut first = FxHashMap::default();
        for (index, block) in own.iter().enumerate() {
            first.entry(block.key.clone()).or_insert(index);
        }
        KnownBlocks {
            list: own,
            first,
            others,
            declarations,
            scope: 0,
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
        let index = self.take_in(key)?;
        (self.list[index].shape == shape).then_some(index)
    }

    /// Takes in the blocks whose states are in a tag of some type: what they hold can be named where nothing runs them.
    pub(crate) fn held(&mut self, ty: Option<Type>) {
        let Some(Type::Compound(id)) = ty.filter(|ty| ty.keeps_state()) else {
            return;
        };
        id.each_block(&mut |name| {
            let key = Name::new(name);
            if !self.first.contains_key(&key) {
                self.take_in(key);
            }
        });
    }

    /// The same of a tag that another file declares.
    pub(crate) fn held_by_other(&mut self, declared: &Declared, file: &Arc<str>) {
        let ty = self.declarations.type_in(declared, file);
        self.held(ty);
    }

    fn take_in(&mut self, key: Name) -> Option<usize> {
        let (file, block) = self.others.blocks(&key).next()?;
        let index = self.list.len();
        let mut facts = block.imported_from(file);
        for parameter in &mut facts.parameters {
            if let Some(declared) = &parameter.declared {
                parameter.ty = self.declarations.type_in(declared, &file.file);
            }
        }
        self.list.push(facts);
        self.first.insert(key, index);
        Some(index)
    }

    /// Whether an operand is the state of a block, which is known by this index.
    pub(crate) fn is_instance(&mut self, node: &Node, index: usize) -> bool {
        self.declarations
            .is_instance(self.scope, node, &self.list[index].key)
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

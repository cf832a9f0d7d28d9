//! The user-defined blocks that a file can use: its own, then those of other files that it does use.

use crate::names::named_types::NamedTypes;
use crate::networks::user_block::UserBlockFacts;
use crate::other_files::others::Others;
use ladder_instructions::Shape;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;

/// Blocks by name. What other files define is taken in when it is first asked for.
pub(crate) struct KnownBlocks<'o> {
    list: Vec<UserBlockFacts>,
    first: FxHashMap<Name, usize>,
    others: &'o Others,
    types: &'o mut NamedTypes,
}

impl<'o> KnownBlocks<'o> {
    pub(crate) fn new(
        own: Vec<UserBlockFacts>,
        others: &'o Others,
        types: &'o mut NamedTypes,
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

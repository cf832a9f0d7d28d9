//! The other files of a workspace, as one of its files sees them: their [`Exports`], found by name.

use crate::other_files::exports::{ExportedBlock, ExportedFunction, Exports, Global};
use crate::other_files::outward::TagUse;
use crate::other_files::part_uses::PartUses;
use crate::other_files::type_values::TypeValues;
use crate::written::type_spec::DeclaredType;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::sync::{Arc, LazyLock, OnceLock};

/// What all files of a workspace show to each other.
#[derive(Debug, Default)]
pub struct Exported {
    files: Vec<Arc<Exports>>,
    functions: FxHashMap<Name, Vec<(u32, u32)>>,
    blocks: FxHashMap<Name, Vec<(u32, u32)>>,
    globals: FxHashMap<Name, Vec<(u32, u32)>>,
    types: FxHashMap<Name, Vec<(u32, u32)>>,
    states: FxHashMap<Name, Vec<(u32, u32)>>,
    /// How each file uses VAR_GLOBAL tags.
    uses: FxHashMap<Name, Vec<(u32, TagUse)>>,
    /// The files that call a function.
    calls: FxHashMap<Name, Vec<u32>>,
    part_uses: OnceLock<PartUses>,
    type_values: OnceLock<TypeValues>,
    library: Option<Library>,
}

/// What the library offers to all of them. It is read when it is first asked for.
pub(crate) type Library = fn() -> &'static Arc<Exported>;

impl Exported {
    /// Of files and, it may be, a library. Where several files offer one name the first of them stands for all.
    pub(crate) fn with(files: Vec<Arc<Exports>>, library: Option<Library>) -> Exported {
        let mut exported = Exported {
            library,
            ..Exported::default()
        };
        for (file, exports) in files.iter().enumerate() {
            let enter = |map: &mut FxHashMap<Name, Vec<(u32, u32)>>, key: &Name, item: usize| {
                map.entry(key.clone())
                    .or_default()
                    .push((file as u32, item as u32));
            };
            for (item, function) in exports.functions.iter().enumerate() {
                enter(&mut exported.functions, &function.key, item);
            }
            for (item, block) in exports.blocks.iter().enumerate() {
                enter(&mut exported.blocks, &block.facts.key, item);
            }
            for (item, global) in exports.globals.iter().enumerate() {
                enter(&mut exported.globals, &global.key, item);
            }
            for (item, ty) in exports.types.iter().enumerate() {
                enter(&mut exported.types, &ty.key, item);
            }
            for (item, (name, _)) in exports.states.iter().enumerate() {
                enter(&mut exported.states, name, item);
            }
        }
        for (file, exports) in files.iter().enumerate() {
            for (name, used) in &exports.outward.tags {
                if exported.globals.contains_key(name) {
                    let uses = exported.uses.entry(name.clone()).or_default();
                    uses.push((file as u32, *used));
                }
            }
            for name in &exports.outward.calls {
                if exported.functions.contains_key(name) {
                    exported.calls.entry(name.clone()).or_default().push(file as u32);
                }
            }
        }
        exported.files = files;
        exported
    }

    /// Whether it matters to other files that one of them says something else now.
    pub fn concerns(&self, before: &Exports, after: &Exports) -> bool {
        let (old, new) = (&before.outward, &after.outward);
        let is_called = |name: &Name| self.functions.contains_key(name);
        let is_block = |name: &Name| self.blocks.contains_key(name);
        let is_global = |name: &Name| self.globals.contains_key(name);
        !before.offers_the_same(after)
            || old.calls.symmetric_difference(&new.calls).any(is_called)
            || old.differing_blocks(new).any(is_block)
            || (!self.globals.is_empty() && old.differing_tags(new).any(is_global))
            || old.all_tags != new.all_tags
            || (self.have_types() && !old.uses_parts_like(new))
    }

    /// Whether a file that says this from now on was read without knowing what the others do with it: calls and uses are
    /// entered for names that some file offers, and it is the first that offers these.
    pub fn did_not_know(&self, after: &Exports) -> bool {
        let others = || self.files.iter().filter(|other| other.file != after.file);
        let new_functions = after.functions.iter().map(|function| &function.key);
        let mut new_functions = new_functions.filter(|key| !self.functions.contains_key(*key));
        let new_globals = after.globals.iter().map(|global| &global.key);
        let mut new_globals = new_globals.filter(|key| !self.globals.contains_key(*key));
        new_functions.any(|key| others().any(|other| other.outward.calls.contains(key)))
            || new_globals.any(|key| others().any(|other| other.outward.tags.contains_key(key)))
    }

    /// Whether one of the files declares a type.
    fn have_types(&self) -> bool {
        !self.types.is_empty()
    }

    /// The files.
    pub fn files(&self) -> &[Arc<Exports>] {
        &self.files
    }

    /// As the file of this name sees it.
    pub fn others_of(self: &Arc<Exported>, file: &str) -> Others {
        Others {
            own: self.files.iter().position(|exports| &*exports.file == file),
            exported: Some(Arc::clone(self)),
        }
    }
}

/// All files of a workspace but one.
#[derive(Debug, Clone, Default)]
pub struct Others {
    exported: Option<Arc<Exported>>,
    own: Option<usize>,
}

type Entries = fn(&Exported) -> &FxHashMap<Name, Vec<(u32, u32)>>;

impl Others {
    /// The functions of a name, at most one of each file.
    pub fn functions(&self, name: &Name) -> impl Iterator<Item = (&Exports, &ExportedFunction)> {
        self.find(name, |exported| &exported.functions)
            .map(|(file, item)| (file, &file.functions[item]))
    }

    /// The blocks of a name, at most one of each file; that of the library where no file defines it.
    pub fn blocks(&self, name: &Name) -> impl Iterator<Item = (&Exports, &ExportedBlock)> {
        let mut last: *const Exports = std::ptr::null();
        let mut others = self
            .find(name, |exported| &exported.blocks)
            .filter(move |(file, _)| !std::ptr::eq(std::mem::replace(&mut last, *file), *file))
            .map(|(file, item)| (file, &file.blocks[item]))
            .peekable();
        let is_defined = others.peek().is_some();
        let library = (!is_defined).then(|| self.library()).flatten();
        let of_library = library.and_then(|library| {
            let &(file, item) = library.blocks.get(name)?.first()?;
            let file = &library.files[file as usize];
            Some((&**file, &file.blocks[item as usize]))
        });
        others.chain(of_library)
    }

    fn library(&self) -> Option<&'static Exported> {
        let library = self.exported.as_deref()?.library?;
        Some(&**library())
    }

    /// The VAR_GLOBAL tags of a name, at most one of each file.
    pub fn globals(&self, name: &Name) -> impl Iterator<Item = (&Exports, &Global)> {
        self.find(name, |exported| &exported.globals)
            .map(|(file, item)| (file, &file.globals[item]))
    }

    /// The blocks that keep their state on a shared tag.
    pub(crate) fn states(&self, name: &Name) -> impl Iterator<Item = (&Exports, ladder_syntax::TextRange)> {
        self.find(name, |exported| &exported.states)
            .map(|(file, item)| (file, file.states[item].1))
    }

    /// How the others use a VAR_GLOBAL tag.
    pub fn tag_use(&self, name: &Name) -> TagUse {
        let uses = self
            .exported
            .iter()
            .filter_map(|exported| exported.uses.get(name))
            .flatten();
        uses.filter(|(file, _)| Some(*file as usize) != self.own)
            .fold(self.all_tags_use(), |all, (_, used)| all.with(*used))
    }

    /// What the unread parts of the others may do with every VAR_GLOBAL tag.
    pub(crate) fn all_tags_use(&self) -> TagUse {
        let files = self.files().map(|file| file.outward.all_tags);
        files.fold(TagUse::default(), TagUse::with)
    }

    /// How the others use members of a name, of whatever structure.
    pub(crate) fn member_use(&self, name: &Name) -> TagUse {
        let uses = self.part_uses().and_then(|uses| uses.members.get(name));
        let others = uses
            .into_iter()
            .flatten()
            .filter(|(file, _)| Some(*file as usize) != self.own);
        others.fold(TagUse::default(), |all, (_, used)| all.with(*used))
    }

    /// Whether one of the others may copy a whole structure of a type, or one that holds it.
    pub(crate) fn may_copy(&self, ty: &Name) -> bool {
        let files = self.part_uses().and_then(|uses| uses.copied.get(ty));
        files.is_some_and(|files| files.iter().any(|file| Some(*file as usize) != self.own))
    }

    fn part_uses(&self) -> Option<&PartUses> {
        let exported = self.exported.as_deref()?;
        Some(exported.part_uses.get_or_init(|| PartUses::of(&exported.files)))
    }

    /// Whether one of the others calls a function of a name.
    pub fn call(&self, name: &Name) -> bool {
        let calls = self
            .exported
            .iter()
            .filter_map(|exported| exported.calls.get(name));
        calls.flatten().any(|file| Some(*file as usize) != self.own)
    }

    /// Whether a file before this one declares a VAR_GLOBAL tag of a name.
    pub(crate) fn is_declared_before(&self, name: &Name) -> bool {
        let own = self.own.unwrap_or(usize::MAX);
        let exported = self.exported.iter();
        let mut declared = exported
            .filter_map(|exported| exported.globals.get(name))
            .flatten();
        declared.any(|(file, _)| (*file as usize) < own)
    }

    /// Whether there are other files at all.
    pub fn have_files(&self) -> bool {
        self.files().next().is_some()
    }

    /// Whether any file offers a VAR_GLOBAL tag.
    pub(crate) fn have_globals(&self) -> bool {
        self.exported
            .as_ref()
            .is_some_and(|exported| !exported.globals.is_empty())
    }

    /// The names of all functions of the others.
    pub fn function_names(&self) -> impl Iterator<Item = &str> {
        self.files()
            .flat_map(|file| &file.functions)
            .map(|function| function.name.as_str())
    }

    /// The VAR_GLOBAL tags of all the others.
    pub fn all_globals(&self) -> impl Iterator<Item = (&Exports, &Global)> {
        self.files()
            .flat_map(|file| file.globals.iter().map(move |global| (file, global)))
    }

    /// The types of a name, in the order of the files.
    pub fn types(&self, name: &Name) -> impl Iterator<Item = (&Exports, &DeclaredType)> {
        self.find(name, |exported| &exported.types)
            .map(|(file, item)| (file, &file.types[item]))
    }

    /// What all files declare of enumerations.
    pub(crate) fn type_values(&self) -> &TypeValues {
        static NONE: LazyLock<TypeValues> = LazyLock::new(TypeValues::default);
        match self.exported.as_deref() {
            Some(exported) => exported
                .type_values
                .get_or_init(|| TypeValues::of(&exported.files)),
            None => &NONE,
        }
    }

    /// All types of the others. The library has blocks only.
    pub fn all_types(&self) -> impl Iterator<Item = (&Exports, &DeclaredType)> {
        self.files()
            .flat_map(|file| file.types.iter().map(move |ty| (file, ty)))
    }

    /// Whether one of the others mentions a type of a name.
    pub(crate) fn mentions_type(&self, name: &Name) -> bool {
        self.files()
            .any(|file| file.mentioned_types.binary_search(name).is_ok())
    }

    /// All blocks of the others, and after them those of the library.
    pub fn all_blocks(&self) -> impl Iterator<Item = (&Exports, &ExportedBlock)> {
        let library = self.library().into_iter().flat_map(|library| &library.files);
        let files = self.files().chain(library.map(|file| &**file));
        files.flat_map(|file| file.blocks.iter().map(move |block| (file, block)))
    }

    /// The files but this one.
    pub(crate) fn files(&self) -> impl Iterator<Item = &Exports> {
        let files = self.exported.iter().flat_map(|exported| &exported.files);
        files
            .enumerate()
            .filter(|(index, _)| Some(*index) != self.own)
            .map(|(_, file)| &**file)
    }

    fn find(&self, name: &Name, entries: Entries) -> impl Iterator<Item = (&Exports, usize)> {
        let exported = self.exported.as_deref();
        let found = exported.and_then(|exported| entries(exported).get(name));
        found
            .into_iter()
            .flatten()
            .filter(|(file, _)| Some(*file as usize) != self.own)
            .filter_map(move |&(file, item)| Some((&*exported?.files[file as usize], item as usize)))
    }
}

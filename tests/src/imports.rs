//! Which files of a crate import which, read from the `use` and path expressions of its sources, and the order of its rooms
//! that follows.
//!
//! A room is a folder with a `mod.rs`, and the crate's root; `foo.rs` and its folder `foo/` belong to the room that `foo.rs`
//! is in. What is built for tests only does not count.

mod paths;

use crate::project;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// A file as the path of its module, without `crate`.
pub type Module = Vec<String>;

/// A file of a crate.
struct File {
    /// It is a `mod.rs`, a `lib.rs` or a `main.rs`.
    is_room: bool,
    text: String,
}

/// The files of a crate.
pub struct Crate {
    files: BTreeMap<Module, File>,
}

/// A room, whose parts - the rooms in it, and its own files - are in the order of their imports.
pub struct Room {
    /// Its folder.
    pub name: Module,
    /// What imports no other part comes first.
    pub order: Vec<Module>,
    /// The imports that break the order, from file to file.
    pub against: Vec<(Module, Module)>,
}

/// From one file to another.
type Import<'c> = (&'c Module, &'c Module);

/// The parts of a room, each with what it imports of which other part.
type Parts<'c> = BTreeMap<&'c Module, BTreeMap<&'c Module, Vec<Import<'c>>>>;

impl Crate {
    /// The sources in a folder `src`.
    pub fn read(folder: &Path) -> Crate {
        let sources = project::files(folder, "rs").into_iter().map(|path| {
            let relative = path.strip_prefix(folder).expect("a file is in its folder");
            let name = relative.to_string_lossy().replace('\\', "/");
            (name, project::read(&path))
        });
        Crate::of(sources)
    }

    /// The sources with these names, such as `names/mod.rs`.
    pub fn of(sources: impl Iterator<Item = (String, String)>) -> Crate {
        let mut files = BTreeMap::new();
        // A program is a crate of its own.
        for (name, text) in sources.filter(|(name, _)| !name.starts_with("bin/")) {
            let mut module: Module = name
                .trim_end_matches(".rs")
                .split('/')
                .map(str::to_owned)
                .collect();
            let is_room = module
                .pop_if(|last| ["mod", "lib", "main"].contains(&last.as_str()))
                .is_some();
            files.insert(module, File { is_room, text });
        }
        let test_modules = files.iter().flat_map(|(module, file): (&Module, &File)| {
            let names = paths::test_modules(&file.text).into_iter();
            names.map(|name| [&module[..], &[name]].concat())
        });
        let test_modules: BTreeSet<Module> = test_modules.collect();
        files.retain(|module, _| !(0..=module.len()).any(|length| test_modules.contains(&module[..length])));
        Crate { files }
    }

    /// The rooms with the orders of their parts.
    pub fn rooms(&self) -> Vec<Room> {
        let files = self.files.iter();
        let imports = files.flat_map(|(module, file)| {
            let imported = self.imports(module, &file.text).into_iter();
            imported.map(move |other| (module, other))
        });
        let imports: Vec<Import> = imports.collect();
        let rooms = self.files.iter().filter(|(_, file)| file.is_room);
        rooms.map(|(name, _)| self.room(name, &imports)).collect()
    }

    fn room(&self, name: &Module, imports: &[Import]) -> Room {
        let inside = self.files.keys().filter(|module| module.starts_with(name));
        let mut parts: Parts = inside
            .map(|module| (self.part(name, module), BTreeMap::new()))
            .collect();
        for import @ (from, to) in imports {
            if !from.starts_with(name) || !to.starts_with(name) {
                continue;
            }
            let (from, to) = (self.part(name, from), self.part(name, to));
            if let Some(imported) = parts.get_mut(from).filter(|_| from != to) {
                imported.entry(to).or_default().push(*import);
            }
        }
        self.forget_circles_of_files(name, &mut parts);
        let mut room = Room {
            name: name.clone(),
            order: Vec::new(),
            against: Vec::new(),
        };
        while let Some(next) = with_fewest_imports(&parts) {
            let against = parts.remove(next).into_iter().flatten();
            let against = against
                .filter(|(to, _)| parts.contains_key(to))
                .flat_map(|(_, imports)| imports);
            room.against
                .extend(against.map(|(from, to)| (from.clone(), to.clone())));
            room.order.push(next.clone());
        }
        room
    }

    /// The part of a room that a file belongs to: the room in this one that holds it, else the file by itself.
    fn part<'c>(&'c self, room: &Module, module: &'c Module) -> &'c Module {
        let mut around =
            (room.len() + 1..module.len()).map(|length| self.files.get_key_value(&module[..length]));
        let found = around.find_map(|file| file.filter(|(_, file)| file.is_room));
        found.map_or(module, |(part, _)| part)
    }

    /// Files of one room may know each other.
    fn forget_circles_of_files(&self, room: &Module, parts: &mut Parts) {
        let reached: BTreeMap<&Module, BTreeSet<&Module>> =
            parts.keys().map(|from| (*from, reach(parts, from))).collect();
        let is_file = |part: &Module| part == room || !self.files[part].is_room;
        for (from, imported) in parts {
            let circle = reached[from]
                .iter()
                .filter(|other| reached[**other].contains(from));
            if circle.clone().all(|other| is_file(other)) {
                imported.retain(|to, _| !reached[to].contains(from));
            }
        }
    }

    /// The files that a file imports.
    fn imports(&self, module: &Module, text: &str) -> BTreeSet<&Module> {
        let paths = paths::of(text).into_iter();
        let found = paths.filter_map(|path| self.file_of(module, &path));
        found.filter(|file| *file != module).collect()
    }

    /// The file that a path leads to. None where it leads out of the crate, or says nothing but `crate`.
    fn file_of(&self, module: &Module, path: &[String]) -> Option<&Module> {
        let mut rest = path;
        let mut at: Module = match rest.first()?.as_str() {
            "crate" => Vec::new(),
            "self" | "super" => module.clone(),
            child => {
                let child = [module, &[child.to_owned()][..]].concat();
                self.files.get(&child)?;
                module.clone()
            }
        };
        while let Some(word @ ("crate" | "self" | "super")) = rest.first().map(String::as_str) {
            if word == "super" {
                at.pop();
            }
            rest = &rest[1..];
        }
        while let Some(next) = rest.first() {
            at.push(next.clone());
            if !self.files.contains_key(&at) {
                at.pop();
                break;
            }
            rest = &rest[1..];
        }
        if at.is_empty() && rest.is_empty() {
            return None;
        }
        self.files.get_key_value(&at).map(|(file, _)| file)
    }
}

/// The part that imports the least of the others.
fn with_fewest_imports<'c>(parts: &Parts<'c>) -> Option<&'c Module> {
    let imports = |imported: &BTreeMap<&Module, Vec<Import>>| {
        let left = imported.iter().filter(|(to, _)| parts.contains_key(*to));
        left.map(|(_, imports)| imports.len()).sum::<usize>()
    };
    parts
        .iter()
        .min_by_key(|(_, imported)| imports(imported))
        .map(|(part, _)| *part)
}

/// The parts that are reached from one, over one import or more.
fn reach<'c>(parts: &Parts<'c>, from: &Module) -> BTreeSet<&'c Module> {
    let mut reached = BTreeSet::new();
    let mut left: Vec<&Module> = parts[from].keys().copied().collect();
    while let Some(part) = left.pop() {
        if reached.insert(part) {
            left.extend(parts[part].keys());
        }
    }
    reached
}

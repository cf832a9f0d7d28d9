//! Which files of a crate import which, read from the `use` and path expressions of its sources, and the circles in that.
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

/// Files that import each other in a circle.
#[derive(Debug, PartialEq, Eq)]
pub struct Circle {
    /// Each with those files of the circle that it imports.
    pub files: BTreeMap<Module, BTreeSet<Module>>,
    /// The rooms that the files are in.
    pub rooms: BTreeSet<Module>,
}

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
        Crate { files }
    }

    /// The circles of imports that cross rooms.
    pub fn circles(&self) -> Vec<Circle> {
        let imports: BTreeMap<&Module, BTreeSet<&Module>> = self
            .files
            .iter()
            .map(|(module, file)| (module, self.imports(module, &file.text)))
            .collect();
        let reached: BTreeMap<&Module, BTreeSet<&Module>> = imports
            .keys()
            .map(|from| (*from, reach(&imports, from)))
            .collect();
        let mut circles: Vec<Circle> = Vec::new();
        for (module, from_here) in &reached {
            let files: BTreeSet<&Module> = from_here
                .iter()
                .copied()
                .filter(|other| reached[*other].contains(module))
                .collect();
            let rooms: BTreeSet<Module> = files.iter().map(|file| self.room(file)).collect();
            // Each circle is reported for the first of its files.
            if rooms.len() > 1 && files.first() == Some(module) {
                let edges = files.iter().map(|file| {
                    let inside = imports[*file].intersection(&files);
                    ((*file).clone(), inside.map(|other| (*other).clone()).collect())
                });
                circles.push(Circle {
                    files: edges.collect(),
                    rooms,
                });
            }
        }
        circles
    }

    /// The room that a file is in.
    fn room(&self, module: &Module) -> Module {
        let mut lengths = (0..=module.len()).rev();
        let length = lengths.find(|&length| {
            let file = self.files.get(&module[..length]);
            file.is_some_and(|file| file.is_room)
        });
        module[..length.unwrap_or(0)].to_vec()
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

/// The files that are reached from one, over one import or more.
fn reach<'c>(imports: &BTreeMap<&'c Module, BTreeSet<&'c Module>>, from: &Module) -> BTreeSet<&'c Module> {
    let mut reached = BTreeSet::new();
    let mut left: Vec<&Module> = imports[from].iter().copied().collect();
    while let Some(module) = left.pop() {
        if reached.insert(module) {
            left.extend(&imports[module]);
        }
    }
    reached
}

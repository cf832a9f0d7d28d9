//! One workspace: its settings, its files on disk, and those of them that an editor shows.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use ladder_analysis::{Analysis, Exported, Exports};
use ladder_notations::{Foreign, of_workspaces};
use ladder_workspace::{Disk, ForeignPrograms, Root, Settings};

use crate::in_parallel;
use crate::on_disk::OnDisk;
use crate::seen::{Seen, SettingsFile};

/// The files that editors show, from when they are opened until they are closed.
#[derive(Debug, Clone, Default)]
pub(crate) struct Shown(Arc<Mutex<HashSet<PathBuf>>>);

impl Shown {
    pub(crate) fn contains(&self, path: &Path) -> bool {
        self.paths().contains(path)
    }

    pub(crate) fn insert(&self, path: &Path) {
        self.paths().insert(path.to_owned());
    }

    pub(crate) fn remove(&self, path: &Path) {
        self.paths().remove(path);
    }

    fn paths(&self) -> MutexGuard<'_, HashSet<PathBuf>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// One workspace.
#[derive(Debug)]
pub(crate) struct Folder {
    pub(crate) settings: Settings,
    /// Where they come from, if there is a file.
    pub(crate) settings_file: Option<Arc<SettingsFile>>,
    pub(crate) disk: BTreeMap<PathBuf, Arc<OnDisk>>,
    pub(crate) open: HashMap<PathBuf, Open>,
    /// Those of which nothing is known yet: an editor shows them, and what it shows was not checked.
    unknown: HashSet<PathBuf>,
    /// What its files show to each other. Nothing if that has changed since it was asked for.
    pub(crate) exported: Option<Arc<Exported>>,
    /// The workspace, as its folder was found.
    found: Option<Root>,
    /// Of files that an editor shows whether they belong to the workspace.
    held: HashMap<PathBuf, bool>,
    /// The programs of the workspace, sorted.
    all: Vec<PathBuf>,
    /// How often what an open file shows has become something else.
    pub(crate) changes: u64,
}

/// A file that an editor shows.
#[derive(Debug)]
pub(crate) struct Open {
    pub(crate) exports: Arc<Exports>,
    pub(crate) analysis: Arc<Analysis>,
    /// The program, where it is of another notation.
    pub(crate) foreign: Option<Arc<Foreign>>,
}

/// So many bytes of programs are read at first, the smallest files before the others.
const FIRST_BYTES: u64 = 2 << 20;

/// A workspace of which the large files are not read yet.
#[derive(Debug)]
pub(crate) struct First {
    folder: Folder,
    large: Vec<PathBuf>,
}

impl First {
    /// Whether it is the whole workspace.
    pub(crate) fn is_whole(&self) -> bool {
        self.large.is_empty()
    }

    /// What the files that are read show to each other.
    pub(crate) fn exported(&mut self) -> Arc<Exported> {
        Arc::clone(self.folder.exported())
    }

    /// What its settings file says.
    pub(crate) fn settings(&self) -> &Settings {
        &self.folder.settings
    }

    /// Reads the rest.
    pub(crate) fn whole(self, programs: &Arc<ForeignPrograms>, root: &Path) -> Folder {
        let First { mut folder, large } = self;
        folder.read(programs, root, &large);
        folder.exported = None;
        folder
    }
}

impl Folder {
    /// Reads a workspace, of which `path` is a file, as far as that is quick. `defaults` hold where it has no settings file.
    pub(crate) fn first(
        programs: &Arc<ForeignPrograms>,
        path: &Path,
        root: &Path,
        defaults: &Settings,
        shown: &Shown,
    ) -> First {
        let mut folder = Folder {
            settings: Settings::default(),
            settings_file: None,
            disk: BTreeMap::new(),
            open: HashMap::new(),
            unknown: HashSet::new(),
            exported: None,
            found: None,
            held: HashMap::new(),
            all: Vec::new(),
            changes: 0,
        };
        let disk = programs.disk();
        let Ok(found) = disk.root_of(path) else {
            let large = Vec::new();
            return First { folder, large };
        };
        match found.settings_file() {
            Some(file) => {
                let (settings, file) = SettingsFile::read(&**disk, file);
                folder.settings = settings;
                folder.settings_file = Some(Arc::new(file));
            }
            None => folder.settings = defaults.clone(),
        }
        folder.all = disk.programs(&found, &folder.settings.files);
        folder.all.retain(|path| folder.settings.files.contain(path));
        folder.found = Some(found);
        folder.unknown = folder
            .all
            .iter()
            .filter(|path| shown.contains(path))
            .cloned()
            .collect();
        let (first, large) = first_and_large(&**disk, folder.all.clone(), &folder.unknown);
        folder.read(programs, root, &first);
        First { folder, large }
    }

    /// Takes files as they are on disk, but for those that an editor shows.
    fn read(&mut self, programs: &Arc<ForeignPrograms>, root: &Path, paths: &[PathBuf]) {
        let (unknown, all) = (&self.unknown, &self.all);
        let read = in_parallel::map(paths, |path| {
            let file = if unknown.contains(path) {
                OnDisk::shown(programs, root, path)
            } else {
                OnDisk::read(programs, (root, all), path)?
            };
            Some((path.clone(), Arc::new(file)))
        });
        self.disk.extend(read);
    }

    /// Whether a file is one of the workspace. One that is hidden or excluded is a guest: it sees the others, and they do not
    /// see it.
    pub(crate) fn holds(&mut self, disk: &dyn Disk, path: &Path) -> bool {
        let (found, files) = (&self.found, &self.settings.files);
        let holds = || found.as_ref().is_some_and(|found| disk.holds(found, path, files));
        *self.held.entry(path.to_owned()).or_insert_with(holds)
    }

    /// How its files were when they were read.
    pub(crate) fn seen(&self) -> Seen {
        let programs = self.disk.iter();
        Seen {
            settings_file: self.settings_file.as_ref().map(|file| file.stamp),
            files: self.settings.files.clone(),
            programs: programs.map(|(path, file)| (path.clone(), file.stamp)).collect(),
        }
    }

    /// What the others see of a file.
    pub(crate) fn shown(&self, path: &Path) -> Option<&Arc<Exports>> {
        let open = self.open.get(path).map(|open| &open.exports);
        open.or_else(|| self.disk.get(path).map(|file| &file.exports))
    }

    /// Takes a file as it is on disk now. One that an editor shows is not read: what its editor shows counts.
    pub(crate) fn reread(&mut self, programs: &Arc<ForeignPrograms>, root: &Path, path: &Path) {
        let disk = programs.disk();
        self.held.remove(path);
        let holds = self.holds(&**disk, path);
        match (
            self.all.binary_search_by(|own| (**own).cmp(path)),
            holds && disk.is_file(path),
        ) {
            (Err(at), true) => self.all.insert(at, path.to_owned()),
            (Ok(at), false) => drop(self.all.remove(at)),
            (Ok(_), true) | (Err(_), false) => {}
        }
        let shown = self.disk.get(path).filter(|_| self.open.contains_key(path));
        let file = if !holds {
            None
        } else if let Some(shown) = shown {
            Some(shown.without_text(disk.stamp(path))).filter(|file| file.stamp.exists())
        } else {
            OnDisk::read(programs, (root, &self.all), path)
        };
        self.unknown.remove(path);
        match file {
            Some(file) => self.disk.insert(path.to_owned(), Arc::new(file)),
            None => self.disk.remove(path),
        };
    }

    /// Reads those programs of other notations again that may name something of a file, which has changed: what they are in ladder
    /// text depends on what that declares. True if any of them shows something else now.
    pub(crate) fn reread_readers(
        &mut self,
        programs: &Arc<ForeignPrograms>,
        root: &Path,
        changed: &Path,
        before: Option<&Exports>,
    ) -> bool {
        let now = self.shown(changed).cloned();
        let names: HashSet<String> = before.into_iter().chain(now.as_deref()).flat_map(names).collect();
        let is_reader = |(path, file): &(&PathBuf, &Arc<OnDisk>)| {
            **path != *changed && of_workspaces(path).is_some() && {
                let text = file.member().text();
                let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
                words.any(|word| names.contains(&word.to_lowercase()))
            }
        };
        let readers: Vec<PathBuf> = self
            .disk
            .iter()
            .filter(is_reader)
            .map(|(path, _)| path.clone())
            .collect();
        let mut other = false;
        for path in readers {
            let before = self.shown(&path).cloned();
            self.reread(programs, root, &path);
            other |= !same(before.as_deref(), self.shown(&path).map(|exports| &**exports));
        }
        other
    }

    /// An editor shows a file, and what it shows is known.
    pub(crate) fn show(&mut self, path: &Path, open: Open) {
        self.unknown.remove(path);
        self.open.insert(path.to_owned(), open);
        if let Some(file) = self.disk.get_mut(path).filter(|file| file.holds_text()) {
            *file = Arc::new(file.without_text(file.stamp));
        }
    }

    /// What its files show to each other, as one of them sees it. Another one of which nothing is known yet counts as it is on
    /// disk.
    pub(crate) fn exported_for(
        &mut self,
        programs: &Arc<ForeignPrograms>,
        root: &Path,
        own: &Path,
    ) -> &Arc<Exported> {
        let others = self.unknown.iter().filter(|path| **path != *own);
        let others: Vec<PathBuf> = others.cloned().collect();
        for path in others {
            self.unknown.remove(&path);
            if let Some(file) = OnDisk::read(programs, (root, &self.all), &path) {
                self.disk.insert(path, Arc::new(file));
                self.exported = None;
            }
        }
        self.exported()
    }

    fn exported(&mut self) -> &Arc<Exported> {
        let (disk, open, held) = (&self.disk, &self.open, &self.held);
        self.exported.get_or_insert_with(|| {
            let mut all: BTreeMap<&Path, &Arc<Exports>> =
                disk.iter().map(|(path, file)| (&**path, &file.exports)).collect();
            let open = open.iter().filter(|(path, _)| held.get(*path) != Some(&false));
            all.extend(open.map(|(path, open)| (&**path, &open.exports)));
            Arc::new(Exported::new(all.into_values().cloned().collect()))
        })
    }
}

/// The files that are read at first, and those that are not. Of what an editor shows nothing is read.
fn first_and_large(
    disk: &dyn Disk,
    programs: Vec<PathBuf>,
    shown: &HashSet<PathBuf>,
) -> (Vec<PathBuf>, Vec<PathBuf>) {
    let size = |path: PathBuf| {
        let bytes = if shown.contains(&path) {
            0
        } else {
            disk.stamp(&path).bytes()
        };
        (bytes, path)
    };
    let mut sized: Vec<(u64, PathBuf)> = programs.into_iter().map(size).collect();
    sized.sort();
    let mut sum = 0;
    let is_first = |(bytes, _): &&(u64, PathBuf)| {
        sum += bytes;
        sum <= FIRST_BYTES
    };
    let first = sized.iter().take_while(is_first).count();
    let large = sized.split_off(first);
    let paths = |sized: Vec<(u64, PathBuf)>| sized.into_iter().map(|(_, path)| path).collect();
    (paths(sized), paths(large))
}

/// The names of what a file declares for others, in small letters.
fn names(exports: &Exports) -> impl Iterator<Item = String> {
    let blocks = exports
        .blocks
        .iter()
        .map(|block| block.facts.name.trim_start_matches('$'));
    let globals = exports.globals.iter().map(|global| &*global.name);
    let types = exports.types.iter().map(|ty| &*ty.name);
    blocks.chain(globals).chain(types).map(str::to_lowercase)
}

/// Whether the others see the same of a file before and after a change on disk, at the same places.
pub(crate) fn same(a: Option<&Exports>, b: Option<&Exports>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.says_the_same(b) && a.lies_the_same(b),
        (None, None) => true,
        _ => false,
    }
}

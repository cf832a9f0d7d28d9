//! The other files of the workspaces that open documents belong to.
//!
//! A file that is open counts with the text that its editor shows, any other with the one on disk. What the files
//! show to each other is kept as [`Exports`]: a change that leaves those as they were concerns no other file.
//!
//! Everything here may read the disk: for a blocking thread.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use ladder_analysis::context::{Context, context};
use ladder_analysis::program::Program;
use ladder_analysis::{
    Analysis, Exported, Exports, NotWhole, Others, RuleSettings, analyze_with, exports, link,
};
use ladder_syntax::Parse;
use ladder_workspace::{FileError, Root, SETTINGS_FILE, Settings, Simulate, Stamp};

use super::seen::{Seen, SettingsFile};
use super::together;

/// All workspaces, by their folders.
#[derive(Debug, Default)]
pub(crate) struct Neighbours {
    state: Mutex<State>,
}

#[derive(Debug, Default)]
struct State {
    /// What holds where there is no settings file.
    defaults: Settings,
    roots: HashMap<PathBuf, PathBuf>,
    folders: HashMap<PathBuf, Folder>,
}

/// One workspace.
#[derive(Debug)]
struct Folder {
    settings: Settings,
    /// Where they come from, if there is a file.
    settings_file: Option<Arc<SettingsFile>>,
    disk: BTreeMap<PathBuf, Arc<OnDisk>>,
    open: HashMap<PathBuf, Open>,
    exported: Option<Arc<Exported>>,
    /// How often what an open file shows has become something else.
    changes: u64,
}

/// Which files see something else once what a file exports has changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct News {
    /// The other ones.
    pub(crate) for_others: bool,
    /// The file itself: others have changed since it was read, when they could not know that it concerns it.
    pub(crate) for_itself: bool,
}

/// The names of files that no editor shows are kept in workspaces with so many bytes of text; in larger ones they are read
/// again when somebody asks.
const MOST_KEPT: usize = 2 << 20;

/// A file that no editor shows.
#[derive(Debug)]
pub(crate) struct OnDisk {
    pub(crate) name: Arc<str>,
    stamp: Stamp,
    /// Its text. All else that is known of it is read again when somebody asks.
    pub(crate) text: String,
    exports: Arc<Exports>,
    /// Its names, as they are among these other files.
    names: Mutex<Option<(Arc<Exported>, Arc<Context>)>>,
}

impl OnDisk {
    /// Reads a program.
    fn read(root: &Path, path: &Path) -> Option<OnDisk> {
        let stamp = Stamp::of(path);
        let text = ladder_workspace::read_own(path).ok()?;
        let name = name_in(root, path);
        let exports = Arc::new(exports(&Arc::new(ladder_syntax::parse(&text)), &name));
        Some(OnDisk {
            name,
            stamp,
            text,
            exports,
            names: Mutex::default(),
        })
    }

    fn parse(&self) -> Arc<Parse> {
        Arc::new(ladder_syntax::parse(&self.text))
    }

    /// Its names. `exported` is what the files of its workspace show to each other.
    pub(crate) fn context(&self, exported: &Arc<Exported>, are_few: bool) -> Arc<Context> {
        if !are_few {
            return Arc::new(self.read_context(exported));
        }
        let mut names = self.names.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((of, context)) = &*names
            && Arc::ptr_eq(of, exported)
        {
            return Arc::clone(context);
        }
        let context = Arc::new(self.read_context(exported));
        *names = Some((Arc::clone(exported), Arc::clone(&context)));
        context
    }

    fn read_context(&self, exported: &Arc<Exported>) -> Context {
        let others = exported.others_of(&self.name);
        context(&self.parse(), &self.name, &others)
    }
}

/// The files of a workspace as they are on disk.
pub(crate) struct FilesOnDisk {
    pub(crate) files: Vec<(PathBuf, Arc<OnDisk>)>,
    /// What all files of the workspace, open or not, show to each other.
    pub(crate) exported: Arc<Exported>,
}

impl FilesOnDisk {
    /// Whether what is known of all of them may be kept. It takes some twenty times the memory of the texts.
    pub(crate) fn are_few(&self) -> bool {
        let bytes: usize = self.files.iter().map(|(_, file)| file.text.len()).sum();
        bytes <= MOST_KEPT
    }
}

/// A file that an editor shows.
#[derive(Debug)]
struct Open {
    exports: Arc<Exports>,
    analysis: Arc<Analysis>,
}

impl Neighbours {
    /// What a file is called in messages, and what it sees of the others.
    pub(crate) fn view(&self, path: &Path) -> (Arc<str>, Others) {
        let (name, others, _) = self.view_now(path);
        (name, others)
    }

    /// As [`Neighbours::view`], with the number of changes that it has in it.
    fn view_now(&self, path: &Path) -> (Arc<str>, Others, u64) {
        let mut state = self.lock();
        let (root, folder) = state.folder(path);
        let name = name_in(&root, path);
        let others = folder.exported().others_of(&name);
        (name, others, folder.changes)
    }

    /// Enters the analysis of an open file, which was read when there had been so many changes.
    fn analysed(&self, path: &Path, analysis: &Arc<Analysis>, read_at: Option<u64>) -> News {
        let exports = Arc::new(Exports::of(&analysis.context, &analysis.context.name));
        let mut state = self.lock();
        let (_, folder) = state.folder(path);
        let changed = match folder.shown(path).cloned() {
            Some(before) => folder.exported().concerns(&before, &exports),
            None => true,
        };
        let for_itself = changed && read_at.is_some_and(|read_at| read_at != folder.changes);
        if !same(folder.shown(path).map(|exports| &**exports), Some(&exports)) {
            folder.changes += 1;
        }
        let open = Open {
            exports,
            analysis: Arc::clone(analysis),
        };
        folder.open.insert(path.to_owned(), open);
        if changed {
            folder.exported = None;
        }
        News {
            for_others: changed,
            for_itself,
        }
    }

    /// The editor has closed a file: the text on disk counts again. True if the others see something else now.
    pub(crate) fn closed(&self, path: &Path) -> bool {
        let mut state = self.lock();
        let (root, folder) = state.folder(path);
        let before = folder.open.remove(path).map(|open| open.exports);
        folder.reread(&root, path);
        folder.exported = None;
        !same(before.as_deref(), folder.shown(path).map(|exports| &**exports))
    }

    /// Files were changed, made or removed. True if any file sees something else now.
    pub(crate) fn disk_changed(&self, paths: &[PathBuf]) -> bool {
        let mut state = self.lock();
        if paths
            .iter()
            .any(|path| path.file_name().is_some_and(|name| name == SETTINGS_FILE))
        {
            // Which file belongs where may be another matter now.
            state.begin_anew();
            return true;
        }
        let mut changed = false;
        for path in paths.iter().filter(|path| ladder_workspace::is_program(path)) {
            let (root, folder) = state.folder(path);
            let before = folder.shown(path).cloned();
            folder.reread(&root, path);
            if !same(before.as_deref(), folder.shown(path).map(|exports| &**exports)) {
                folder.exported = None;
                changed = true;
            }
        }
        changed
    }

    /// What holds for programs that no settings file is above.
    pub(crate) fn set_defaults(&self, settings: Settings) {
        let mut state = self.lock();
        state.defaults = settings;
        state.begin_anew();
    }

    /// Whether two files belong to one workspace.
    pub(crate) fn together(&self, a: &Path, b: &Path) -> bool {
        let mut state = self.lock();
        state.root(a) == state.root(b)
    }

    /// The folder of the workspace that a file belongs to.
    pub(crate) fn folder_of(&self, path: &Path) -> PathBuf {
        self.lock().root(path)
    }

    /// The files on disk of a file's workspace. Those that are open are among them, as they were when they were last
    /// saved.
    pub(crate) fn on_disk(&self, path: &Path) -> FilesOnDisk {
        let mut state = self.lock();
        let (_, folder) = state.folder(path);
        let exported = Arc::clone(folder.exported());
        let files = folder.disk.iter();
        FilesOnDisk {
            files: files
                .map(|(path, file)| (path.clone(), Arc::clone(file)))
                .collect(),
            exported,
        }
    }

    /// What the workspace of a file asks for.
    pub(crate) fn format_options(&self, path: &Path) -> ladder_format::Options {
        self.lock().folder(path).1.settings.format.clone()
    }

    /// The settings of the rules for a file.
    pub(crate) fn rules(&self, path: &Path) -> RuleSettings {
        self.lock().folder(path).1.settings.rules_for(path)
    }

    /// How the workspace of a file has its programs run.
    pub(crate) fn simulate(&self, path: &Path) -> Simulate {
        self.lock().folder(path).1.settings.simulate.clone()
    }

    /// The settings file above a program.
    pub(crate) fn settings_file(&self, path: &Path) -> Option<Arc<SettingsFile>> {
        self.lock().folder(path).1.settings_file.clone()
    }

    /// All settings files that were read.
    pub(crate) fn settings_files(&self) -> Vec<Arc<SettingsFile>> {
        let state = self.lock();
        let folders = state.folders.values();
        folders
            .filter_map(|folder| folder.settings_file.clone())
            .collect()
    }

    /// The analysis of a program: as its editor shows it if it is open, else as it is on disk.
    pub(crate) fn analysis_of(&self, path: &Path) -> Result<Arc<Analysis>, FileError> {
        let mut state = self.lock();
        let (root, folder) = state.folder(path);
        if let Some(open) = folder.open.get(path) {
            return Ok(Arc::clone(&open.analysis));
        }
        let name = name_in(&root, path);
        let others = folder.exported().others_of(&name);
        let rules = folder.settings.rules_for(path);
        let known = folder.disk.get(path).cloned();
        drop(state);
        let parse = match known {
            Some(file) => file.parse(),
            // Excluded from the workspace, but a program all the same.
            None => Arc::new(ladder_syntax::parse(&ladder_workspace::read_own(path)?)),
        };
        Ok(Arc::new(analyze_with(&parse, &name, &others, &rules)))
    }

    /// All programs that were read and that no editor shows, sorted.
    pub(crate) fn closed_programs(&self) -> Vec<PathBuf> {
        let state = self.lock();
        let closed = state.folders.values().flat_map(|folder| {
            let paths = folder.disk.keys();
            paths.filter(|path| !folder.open.contains_key(*path)).cloned()
        });
        let mut closed: Vec<PathBuf> = closed.collect();
        closed.sort();
        closed
    }

    /// A program as it is on disk, and what it sees: what is found in it is the same as long as both are.
    pub(crate) fn closed_program(&self, path: &Path) -> Option<(Arc<OnDisk>, Arc<Exported>)> {
        let mut state = self.lock();
        let (_, folder) = state.folder(path);
        let file = Arc::clone(folder.disk.get(path)?);
        Some((file, Arc::clone(folder.exported())))
    }

    /// Reads the workspace of a program, if that was not done. The others may go on meanwhile.
    pub(crate) fn load(&self, path: &Path) {
        let (root, defaults) = {
            let mut state = self.lock();
            let root = state.root(path);
            if state.folders.contains_key(&root) {
                return;
            }
            (root, state.defaults.clone())
        };
        let folder = Folder::load(path, &root, &defaults);
        self.lock().folders.entry(root).or_insert(folder);
    }

    /// Forgets the workspaces that no open file belongs to, but for those that are wanted.
    pub(crate) fn forget(&self, wanted: impl Fn(&Path) -> bool) {
        let mut state = self.lock();
        state
            .folders
            .retain(|root, folder| !folder.open.is_empty() || wanted(root));
    }

    /// The files that are not as they were read, for an editor that does not report changes. This looks at every
    /// file, but reads none.
    pub(crate) fn changed_on_disk(&self) -> Vec<PathBuf> {
        let state = self.lock();
        let folders: Vec<_> = state
            .folders
            .iter()
            .map(|(root, folder)| (root.clone(), folder.seen()))
            .collect();
        let open = state.folders.iter().flat_map(|(root, folder)| {
            let paths = folder.open.keys();
            paths.map(|path| (path.clone(), root.clone()))
        });
        let open: Vec<(PathBuf, PathBuf)> = open.collect();
        drop(state);
        let mut changed = Vec::new();
        for (root, seen) in folders {
            changed.extend(seen.changed(&root));
        }
        // A settings file that is made or removed above a program gives it another workspace.
        let moved = open
            .iter()
            .find(|(path, root)| Root::of(path).is_ok_and(|found| found.folder() != root));
        changed.extend(moved.map(|(path, _)| path.with_file_name(SETTINGS_FILE)));
        changed
    }

    /// The file of a name, as findings and programs of another file know it: its path and text.
    pub(crate) fn text_of(&self, from: &Path, name: &str) -> Option<(PathBuf, String)> {
        let mut state = self.lock();
        let (root, folder) = state.folder(from);
        let open = folder
            .open
            .iter()
            .find(|(path, _)| *name_in(&root, path) == *name);
        if let Some((path, open)) = open {
            return Some((path.clone(), open.analysis.context.parse.to_string()));
        }
        let (path, file) = folder.disk.iter().find(|(_, file)| *file.name == *name)?;
        Some((path.clone(), file.text.clone()))
    }

    /// What runs: a file's program with what it uses of the others.
    pub(crate) fn link(&self, path: &Path, own: &Arc<Analysis>) -> Result<Arc<Program>, NotWhole> {
        link(own, &|name| {
            let mut state = self.lock();
            let (root, folder) = state.folder(path);
            let open = folder
                .open
                .iter()
                .find(|(path, _)| *name_in(&root, path) == *name);
            if let Some((_, open)) = open {
                return Some(Arc::clone(&open.analysis));
            }
            let (path, file) = folder.disk.iter().find(|(_, file)| *file.name == *name)?;
            let rules = folder.settings.rules_for(path);
            let (file, others) = (Arc::clone(file), folder.exported().others_of(name));
            drop(state);
            Some(Arc::new(analyze_with(&file.parse(), name, &others, &rules)))
        })
    }

    /// A panic elsewhere leaves at worst a file that is read again.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl State {
    /// Forgets what was read from disk, and reads it again when it is needed.
    fn begin_anew(&mut self) {
        let open: Vec<(PathBuf, Open)> = self
            .folders
            .values_mut()
            .flat_map(|folder| folder.open.drain())
            .collect();
        self.folders.clear();
        self.roots.clear();
        for (path, open) in open {
            let (_, folder) = self.folder(&path);
            folder.open.insert(path, open);
            folder.exported = None;
        }
    }

    fn root(&mut self, path: &Path) -> PathBuf {
        let parent = path.parent().unwrap_or(path).to_owned();
        let found = self.roots.entry(parent).or_insert_with_key(|parent| {
            let root = Root::of(path).map(|root| root.folder().to_owned());
            root.unwrap_or_else(|_| parent.clone())
        });
        found.clone()
    }

    fn folder(&mut self, path: &Path) -> (PathBuf, &mut Folder) {
        let root = self.root(path);
        let defaults = &self.defaults;
        let folder = self
            .folders
            .entry(root.clone())
            .or_insert_with(|| Folder::load(path, &root, defaults));
        (root, folder)
    }
}

impl Folder {
    fn load(path: &Path, root: &Path, defaults: &Settings) -> Folder {
        let mut folder = Folder {
            settings: Settings::default(),
            settings_file: None,
            disk: BTreeMap::new(),
            open: HashMap::new(),
            exported: None,
            changes: 0,
        };
        let Ok(found) = Root::of(path) else {
            return folder;
        };
        match found.settings_file() {
            Some(file) => {
                let (settings, file) = SettingsFile::read(file);
                folder.settings = settings;
                folder.settings_file = Some(Arc::new(file));
            }
            None => folder.settings = defaults.clone(),
        }
        let mut programs = found.programs(&folder.settings.files);
        programs.retain(|path| folder.settings.files.contain(path));
        folder.disk = together::map(&programs, |path| {
            Some((path.clone(), Arc::new(OnDisk::read(root, path)?)))
        })
        .into_iter()
        .collect();
        folder
    }

    /// How its files were when they were read.
    fn seen(&self) -> Seen {
        let programs = self.disk.iter();
        Seen {
            settings_file: self.settings_file.as_ref().map(|file| file.stamp),
            files: self.settings.files.clone(),
            programs: programs.map(|(path, file)| (path.clone(), file.stamp)).collect(),
        }
    }

    /// What the others see of a file.
    fn shown(&self, path: &Path) -> Option<&Arc<Exports>> {
        let open = self.open.get(path).map(|open| &open.exports);
        open.or_else(|| self.disk.get(path).map(|file| &file.exports))
    }

    /// Takes a file as it is on disk now.
    fn reread(&mut self, root: &Path, path: &Path) {
        let belongs = self.settings.files.contain(path);
        match belongs.then(|| OnDisk::read(root, path)).flatten() {
            Some(file) => self.disk.insert(path.to_owned(), Arc::new(file)),
            None => self.disk.remove(path),
        };
    }

    fn exported(&mut self) -> &Arc<Exported> {
        let (disk, open) = (&self.disk, &self.open);
        self.exported.get_or_insert_with(|| {
            let mut all: BTreeMap<&Path, &Arc<Exports>> =
                disk.iter().map(|(path, file)| (&**path, &file.exports)).collect();
            all.extend(open.iter().map(|(path, open)| (&**path, &open.exports)));
            Arc::new(Exported::new(all.into_values().cloned().collect()))
        })
    }
}

fn same(a: Option<&Exports>, b: Option<&Exports>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.says_the_same(b),
        (None, None) => true,
        _ => false,
    }
}

/// The path from the workspace's folder on: no two files have one name.
fn name_in(root: &Path, path: &Path) -> Arc<str> {
    let name = path.strip_prefix(root).unwrap_or(path);
    Arc::from(name.to_string_lossy().replace('\\', "/"))
}

/// A document's place among the files of its workspace.
#[derive(Debug, Clone)]
pub(crate) struct Membership {
    /// The file.
    pub(crate) path: PathBuf,
    /// The workspaces.
    pub(crate) neighbours: Arc<Neighbours>,
    /// Whether what the file exports was passed on to the others.
    passed_on: Arc<OnceLock<()>>,
    /// How many changes there had been when it was read.
    read_at: Arc<OnceLock<u64>>,
}

impl Membership {
    pub(crate) fn new(path: PathBuf, neighbours: &Arc<Neighbours>) -> Membership {
        Membership {
            path,
            neighbours: Arc::clone(neighbours),
            passed_on: Arc::default(),
            read_at: Arc::default(),
        }
    }

    /// As [`Neighbours::view`], for the text that is to be passed on.
    pub(super) fn view(&self) -> (Arc<str>, Others) {
        let (name, others, changes) = self.neighbours.view_now(&self.path);
        let _ = self.read_at.set(changes);
        (name, others)
    }

    /// The same file, with a text that was not passed on yet.
    pub(super) fn anew(&self) -> Membership {
        Membership::new(self.path.clone(), &self.neighbours)
    }

    /// Tells the others what the file says now. Gives, once, who sees something else than before.
    pub(super) fn tell(&self, analysis: &Arc<Analysis>) -> News {
        if self.passed_on.set(()).is_err() {
            return News::default();
        }
        let read_at = self.read_at.get().copied();
        self.neighbours.analysed(&self.path, analysis, read_at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::position::Encoding;
    use crate::document::revision::Revision;

    #[test]
    fn a_new_file_is_looked_at_again_if_another_has_changed_meanwhile() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("ladder.toml"), "").unwrap();
        let neighbours = Arc::<Neighbours>::default();
        let open = |name: &str, text: &str| {
            let place = Membership::new(folder.path().join(name), &neighbours);
            Revision::on_disk(name, Encoding::Utf8, text, place)
        };
        let caller = open("caller.clad", "+--( )( z )--<CALL>( count )--+\n");
        let called = open("called.clad", "+--( )( y )--+\n+--<FUN>( count )--( )( y )--+\n");
        assert!(called.analysis().is_some());
        // Nobody knows of the function yet: the call concerns no other file.
        caller.tell_neighbours();
        let news = called.tell_neighbours();
        assert!(news.for_others && news.for_itself, "{news:?}");
        assert_eq!(called.tell_neighbours(), News::default());
    }
}

//! The other files of the workspaces that open documents belong to.
//!
//! A file that is open counts with the text that its editor shows, any other with the one on disk. What the files
//! show to each other is kept as [`Exports`]: a change that leaves those as they were concerns no other file.
//!
//! Everything here but [`Neighbours::opened`] may read the disk: for a blocking thread.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use ladder_analysis::{
    Analysis, AnalyzeOptions, Connect, Exported, Exports, Linked, NotWhole, Others, PlantError, PlantFile,
    RuleSettings, analyze, link_files, link_tasks, link_with_plants,
};
use ladder_notations::{Foreign, of_workspaces};
use ladder_workspace::{Disk, FileError, ForeignPrograms, Member, Plan, SETTINGS_FILE, Settings, Simulate};

use crate::folder::{First, Folder, Open, Shown, same};
use crate::on_disk::{FilesOnDisk, OnDisk, name_in};
use crate::seen::SettingsFile;

/// All workspaces, by their folders.
#[derive(Debug)]
pub struct Neighbours {
    /// Apart from the rest, which may be locked while files are read.
    shown: Shown,
    disk: Arc<dyn Disk>,
    foreign: Arc<ForeignPrograms>,
    state: Mutex<State>,
    /// Held by who reads the large files of a workspace, while the others go on.
    loading: Mutex<()>,
    /// Workspaces that are read in part. Locked before the state.
    first: Mutex<HashMap<PathBuf, InPart>>,
}

/// A workspace whose large files are being read, or nobody asked for yet.
#[derive(Debug)]
struct InPart {
    /// What its small files show to each other.
    exported: Arc<Exported>,
    settings: Settings,
    /// None while its large files are read.
    first: Option<First>,
    /// What [`State::begun`] was.
    begun: u64,
}

#[derive(Debug)]
struct State {
    disk: Arc<dyn Disk>,
    foreign: Arc<ForeignPrograms>,
    /// The same as above.
    shown: Shown,
    /// What holds where there is no settings file.
    defaults: Settings,
    roots: HashMap<PathBuf, PathBuf>,
    folders: HashMap<PathBuf, Folder>,
    /// How often all was forgotten.
    begun: u64,
}

/// Which files see something else once what a file exports has changed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Affected {
    /// The other ones.
    pub for_others: bool,
    /// The file itself: others have changed since it was read, when they could not know that it concerns it.
    pub for_itself: bool,
    /// The same is seen at other places.
    pub moved: bool,
}

impl Neighbours {
    /// The workspaces of a disk.
    pub fn on(disk: Arc<dyn Disk>) -> Neighbours {
        let shown = Shown::default();
        let foreign = Arc::new(ForeignPrograms::on(disk.clone()));
        let state = State {
            disk: disk.clone(),
            foreign: Arc::clone(&foreign),
            shown: shown.clone(),
            defaults: Settings::default(),
            roots: HashMap::new(),
            folders: HashMap::new(),
            begun: 0,
        };
        Neighbours {
            shown,
            foreign,
            disk,
            state: Mutex::new(state),
            loading: Mutex::default(),
            first: Mutex::default(),
        }
    }

    /// Where the files are.
    pub fn disk(&self) -> &Arc<dyn Disk> {
        &self.disk
    }

    /// The programs of other systems there.
    pub fn foreign(&self) -> &ForeignPrograms {
        &self.foreign
    }

    /// What a file is called in messages, and what it sees of the others.
    pub fn view(&self, path: &Path) -> (Arc<str>, Others) {
        let (name, others, _) = self.view_now(path);
        (name, others)
    }

    /// As [`Neighbours::view`], with the number of changes that it has in it.
    pub(crate) fn view_now(&self, path: &Path) -> (Arc<str>, Others, u64) {
        let mut state = self.loaded(path);
        let (root, folder) = state.folder(path);
        let name = name_in(&root, path);
        let others = folder.exported_for(&self.foreign, &root, path).others_of(&name);
        (name, others, folder.changes)
    }

    /// Enters the analysis of an open file, which was read when there had been this many changes.
    pub(crate) fn analysed(
        &self,
        path: &Path,
        (analysis, foreign): (&Arc<Analysis>, Option<&Arc<Foreign>>),
        read_at: Option<u64>,
    ) -> Affected {
        let exports = Arc::new(Exports::of(&analysis.context, &analysis.context.name));
        let mut state = self.loaded(path);
        let (root, folder) = state.folder(path);
        let is_guest = !folder.holds(&*self.disk, path);
        let before = folder.shown(path).cloned();
        let exported = folder.exported_for(&self.foreign, &root, path);
        let did_not_know = !is_guest && exported.did_not_know(&exports);
        let concerns = match &before {
            Some(before) => exported.concerns(before, &exports),
            None => true,
        };
        let changed = concerns && !is_guest;
        let moved = before.is_some_and(|before| !before.lies_the_same(&exports)) && !is_guest;
        let for_itself =
            did_not_know || (concerns && read_at.is_some_and(|read_at| read_at != folder.changes));
        let shown = folder.shown(path);
        if !shown.is_some_and(|before| before.says_the_same(&exports)) {
            folder.changes += 1;
        }
        let open = Open {
            exports,
            analysis: Arc::clone(analysis),
            foreign: foreign.cloned(),
        };
        folder.show(path, open);
        if changed {
            folder.exported = None;
        }
        Affected {
            for_others: changed,
            for_itself,
            moved,
        }
    }

    /// What the others see of a file lies at other places now, and one of them names one.
    pub fn places_moved(&self, path: &Path) {
        self.loaded(path).folder(path).1.exported = None;
    }

    /// An editor shows a file from now on: its text on disk does not count. Reads nothing, and waits for nobody who does.
    pub fn opened(&self, path: &Path) {
        self.shown.insert(path);
    }

    /// The editor has closed a file: the text on disk counts again. True if the others see something else now.
    pub fn closed(&self, path: &Path) -> bool {
        self.shown.remove(path);
        let mut state = self.loaded(path);
        let (root, folder) = state.folder(path);
        let before = folder.open.remove(path).map(|open| open.exports);
        let was_guest = !folder.holds(&*self.disk, path);
        folder.reread(&self.foreign, &root, path);
        folder.exported = None;
        !was_guest && !same(before.as_deref(), folder.shown(path).map(|exports| &**exports))
    }

    /// Files were changed, made or removed. True if any file sees something else now.
    pub fn disk_changed(&self, paths: &[PathBuf]) -> bool {
        for path in paths.iter().filter(|path| ladder_workspace::is_program(path)) {
            self.load(path);
        }
        let mut state = self.lock();
        if paths
            .iter()
            .any(|path| path.file_name().is_some_and(|name| name == SETTINGS_FILE))
        {
            // Which file belongs where may be another matter now.
            state.begin_again();
            return true;
        }
        let mut changed = false;
        for path in paths.iter().filter(|path| ladder_workspace::is_program(path)) {
            let own = state.folder(path).0;
            // What lies in a library is a program of those who name it as well.
            let holding = state
                .folders
                .iter_mut()
                .filter(|(root, folder)| **root == own || folder.settings.files.is_in_library(path));
            for (root, folder) in holding {
                let before = folder.shown(path).cloned();
                folder.reread(&self.foreign, root, path);
                let is_other = !same(before.as_deref(), folder.shown(path).map(|exports| &**exports));
                if folder.reread_readers(&self.foreign, root, path, before.as_deref()) || is_other {
                    folder.exported = None;
                    changed = true;
                }
            }
        }
        changed
    }

    /// What holds for programs that no settings file is above.
    pub fn set_defaults(&self, settings: Settings) {
        let mut state = self.lock();
        state.defaults = settings;
        state.begin_again();
    }

    /// Whether two files belong to one workspace, or one of them to the library of the other's.
    pub fn together(&self, a: &Path, b: &Path) -> bool {
        let mut state = self.lock();
        let (of_a, of_b) = (state.root(a), state.root(b));
        let holds = |root: &PathBuf, path: &Path| {
            let folder = state.folders.get(root);
            folder.is_some_and(|folder| folder.settings.files.is_in_library(path))
        };
        of_a == of_b || holds(&of_a, b) || holds(&of_b, a)
    }

    /// The folder of the workspace that a file belongs to.
    pub(crate) fn folder_of(&self, path: &Path) -> PathBuf {
        self.lock().root(path)
    }

    /// The files on disk of a file's workspace. Those that are open are among them, as they were when they were last
    /// saved.
    pub fn on_disk(&self, path: &Path) -> FilesOnDisk {
        let mut state = self.loaded(path);
        let (root, folder) = state.folder(path);
        let exported = Arc::clone(folder.exported_for(&self.foreign, &root, path));
        let files = folder.disk.iter().map(|(path, file)| {
            let open = folder.open.get(path);
            let shown = open.and_then(|open| Some(file.as_shown(open.foreign.as_ref()?, &open.exports)));
            (path.clone(), shown.map_or_else(|| Arc::clone(file), Arc::new))
        });
        FilesOnDisk {
            files: files.collect(),
            exported,
        }
    }

    /// What the workspace of a file asks for.
    pub fn format_options(&self, path: &Path) -> ladder_format::Options {
        self.settings(path, |settings| settings.format.clone())
    }

    /// The settings of the rules for a file.
    pub fn rules(&self, path: &Path) -> RuleSettings {
        self.settings(path, |settings| settings.rules_for(path))
    }

    /// How the workspace of a file has its programs run.
    pub fn simulate(&self, path: &Path) -> Simulate {
        self.settings(path, |settings| settings.simulate.clone())
    }

    /// The controller that its workspace watches.
    pub fn online(&self, path: &Path) -> Option<ladder_workspace::Online> {
        self.settings(path, |settings| settings.online.clone())
    }

    /// What its workspace serves on Modbus.
    pub fn served(&self, path: &Path) -> Option<ladder_workspace::ServeModbus> {
        self.settings(path, |settings| settings.modbus.clone())
    }

    /// The settings of its workspace, if they ask anything of its programs that may not fit them.
    pub fn that_may_misfit(&self, path: &Path) -> Option<Settings> {
        self.settings(path, |settings| settings.may_misfit().then(|| settings.clone()))
    }

    /// Asks the settings that hold for a file, which are known before large files are read.
    fn settings<T>(&self, path: &Path, ask: impl Fn(&Settings) -> T) -> T {
        let early = self.in_part(path, |_, part| ask(&part.settings));
        early.unwrap_or_else(|| ask(&self.loaded(path).folder(path).1.settings))
    }

    /// The settings file above a program.
    pub fn settings_file(&self, path: &Path) -> Option<Arc<SettingsFile>> {
        self.loaded(path).folder(path).1.settings_file.clone()
    }

    /// All settings files that were read.
    pub fn settings_files(&self) -> Vec<Arc<SettingsFile>> {
        let state = self.lock();
        let folders = state.folders.values();
        folders
            .filter_map(|folder| folder.settings_file.clone())
            .collect()
    }

    /// The analysis of a program: as its editor shows it if it is open, else as it is on disk.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn analysis_of(&self, path: &Path) -> Result<Arc<Analysis>, FileError> {
        let mut state = self.loaded(path);
        let (root, folder) = state.folder(path);
        if let Some(open) = folder.open.get(path) {
            return Ok(Arc::clone(&open.analysis));
        }
        let name = name_in(&root, path);
        let others = folder.exported_for(&self.foreign, &root, path).others_of(&name);
        let rules = folder.settings.rules_for(path);
        let known = folder.disk.get(path).cloned();
        drop(state);
        let parse = match known {
            Some(file) => file.parse(),
            // Excluded from the workspace, but a program all the same.
            None => Arc::new(ladder_syntax::parse(&self.text_on_disk(path)?)),
        };
        Ok(Arc::new(analyze(
            &parse,
            AnalyzeOptions::new(&name).among(&others).with_rules(&rules),
        )))
    }

    /// The ladder text of a file as it is on disk: of a settings file what its tasks run.
    ///
    /// # Errors
    /// It cannot be read, or has no tasks.
    pub fn text_on_disk(&self, path: &Path) -> Result<String, FileError> {
        if !is_settings(path) {
            return Ok(self.foreign.member(path, None)?.ladder().to_owned());
        }
        self.settings(path, |settings| {
            Ok(Plan::of(settings, path)?.text(&settings.format))
        })
    }

    /// All programs that were read and that no editor shows, sorted.
    pub fn closed_programs(&self) -> Vec<PathBuf> {
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
    pub fn closed_program(&self, path: &Path) -> Option<(Arc<OnDisk>, Arc<Exported>)> {
        let mut state = self.loaded(path);
        let (root, folder) = state.folder(path);
        let file = Arc::clone(folder.disk.get(path)?);
        Some((file, Arc::clone(folder.exported_for(&self.foreign, &root, path))))
    }

    /// Reads the workspace of a program, if that was not done. The others may go on meanwhile.
    pub fn load(&self, path: &Path) {
        if self.is_loaded(path) {
            return;
        }
        let _loading = self.loading.lock().unwrap_or_else(PoisonError::into_inner);
        let take = |root: &Path, part: &mut InPart| Some((root.to_owned(), part.begun, part.first.take()?));
        while let Some(Some((root, begun, first))) = self.in_part(path, take) {
            let folder = first.whole(&self.foreign, &root);
            self.parts().remove(&root);
            let mut state = self.lock();
            // Else other settings hold by now.
            if state.begun == begun {
                state.folders.entry(root).or_insert(folder);
                return;
            }
        }
    }

    /// Whether the workspace of a program is read.
    fn is_loaded(&self, path: &Path) -> bool {
        let mut state = self.lock();
        let root = state.root(path);
        state.folders.contains_key(&root)
    }

    /// As [`Neighbours::view`], of the small files of a workspace whose large ones are not read yet; nothing for one that is read.
    pub(crate) fn first_view(&self, path: &Path) -> Option<(Arc<str>, Others)> {
        self.in_part(path, |root, part| {
            let name = name_in(root, path);
            let others = part.exported.others_of(&name);
            (name, others)
        })
    }

    /// Asks the workspace of a program as far as it is read; nothing if that is the whole of it.
    fn in_part<T>(&self, path: &Path, ask: impl FnOnce(&Path, &mut InPart) -> T) -> Option<T> {
        let mut parts = self.parts();
        let (root, defaults, begun) = {
            let mut state = self.lock();
            let root = state.root(path);
            if state.folders.contains_key(&root) {
                return None;
            }
            (root, state.defaults.clone(), state.begun)
        };
        if parts.get(&root).is_none_or(|part| part.begun != begun) {
            let mut first = Folder::first(&self.foreign, path, &root, &defaults, &self.shown);
            if first.is_whole() {
                let mut state = self.lock();
                if state.begun == begun {
                    let folder = first.whole(&self.foreign, &root);
                    state.folders.entry(root).or_insert(folder);
                }
                return None;
            }
            let part = InPart {
                exported: first.exported(),
                settings: first.settings().clone(),
                first: Some(first),
                begun,
            };
            parts.insert(root.clone(), part);
        }
        parts.get_mut(&root).map(|part| ask(&root, part))
    }

    fn parts(&self) -> MutexGuard<'_, HashMap<PathBuf, InPart>> {
        self.first.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The state, in which the workspace of a program is read.
    fn loaded(&self, path: &Path) -> MutexGuard<'_, State> {
        self.load(path);
        self.lock()
    }

    /// Forgets the workspaces that no open file belongs to, but for those that are wanted.
    pub fn forget(&self, wanted: impl Fn(&Path) -> bool) {
        let mut state = self.lock();
        state
            .folders
            .retain(|root, folder| !folder.open.is_empty() || wanted(root));
    }

    /// The files that are not as they were read, for an editor that does not report changes. This looks at every
    /// file, but reads none.
    pub fn changed_on_disk(&self) -> Vec<PathBuf> {
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
            changed.extend(seen.changed(&*self.disk, &root));
        }
        // A settings file that is made or removed above a program gives it another workspace.
        let moved = open
            .iter()
            .find(|(path, root)| self.disk.root_of(path).is_ok_and(|found| found.folder() != root));
        changed.extend(moved.map(|(path, _)| path.with_file_name(SETTINGS_FILE)));
        changed
    }

    /// The file of a name, as findings and programs of another file know it: its path and text.
    pub fn text_of(&self, from: &Path, name: &str) -> Option<(PathBuf, Member)> {
        let mut state = self.loaded(from);
        let (root, folder) = state.folder(from);
        let open = folder
            .open
            .iter()
            .find(|(path, _)| *name_in(&root, path) == *name);
        if let Some((path, open)) = open {
            let text = match &open.foreign {
                Some(foreign) => Member::Foreign(Arc::clone(foreign)),
                None => Member::Ladder(open.analysis.context.parse.to_string()),
            };
            return Some((path.clone(), text));
        }
        let (path, file) = folder.disk.iter().find(|(_, file)| *file.name == *name)?;
        Some((path.clone(), file.member().clone()))
    }

    /// What runs: a file's program with what it uses of the others, and these.
    ///
    /// # Errors
    /// Something that it uses is missing, or has errors.
    pub fn link(&self, path: &Path, own: &Arc<Analysis>) -> Result<Linked, NotWhole> {
        let analysis = |name: &str| self.analysis_named(path, name);
        if !is_settings(path) {
            return self.checked(path, link_files(own, &analysis)?);
        }
        let linked = link_tasks(own, &self.programs_of_tasks(path)?, &analysis)?;
        self.checked(path, linked)
    }

    /// What runs beside models of its machine, which are these files with what is before the names of their tags. What is wrong with
    /// them comes with it; then it must not run.
    ///
    /// # Errors
    /// As for [`Neighbours::link`]; a plant has errors, too, or cannot be read.
    pub fn link_beside(
        &self,
        path: &Path,
        own: &Arc<Analysis>,
        plants: &[(PathBuf, String)],
        connects: &[Connect],
    ) -> Result<(Linked, Vec<PlantError>), NotWhole> {
        let analysis = |name: &str| self.analysis_named(path, name);
        let programs = if is_settings(path) {
            self.programs_of_tasks(path)?
        } else {
            Vec::new()
        };
        let plants = plants.iter().map(|(file, name)| {
            let missing = || NotWhole::Missing(Arc::from(file.to_string_lossy()));
            Ok(PlantFile {
                analysis: self.analysis_of(file).map_err(|_| missing())?,
                name: name.clone(),
            })
        });
        let plants = plants.collect::<Result<Vec<_>, NotWhole>>()?;
        let (linked, errors) = link_with_plants(own, &programs, (&plants, connects), &analysis)?;
        Ok((self.checked(path, linked)?, errors))
    }

    /// The main programs that the tasks of a settings file run, each with how many scans there are from one run to the next.
    fn programs_of_tasks(&self, path: &Path) -> Result<Vec<(Arc<Analysis>, u32)>, NotWhole> {
        let missing = |file: &Path| NotWhole::Missing(Arc::from(file.to_string_lossy()));
        let settings = self.settings(path, Settings::clone);
        let plan = Plan::of(&settings, path).map_err(|_| missing(path))?;
        let programs = plan.programs().map(|(program, every)| {
            let file = self.disk.locate(program).map_err(|_| missing(&program.path()))?;
            let program = self.analysis_of(&file).map_err(|_| missing(&file))?;
            Ok((program, every))
        });
        programs.collect()
    }

    /// The analysis of another file of the workspace, by its name.
    fn analysis_named(&self, path: &Path, name: &str) -> Option<Arc<Analysis>> {
        let mut state = self.loaded(path);
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
        let (path, file) = (path.clone(), Arc::clone(file));
        let others = folder.exported_for(&self.foreign, &root, &path).others_of(name);
        drop(state);
        Some(Arc::new(analyze(
            &file.parse(),
            AnalyzeOptions::new(name).among(&others).with_rules(&rules),
        )))
    }

    /// What runs, unless a file that it uses has errors before it is ladder text.
    fn checked(&self, path: &Path, linked: Linked) -> Result<Linked, NotWhole> {
        let is_broken = |name: &&Arc<str>| {
            of_workspaces(Path::new(&***name)).is_some()
                && self
                    .text_of(path, name)
                    .is_some_and(|(_, text)| text.foreign().is_some_and(|foreign| foreign.has_errors()))
        };
        let mut names = linked.others.iter().map(|other| &other.context.name);
        match names.find(is_broken).cloned() {
            Some(file) => Err(NotWhole::Errors(file)),
            None => Ok(linked),
        }
    }

    /// Whether the text of a program is held as it is on disk.
    #[cfg(test)]
    pub(crate) fn holds_text_of(&self, path: &Path) -> bool {
        let mut state = self.loaded(path);
        let (_, folder) = state.folder(path);
        folder.disk.get(path).is_some_and(|file| file.holds_text())
    }

    /// A panic elsewhere leaves at worst a file that is read again.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Whether a file is that of a workspace's settings, which runs as a program where it has tasks.
fn is_settings(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == SETTINGS_FILE)
}

impl State {
    /// Forgets what was read from disk, and reads it again when it is needed.
    fn begin_again(&mut self) {
        let open: Vec<(PathBuf, Open)> = self
            .folders
            .values_mut()
            .flat_map(|folder| folder.open.drain())
            .collect();
        self.begun += 1;
        self.folders.clear();
        self.roots.clear();
        for (path, open) in open {
            let (_, folder) = self.folder(&path);
            folder.show(&path, open);
            folder.exported = None;
        }
    }

    fn root(&mut self, path: &Path) -> PathBuf {
        let parent = path.parent().unwrap_or(path).to_owned();
        let found = self.roots.entry(parent).or_insert_with_key(|parent| {
            let root = self.disk.root_of(path).map(|root| root.folder().to_owned());
            root.unwrap_or_else(|_| parent.clone())
        });
        found.clone()
    }

    fn folder(&mut self, path: &Path) -> (PathBuf, &mut Folder) {
        let root = self.root(path);
        let (foreign, defaults, shown) = (&self.foreign, &self.defaults, &self.shown);
        let folder = self
            .folders
            .entry(root.clone())
            .or_insert_with(|| Folder::first(foreign, path, &root, defaults, shown).whole(foreign, &root));
        (root, folder)
    }
}

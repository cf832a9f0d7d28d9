//! Programs of other systems as their notations read them: with the files that belong to them.
//!
//! What belongs to a program lies in its folder, or anywhere in its project ([`Reach`]). The folder of a project is the nearest
//! one above the program with a settings file (LANGUAGE §4); else the one that a person opened or had searched; else the nearest one
//! with a project file of the other system; else the program's own.

use crate::disk::{Disk, SystemDisk};
use crate::error::{FileError, Problem};
use crate::member::Member;
use crate::root::Root;
use crate::settings::Settings;
use crate::stamp::Stamp;
use ladder_notations::{Bytes, Companion, Foreign, Notation, Reach, ReadError, Source, of_workspaces};
use ladder_syntax::MAX_FILE_BYTES;
use std::borrow::Cow;
use std::collections::HashMap;
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// This many names of a folder are checked: of a program in a larger folder, some files may be missed.
const MOST_NAMES: usize = 10_000;

/// This many files next to a program belong to it.
const MOST_FILES: usize = 100;

/// This many files of a project belong to a program, the nearest ones.
const MOST_FILES_OF_PROJECTS: usize = 5_000;

/// The programs of other systems on a disk. Files that belong to several are read once, until they change.
#[derive(Debug)]
pub struct ForeignPrograms {
    disk: Arc<dyn Disk>,
    opened: Mutex<Vec<PathBuf>>,
    known: Mutex<HashMap<PathBuf, (Stamp, Bytes)>>,
}

impl Default for ForeignPrograms {
    fn default() -> ForeignPrograms {
        ForeignPrograms::on(Arc::new(SystemDisk))
    }
}

impl ForeignPrograms {
    /// Those of a disk.
    pub fn on(disk: Arc<dyn Disk>) -> ForeignPrograms {
        ForeignPrograms {
            disk,
            opened: Mutex::default(),
            known: Mutex::default(),
        }
    }

    /// Says which folders a person has opened, or has searched: each is a project, if nothing in or above it says otherwise.
    pub fn open(&self, folders: &[PathBuf]) {
        *lock(&self.opened) = folders.iter().map(|folder| absolute(folder)).collect();
    }

    /// A program, whose content is at hand, with the files that belong to it. Every command and request that takes such a
    /// program has it from here.
    ///
    /// # Errors
    /// A file that belongs to it is not a regular file, lies outside, or cannot be read; or together they are larger than
    /// [`MAX_FILE_BYTES`].
    pub fn source<'s>(
        &self,
        notation: &dyn Notation,
        program: &'s Path,
        bytes: &'s [u8],
    ) -> Result<Source<'s>, FileError> {
        let whole = absolute(program);
        let folder = whole.parent().unwrap_or(Path::new(""));
        let (project, files) = match notation.reach() {
            Reach::Workspace => {
                let root = self
                    .disk
                    .root_of(&whole)
                    .unwrap_or(Root::Folder(folder.to_owned()));
                let files = self.disk.programs(&root, &self.settings_of(&root).files);
                (root.folder().to_owned(), files)
            }
            Reach::Folder => (folder.to_owned(), self.files_in(folder)),
            Reach::FolderAnd(inner) => {
                let mut files = self.files_in(folder);
                files.extend(self.files_in(&folder.join(inner)));
                (folder.to_owned(), files)
            }
            Reach::Project(mark) => {
                let project = self.project_of(&whole, mark);
                let files = self.disk.files_below(&project, MOST_NAMES);
                (project, files)
            }
        };
        self.source_among((notation, program), bytes, (&project, files))
    }

    /// A program of a workspace as it is on disk. `all` is the folder of that and its programs, where they are at hand.
    ///
    /// # Errors
    /// As for [`ForeignPrograms::source`], or the file is not in the notation that its name says.
    pub fn member(&self, path: &Path, all: Option<(&Path, &[PathBuf])>) -> Result<Member, FileError> {
        let text = self.disk.read_own(path)?;
        let Some(notation) = of_workspaces(path) else {
            return Ok(Member::Ladder(text));
        };
        let bytes = text.as_bytes();
        let source = match all {
            Some((root, all)) => self.source_among((notation, path), bytes, (root, all.to_vec()))?,
            None => self.source(notation, path, bytes)?,
        };
        let broken = |error: ReadError| FileError::new(path, Problem::Broken(error.to_string()));
        let foreign = Foreign::read(notation, &source).map_err(broken)?;
        Ok(Member::Foreign(Arc::new(foreign)))
    }

    /// A program with those of the files that belong to it. In a workspace a file that cannot be read is left out: each is usable
    /// next to one that is not.
    fn source_among<'s>(
        &self,
        (notation, program): (&dyn Notation, &'s Path),
        bytes: &'s [u8],
        (project, files): (&Path, Vec<PathBuf>),
    ) -> Result<Source<'s>, FileError> {
        let whole = absolute(program);
        let is_in_workspace = notation.reach() == Reach::Workspace;
        let mut size = 0;
        let mut read = |(name, path): (String, PathBuf)| {
            let bytes = match self.content(project, &path) {
                Err(_) if is_in_workspace => return Ok(None),
                content => content?,
            };
            size += bytes.len();
            if size > MAX_FILE_BYTES {
                return Err(FileError::new(
                    program,
                    Problem::ProjectTooLarge(project.to_owned()),
                ));
            }
            Ok(Some(Companion { name, bytes }))
        };
        let belonging = belonging(notation, &whole, files).into_iter();
        Ok(Source {
            name: stem(program),
            bytes,
            companions: belonging
                .filter_map(|file| read(file).transpose())
                .collect::<Result<_, _>>()?,
        })
    }

    /// Whether a file belongs to a program.
    pub fn is_companion(&self, notation: &dyn Notation, program: &Path, file: &Path) -> bool {
        let (program, file) = (absolute(program), absolute(file));
        let is_in_project = match notation.reach() {
            Reach::Project(mark) => file.starts_with(self.project_of(&program, mark)),
            Reach::Workspace => self.disk.root_of(&program).ok() == self.disk.root_of(&file).ok(),
            Reach::Folder | Reach::FolderAnd(_) => true,
        };
        is_in_project && !belonging(notation, &program, vec![file]).is_empty()
    }

    /// What lies in a folder. One that cannot be read, as that of a program from standard input, has nothing.
    fn files_in(&self, folder: &Path) -> Vec<PathBuf> {
        let names = self.disk.names_in(folder, MOST_NAMES).into_iter();
        names.map(|name| folder.join(name)).collect()
    }

    /// The content of a file that was found below a folder. Links do not lead out of that or the workspace.
    fn content(&self, project: &Path, path: &Path) -> Result<Bytes, FileError> {
        let stamp = self.disk.stamp(path);
        if let Some((known, content)) = lock(&self.known).get(path)
            && *known == stamp
        {
            return Ok(content.clone());
        }
        let content = Bytes::from(self.disk.read_below(project, path)?);
        lock(&self.known).insert(path.to_owned(), (stamp, content.clone()));
        Ok(content)
    }

    /// The settings of a workspace, as far as they can be read.
    fn settings_of(&self, root: &Root) -> Settings {
        let read = |file: PathBuf| Some(Settings::examine(&file, &self.disk.settings_text(&file).ok()?).0);
        root.settings_file().and_then(read).unwrap_or_default()
    }

    /// The disk that they are on.
    pub fn disk(&self) -> &Arc<dyn Disk> {
        &self.disk
    }

    /// The folder of the project that a program belongs to.
    fn project_of(&self, program: &Path, mark: Option<&str>) -> PathBuf {
        let own = program.parent().unwrap_or(Path::new(""));
        if let Ok(Root::Settings(folder)) = self.disk.root_of(program) {
            return folder;
        }
        let opened = lock(&self.opened);
        if let Some(opened) = own
            .ancestors()
            .find(|folder| opened.iter().any(|opened| opened == folder))
        {
            return opened.to_owned();
        }
        let is_marked = |folder: &&Path| {
            let names = self.disk.names_in(folder, MOST_NAMES);
            mark.is_some_and(|mark| names.iter().any(|name| name.ends_with(mark)))
        };
        let marked = mark.and_then(|_| own.ancestors().find(is_marked));
        marked.unwrap_or(own).to_owned()
    }
}

/// Which files belong to a program, of those in its project, by their names as they are seen from its folder, the nearest first.
pub fn belonging(notation: &dyn Notation, program: &Path, files: Vec<PathBuf>) -> Vec<(String, PathBuf)> {
    let folder = program.parent().unwrap_or(Path::new(""));
    let stem = stem(program);
    let (inner, most) = match notation.reach() {
        Reach::Folder => (Some(None), MOST_FILES),
        Reach::FolderAnd(inner) => (Some(Some(inner)), MOST_FILES),
        Reach::Project(_) | Reach::Workspace => (None, MOST_FILES_OF_PROJECTS),
    };
    let is_near = |name: &str| match (inner, name.rsplit_once('/')) {
        (None, _) | (_, None) => true,
        (Some(inner), Some((folder, _))) => inner == Some(folder),
    };
    let files = files.into_iter().filter(|path| path != program);
    let mut named: Vec<(String, PathBuf)> = files
        .map(|path| (seen_from(folder, &path), path))
        .filter(|(name, _)| is_near(name) && notation.has_companion(&stem, name))
        .collect();
    named.sort_by_cached_key(|(name, _)| (name.matches('/').count(), name.clone()));
    named.truncate(most);
    named
}

fn stem(program: &Path) -> Cow<'_, str> {
    program
        .file_stem()
        .map(OsStr::to_string_lossy)
        .unwrap_or_default()
}

fn lock<T>(shared: &Mutex<T>) -> MutexGuard<'_, T> {
    shared.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A path from the top on. Without a current folder it stays what it is.
fn absolute(path: &Path) -> PathBuf {
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// A file's name as it is seen from a folder, with `/` on every system.
fn seen_from(folder: &Path, file: &Path) -> String {
    let above = folder.ancestors().find(|above| file.starts_with(above));
    let above = above.unwrap_or(Path::new(""));
    let up = folder
        .strip_prefix(above)
        .map_or(0, |below| below.components().count());
    let below = file.strip_prefix(above).unwrap_or(file).components();
    let below = below.map(Component::as_os_str).map(|part| part.to_string_lossy());
    let parts: Vec<_> = std::iter::repeat_n("..".into(), up).chain(below).collect();
    parts.join("/")
}

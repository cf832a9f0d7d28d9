//! Which files are meant when a person names files and folders.

mod ignored;
mod walk;

pub(crate) use ignored::is_ignored;
pub(crate) use walk::is_own_file;

use crate::error::{FileError, Problem};
use crate::named;
use crate::root::{Root, SETTINGS_FILE, is_ladder_text, is_program};
use crate::settings::{Files, Settings};
use ladder_analysis::Cancel;
use std::collections::{HashMap, HashSet};
use std::io;
use std::path::{Path, PathBuf};
use walk::Walker;

/// What the name of a scenario file ends in, without the dot.
pub const SCENARIO_EXTENSION: &str = "ladder-test";

/// Whether a file holds scenarios by its name.
pub fn is_scenario(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case(SCENARIO_EXTENSION))
}

/// What the name of a scene ends in: a drawing of the machine.
const SCENE: &str = ".scene.svg";

/// What the name of a scene has before its ending; none of another file.
pub fn scene_stem(path: &Path) -> Option<&str> {
    let name = path.file_name()?.to_str()?;
    let at = name.len().checked_sub(SCENE.len())?;
    let ending = name.get(at..)?;
    ending.eq_ignore_ascii_case(SCENE).then(|| &name[..at])
}

/// Whether a file is a scene by its name.
pub fn is_scene(path: &Path) -> bool {
    scene_stem(path).is_some()
}

/// Whether a file names the tags of a program next to it: scenarios do, and scenes.
pub(crate) fn is_companion(path: &Path) -> bool {
    is_scenario(path) || is_scene(path)
}

/// Which files of a folder are meant.
#[derive(Clone, Copy)]
enum Wanted<'w> {
    Programs,
    LadderText,
    Scenarios,
    /// Those that the caller knows by their names.
    Others(&'w dyn Fn(&Path) -> bool),
}

/// The programs that the paths stand for, in the order of the paths; those of a folder sorted, sub-folders
/// included. A file that is named is taken whatever its name; in folders hidden files, and what `.gitignore` and
/// `.ignore` exclude, are passed over, and what the settings of a workspace exclude. Nothing is listed twice.
///
/// What is wrong with single paths does not keep the others from being found: it is in the second list.
pub fn find_programs(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<FileError>) {
    find(paths, Wanted::Programs)
}

/// The programs in ladder text that the paths stand for, by the rules of [`find_programs`].
pub fn find_ladder_text(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<FileError>) {
    find(paths, Wanted::LadderText)
}

/// The scenario files that the paths stand for, by the rules of [`find_programs`].
pub fn find_scenarios(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<FileError>) {
    find(paths, Wanted::Scenarios)
}

/// Files of another kind that the paths stand for, by the rules of [`find_programs`]; `wanted` knows them by their names.
pub fn find_files(paths: &[PathBuf], wanted: &dyn Fn(&Path) -> bool) -> (Vec<PathBuf>, Vec<FileError>) {
    find(paths, Wanted::Others(wanted))
}

fn find(paths: &[PathBuf], wanted: Wanted<'_>) -> (Vec<PathBuf>, Vec<FileError>) {
    let mut search = Search::new(wanted);
    for path in paths {
        match std::fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => search.folder(path),
            Ok(_) => search.take(path.clone()),
            Err(error) => search.errors.push(FileError::reading(path, error)),
        }
    }
    (search.found, search.errors)
}

impl Root {
    /// The programs of the workspace, sorted; `files` are those that its settings ask for. What cannot be read is
    /// left out: a program must be usable next to a folder that is not.
    pub fn programs(&self, files: &Files) -> Vec<PathBuf> {
        match self {
            Root::Settings(folder) => {
                let mut programs = programs_below(folder, None);
                programs.retain(|program| files.contain(program));
                for library in files.library() {
                    // A link may point out of the workspace.
                    if library
                        .named
                        .locate()
                        .is_ok_and(|located| located == library.path)
                    {
                        programs.extend(programs_of_library(&library.path));
                    }
                }
                programs.sort();
                programs.dedup();
                programs
            }
            Root::Folder(folder) => {
                let mut programs = programs_below(folder, Some(1));
                programs.retain(|path| path.parent() == Some(folder));
                programs
            }
        }
    }

    /// Whether a program is one of the workspace: it is not hidden, nor excluded. It need not be there.
    pub fn holds(&self, program: &Path, files: &Files) -> bool {
        if files.is_in_library(program) {
            return true;
        }
        let Ok(below) = program.strip_prefix(self.folder()) else {
            return false;
        };
        let mut parts = below.components();
        let is_hidden = parts.any(|part| part.as_os_str().as_encoded_bytes().starts_with(b"."));
        !is_hidden && files.contain(program) && !is_ignored(program)
    }
}

/// The programs of one workspace, sorted: those below its folder, as deep as that, but not those below another settings file.
pub(crate) fn programs_below(root: &Path, depth: Option<usize>) -> Vec<PathBuf> {
    let Ok(mut walk) = Walker::below(root, |entry| !entry.path().join(SETTINGS_FILE).is_file()) else {
        return Vec::new();
    };
    walk.builder
        .max_depth(depth)
        .build()
        .filter_map(Result::ok)
        .map(ignore::DirEntry::into_path)
        .filter(|path| is_program(path) && is_own_file(root, path))
        .collect()
}

/// The programs in a folder of a library, which may be a workspace of its own, but not those of others in it. Whether what is above
/// passes over the folder does not matter: it is named.
fn programs_of_library(folder: &Path) -> Vec<PathBuf> {
    let is_wanted =
        |entry: &ignore::DirEntry| entry.depth() == 0 || !entry.path().join(SETTINGS_FILE).is_file();
    let Ok(mut walk) = Walker::below(folder, is_wanted) else {
        return Vec::new();
    };
    let entries = walk.builder.parents(false).build().filter_map(Result::ok);
    entries
        .map(ignore::DirEntry::into_path)
        .filter(|path| is_program(path) && is_own_file(folder, path))
        .collect()
}

/// The files below a folder, by the rules of [`find_programs`], up to so many files and folders.
pub(crate) fn files_below(folder: &Path, most: usize) -> Vec<PathBuf> {
    let Ok(walk) = Walker::below(folder, |_| true) else {
        return Vec::new();
    };
    let entries = walk.builder.build().take(most).filter_map(Result::ok);
    let paths = entries.map(ignore::DirEntry::into_path);
    paths.filter(|path| is_own_file(folder, path)).collect()
}

/// What lies below a folder that a person works in.
#[derive(Debug, Default)]
pub struct Survey {
    /// The programs, whichever workspace they belong to.
    pub programs: Vec<PathBuf>,
    /// The settings files.
    pub settings_files: Vec<PathBuf>,
    /// Whether all of it was seen, but for what was refused.
    pub whole: bool,
    /// Why folders were not entered.
    pub refused: Vec<FileError>,
}

/// Looks what lies below a folder, by the rules of `.gitignore`, but not at more files and folders than `most`: a
/// person may have opened the root of a disk. What is cancelled is not whole.
pub fn survey(folder: &Path, most: usize, cancel: &Cancel) -> Survey {
    let mut found = Survey::default();
    let walk = match Walker::below(folder, |_| true) {
        Ok(walk) => walk,
        Err(error) => {
            found.whole = true;
            found.refused.push(error);
            return found;
        }
    };
    for (seen, entry) in walk.builder.build().enumerate() {
        if seen >= most || cancel.is_cancelled() {
            return found;
        }
        let Ok(entry) = entry else { continue };
        let path = entry.path();
        if is_program(path) && is_own_file(folder, path) {
            found.programs.push(entry.into_path());
        } else if path.file_name().is_some_and(|name| name == SETTINGS_FILE) && is_own_file(folder, path) {
            found.settings_files.push(entry.into_path());
        }
    }
    found.whole = true;
    found.refused = walk.refused();
    found
}

struct Search<'w> {
    wanted: Wanted<'w>,
    found: Vec<PathBuf>,
    /// The files of `found`, by their true paths: `.` and `motor.clad` name one file twice.
    seen: HashSet<PathBuf>,
    /// By folder, which of its files belong to the workspace.
    belonging: HashMap<PathBuf, Files>,
    errors: Vec<FileError>,
}

impl<'w> Search<'w> {
    fn new(wanted: Wanted<'w>) -> Search<'w> {
        Search {
            wanted,
            found: Vec::new(),
            seen: HashSet::new(),
            belonging: HashMap::new(),
            errors: Vec::new(),
        }
    }

    fn wants(&self, path: &Path) -> bool {
        match self.wanted {
            Wanted::Programs => is_program(path),
            Wanted::LadderText => is_ladder_text(path),
            Wanted::Scenarios => is_scenario(path),
            Wanted::Others(is_wanted) => is_wanted(path),
        }
    }

    fn take(&mut self, path: PathBuf) {
        let true_path = path.canonicalize().unwrap_or_else(|_| path.clone());
        if self.seen.insert(true_path) {
            self.found.push(path);
        }
    }

    fn folder(&mut self, folder: &Path) {
        let walk = match Walker::below(folder, |_| true) {
            Ok(walk) => walk,
            Err(error) => return self.errors.push(error),
        };
        let mut empty = true;
        for entry in walk.builder.build() {
            match entry {
                // A linked file is a program like any other, a linked folder is not entered.
                Ok(entry)
                    if self.wants(entry.path())
                        && entry.path_is_symlink()
                        && !named::stays_inside(folder, entry.path()) =>
                {
                    if self.belongs(entry.path()) {
                        let path = without_dot(folder, entry.into_path());
                        self.errors.push(FileError::new(&path, Problem::Outside));
                    }
                }
                Ok(entry) if self.wants(entry.path()) && entry.path().is_file() => {
                    empty = false;
                    if self.belongs(entry.path()) {
                        self.take(without_dot(folder, entry.into_path()));
                    }
                }
                Ok(_) => {}
                Err(error) => self.unreadable(folder, &error),
            }
        }
        self.errors.extend(walk.refused());
        if empty && self.errors.iter().all(|error| !error.path.starts_with(folder)) {
            self.errors.push(FileError::new(
                folder,
                match self.wanted {
                    Wanted::Programs => Problem::NoPrograms,
                    Wanted::LadderText => Problem::NoLadderText,
                    Wanted::Scenarios => Problem::NoScenarios,
                    Wanted::Others(_) => Problem::NoneOfThese,
                },
            ));
        }
    }

    /// Whether the settings above a file do not exclude it. Settings that cannot be read exclude nothing: a command that
    /// needs them says what is wrong with them.
    fn belongs(&mut self, path: &Path) -> bool {
        let Ok(path) = std::path::absolute(path) else {
            return true;
        };
        let folder = path.parent().unwrap_or(&path).to_owned();
        let files = self.belonging.entry(folder).or_insert_with(|| {
            let settings = Settings::of(&path);
            settings.map(|settings| settings.files).unwrap_or_default()
        });
        files.contain(&path)
    }

    fn unreadable(&mut self, folder: &Path, error: &ignore::Error) {
        let path = path_of(error).unwrap_or(folder).to_owned();
        let problem = match error.io_error() {
            Some(cause) => Problem::Read(io::Error::from(cause.kind())),
            None => Problem::Read(io::Error::other(error.to_string())),
        };
        self.errors.push(FileError { path, problem });
    }
}

/// `./motor.clad` is shown as `motor.clad`.
fn without_dot(folder: &Path, path: PathBuf) -> PathBuf {
    if folder != Path::new(".") {
        return path;
    }
    match path.strip_prefix(".") {
        Ok(stripped) => stripped.to_owned(),
        Err(_) => path,
    }
}

fn path_of(error: &ignore::Error) -> Option<&Path> {
    match error {
        ignore::Error::WithPath { path, .. } => Some(path),
        ignore::Error::WithDepth { err, .. } | ignore::Error::WithLineNumber { err, .. } => path_of(err),
        _ => None,
    }
}

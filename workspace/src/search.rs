//! Which files are meant when a person names files and folders.

use crate::{FileError, Problem};
use ignore::WalkBuilder;
use std::collections::HashSet;
use std::io;
use std::path::{Path, PathBuf};

/// What the name of a program ends in, without the dot.
pub const EXTENSION: &str = "clad";

/// Whether a file is a program by its name.
pub fn is_program(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension.eq_ignore_ascii_case(EXTENSION))
}

/// The programs that the paths stand for, in the order of the paths; those of a folder sorted, sub-folders
/// included. A file that is named is taken whatever its name; in folders hidden files, and what `.gitignore` and
/// `.ignore` exclude, are passed over. Nothing is listed twice.
///
/// What is wrong with single paths does not keep the others from being found: it is in the second list.
pub fn find_programs(paths: &[PathBuf]) -> (Vec<PathBuf>, Vec<FileError>) {
    let mut search = Search::default();
    for path in paths {
        match std::fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => search.folder(path),
            Ok(_) => search.take(path.clone()),
            Err(error) => search.errors.push(FileError::reading(path, error)),
        }
    }
    (search.found, search.errors)
}

#[derive(Default)]
struct Search {
    found: Vec<PathBuf>,
    /// The files behind `found`, by their true paths: `.` and `motor.clad` name one file twice.
    seen: HashSet<PathBuf>,
    errors: Vec<FileError>,
}

impl Search {
    fn take(&mut self, path: PathBuf) {
        let true_path = path.canonicalize().unwrap_or_else(|_| path.clone());
        if self.seen.insert(true_path) {
            self.found.push(path);
        }
    }

    fn folder(&mut self, folder: &Path) {
        let mut empty = true;
        // A folder that is no repository (yet) has its `.gitignore` obeyed too.
        let walk = WalkBuilder::new(folder)
            .require_git(false)
            .sort_by_file_path(Path::cmp)
            .build();
        for entry in walk {
            match entry {
                // Asked through links: a linked file is a program like any other, a linked folder is not entered.
                Ok(entry) if is_program(entry.path()) && entry.path().is_file() => {
                    empty = false;
                    self.take(without_dot(folder, entry.into_path()));
                }
                Ok(_) => {}
                Err(error) => self.unreadable(folder, &error),
            }
        }
        if empty && self.errors.iter().all(|error| !error.path.starts_with(folder)) {
            self.errors.push(FileError::new(folder, Problem::NoPrograms));
        }
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

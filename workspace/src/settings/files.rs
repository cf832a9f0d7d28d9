//! `[workspace]`: which files belong to it.

use super::given::Given;
use super::reader::{Reader, Table};
use super::table::{EXCLUDE, INCLUDE, LIBRARY};
use crate::error::{FileError, Problem};
use crate::named::Named;
use ignore::gitignore::{Gitignore, GitignoreBuilder};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The programs of a workspace. Patterns are those of `.gitignore`, seen from the settings file's folder.
#[derive(Debug, Clone, Default)]
pub struct Files {
    /// Only what matches one of these; without them everything.
    include: Option<Gitignore>,
    /// But not what matches one of these.
    exclude: Option<Gitignore>,
    /// And all in these folders.
    library: Vec<LibraryFolder>,
}

/// A folder of blocks inside of the workspace, which may be one of its own: a repository in the repository.
#[derive(Debug, Clone)]
pub(crate) struct LibraryFolder {
    /// As the settings file names it.
    pub(crate) name: String,
    pub(crate) named: Named,
    /// Where it lies, if no link is on the way.
    pub(crate) path: PathBuf,
    /// Where the settings file names it.
    pub(crate) range: Range<usize>,
}

impl Files {
    /// Whether a program below the settings file's folder belongs to the workspace.
    pub fn contain(&self, program: &Path) -> bool {
        let matches = |patterns: &Gitignore| covers(patterns, program);
        self.is_in_library(program)
            || self.include.as_ref().is_none_or(matches) && !self.exclude.as_ref().is_some_and(matches)
    }

    /// Whether a program lies in a folder of the library, which may be a workspace of its own.
    pub fn is_in_library(&self, program: &Path) -> bool {
        self.library
            .iter()
            .any(|folder| program.starts_with(&folder.path))
    }

    /// The folders of the library.
    pub(crate) fn library(&self) -> &[LibraryFolder] {
        &self.library
    }
}

/// Whether a file matches patterns.
pub(super) fn covers(patterns: &Gitignore, program: &Path) -> bool {
    // What does not lie below the folder is none of its business (and would be a panic).
    program.starts_with(patterns.path()) && patterns.matched_path_or_any_parents(program, false).is_ignore()
}

pub(super) fn read(mut table: Table, folder: &Path, reader: &mut Reader) -> Files {
    let include = reader.take(&mut table, &INCLUDE);
    let exclude = reader.take(&mut table, &EXCLUDE);
    let library = reader.take(&mut table, &LIBRARY);
    table.finish(reader);
    Files {
        library: library.map_or_else(Vec::new, |given| folders(&given, folder, reader)),
        include: include.map(|given| patterns(&given, "\"lines/**\"", folder, reader)),
        exclude: exclude.map(|given| patterns(&given, "\"old/\"", folder, reader)),
    }
}

/// The folders of the library.
fn folders(given: &Given, folder: &Path, reader: &mut Reader) -> Vec<LibraryFolder> {
    let mut folders = Vec::new();
    for (range, name) in reader.texts(given, "\"blocks\"") {
        let named = Named::in_settings(folder, &name);
        let located = named.locate_without_links();
        match named
            .error()
            .map_or(located, |problem| Err(FileError::new(folder, problem)))
        {
            Ok(path) => folders.push(LibraryFolder {
                name,
                named,
                path,
                range,
            }),
            Err(error) => {
                let problem = match error.problem {
                    Problem::Directory => {
                        "name a folder in the workspace, whose own programs are seen anyway".to_owned()
                    }
                    problem => problem.to_string(),
                };
                reader.wrong(range, format!("`{name}` cannot be used: {problem}"));
            }
        }
    }
    folders
}

/// Patterns as in `.gitignore`, seen from a folder. `example` shows one.
pub(super) fn patterns(given: &Given, example: &str, folder: &Path, reader: &mut Reader) -> Gitignore {
    let mut builder = GitignoreBuilder::new(folder);
    for (range, pattern) in reader.texts(given, example) {
        if pattern.split('/').any(|part| part == "..") {
            reader.wrong(
                range,
                format!(
                    "`{pattern}` leads out of the workspace: patterns are seen from the folder of ladder.toml"
                ),
            );
        } else if let Err(error) = builder.add_line(None, &pattern) {
            reader.wrong(
                range,
                format!("`{pattern}` is not a pattern as in .gitignore: {}", plain(&error)),
            );
        }
    }
    builder.build().unwrap_or_else(|_| Gitignore::empty())
}

fn plain(error: &ignore::Error) -> String {
    match error {
        ignore::Error::Glob { err, .. } => err.clone(),
        other => other.to_string(),
    }
}

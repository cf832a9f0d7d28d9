//! `[workspace]`: which files belong to it.

use super::given::Given;
use super::reader::{Reader, Table};
use super::table::{EXCLUDE, INCLUDE};
use ignore::gitignore::{Gitignore, GitignoreBuilder};
use std::path::Path;

/// The programs of a workspace. Patterns are those of `.gitignore`, seen from the settings file's folder.
#[derive(Debug, Clone, Default)]
pub struct Files {
    /// Only what matches one of these; without them everything.
    include: Option<Gitignore>,
    /// But not what matches one of these.
    exclude: Option<Gitignore>,
}

impl Files {
    /// Whether a program below the settings file's folder belongs to the workspace.
    pub fn contain(&self, program: &Path) -> bool {
        let matches = |patterns: &Gitignore| covers(patterns, program);
        self.include.as_ref().is_none_or(matches) && !self.exclude.as_ref().is_some_and(matches)
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
    table.finish(reader);
    Files {
        include: include.map(|given| patterns(&given, "\"lines/**\"", folder, reader)),
        exclude: exclude.map(|given| patterns(&given, "\"old/\"", folder, reader)),
    }
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

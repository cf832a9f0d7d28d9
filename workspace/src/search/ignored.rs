//! Whether ignore files exclude one file, which nobody searches for.

use super::walk::ignore_files;
use crate::root::SETTINGS_FILE;
use ignore::Match;
use ignore::gitignore::Gitignore;
use std::path::Path;

/// Whether a `.gitignore` or `.ignore` in a folder above a file excludes it, up to the repository it lies in. The nearest that
/// says something about it decides. The file need not exist.
pub(crate) fn is_ignored(file: &Path) -> bool {
    for folder in file.ancestors().skip(1) {
        // What cannot be read says nothing, as in a search.
        if ignore_files(folder).is_err() {
            continue;
        }
        for name in [".ignore", ".gitignore"] {
            let patterns = folder.join(name);
            if !patterns.is_file() {
                continue;
            }
            // A pattern that cannot be read says nothing, as in a search.
            let (patterns, _) = Gitignore::new(patterns);
            match patterns.matched_path_or_any_parents(file, false) {
                Match::Ignore(_) => return true,
                Match::Whitelist(_) => return false,
                Match::None => {}
            }
        }
        // What is above a repository or a workspace does not belong to it.
        if folder.join(".git").exists() || folder.join(SETTINGS_FILE).is_file() && !in_repository(folder) {
            return false;
        }
    }
    false
}

fn in_repository(folder: &Path) -> bool {
    folder.ancestors().any(|above| above.join(".git").exists())
}

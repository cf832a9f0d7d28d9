//! Whether a file that the user named is one that a search would pass over.

use crate::search::is_ignored;
use crate::settings::Settings;
use std::path::Path;

/// Whether the settings of its workspace exclude a file, or a `.gitignore` or `.ignore` in a folder above it does, up to
/// the repository it lies in. The file need not exist. Settings that cannot be used exclude nothing: a command that needs
/// them says what is wrong with them.
pub fn is_excluded(file: &Path) -> bool {
    let Ok(file) = std::path::absolute(file) else {
        return false;
    };
    let settings = Settings::of(&file).unwrap_or_default();
    !settings.files.contain(&file) || is_ignored(&file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn settings_and_ignore_files() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir_all(at("old/deep")).unwrap();
        fs::create_dir_all(at("lines")).unwrap();
        fs::write(at("ladder.toml"), "[workspace]\nexclude = [\"old/\"]\n").unwrap();
        fs::write(at(".gitignore"), "*.made.clad\n").unwrap();
        fs::write(at("lines/.ignore"), "spare.clad\n!kept.made.clad\n").unwrap();
        let excluded = |name: &str| is_excluded(&at(name));
        assert!(excluded("old/a.clad"));
        assert!(excluded("old/deep/a.clad"));
        assert!(excluded("a.made.clad"));
        assert!(excluded("lines/a.made.clad"));
        assert!(excluded("lines/spare.clad"));
        assert!(!excluded("lines/kept.made.clad"));
        assert!(!excluded("spare.clad"));
        assert!(!excluded("a.clad"));
        assert!(!excluded("not-there/a.clad"));
    }
}

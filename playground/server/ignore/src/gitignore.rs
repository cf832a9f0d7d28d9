//! Patterns.

use crate::{Error, Match};
use std::path::{Path, PathBuf};

/// One pattern.
#[derive(Debug, Clone)]
pub struct Glob {
    /// The names of the way, from the folder of the patterns on.
    parts: Vec<String>,
    is_folder: bool,
    is_whitelist: bool,
}

/// Patterns, seen from a folder.
#[derive(Debug, Clone)]
pub struct Gitignore {
    root: PathBuf,
    globs: Vec<Glob>,
}

impl Gitignore {
    /// The patterns of a file of the operating system, which there is none of.
    pub fn new(_file: impl AsRef<Path>) -> (Gitignore, Option<Error>) {
        (Gitignore::empty(), None)
    }

    /// No patterns.
    pub fn empty() -> Gitignore {
        GitignoreBuilder::new("").0
    }

    /// The folder that they are seen from.
    pub fn path(&self) -> &Path {
        &self.root
    }

    /// What the patterns say of a file below their folder, or of a folder that it lies in: the last one decides.
    pub fn matched_path_or_any_parents(&self, path: impl AsRef<Path>, is_folder: bool) -> Match<&Glob> {
        let path = path.as_ref();
        let below = path.strip_prefix(&self.root).unwrap_or(path);
        let names: Vec<_> = below.iter().map(|name| name.to_string_lossy()).collect();
        let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
        for length in (1..=names.len()).rev() {
            let is_folder = is_folder || length < names.len();
            let found = self
                .globs
                .iter()
                .rev()
                .find(|glob| (is_folder || !glob.is_folder) && covers(&glob.parts, &names[..length]));
            match found {
                Some(glob) if glob.is_whitelist => return Match::Whitelist(glob),
                Some(glob) => return Match::Ignore(glob),
                None => {}
            }
        }
        Match::None
    }
}

/// Makes patterns.
#[derive(Debug)]
pub struct GitignoreBuilder(Gitignore);

impl GitignoreBuilder {
    /// None yet, seen from this folder.
    pub fn new(root: impl AsRef<Path>) -> GitignoreBuilder {
        GitignoreBuilder(Gitignore {
            root: root.as_ref().to_owned(),
            globs: Vec::new(),
        })
    }

    /// Adds a pattern.
    ///
    /// # Errors
    /// It has what is not known here.
    pub fn add_line(&mut self, _from: Option<PathBuf>, line: &str) -> Result<&mut GitignoreBuilder, Error> {
        let line = line.trim_end();
        if line.is_empty() || line.starts_with('#') {
            return Ok(self);
        }
        if line.contains(['[', '{', '\\']) {
            return Err(Error::Glob {
                glob: Some(line.to_owned()),
                err: "in a page a pattern has `*`, `**` and `?` only".to_owned(),
            });
        }
        let (is_whitelist, line) = line.strip_prefix('!').map_or((false, line), |rest| (true, rest));
        let (is_folder, line) = line.strip_suffix('/').map_or((false, line), |rest| (true, rest));
        let is_anywhere = !line.contains('/');
        let parts = line.trim_start_matches('/').split('/').map(str::to_owned);
        self.0.globs.push(Glob {
            parts: is_anywhere
                .then(|| "**".to_owned())
                .into_iter()
                .chain(parts)
                .collect(),
            is_folder,
            is_whitelist,
        });
        Ok(self)
    }

    /// The patterns.
    ///
    /// # Errors
    /// There are none.
    pub fn build(&self) -> Result<Gitignore, Error> {
        Ok(self.0.clone())
    }
}

/// Whether a pattern covers a way.
fn covers(parts: &[String], names: &[&str]) -> bool {
    match (parts.split_first(), names.split_first()) {
        (None, _) => names.is_empty(),
        // At the end it is what lies below, and not the folder itself.
        (Some((part, [])), _) if part == "**" => !names.is_empty(),
        (Some((part, rest)), _) if part == "**" => {
            (0..=names.len()).any(|skipped| covers(rest, &names[skipped..]))
        }
        (Some((part, rest)), Some((name, others))) => {
            is_name(part.as_bytes(), name.as_bytes()) && covers(rest, others)
        }
        (Some(_), None) => false,
    }
}

/// Whether a pattern covers a name. It goes back to the last star only.
fn is_name(pattern: &[u8], name: &[u8]) -> bool {
    let (mut at, mut place, mut star) = (0, 0, None);
    while place < name.len() {
        match pattern.get(at) {
            Some(b'*') => {
                star = Some((at, place));
                at += 1;
            }
            Some(&byte) if byte == b'?' || byte == name[place] => {
                at += 1;
                place += 1;
            }
            _ => match &mut star {
                Some((last, from)) => {
                    *from += 1;
                    (at, place) = (*last + 1, *from);
                }
                None => return false,
            },
        }
    }
    pattern[at..].iter().all(|&byte| byte == b'*')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_are_those_of_gitignore() {
        let says = |lines: &[&str], path: &str| {
            let mut builder = GitignoreBuilder::new("/work");
            for line in lines {
                builder.add_line(None, line).expect("a pattern");
            }
            let patterns = builder.build().expect("patterns");
            patterns
                .matched_path_or_any_parents(Path::new("/work").join(path), false)
                .is_ignore()
        };
        assert!(says(&["old/"], "old/a.clad"));
        assert!(says(&["old/"], "lines/old/a.clad"));
        assert!(!says(&["old/"], "old"));
        assert!(!says(&["/old"], "lines/old/a.clad"));
        assert!(says(&["lines/**"], "lines/one/a.clad"));
        assert!(!says(&["lines/**"], "other/a.clad"));
        assert!(says(&["lines/**/a.clad"], "lines/a.clad"));
        assert!(says(&["*_old.clad"], "lines/pump_old_old.clad"));
        assert!(!says(&["*.clad", "!keep.clad"], "keep.clad"));
        assert!(says(&["pump?.clad"], "pump1.clad"));
        assert!(GitignoreBuilder::new("").add_line(None, "[ab].clad").is_err());
    }
}

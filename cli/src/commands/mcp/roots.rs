//! The folders that a client has opened: no path leads out of them.

use crate::outcome::Failure;
use ladder_workspace::address::path_of;
use ladder_workspace::shown;
use std::path::{Component, Path, PathBuf};
use std::time::Duration;

/// So long a client may take to name its folders.
pub(super) const PATIENCE: Duration = Duration::from_secs(5);

/// See the module. There is at least one, and each is without links.
#[derive(Debug, Clone)]
pub(super) struct Roots {
    folders: Vec<PathBuf>,
    of_arguments: Vec<PathBuf>,
    is_of_client: bool,
}

/// A path within a root, as a process sees it that runs there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Within {
    pub(super) root: PathBuf,
    /// Seen from the root.
    pub(super) path: PathBuf,
}

impl Within {
    /// All of it.
    pub(super) fn whole(&self) -> PathBuf {
        self.root.join(&self.path)
    }

    /// The path as an argument that is not an option.
    pub(super) fn argument(&self) -> String {
        let path = self.path.to_string_lossy();
        match &*path {
            "" => ".".to_owned(),
            path if path.starts_with('-') => format!("./{path}"),
            path => path.to_owned(),
        }
    }
}

impl Roots {
    /// Those of the command line, else the folder in which the server was started.
    ///
    /// # Errors
    /// One of them is not a folder.
    pub(super) fn of_arguments(folders: &[PathBuf]) -> Result<Roots, Failure> {
        let here = [PathBuf::from(".")];
        let folders = if folders.is_empty() { &here } else { folders };
        let real = folders.iter().map(|folder| {
            let real = folder.canonicalize().ok().filter(|real| real.is_dir());
            real.ok_or_else(|| Failure::new(format!("{}: this is not a folder", shown::path(folder))))
        });
        let folders = real.collect::<Result<Vec<_>, Failure>>()?;
        Ok(Roots {
            of_arguments: folders.clone(),
            folders,
            is_of_client: false,
        })
    }

    /// Whether the client has named them.
    pub(super) fn is_of_client(&self) -> bool {
        self.is_of_client
    }

    /// The client has opened others.
    pub(super) fn ask_again(&mut self) {
        self.is_of_client = false;
    }

    /// Takes the addresses of a client's folders. If it names none that is here, those of the command line stay.
    pub(super) fn become_those_of(&mut self, addresses: &[String]) {
        let named = addresses
            .iter()
            .filter_map(|address| path_of(address)?.canonicalize().ok());
        let named: Vec<PathBuf> = named.filter(|folder| folder.is_dir()).collect();
        self.is_of_client = true;
        self.folders = if named.is_empty() {
            self.of_arguments.clone()
        } else {
            named
        };
    }

    /// A file or folder that is there.
    ///
    /// # Errors
    /// It is not there, or leads out of the folders.
    pub(super) fn there(&self, path: &str) -> Result<Within, String> {
        let candidates = self.folders.iter().map(|root| root.join(path));
        let mut there = candidates.filter_map(|path| path.canonicalize().ok());
        match there.find_map(|real| self.within(&real)) {
            Some(within) => Ok(within),
            None => Err(format!(
                "{path}: there is no such file or folder in {}",
                self.named()
            )),
        }
    }

    /// A file that may be written: its folder is there.
    ///
    /// # Errors
    /// Its folder is not there, or it leads out of the folders.
    pub(super) fn to_write(&self, path: &str) -> Result<Within, String> {
        let written = Path::new(path);
        let name = match written.components().next_back() {
            Some(Component::Normal(name)) => name.to_owned(),
            _ => return Err(format!("{path}: this is not the name of a file")),
        };
        let folder = written.parent().and_then(Path::to_str).unwrap_or_default();
        let folder = self.there(folder)?;
        let file = folder.whole().join(name);
        let is_link = file.symlink_metadata().is_ok_and(|it| it.is_symlink());
        match self.within(&file) {
            Some(within) if !is_link => Ok(within),
            _ => Err(format!("{path}: this leads out of {}", self.named())),
        }
    }

    fn within(&self, real: &Path) -> Option<Within> {
        self.folders.iter().find_map(|root| {
            let path = real.strip_prefix(root).ok()?;
            Some(Within {
                root: root.clone(),
                path: path.to_owned(),
            })
        })
    }

    fn named(&self) -> String {
        let named: Vec<String> = self.folders.iter().map(|root| shown::path(root)).collect();
        named.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_path_leads_out() {
        let folder = tempfile::tempdir().unwrap();
        let (inside, outside) = (folder.path().join("in side"), folder.path().join("outside"));
        for folder in [&inside, &outside] {
            std::fs::create_dir(folder).unwrap();
            std::fs::write(folder.join("a.clad"), "").unwrap();
        }
        std::fs::write(inside.join("-o"), "").unwrap();
        let mut roots = Roots::of_arguments(std::slice::from_ref(&outside)).unwrap();
        let address = format!("file://{}", inside.display()).replace(' ', "%20");
        roots.become_those_of(&[address]);
        assert_eq!(roots.there("a.clad").unwrap().argument(), "a.clad");
        assert_eq!(roots.there("").unwrap().argument(), ".");
        assert_eq!(roots.there("-o").unwrap().argument(), "./-o");
        assert_eq!(roots.to_write("b.clad").unwrap().argument(), "b.clad");
        let absolute = outside.join("a.clad");
        for path in ["../outside/a.clad", absolute.to_str().unwrap(), "none.clad"] {
            assert!(roots.there(path).is_err(), "{path}");
        }
        for path in ["../outside/b.clad", "..", ".", "", "none/b.clad"] {
            assert!(roots.to_write(path).is_err(), "{path}");
        }
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&outside, inside.join("link")).unwrap();
            std::os::unix::fs::symlink(&absolute, inside.join("link.clad")).unwrap();
            assert!(roots.there("link/a.clad").is_err());
            assert!(roots.to_write("link/b.clad").is_err());
            assert!(roots.to_write("link.clad").is_err());
        }
    }
}

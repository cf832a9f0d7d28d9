//! The programs of a revision, as a disk of their own.

use super::objects::{Listed, Object, Objects, list, staged};
use super::{command, output, told};
use crate::outcome::Failure;
use ladder_workspace::{Disk, MAX_FILE_BYTES, MemoryDisk, Root, SETTINGS_FILE, Workspace, is_program};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The programs of a workspace may be so large together.
const MOST_BYTES: usize = 4 * MAX_FILE_BYTES;

/// A revision, or what is staged.
pub(crate) struct Revision {
    /// Its programs and settings, by their paths in the repository.
    files: Vec<Listed>,
    /// The current folder in the repository: empty, or with a `/` at its end.
    here: String,
}

/// `REV:path` as both; what is staged has an empty revision. None: it is no such name.
pub(crate) fn parts(name: &str) -> Option<(&str, &str)> {
    // A search for a message may hold a colon: `HEAD^{/fix: it}:motor.clad`.
    let mut depth = 0usize;
    let colon = name.char_indices().find(|(_, letter)| {
        match letter {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        *letter == ':' && depth == 0
    });
    let (revision, path) = name.split_at(colon?.0);
    let path = &path[1..];
    match (revision, path.as_bytes()) {
        ("", [b'0'..=b'3', b':', ..]) => Some(("", &path[2..])),
        ("", [b'/', ..]) => None,
        _ => Some((revision, path)),
    }
}

impl Revision {
    /// Lists its programs.
    ///
    /// # Errors
    /// git knows no such revision.
    pub(crate) fn read(name: &str, objects: &mut Objects) -> Result<Revision, Failure> {
        let mut files = match name {
            "" => staged()?,
            name => match objects.read(&format!("{name}:"))? {
                Object::Folder(id) => list(&id)?,
                Object::File(_) => return Err(Failure::new(format!("{name}: this is a file"))),
            },
        };
        files.retain(|file| is_program(Path::new(&file.path)) || is_settings(&file.path));
        let git = output(command(Path::new(".")).args(["rev-parse", "--show-prefix"]))?;
        if !git.status.success() {
            return Err(Failure::new(told(&git)));
        }
        let here = String::from_utf8_lossy(&git.stdout)
            .trim_end_matches('\n')
            .to_owned();
        Ok(Revision { files, here })
    }

    /// A path on the disk, of one as git takes it: from the top of the repository, or with `./` from the current folder. None: it
    /// leads out of the repository.
    pub(crate) fn path(&self, path: &str) -> Option<PathBuf> {
        let is_from_here = path == "." || path.starts_with("./") || path.starts_with("../");
        let mut from_top = PathBuf::from("/");
        let parts = if is_from_here { &*self.here } else { "" };
        for part in parts.split('/').chain(path.split('/')) {
            match part {
                "" | "." => {}
                ".." if from_top.parent().is_none() => return None,
                ".." => drop(from_top.pop()),
                part => from_top.push(part),
            }
        }
        Some(from_top)
    }

    /// The root of a program.
    pub(crate) fn root_of(&self, program: &Path) -> Root {
        let folder = program.parent().unwrap_or(program);
        let has_settings = |folder: &&Path| {
            let settings = folder.join(SETTINGS_FILE);
            self.files.iter().any(|file| on_disk(&file.path) == settings)
        };
        match folder.ancestors().find(has_settings) {
            Some(root) => Root::Settings(root.to_owned()),
            None => Root::Folder(folder.to_owned()),
        }
    }

    /// The workspace of a program. None: its settings cannot be used, or it is too large.
    ///
    /// # Errors
    /// git does not answer.
    pub(crate) fn workspace(
        &self,
        program: &Path,
        objects: &mut Objects,
    ) -> Result<Option<Workspace>, Failure> {
        let root = self.root_of(program);
        let disk = MemoryDisk::default();
        let mut size = 0;
        for file in &self.files {
            let path = on_disk(&file.path);
            let is_own = match &root {
                Root::Settings(folder) => path.starts_with(folder),
                Root::Folder(folder) => path.parent() == Some(folder),
            };
            if !is_own {
                continue;
            }
            let Object::File(bytes) = objects.read(&file.id)? else {
                continue;
            };
            size += bytes.len();
            if size > MOST_BYTES {
                return Ok(None);
            }
            disk.write(&path, &bytes);
        }
        let disk: Arc<dyn Disk> = Arc::new(disk);
        Ok(Workspace::on(&disk, program).ok())
    }
}

fn on_disk(path: &str) -> PathBuf {
    Path::new("/").join(path)
}

fn is_settings(path: &str) -> bool {
    path.rsplit('/').next() == Some(SETTINGS_FILE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_a_revision_and_a_path() {
        for (name, expected) in [
            ("HEAD:a/b.clad", Some(("HEAD", "a/b.clad"))),
            ("HEAD^{/fix: it}:a.clad", Some(("HEAD^{/fix: it}", "a.clad"))),
            (":a.clad", Some(("", "a.clad"))),
            (":1:a.clad", Some(("", "a.clad"))),
            (":/fix", None),
            ("HEAD:a:b.clad", Some(("HEAD", "a:b.clad"))),
            ("a.clad", None),
        ] {
            assert_eq!(parts(name), expected, "{name}");
        }
    }

    #[test]
    fn a_path_is_from_the_top_or_from_here() {
        let revision = Revision {
            files: Vec::new(),
            here: "plant/line/".into(),
        };
        for (path, expected) in [
            ("a.clad", Some("/a.clad")),
            ("./a.clad", Some("/plant/line/a.clad")),
            ("../b/a.clad", Some("/plant/b/a.clad")),
            ("../../../a.clad", None),
        ] {
            assert_eq!(revision.path(path).as_deref(), expected.map(Path::new), "{path}");
        }
    }
}

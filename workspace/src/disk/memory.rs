//! Files in memory: plain ones in folders, without links. A folder is there as long as something lies in it.

use super::{Disk, Keeper};
use crate::error::{FileError, Problem};
use crate::named::Named;
use crate::root::is_program;
use crate::root::{Root, SETTINGS_FILE};
use crate::search::{Survey, is_companion};
use crate::settings::Files;
use crate::stamp::Stamp;
use crate::text;
use ladder_analysis::Cancel;
use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Files in memory. Clones have the same files. Paths begin with a `/`, on every system.
#[derive(Debug, Clone, Default)]
pub struct MemoryDisk {
    files: Arc<Mutex<Written>>,
}

#[derive(Debug, Default)]
struct Written {
    files: BTreeMap<PathBuf, File>,
    /// How often something was written.
    times: u64,
}

#[derive(Debug)]
struct File {
    bytes: Arc<[u8]>,
    /// The number of the writing that it comes from.
    written: u64,
}

impl MemoryDisk {
    /// Writes a file.
    pub fn write(&self, path: &Path, bytes: &[u8]) {
        let mut all = self.lock();
        all.times += 1;
        let written = all.times;
        let bytes = bytes.into();
        all.files.insert(plain(path), File { bytes, written });
    }

    /// Removes a file, if it is there.
    pub fn remove(&self, path: &Path) {
        self.lock().files.remove(&plain(path));
    }

    fn bytes(&self, path: &Path) -> Result<Arc<[u8]>, FileError> {
        let found = self.lock().files.get(&plain(path)).map(|file| file.bytes.clone());
        found.ok_or_else(|| {
            let problem = if self.is_folder(path) {
                Problem::Directory
            } else {
                Problem::Missing
            };
            FileError::new(path, problem)
        })
    }

    fn is_folder(&self, path: &Path) -> bool {
        let folder = plain(path);
        self.lock()
            .files
            .keys()
            .any(|file| *file != folder && file.starts_with(&folder))
    }

    /// The files below a folder that nothing hides.
    fn below(&self, folder: &Path, wanted: impl Fn(&Path) -> bool) -> Vec<PathBuf> {
        let folder = plain(folder);
        let all = self.lock();
        let found = all.files.keys().filter(|file| {
            let below = file.strip_prefix(&folder);
            below.is_ok_and(|below| !is_hidden(below)) && wanted(file)
        });
        found.cloned().collect()
    }

    fn lock(&self) -> MutexGuard<'_, Written> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Disk for MemoryDisk {
    fn root_of(&self, program: &Path) -> io::Result<Root> {
        let program = plain(program);
        let folder = program.parent().unwrap_or(&program);
        let all = self.lock();
        let settings = folder
            .ancestors()
            .find(|above| all.files.contains_key(&above.join(SETTINGS_FILE)));
        Ok(match settings {
            Some(root) => Root::Settings(root.to_owned()),
            None => Root::Folder(folder.to_owned()),
        })
    }

    fn stamp(&self, file: &Path) -> Stamp {
        let all = self.lock();
        let file = all.files.get(&plain(file));
        Stamp::numbered(file.map(|file| (file.written, file.bytes.len() as u64)))
    }

    fn is_there(&self, path: &Path) -> bool {
        self.is_file(path) || self.is_folder(path)
    }

    fn is_file(&self, path: &Path) -> bool {
        self.lock().files.contains_key(&plain(path))
    }

    fn is_whole(&self, path: &Path) -> bool {
        path.has_root()
    }

    fn is_link(&self, _path: &Path) -> bool {
        false
    }

    fn canonicalize(&self, path: &Path) -> io::Result<PathBuf> {
        if self.is_there(path) {
            Ok(plain(path))
        } else {
            Err(io::ErrorKind::NotFound.into())
        }
    }

    fn names_in(&self, folder: &Path, most: usize) -> Vec<String> {
        let folder = plain(folder);
        let all = self.lock();
        let names = all.files.keys().filter_map(|file| {
            let first = file.strip_prefix(&folder).ok()?.components().next()?;
            Some(first.as_os_str().to_string_lossy().into_owned())
        });
        // Those of one folder are next to each other.
        let mut names: Vec<String> = names.collect();
        names.dedup();
        names.truncate(most);
        names
    }

    fn read(&self, file: &Path) -> Result<String, FileError> {
        text::decode(file, self.bytes(file)?.to_vec())
    }

    fn read_own(&self, file: &Path) -> Result<String, FileError> {
        self.read(file)
    }

    fn locate(&self, file: &Named) -> Result<PathBuf, FileError> {
        file.locate_without_links()
    }

    fn read_named(&self, file: &Named) -> Result<Vec<u8>, FileError> {
        let bytes = self.bytes(&self.locate(file)?);
        let renamed = |error: FileError| FileError::new(&file.path(), error.problem);
        Ok(bytes.map_err(renamed)?.to_vec())
    }

    fn programs(&self, root: &Root, files: &Files) -> Vec<PathBuf> {
        let folder = root.folder();
        let is_own = |program: &Path| match root {
            Root::Folder(_) => program.parent() == Some(folder),
            Root::Settings(_) => self.root_of(program).is_ok_and(|of| of.folder() == folder),
        };
        let mut found = self.below(folder, is_program);
        found.retain(|program| is_own(program) && files.contain(program));
        for library in files.library().iter().map(|library| &*library.path) {
            let is_inner = |program: &PathBuf| {
                let root = self.root_of(program).ok();
                root.is_none_or(|root| !root.folder().starts_with(library) || root.folder() == library)
            };
            found.extend(self.below(library, is_program).into_iter().filter(is_inner));
        }
        found.sort();
        found.dedup();
        found
    }

    fn holds(&self, root: &Root, program: &Path, files: &Files) -> bool {
        let below = program.strip_prefix(root.folder());
        files.is_in_library(program) || below.is_ok_and(|below| !is_hidden(below)) && files.contain(program)
    }

    fn companions(&self, folders: &[PathBuf]) -> Vec<PathBuf> {
        let found = folders.iter().flat_map(|folder| self.below(folder, is_companion));
        found.collect()
    }

    fn survey(&self, folder: &Path, _most: usize, _cancel: &Cancel) -> Survey {
        let is_settings_file = |file: &Path| file.file_name().is_some_and(|name| name == SETTINGS_FILE);
        Survey {
            programs: self.below(folder, is_program),
            settings_files: self.below(folder, is_settings_file),
            whole: true,
            refused: Vec::new(),
        }
    }

    fn files_below(&self, folder: &Path, most: usize) -> Vec<PathBuf> {
        let mut found = self.below(folder, |_| true);
        found.truncate(most);
        found
    }

    fn read_below(&self, _folder: &Path, file: &Path) -> Result<Vec<u8>, FileError> {
        Ok(self.bytes(file)?.to_vec())
    }

    fn keeper(&self, file: &Named) -> Result<Box<dyn Keeper>, FileError> {
        Ok(Box::new(KeptInMemory {
            path: self.locate(file)?,
            disk: self.clone(),
        }))
    }
}

/// A file in memory that keeps values. Several may have it: who saves last counts.
#[derive(Debug)]
struct KeptInMemory {
    path: PathBuf,
    disk: MemoryDisk,
}

impl Keeper for KeptInMemory {
    fn path(&self) -> &Path {
        &self.path
    }

    fn read(&self) -> Result<Option<Vec<u8>>, FileError> {
        Ok(self.disk.bytes(&self.path).ok().map(|bytes| bytes.to_vec()))
    }

    fn lock(&mut self, _patience: Duration) -> Result<(), FileError> {
        Ok(())
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), FileError> {
        self.disk.write(&self.path, bytes);
        Ok(())
    }

    fn put_aside(&mut self) -> Result<PathBuf, FileError> {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        let aside = self.path.with_file_name(format!("{name}.damaged"));
        let bytes = self.disk.bytes(&self.path)?;
        self.disk.write(&aside, &bytes);
        self.disk.remove(&self.path);
        Ok(aside)
    }
}

/// Whether a path begins with a dot anywhere.
fn is_hidden(below: &Path) -> bool {
    let mut parts = below.components();
    parts.any(|part| part.as_os_str().as_encoded_bytes().starts_with(b"."))
}

/// The path without `.` and `..`, from the top on.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::from("/");
    for part in path.components() {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            Component::Normal(name) => plain.push(name),
            Component::CurDir | Component::RootDir | Component::Prefix(_) => {}
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect;

    fn disk(files: &[(&str, &str)]) -> MemoryDisk {
        let disk = MemoryDisk::default();
        for (path, text) in files {
            disk.write(Path::new(path), text.as_bytes());
        }
        disk
    }

    #[test]
    fn programs_belong_to_the_nearest_settings_file() {
        let disk = disk(&[
            ("/plant/ladder.toml", ""),
            ("/plant/a.clad", ""),
            ("/plant/line/b.clad", ""),
            ("/plant/line/c.ladder-test", ""),
            ("/plant/.old/d.clad", ""),
            ("/plant/other/ladder.toml", ""),
            ("/plant/other/e.clad", ""),
        ]);
        let root = disk.root_of(Path::new("/plant/line/../new.clad")).unwrap();
        assert_eq!(root, Root::Settings("/plant".into()));
        let files = Files::default();
        let programs = disk.programs(&root, &files);
        assert_eq!(
            programs,
            [Path::new("/plant/a.clad"), Path::new("/plant/line/b.clad")]
        );
        assert!(!disk.holds(&root, Path::new("/plant/.old/d.clad"), &files));
        assert_eq!(
            disk.survey(Path::new("/plant"), 9, &Cancel::default())
                .programs
                .len(),
            3
        );
        assert_eq!(
            disk.names_in(Path::new("/plant/line"), 9),
            ["b.clad", "c.ladder-test"]
        );
        let folder = disk.root_of(Path::new("/b.clad")).unwrap();
        assert_eq!(folder, Root::Folder("/".into()));
    }

    #[test]
    fn what_is_named_lies_inside() {
        let disk = disk(&[
            ("/plant/ladder.toml", ""),
            ("/plant/line/a.clad", "x"),
            ("/secret", "y"),
        ]);
        let told = |name| {
            let named = disk.named_in(Path::new("/plant/line/a.clad"), name);
            match disk.read_text(&named) {
                Ok(text) => text,
                Err(error) => error.to_string(),
            }
        };
        assert_eq!(told("../line/a.clad"), "x");
        expect!["/plant/line/../../secret: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one"]
            .assert_eq(&told("../../secret"));
        expect![
            "/secret: a path in a workspace is relative: write it as it is seen from the file that names it"
        ]
        .assert_eq(&told("/secret"));
        expect!["/plant/line/b.clad: no such file or folder"].assert_eq(&told("b.clad"));
        expect!["/plant/line/..: this is a folder; name a file in it"].assert_eq(&told(".."));
    }

    #[test]
    fn a_file_that_is_written_has_another_stamp() {
        let disk = disk(&[]);
        let file = Path::new("/a.clad");
        assert!(!disk.stamp(file).exists());
        disk.write(file, b"one");
        let one = disk.stamp(file);
        disk.write(file, b"two");
        assert_ne!(one, disk.stamp(file));
        disk.remove(file);
        assert!(!disk.is_there(file));
    }
}

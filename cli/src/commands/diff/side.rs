//! What is compared: a file, a folder, or one of them as git has it in a revision.

use crate::findings::{Source, is_settings};
use crate::form::{self, Form};
use crate::git::Git;
use crate::git::objects::{self, Object, Objects};
use crate::git::revision::parts;
use crate::outcome::Failure;
use ladder_notations::{Companion, Foreign, Notation, Reach};
use ladder_workspace::{MAX_FILE_BYTES, SETTINGS_FILE, belonging, is_program};
use std::collections::{BTreeMap, HashMap};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// One side of a comparison.
pub(super) enum Side {
    /// One program.
    File(File),
    /// Programs and settings by their paths in a folder.
    Folder(BTreeMap<String, File>),
    /// No file: what git names where one was added or deleted.
    Nothing,
}

/// The ladder text of a file.
pub(super) struct Text {
    pub(super) ladder: String,
    /// What it was made from, in a file of another system.
    pub(super) foreign: Option<Arc<Foreign>>,
}

/// A file that can be read.
pub(super) struct File {
    /// What it is called.
    pub(super) name: String,
    pub(super) place: Place,
}

/// Where a file is.
pub(super) enum Place {
    /// On the disk.
    Disk(PathBuf),
    /// In git.
    Git {
        /// A name that git knows the content by.
        object: String,
        /// The revision, which is empty for what is staged. None: it is not known.
        revision: Option<String>,
        /// The path in it, as git takes it.
        path: String,
    },
}

impl Side {
    /// What an argument means.
    ///
    /// # Errors
    /// There is nothing of that name.
    pub(super) fn of(argument: &Path) -> Result<Side, Failure> {
        if argument == Path::new("/dev/null") {
            return Ok(Side::Nothing);
        }
        let name = argument.display().to_string();
        if argument.is_dir() {
            return Ok(Side::Folder(folder(argument)?));
        }
        let text = argument.to_str().filter(|text| objects::is_meant(text));
        let Some(text) = text.filter(|_| argument.symlink_metadata().is_err()) else {
            return Ok(Side::File(File {
                name,
                place: Place::Disk(argument.to_owned()),
            }));
        };
        let (revision, path) = match parts(text) {
            Some((revision, path)) => (Some(revision.to_owned()), path),
            None => (None, ""),
        };
        match Objects::open()?.read(text)? {
            Object::File(_) => Ok(Side::File(File {
                name,
                place: Place::Git {
                    object: text.to_owned(),
                    revision,
                    path: path.to_owned(),
                },
            })),
            Object::Folder(id) => {
                let files = objects::list(&id)?.into_iter();
                let files = files.filter(|file| is_compared(Path::new(&file.path)));
                let files = files.map(|file| {
                    let slash = |text: &str| {
                        if text.is_empty() || text.ends_with([':', '/']) {
                            ""
                        } else {
                            "/"
                        }
                    };
                    let name = format!("{text}{}{}", slash(text), file.path);
                    let place = Place::Git {
                        object: file.id,
                        revision: revision.clone(),
                        path: format!("{path}{}{}", slash(path), file.path),
                    };
                    (file.path, File { name, place })
                });
                Ok(Side::Folder(files.collect()))
            }
        }
    }

    /// The same under another name, of one program.
    pub(super) fn named(self, name: Option<&Path>) -> Side {
        match (self, name) {
            (Side::File(file), Some(name)) => Side::File(File {
                name: name.display().to_string(),
                ..file
            }),
            (side, _) => side,
        }
    }
}

/// Whether a file of a folder is compared: the programs and the settings.
fn is_compared(path: &Path) -> bool {
    is_program(path) || is_settings(path)
}

fn folder(folder: &Path) -> Result<BTreeMap<String, File>, Failure> {
    let (found, errors) = ladder_workspace::find_files(&[folder.to_owned()], &is_compared);
    if let Some(error) = errors.into_iter().next() {
        return Err(error.into());
    }
    let files = found.into_iter().map(|path| {
        let below = path.strip_prefix(folder).unwrap_or(&path);
        let parts: Vec<_> = below.iter().map(OsStr::to_string_lossy).collect();
        let name = path.display().to_string();
        (
            parts.join("/"),
            File {
                name,
                place: Place::Disk(path),
            },
        )
    });
    Ok(files.collect())
}

impl File {
    /// What it holds.
    ///
    /// # Errors
    /// It cannot be read.
    pub(super) fn bytes(&self, git: &Git) -> Result<Vec<u8>, Failure> {
        match &self.place {
            Place::Disk(path) => Ok(ladder_workspace::read_bytes(path)?),
            Place::Git { object, .. } => match git.objects()?.read(object)? {
                Object::File(bytes) => Ok(bytes),
                Object::Folder(_) => Err(Failure::new(format!("{}: this is a folder", self.name))),
            },
        }
    }

    /// Its ladder text: as it is, or what a program of another system becomes.
    ///
    /// # Errors
    /// It is not a program.
    pub(super) fn text(&self, bytes: Vec<u8>, git: &Git) -> Result<Text, Failure> {
        let path = Path::new(&self.name);
        match &self.place {
            Place::Disk(path) => {
                let source = Source::of_bytes(path, bytes, None)?;
                Ok(Text {
                    foreign: source.foreign().cloned(),
                    ladder: source.text,
                })
            }
            Place::Git {
                object,
                revision,
                path: within,
            } => match form::of_program(path, &bytes)? {
                Form::Ladder => Ok(Text {
                    ladder: ladder_workspace::decode(path, bytes)?,
                    foreign: None,
                }),
                Form::Foreign(notation) => {
                    let name = match revision {
                        Some(revision) => format!("{revision}:{within}"),
                        None => object.clone(),
                    };
                    let companions = companions(notation, &name, &mut *git.objects()?)?;
                    let stem = path.file_stem().map(OsStr::to_string_lossy);
                    let source = ladder_notations::Source {
                        name: stem.unwrap_or_default(),
                        bytes: &bytes,
                        companions,
                    };
                    let read = Foreign::read(notation, &source);
                    let foreign = read.map_err(|error| Failure::broken(path, &error))?;
                    Ok(Text {
                        ladder: foreign.ladder().to_owned(),
                        foreign: Some(Arc::new(foreign)),
                    })
                }
            },
        }
    }
}

/// The files of the same revision that belong to a program of another system.
fn companions(notation: &dyn Notation, name: &str, objects: &mut Objects) -> Result<Vec<Companion>, Failure> {
    let Some((revision, path)) = parts(name) else {
        return Ok(Vec::new());
    };
    // What may lie anywhere in its project is looked for in all of the revision.
    let folder = match notation.reach() {
        Reach::Project(_) | Reach::Workspace => "",
        Reach::Folder | Reach::FolderAnd(_) => path.rsplit_once('/').map_or("", |(folder, _)| folder),
    };
    let Ok(Object::Folder(id)) = objects.read(&format!("{revision}:{folder}")) else {
        return Ok(Vec::new());
    };
    let listed = objects::list(&id)?.into_iter();
    let ids: HashMap<PathBuf, String> = listed
        .map(|file| (Path::new(folder).join(file.path), file.id))
        .collect();
    let mut files: Vec<PathBuf> = ids.keys().cloned().collect();
    if notation.reach() == Reach::Workspace {
        let own = Path::new(path).parent().unwrap_or(Path::new(""));
        let mut above = own.ancestors();
        match above.find(|folder| ids.contains_key(&folder.join(SETTINGS_FILE))) {
            Some(root) => files.retain(|file| file.starts_with(root)),
            None => files.retain(|file| file.parent() == Some(own)),
        }
    }
    let mut companions = Vec::new();
    let mut size = 0;
    for (own, file) in belonging(notation, Path::new(path), files) {
        if let Object::File(bytes) = objects.read(&ids[&file])? {
            size += bytes.len();
            if size > MAX_FILE_BYTES {
                return Err(Failure::new(format!(
                    "{name}: what belongs to it is larger than 64 MiB"
                )));
            }
            companions.push(Companion {
                name: own,
                bytes: bytes.into(),
            });
        }
    }
    Ok(companions)
}

//! What a program sees of the other files of its workspace, as they are on its side of the comparison.

use super::side::{File, Place};
use crate::findings::Source;
use crate::git::Git;
use crate::git::revision::Revision;
use crate::outcome::Failure;
use ladder_analysis::analyze;
use ladder_review::Outline;
use ladder_review::outline::why_not;
use ladder_workspace::{Root, Workspace};
use std::collections::hash_map::{DefaultHasher, Entry};
use std::collections::{BTreeMap, HashMap};
use std::hash::{Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The workspaces of one side, each read once.
pub(super) struct Around<'g> {
    git: &'g Git,
    /// What the other side is, where that is on the disk: the programs of this side do not see it.
    apart: Option<PathBuf>,
    /// Where its file is taken to be.
    among: Option<PathBuf>,
    revisions: HashMap<String, Option<Revision>>,
    /// By their revision and their folder.
    workspaces: HashMap<(Option<String>, PathBuf), Option<Seen>>,
}

/// A workspace.
#[derive(Clone)]
struct Seen {
    folder: PathBuf,
    workspace: Arc<Workspace>,
    /// What tells it from one with other programs.
    content: u64,
}

/// Where a file is in its workspace.
struct At {
    path: PathBuf,
    seen: Seen,
}

impl<'g> Around<'g> {
    /// Those of the side that is compared with `other`; its file is taken to be at `among`, if that is given.
    pub(super) fn new(other: &Path, among: Option<&Path>, git: &'g Git) -> Around<'g> {
        Around {
            git,
            apart: other.canonicalize().ok(),
            among: among.map(Path::to_owned),
            revisions: HashMap::new(),
            workspaces: HashMap::new(),
        }
    }

    /// What tells the programs around a file from others.
    pub(super) fn content(&mut self, file: &File) -> Result<u64, Failure> {
        Ok(self.at(file)?.map_or(0, |at| at.seen.content))
    }

    /// The entries of a text, and the program that it is with its other files. Where these do not fit together (copies of one
    /// file in a folder), the program that it is alone.
    pub(super) fn outline(&mut self, file: &File, text: &str) -> Result<Outline, Failure> {
        let parse = || Arc::new(ladder_syntax::parse(text));
        let Some(At { path, seen }) = self.at(file)? else {
            let alone = analyze(&parse(), &file.name);
            let program = alone.program().cloned().ok_or_else(|| "has errors".to_owned());
            return Ok(Outline::among(alone.context, program, BTreeMap::new()));
        };
        let source =
            Source::new(path.display().to_string(), text.to_owned()).within(Arc::clone(&seen.workspace));
        let not_whole = match source.linked() {
            Ok(linked) => {
                let files = linked.others.iter().filter_map(|other| {
                    let path = seen.workspace.program_named(&other.context.name)?.path();
                    let below = path.strip_prefix(&seen.folder).unwrap_or(path);
                    Some((below.display().to_string(), Arc::clone(&other.context)))
                });
                let files = files.collect();
                return Ok(Outline::among(
                    Arc::clone(&source.analyze().context),
                    Ok(linked.program),
                    files,
                ));
            }
            Err(not_whole) => not_whole,
        };
        let alone = analyze(&parse(), &file.name);
        let program = alone.program().cloned().ok_or_else(|| {
            let own = &source.analyze().context.name;
            why_not(&not_whole, own, |name| seen.name(name))
        });
        Ok(Outline::among(alone.context, program, BTreeMap::new()))
    }

    /// Where a file is. None: in no workspace that can be used.
    fn at(&mut self, file: &File) -> Result<Option<At>, Failure> {
        if let Some(path) = self.among.clone() {
            return self.on_disk(&path);
        }
        match &file.place {
            Place::Disk(path) => self.on_disk(path),
            Place::Git {
                revision: Some(revision),
                path,
                ..
            } => self.in_revision(revision, path),
            Place::Git { .. } => Ok(None),
        }
    }

    fn on_disk(&mut self, path: &Path) -> Result<Option<At>, Failure> {
        let Ok(root) = Root::of(path) else { return Ok(None) };
        let folder = root.folder().to_owned();
        let seen = match self.workspaces.entry((None, folder.clone())) {
            Entry::Occupied(entry) => entry.get().clone(),
            Entry::Vacant(entry) => {
                let mut workspace = Workspace::of(path)?;
                // What holds this file is not apart from it.
                let is_apart =
                    |apart: &&PathBuf| path.canonicalize().is_ok_and(|path| !path.starts_with(apart));
                if let Some(apart) = self.apart.as_ref().filter(is_apart) {
                    workspace.leave_out(apart);
                }
                entry.insert(Some(Seen::new(folder, workspace))).clone()
            }
        };
        Ok(seen.map(|seen| At {
            path: path.to_owned(),
            seen,
        }))
    }

    fn in_revision(&mut self, name: &str, path: &str) -> Result<Option<At>, Failure> {
        let revision = match self.revisions.entry(name.to_owned()) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => entry.insert(Revision::read(name, &mut *self.git.objects()?).ok()),
        };
        let Some(revision) = revision else { return Ok(None) };
        let Some(path) = revision.path(path) else {
            return Ok(None);
        };
        let folder = revision.root_of(&path).folder().to_owned();
        let key = (Some(name.to_owned()), folder.clone());
        let seen = match self.workspaces.entry(key) {
            Entry::Occupied(entry) => entry.get().clone(),
            Entry::Vacant(entry) => {
                let workspace = revision.workspace(&path, &mut *self.git.objects()?)?;
                entry
                    .insert(workspace.map(|workspace| Seen::new(folder, workspace)))
                    .clone()
            }
        };
        Ok(seen.map(|seen| At { path, seen }))
    }
}

impl Seen {
    fn new(folder: PathBuf, workspace: Workspace) -> Seen {
        let mut texts: Vec<&str> = workspace
            .programs_seen_by_others()
            .iter()
            .map(ladder_workspace::Source::text)
            .collect();
        texts.sort_unstable();
        let mut hasher = DefaultHasher::new();
        texts.hash(&mut hasher);
        Seen {
            folder,
            workspace: Arc::new(workspace),
            content: hasher.finish(),
        }
    }

    /// The path of a program below the folder, by its name in messages.
    fn name(&self, name: &str) -> String {
        let path = self
            .workspace
            .program_named(name)
            .map(ladder_workspace::Source::path);
        let below = path.and_then(|path| path.strip_prefix(&self.folder).ok());
        below.map_or_else(|| name.to_owned(), |below| below.display().to_string())
    }
}

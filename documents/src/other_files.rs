//! What features read that look beyond one document: the other files of its workspace, open or not.
//!
//! An open file counts with the text that its editor shows, any other with the one on disk. Everything here may
//! read the disk and analyse texts: for a blocking thread.

use std::cell::{Cell, OnceCell};
use std::collections::{HashMap, HashSet};
use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use ladder_analysis::context::Context;
use ladder_analysis::{Cancel, Exported};
use ladder_ide::{ScenarioFile, Which, Workspace};
use ladder_notations::Foreign;
use ladder_picture::scene;
use ladder_syntax::TextRange;
use ladder_workspace::{Member, scene_stem};
use ropey::Rope;

use crate::kind::Kind;
use crate::library_source;
use crate::on_disk::OnDisk;
use crate::position::{self, Range};
use crate::positions::Positions;
use crate::revision::Revision;
use crate::store::Documents;
use crate::{address, in_parallel};

/// The files of a document's workspace, the document itself among them. They are looked for when they are first asked
/// for: most requests stay within their document.
pub struct OtherFiles {
    own: Arc<Revision>,
    documents: Arc<Documents>,
    companions: Arc<Documents>,
    files: OnceLock<Files>,
    scenarios: OnceLock<Vec<Scenarios>>,
    cancel: Cancel,
}

/// The programs.
#[derive(Default)]
struct Files {
    /// The open ones but the own, by name.
    open: Vec<(Arc<str>, Arc<Revision>)>,
    /// The others.
    closed: Vec<(PathBuf, Arc<OnDisk>)>,
    /// Their numbers by their names.
    closed_by_name: HashMap<Arc<str>, usize>,
    exported: Option<Arc<Exported>>,
    /// Whether the closed ones are so few that what is known of them is kept.
    are_few: bool,
}

impl Files {
    fn closed(&self, name: &str) -> Option<&(PathBuf, Arc<OnDisk>)> {
        self.closed.get(*self.closed_by_name.get(name)?)
    }

    fn context(&self, closed: &OnDisk) -> Option<Arc<Context>> {
        Some(closed.context(self.exported.as_ref()?, self.are_few))
    }
}

/// A file of scenarios.
struct Scenarios {
    path: PathBuf,
    text: String,
    revision: Option<Arc<Revision>>,
    shown: ScenarioFile,
}

/// A file as it is shown to an editor.
pub struct FileText {
    /// Its address.
    pub uri: String,
    /// The document, if it is open.
    pub revision: Option<Arc<Revision>>,
    /// The text of an open document, for the first few ranges.
    rope: Option<Rope>,
    encoding: position::Encoding,
    /// How many ranges were asked for, up to [`FEW`].
    asked: Cell<u32>,
    /// For those after them.
    positions: OnceCell<Positions>,
    /// What ranges are places in the ladder text of, where it is of another notation.
    foreign: Option<Arc<Foreign>>,
}

/// This many ranges of a file are looked up in its rope, before its lines are gone through for all that follow.
const FEW: u32 = 16;

impl FileText {
    fn of_document(uri: String, revision: &Arc<Revision>, encoding: position::Encoding) -> FileText {
        FileText {
            uri,
            revision: Some(Arc::clone(revision)).filter(|revision| revision.is_open()),
            rope: Some(revision.rope().clone()),
            encoding,
            asked: Cell::default(),
            positions: OnceCell::new(),
            foreign: match revision.opened() {
                Some(Ok(opened)) => Some(Arc::clone(opened.foreign())),
                _ => None,
            },
        }
    }

    fn of_file(uri: String, text: &str, encoding: position::Encoding) -> FileText {
        FileText {
            uri,
            revision: None,
            rope: None,
            encoding,
            asked: Cell::default(),
            positions: OnceCell::from(Positions::new(text.to_owned(), encoding)),
            foreign: None,
        }
    }

    fn of_member(uri: String, member: &Member, encoding: position::Encoding) -> FileText {
        FileText {
            foreign: member.foreign().cloned(),
            ..FileText::of_file(uri, member.text(), encoding)
        }
    }

    /// Whether it is ladder text, which edits can be made in.
    pub fn is_ladder(&self) -> bool {
        self.foreign.is_none()
    }

    /// A range of it.
    pub fn range(&self, range: TextRange) -> Range {
        let range = self
            .foreign
            .as_ref()
            .map_or(range, |foreign| foreign.range(range));
        let asked = self.asked.get();
        if let Some(rope) = self.rope.as_ref().filter(|_| asked < FEW) {
            self.asked.set(asked + 1);
            return position::range(rope, self.encoding, range.into());
        }
        let text = || self.rope.as_ref().map_or_else(String::new, Rope::to_string);
        let positions = || Positions::new(text(), self.encoding);
        self.positions.get_or_init(positions).range(range)
    }
}

impl OtherFiles {
    /// The files next to a document, as they are when they are first asked for. `documents` are the open programs,
    /// `companions` other open files. Once it is cancelled it finds no more files.
    pub fn of(
        own: &Arc<Revision>,
        documents: &Arc<Documents>,
        companions: &Arc<Documents>,
        cancel: &Cancel,
    ) -> OtherFiles {
        OtherFiles {
            own: Arc::clone(own),
            documents: Arc::clone(documents),
            companions: Arc::clone(companions),
            files: OnceLock::new(),
            scenarios: OnceLock::new(),
            cancel: cancel.clone(),
        }
    }

    fn files(&self) -> &Files {
        self.files.get_or_init(|| self.find_files().unwrap_or_default())
    }

    fn find_files(&self) -> Option<Files> {
        let place = self.own.place()?;
        let mut open = Vec::new();
        let mut shown = vec![place.path.clone()];
        for revision in self.documents.all() {
            let Some(other) = revision.place() else { continue };
            if other.path == place.path || !place.neighbours.together(&place.path, &other.path) {
                continue;
            }
            shown.push(other.path.clone());
            let (name, _) = place.neighbours.view(&other.path);
            open.push((name, revision));
        }
        open.sort_by(|(a, _), (b, _)| a.cmp(b));
        let mut on_disk = place.neighbours.on_disk(&place.path);
        let are_few = on_disk.are_few();
        on_disk.files.retain(|(path, _)| !shown.contains(path));
        let names = on_disk.files.iter().map(|(_, file)| Arc::clone(&file.name));
        Some(Files {
            open,
            closed_by_name: names.zip(0..).collect(),
            closed: on_disk.files,
            exported: Some(on_disk.exported),
            are_few,
        })
    }

    fn scenario_files(&self) -> &[Scenarios] {
        self.scenarios
            .get_or_init(|| self.find_scenarios().unwrap_or_default())
    }

    /// The files of scenarios, and the scenes, below the workspace's folder.
    fn find_scenarios(&self) -> Option<Vec<Scenarios>> {
        let place = self.own.place()?;
        let folder = place.neighbours.folder_of(&place.path);
        let disk = place.neighbours.disk();
        let mut paths = disk.companions(&[folder]);
        let open: Vec<_> = self
            .companions
            .all()
            .into_iter()
            .filter(|revision| matches!(revision.kind(), Kind::Scenarios | Kind::Scene))
            .filter_map(|revision| Some((address::path_of(&revision.uri)?, revision)))
            .collect();
        // What a person has open counts, even where the workspace passes over it.
        let known: HashSet<&PathBuf> = paths.iter().collect();
        let more = open
            .iter()
            .map(|(path, _)| path)
            .filter(|path| !known.contains(path));
        let more: Vec<PathBuf> = more.cloned().collect();
        paths.extend(more);
        let mut found = Vec::new();
        for path in paths {
            if !place.neighbours.together(&place.path, &path) {
                continue;
            }
            let revision = open.iter().find(|(of, _)| *of == path);
            let revision = revision.map(|(_, revision)| Arc::clone(revision));
            let text = match &revision {
                Some(revision) => revision.rope().to_string(),
                None => disk.read(&path).unwrap_or_default(),
            };
            let suite = match scene_stem(&path) {
                Some(stem) => scene::of_file(stem, &text).suite(),
                None => ladder_simulator::scenario::parse(&text),
            };
            let program = suite.program.as_ref().and_then(|(program, _)| {
                let next_to = disk.locate(&disk.named_in(&path, program)).ok()?;
                Some(place.neighbours.view(&next_to).0)
            });
            let (name, _) = place.neighbours.view(&path);
            let shown = ScenarioFile {
                name,
                program,
                text: text.clone(),
                suite: Arc::new(suite),
            };
            found.push(Scenarios {
                path,
                text,
                revision,
                shown,
            });
        }
        Some(found)
    }

    /// The other open files.
    pub fn open(&self) -> impl Iterator<Item = &Arc<Revision>> {
        self.files().open.iter().map(|(_, revision)| revision)
    }

    /// The file of a name as an editor shows it; the document itself too.
    pub fn text(&self, name: &str) -> Option<FileText> {
        let encoding = self.own.encoding();
        let own = self.own.context().is_some_and(|own| own.is_called(name));
        let open = if own {
            Some(&self.own)
        } else {
            let mut open = self.files().open.iter();
            open.find(|(of, _)| **of == *name).map(|(_, revision)| revision)
        };
        if let Some(revision) = open {
            return Some(FileText::of_document(
                revision.uri.to_string(),
                revision,
                encoding,
            ));
        }
        if let Some((address, text)) = library_source::file(name) {
            return Some(FileText::of_file(address, text, encoding));
        }
        if let Some((path, file)) = self.files().closed(name) {
            return Some(FileText::of_member(
                address::uri_of(path),
                file.member(),
                encoding,
            ));
        }
        let mut scenarios = self.scenarios.get()?.iter();
        let found = scenarios.find(|it| *it.shown.name == *name)?;
        Some(match &found.revision {
            Some(revision) => FileText::of_document(revision.uri.to_string(), revision, encoding),
            None => FileText::of_file(address::uri_of(&found.path), &found.text, encoding),
        })
    }
}

impl Workspace for OtherFiles {
    fn file(&self, name: &str) -> Option<Arc<Context>> {
        let files = self.files();
        if self.cancel.is_cancelled() {
            return None;
        }
        if let Some((_, revision)) = files.open.iter().find(|(of, _)| **of == *name) {
            return Some(Arc::clone(revision.context()?));
        }
        files.context(&files.closed(name)?.1)
    }

    fn show(&self, which: Which<'_>, look: &(dyn Fn(usize, &Arc<Context>) + Sync)) {
        let files = self.files();
        for (number, (_, revision)) in files.open.iter().enumerate() {
            if !self.cancel.is_cancelled()
                && which.takes(|| revision.rope().into())
                && let Some(context) = revision.context()
            {
                look(number, context);
            }
        }
        in_parallel::each(&files.closed, |number, (_, file)| {
            if !self.cancel.is_cancelled()
                && which.takes(|| file.member().ladder().into())
                && let Some(context) = files.context(file)
            {
                look(files.open.len() + number, &context);
            }
        });
    }

    fn scenarios(&self) -> Vec<ScenarioFile> {
        self.scenario_files().iter().map(|it| it.shown.clone()).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::membership::Membership;
    use crate::position::Encoding;

    #[test]
    fn nothing_is_read_for_an_answer_that_nobody_waits_for() {
        let folder = tempfile::tempdir().unwrap();
        let (documents, companions) = (Arc::<Documents>::default(), Arc::<Documents>::default());
        let neighbours = crate::testing::neighbours();
        let open = |name: &str| {
            let path = folder.path().join(name);
            std::fs::write(&path, "+--[ ]( a )--( )( b )--+\n").unwrap();
            let place = Some(Membership::new(path.clone(), &neighbours));
            let text = std::fs::read_to_string(&path).unwrap();
            documents.open_at(
                &address::uri_of(&path),
                Kind::Program,
                1,
                Encoding::Utf8,
                &text,
                place,
            )
        };
        std::fs::write(folder.path().join("closed.clad"), "+--[ ]( a )--( )( c )--+\n").unwrap();
        let own = open("own.clad");
        open("other.clad");
        let cancel = Cancel::default();
        let elsewhere = OtherFiles::of(&own, &documents, &companions, &cancel);
        let shown = || {
            let shown = AtomicUsize::new(0);
            elsewhere.show(Which::All, &|_, _| {
                shown.fetch_add(1, Ordering::Relaxed);
            });
            shown.into_inner()
        };
        assert_eq!(shown(), 2);
        cancel.cancel();
        assert_eq!(shown(), 0);
    }
}

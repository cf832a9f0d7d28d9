//! What features read that look beyond one document: the other files of its workspace, open or not.
//!
//! An open file counts with the text that its editor shows, any other with the one on disk. Everything here may
//! read the disk and analyse texts: for a blocking thread.

use std::path::PathBuf;
use std::sync::Arc;

use ladder_analysis::Exported;
use ladder_ide::{Neighbour, Workspace, mentions};
use ladder_syntax::{Name, TextRange};
use ropey::Rope;

use super::neighbours::OnDisk;
use super::position::{self, Range};
use super::{Documents, Revision, address};

/// The files of a document's workspace, the document itself among them.
pub(crate) struct Elsewhere {
    own: Arc<Revision>,
    /// The open ones but the own, by name.
    open: Vec<(Arc<str>, Arc<Revision>)>,
    /// The others.
    closed: Vec<(PathBuf, Arc<OnDisk>)>,
    exported: Option<Arc<Exported>>,
}

/// A file as it is shown to an editor.
pub(crate) struct FileText {
    /// Its address.
    pub(crate) uri: String,
    /// The document, if it is open.
    pub(crate) revision: Option<Arc<Revision>>,
    rope: Rope,
    encoding: position::Encoding,
}

impl FileText {
    /// A range of it.
    pub(crate) fn range(&self, range: TextRange) -> Range {
        position::range(&self.rope, self.encoding, range.into())
    }
}

impl Elsewhere {
    /// The files beside a document, as they are now.
    pub(crate) fn of(own: &Arc<Revision>, documents: &Documents) -> Elsewhere {
        let mut elsewhere = Elsewhere {
            own: Arc::clone(own),
            open: Vec::new(),
            closed: Vec::new(),
            exported: None,
        };
        let Some(place) = own.place() else {
            return elsewhere;
        };
        let mut shown = vec![place.path.clone()];
        for revision in documents.all() {
            let Some(other) = revision.place() else { continue };
            if other.path == place.path || !place.neighbours.together(&place.path, &other.path) {
                continue;
            }
            shown.push(other.path.clone());
            let (name, _) = place.neighbours.view(&other.path);
            elsewhere.open.push((name, revision));
        }
        elsewhere.open.sort_by(|(a, _), (b, _)| a.cmp(b));
        let (mut closed, exported) = place.neighbours.on_disk(&place.path);
        closed.retain(|(path, _)| !shown.contains(path));
        (elsewhere.closed, elsewhere.exported) = (closed, Some(exported));
        elsewhere
    }

    /// The other open files.
    pub(crate) fn open(&self) -> impl Iterator<Item = &Arc<Revision>> {
        self.open.iter().map(|(_, revision)| revision)
    }

    /// The file of a name as an editor shows it; the document itself too.
    pub(crate) fn text(&self, name: &str) -> Option<FileText> {
        let own = self.own.analysis().is_some_and(|own| *own.whole().name == *name);
        let open = self.open.iter().find(|(of, _)| **of == *name);
        let open = if own {
            Some(&self.own)
        } else {
            open.map(|(_, it)| it)
        };
        if let Some(revision) = open {
            return Some(FileText {
                uri: revision.uri.to_string(),
                revision: Some(Arc::clone(revision)),
                rope: revision.rope().clone(),
                encoding: self.own.encoding(),
            });
        }
        let (path, file) = self.closed.iter().find(|(_, file)| *file.name == *name)?;
        Some(FileText {
            uri: address::uri_of(path),
            revision: None,
            rope: Rope::from_str(&file.text),
            encoding: self.own.encoding(),
        })
    }

    fn which(&self, wanted: impl Fn(&str, &dyn Fn() -> String) -> bool) -> Vec<Neighbour> {
        let open = self.open.iter();
        let open = open.filter(|(name, revision)| wanted(name, &|| revision.rope().to_string()));
        let mut found: Vec<Neighbour> = open
            .filter_map(|(_, revision)| {
                let analysis = revision.analysis()?;
                Some(Neighbour::analysed(Arc::clone(analysis.whole())))
            })
            .collect();
        let Some(exported) = &self.exported else {
            return found;
        };
        let closed = self.closed.iter();
        let closed = closed.filter(|(_, file)| wanted(&file.name, &|| file.text.clone()));
        found.extend(closed.map(|(_, file)| Neighbour::read(Arc::clone(&file.name), file.context(exported))));
        found
    }
}

impl Workspace for Elsewhere {
    fn file(&self, name: &str) -> Option<Neighbour> {
        self.which(|of, _| of == name).pop()
    }

    fn mentioning(&self, name: &Name) -> Vec<Neighbour> {
        self.which(|_, text| mentions(&text(), name))
    }

    fn all(&self) -> Vec<Neighbour> {
        self.which(|_, _| true)
    }
}

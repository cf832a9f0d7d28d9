//! A program of a workspace as it is on disk.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use ladder_analysis::context::{Context, context};
use ladder_analysis::{Exported, Exports, exports};
use ladder_syntax::Parse;
use ladder_workspace::Stamp;

/// The names of files that no editor shows are kept in workspaces with so many bytes of text; in larger ones they are read
/// again when somebody asks.
const MOST_KEPT: usize = 2 << 20;

/// A file that no editor shows.
#[derive(Debug)]
pub(crate) struct OnDisk {
    pub(crate) name: Arc<str>,
    pub(super) stamp: Stamp,
    /// Its text. All else that is known of it is read again when somebody asks.
    pub(crate) text: String,
    pub(super) exports: Arc<Exports>,
    /// Its names, as they are among these other files.
    names: Mutex<Option<(Arc<Exported>, Arc<Context>)>>,
}

impl OnDisk {
    /// Reads a program.
    pub(super) fn read(root: &Path, path: &Path) -> Option<OnDisk> {
        let stamp = Stamp::of(path);
        let text = ladder_workspace::read_own(path).ok()?;
        let name = name_in(root, path);
        let exports = Arc::new(exports(&Arc::new(ladder_syntax::parse(&text)), &name));
        Some(OnDisk {
            name,
            stamp,
            text,
            exports,
            names: Mutex::default(),
        })
    }

    pub(super) fn parse(&self) -> Arc<Parse> {
        Arc::new(ladder_syntax::parse(&self.text))
    }

    /// Its names. `exported` is what the files of its workspace show to each other.
    pub(crate) fn context(&self, exported: &Arc<Exported>, are_few: bool) -> Arc<Context> {
        if !are_few {
            return Arc::new(self.read_context(exported));
        }
        let mut names = self.names.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((of, context)) = &*names
            && Arc::ptr_eq(of, exported)
        {
            return Arc::clone(context);
        }
        let context = Arc::new(self.read_context(exported));
        *names = Some((Arc::clone(exported), Arc::clone(&context)));
        context
    }

    fn read_context(&self, exported: &Arc<Exported>) -> Context {
        let others = exported.others_of(&self.name);
        context(&self.parse(), &self.name, &others)
    }
}

/// The files of a workspace as they are on disk.
pub(crate) struct FilesOnDisk {
    pub(crate) files: Vec<(PathBuf, Arc<OnDisk>)>,
    /// What all files of the workspace, open or not, show to each other.
    pub(crate) exported: Arc<Exported>,
}

impl FilesOnDisk {
    /// Whether what is known of all of them may be kept. It takes some twenty times the memory of the texts.
    pub(crate) fn are_few(&self) -> bool {
        let bytes: usize = self.files.iter().map(|(_, file)| file.text.len()).sum();
        bytes <= MOST_KEPT
    }
}

/// The path from the workspace's folder on: no two files have one name.
pub(super) fn name_in(root: &Path, path: &Path) -> Arc<str> {
    let name = path.strip_prefix(root).unwrap_or(path);
    Arc::from(name.to_string_lossy().replace('\\', "/"))
}

//! The workspaces of many files, each loaded once.

use crate::outcome::Failure;
use ladder_workspace::{Root, Workspace, shown};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Workspaces by their folder.
#[derive(Default)]
pub(crate) struct Workspaces {
    loaded: BTreeMap<PathBuf, Option<Arc<Workspace>>>,
}

impl Workspaces {
    /// The workspace of a file. None: its settings cannot be used, and that has been reported.
    ///
    /// # Errors
    /// The settings cannot be used, and that has not been reported yet.
    pub(crate) fn of(&mut self, file: &Path) -> Result<Option<Arc<Workspace>>, Failure> {
        let folder = match Root::of(file) {
            Ok(root) => root.folder().to_owned(),
            Err(error) => return Err(Failure::new(format!("{}: {error}", shown::path(file)))),
        };
        if let Some(loaded) = self.loaded.get(&folder) {
            return Ok(loaded.clone());
        }
        let workspace = Workspace::of(file).map(Arc::new);
        if let Ok(workspace) = &workspace {
            // What the files see of each other is needed before any of them is checked.
            workspace
                .programs_seen_by_others()
                .par_iter()
                .for_each(ladder_workspace::Source::prepare);
        }
        self.loaded.insert(folder, workspace.as_ref().ok().cloned());
        Ok(Some(workspace?))
    }

    /// Those that can be used, each with its folder.
    #[cfg(feature = "run")]
    pub(crate) fn loaded(&self) -> Vec<(PathBuf, Arc<Workspace>)> {
        let loaded = self.loaded.iter();
        let usable = loaded.filter_map(|(folder, workspace)| Some((folder.clone(), workspace.clone()?)));
        usable.collect()
    }
}

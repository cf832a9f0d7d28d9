//! A program of a workspace as it is on disk.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use ladder_analysis::context::Context;
use ladder_analysis::{AnalyzeOptions, context};
use ladder_analysis::{Exported, Exports, exports};
use ladder_notations::Foreign;
use ladder_syntax::Parse;
use ladder_workspace::{ForeignPrograms, Member, Stamp};

/// The names of files that no editor shows are kept in workspaces with this many bytes of text; in larger ones they are read
/// again when it is asked for.
const MOST_KEPT: u64 = 2 << 20;

/// A program as it is on disk: what counts of one that no editor shows.
#[derive(Debug)]
pub struct OnDisk {
    /// The name by which findings and programs know it.
    pub name: Arc<str>,
    pub(crate) stamp: Stamp,
    path: PathBuf,
    programs: Arc<ForeignPrograms>,
    /// Its text. All else that is known of it is read again when it is asked for. Of a file that an editor shows the text too is
    /// read only if it is asked for: it is mostly the same that the editor has sent.
    text: OnceLock<Member>,
    pub(crate) exports: Arc<Exports>,
    /// Its names, as they are among these other files.
    names: Mutex<Option<(Arc<Exported>, Arc<Context>)>>,
}

impl OnDisk {
    /// Reads a program. `all` are those of its workspace, whose folder is `root`.
    pub(crate) fn read(
        programs: &Arc<ForeignPrograms>,
        (root, all): (&Path, &[PathBuf]),
        path: &Path,
    ) -> Option<OnDisk> {
        let stamp = programs.disk().stamp(path);
        let member = programs.member(path, Some((root, all))).ok()?;
        let name = name_in(root, path);
        let exports = exports_of(member.ladder(), &name);
        let text = OnceLock::from(member);
        Some(OnDisk::new(programs, (path, stamp), name, exports, text))
    }

    /// A program that an editor shows, before anything is known of it: as if it were empty.
    pub(crate) fn shown(programs: &Arc<ForeignPrograms>, root: &Path, path: &Path) -> OnDisk {
        let name = name_in(root, path);
        let exports = exports_of("", &name);
        let stamp = programs.disk().stamp(path);
        OnDisk::new(programs, (path, stamp), name, exports, OnceLock::new())
    }

    /// The same, as it was written then, without its text, which is read again if it is asked for.
    pub(crate) fn without_text(&self, stamp: Stamp) -> OnDisk {
        let (name, exports) = (Arc::clone(&self.name), Arc::clone(&self.exports));
        OnDisk::new(
            &self.programs,
            (&self.path, stamp),
            name,
            exports,
            OnceLock::new(),
        )
    }

    /// The same as an editor shows it, where it is a program of another notation.
    pub(crate) fn as_shown(&self, foreign: &Arc<Foreign>, exports: &Arc<Exports>) -> OnDisk {
        let (name, exports) = (Arc::clone(&self.name), Arc::clone(exports));
        let text = OnceLock::from(Member::Foreign(Arc::clone(foreign)));
        OnDisk::new(&self.programs, (&self.path, self.stamp), name, exports, text)
    }

    fn new(
        programs: &Arc<ForeignPrograms>,
        (path, stamp): (&Path, Stamp),
        name: Arc<str>,
        exports: Arc<Exports>,
        text: OnceLock<Member>,
    ) -> OnDisk {
        OnDisk {
            name,
            stamp,
            path: path.to_owned(),
            programs: Arc::clone(programs),
            text,
            exports,
            names: Mutex::default(),
        }
    }

    /// Its text; empty if it cannot be read any more.
    pub fn member(&self) -> &Member {
        let empty = |_| Member::Ladder(String::new());
        self.text
            .get_or_init(|| self.programs.member(&self.path, None).unwrap_or_else(empty))
    }

    /// Whether its text is held.
    pub(crate) fn holds_text(&self) -> bool {
        self.text.get().is_some()
    }

    pub(crate) fn parse(&self) -> Arc<Parse> {
        Arc::new(ladder_syntax::parse(self.member().ladder()))
    }

    /// Its names. `exported` is what the files of its workspace show to each other.
    pub fn context(&self, exported: &Arc<Exported>, are_few: bool) -> Arc<Context> {
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
        context(&self.parse(), AnalyzeOptions::new(&self.name).among(&others))
    }
}

/// The files of a workspace as they are on disk.
pub struct FilesOnDisk {
    /// Each with its path.
    pub files: Vec<(PathBuf, Arc<OnDisk>)>,
    /// What all files of the workspace, open or not, show to each other.
    pub exported: Arc<Exported>,
}

impl FilesOnDisk {
    /// Whether what is known of all of them may be kept. It takes some twenty times the memory of the texts.
    pub(crate) fn are_few(&self) -> bool {
        let bytes: u64 = self.files.iter().map(|(_, file)| file.stamp.bytes()).sum();
        bytes <= MOST_KEPT
    }
}

fn exports_of(text: &str, name: &str) -> Arc<Exports> {
    Arc::new(exports(&Arc::new(ladder_syntax::parse(text)), name))
}

/// The path from the workspace's folder on: no two files have one name.
pub(crate) fn name_in(root: &Path, path: &Path) -> Arc<str> {
    let name = path.strip_prefix(root).unwrap_or(path);
    Arc::from(name.to_string_lossy().replace('\\', "/"))
}

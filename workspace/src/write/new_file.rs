//! A new file that takes the name of the old one when it is whole.
//!
//! On Linux it has no name until then: whatever ends the process before leaves nothing. To replace a file it takes a temporary
//! name for a moment, since a file without a name cannot be renamed. On other systems, and on file systems that know no such files,
//! it has that from the beginning.

use super::folder_of;
use super::temporary::Temporary;
use std::fs::{self, File, Metadata, Permissions};
use std::io;
use std::path::{Path, PathBuf};

/// The new file.
#[derive(Debug)]
pub(super) struct NewFile {
    stage: Stage,
    target: PathBuf,
    /// The mode to keep; none for a new file.
    mode: Option<Permissions>,
}

#[derive(Debug)]
enum Stage {
    #[cfg(target_os = "linux")]
    Nameless(File),
    Named(Temporary),
}

impl NewFile {
    pub(super) fn of(target: &Path, there: Option<&Metadata>) -> io::Result<NewFile> {
        let private = there.is_some();
        Ok(NewFile {
            stage: stage(target, private)?,
            target: target.to_owned(),
            mode: there.map(Metadata::permissions),
        })
    }

    pub(super) fn file(&self) -> &File {
        match &self.stage {
            #[cfg(target_os = "linux")]
            Stage::Nameless(file) => file,
            Stage::Named(temporary) => temporary.file(),
        }
    }

    /// Whether the new file has the old one's owner and group, or could be given to them.
    pub(super) fn belongs_to_the_owner_of(&self, there: &Metadata) -> bool {
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, fchown};
            let Ok(own) = self.file().metadata() else {
                return false;
            };
            let wanted = |new: u32, old: u32| (new != old).then_some(old);
            let (user, group) = (wanted(own.uid(), there.uid()), wanted(own.gid(), there.gid()));
            user.is_none() && group.is_none() || fchown(self.file(), user, group).is_ok()
        }
        #[cfg(not(unix))]
        {
            let _ = there;
            true
        }
    }

    /// What was written is on the disk before the name leads to it, and the name is there when this returns.
    pub(super) fn commit(self) -> io::Result<()> {
        if let Some(mode) = &self.mode {
            self.file().set_permissions(mode.clone())?;
        }
        self.file().sync_all()?;
        let temporary = match self.stage {
            #[cfg(target_os = "linux")]
            Stage::Nameless(file) => Temporary::named(file, &self.target)?,
            Stage::Named(temporary) => temporary,
        };
        temporary.rename(&self.target)?;
        sync_folder(folder_of(&self.target));
        Ok(())
    }
}

#[cfg(target_os = "linux")]
fn stage(target: &Path, private: bool) -> io::Result<Stage> {
    use rustix::fs::{Mode, OFlags};
    let mode = Mode::from_raw_mode(if private { 0o600 } else { 0o666 });
    let flags = OFlags::TMPFILE | OFlags::RDWR | OFlags::CLOEXEC;
    // A name is given through /proc; where that is not there, it must be given now.
    if Path::new("/proc/self/fd").is_dir()
        && let Ok(file) = rustix::fs::open(folder_of(target), flags, mode)
    {
        return Ok(Stage::Nameless(File::from(file)));
    }
    Temporary::new(target, private).map(Stage::Named)
}

#[cfg(not(target_os = "linux"))]
fn stage(target: &Path, private: bool) -> io::Result<Stage> {
    Temporary::new(target, private).map(Stage::Named)
}

/// A new name is on the disk when its folder is. Not every file system can be asked for that.
fn sync_folder(folder: &Path) {
    if cfg!(unix) {
        let _ = fs::File::open(folder).and_then(|folder| folder.sync_all());
    }
}

//! Writing over the bytes of a file that must stay the one that it is: it has several names, belongs to another user, or
//! lies in a folder that takes no new file.
//!
//! This is not one step. So the old content is kept in a file of its own until the new one is on the disk: next to it, or
//! in the folder for temporary files where nothing can be made next to it. What ends the process in between leaves the
//! backup behind, which is what it is for.

use super::folder_of;
use crate::error::Problem;
use std::fs::File;
use std::io::{self, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// The new content, and where it is to go.
#[derive(Debug)]
pub(super) struct InPlace {
    /// Gathers what is written; it has no name.
    spool: File,
    file: File,
    target: PathBuf,
}

impl InPlace {
    pub(super) fn of(target: PathBuf) -> io::Result<InPlace> {
        Ok(InPlace {
            spool: tempfile::tempfile()?,
            file: File::options().read(true).write(true).open(&target)?,
            target,
        })
    }

    pub(super) fn spool(&self) -> &File {
        &self.spool
    }

    pub(super) fn commit(mut self) -> Result<(), Problem> {
        let mut backup = self.back_up().map_err(Problem::Write)?;
        let Err(error) = put(&mut self.spool, &mut self.file) else {
            return Ok(());
        };
        // As it was before; the backup goes only if that is done.
        if put(backup.as_file_mut(), &mut self.file).is_ok() {
            return Err(Problem::Write(error));
        }
        Err(match backup.keep() {
            Ok((_, backup)) => Problem::HalfWritten { error, backup },
            Err(_) => Problem::Write(error),
        })
    }

    /// A copy of the old content, on the disk.
    fn back_up(&mut self) -> io::Result<NamedTempFile> {
        let mut backup = backup_in(folder_of(&self.target), &self.target)
            .or_else(|_| backup_in(&std::env::temp_dir(), &self.target))?;
        put(&mut self.file, backup.as_file_mut())?;
        Ok(backup)
    }
}

fn backup_in(folder: &Path, target: &Path) -> io::Result<NamedTempFile> {
    let name = target.file_name().unwrap_or_default().to_string_lossy();
    let name: String = name.chars().take(50).collect();
    tempfile::Builder::new()
        .prefix(&format!("{name}."))
        .suffix(".ladder-backup")
        .tempfile_in(folder)
}

/// Makes the content of one file that of another.
fn put(from: &mut File, into: &mut File) -> io::Result<()> {
    from.seek(SeekFrom::Start(0))?;
    into.seek(SeekFrom::Start(0))?;
    let length = io::copy(from, into)?;
    into.set_len(length)?;
    into.sync_all()
}

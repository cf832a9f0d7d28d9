//! What becomes of a file that is there already: a slip of the finger must not cost a program.

use super::made;
use crate::outcome::Failure;
use ladder_workspace::{SETTINGS_FILE, is_ladder_text, is_scenario, is_scene, shown};
use std::ffi::OsStr;
use std::path::Path;

/// What may become of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Existing {
    /// It is replaced if one of the commands made it; else it stays.
    Kept,
    /// It is replaced, whatever it is.
    Replaced,
}

impl Existing {
    /// As `--force` has it.
    pub(crate) fn by(force: bool) -> Existing {
        if force { Existing::Replaced } else { Existing::Kept }
    }
}

/// Looks whether an output file may be written.
///
/// # Errors
/// It is there, and is a program or something else that no command made; or a link, through which nothing is written.
pub(crate) fn may_write(file: &Path, existing: Existing) -> Result<(), Failure> {
    let failure = |problem: &str| Err(Failure::new(format!("{}: {problem}", shown::path(file))));
    let is_link = file.symlink_metadata().is_ok_and(|own| own.is_symlink());
    let link = "this is a link, and nothing is written through it; name another file, or end with --force, which replaces the link";
    let metadata = match file.metadata() {
        Ok(metadata) => metadata,
        Err(_) if is_link && existing == Existing::Kept => return failure(link),
        // There is none; or it is reported when it is written.
        Err(_) => return Ok(()),
    };
    // What is not a file (a device, a pipe) is written to as it is, and an empty one holds nothing to lose.
    if existing == Existing::Replaced || !metadata.is_file() {
        return Ok(());
    }
    // By any of its names.
    let own = file.canonicalize().unwrap_or_else(|_| file.to_owned());
    for name in [file, &own] {
        if is_ladder_text(name) {
            return failure(
                "this is a program, and it stays as it is; name another file, or end with --force",
            );
        }
        if is_scenario(name) || is_scene(name) || name.file_name() == Some(OsStr::new(SETTINGS_FILE)) {
            return failure(
                "this belongs to a program, and it stays as it is; name another file, or end with --force",
            );
        }
    }
    if is_link {
        return failure(link);
    }
    if metadata.len() == 0 || made::by_a_command(file) {
        return Ok(());
    }
    failure("this file is there, and no command of ladder made it; name another file, or end with --force")
}

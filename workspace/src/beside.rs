//! Files that lie beside a program and belong to it, as other systems have them.

use crate::error::{FileError, Problem};
use crate::{named, regular, text};
use ladder_syntax::MAX_FILE_BYTES;
use std::fs::{self, File};
use std::path::Path;

/// This many names of a folder are looked at. Whoever keeps more files in it does without those beside a program.
const MOST_NAMES: usize = 10_000;

/// This many files belong to one program.
const MOST_FILES: usize = 100;

/// The files in a program's folder that belong to it, as `wanted` knows them by their names: each with its name, sorted.
/// Links do not lead out of the folder or the workspace.
///
/// # Errors
/// One of them is no regular file, lies outside, or cannot be read; or together they are larger than [`MAX_FILE_BYTES`].
pub fn read_beside(
    program: &Path,
    wanted: &dyn Fn(&str) -> bool,
) -> Result<Vec<(String, Vec<u8>)>, FileError> {
    let folder = program.parent().unwrap_or(Path::new(""));
    let listed = if folder == Path::new("") {
        Path::new(".")
    } else {
        folder
    };
    // A program that is not on disk (standard input) has nothing beside it.
    let Ok(entries) = fs::read_dir(listed) else {
        return Ok(Vec::new());
    };
    let names = entries
        .take(MOST_NAMES)
        .flatten()
        .filter_map(|entry| entry.file_name().into_string().ok());
    let is_other = |name: &String| program.file_name().is_none_or(|own| own != name.as_str());
    let mut names: Vec<String> = names.filter(|name| is_other(name) && wanted(name)).collect();
    names.sort_unstable();
    names.truncate(MOST_FILES);
    let mut found = Vec::with_capacity(names.len());
    let mut size = 0;
    for name in names {
        let path = folder.join(&name);
        if path.is_symlink() && !named::stays_inside(folder, &path) {
            return Err(FileError::new(&path, Problem::Outside));
        }
        let bytes = text::bytes_from(regular::open_plain(&path, File::options().read(true))?, &path)?;
        size += bytes.len();
        if size > MAX_FILE_BYTES {
            return Err(FileError::new(&path, Problem::TooLarge));
        }
        found.push((name, bytes));
    }
    Ok(found)
}

//! A program of another system as a notation reads it: with the files next to it that belong to it.

use crate::error::{FileError, Problem};
use crate::{named, regular, text};
use ladder_notation::{Companion, Notation, Source};
use ladder_syntax::MAX_FILE_BYTES;
use std::fs::{self, File};
use std::path::Path;

/// This many names of a folder are checked: of a program in a larger folder, some files may be missed.
const MOST_NAMES: usize = 10_000;

/// This many files belong to one program.
pub(crate) const MOST_FILES: usize = 100;

/// A program of another system, whose content is at hand, with the files in its folder that belong to it. Every command
/// and request that takes such a program has it from here.
///
/// # Errors
/// A file that belongs to it is not a regular file, lies outside, or cannot be read; or together they are larger than
/// [`MAX_FILE_BYTES`].
pub fn foreign_source<'s>(
    notation: &dyn Notation,
    program: &'s Path,
    bytes: &'s [u8],
) -> Result<Source<'s>, FileError> {
    source(notation, program, bytes, |inner, wanted| {
        read_companions(program, inner, wanted)
    })
}

/// The same, with the files that belong to it as they are read.
pub(crate) fn source<'s>(
    notation: &dyn Notation,
    program: &'s Path,
    bytes: &'s [u8],
    read: impl FnOnce(Option<&str>, &dyn Fn(&str) -> bool) -> Result<Vec<Companion>, FileError>,
) -> Result<Source<'s>, FileError> {
    let name = program
        .file_stem()
        .map(|stem| stem.to_string_lossy())
        .unwrap_or_default();
    let wanted = |file: &str| notation.has_companion(&name, file);
    let companions = read(notation.companion_folder(), &wanted)?;
    Ok(Source {
        name,
        bytes,
        companions,
    })
}

/// Whether a file belongs to a program, as [`Notation::has_companion`] says for those in its folder and in the folder next
/// to it.
pub fn is_companion(notation: &dyn Notation, program: &Path, file: &Path) -> bool {
    let (Some(folder), Some(stem)) = (program.parent(), program.file_stem()) else {
        return false;
    };
    let Ok(below) = file.strip_prefix(folder) else {
        return false;
    };
    let parts: Vec<_> = below.iter().map(|part| part.to_string_lossy()).collect();
    let name = match &parts[..] {
        [name] => name.to_string(),
        [inner, name] if notation.companion_folder() == Some(inner.as_ref()) => format!("{inner}/{name}"),
        _ => return false,
    };
    program != file && notation.has_companion(&stem.to_string_lossy(), &name)
}

/// The files that belong to a program, as `wanted` knows them by their names, sorted: those in its folder, and in the folder
/// `inner` of that. Links do not lead out of the folder or the workspace.
pub(crate) fn read_companions(
    program: &Path,
    inner: Option<&str>,
    wanted: &dyn Fn(&str) -> bool,
) -> Result<Vec<Companion>, FileError> {
    let folder = program.parent().unwrap_or(Path::new(""));
    let is_other = |name: &String| program.file_name().is_none_or(|own| own != name.as_str());
    let mut names: Vec<String> = listed(folder).filter(is_other).collect();
    if let Some(inner) = inner {
        names.extend(listed(&folder.join(inner)).map(|name| format!("{inner}/{name}")));
    }
    names.retain(|name| wanted(name));
    names.sort_unstable();
    names.truncate(MOST_FILES);
    let mut found = Vec::with_capacity(names.len());
    let mut size = 0;
    for name in names {
        let path = folder.join(&name);
        let is_link =
            path.is_symlink() || (name.contains('/') && path.parent().is_some_and(Path::is_symlink));
        if is_link && !named::stays_inside(folder, &path) {
            return Err(FileError::new(&path, Problem::Outside));
        }
        let bytes = text::bytes_from(regular::open_plain(&path, File::options().read(true))?, &path)?;
        size += bytes.len();
        if size > MAX_FILE_BYTES {
            return Err(FileError::new(&path, Problem::TooLarge));
        }
        found.push(Companion { name, bytes });
    }
    Ok(found)
}

/// The names in a folder. One that cannot be read, as that of a program from standard input, has none.
fn listed(folder: &Path) -> impl Iterator<Item = String> {
    let folder = if folder == Path::new("") {
        Path::new(".")
    } else {
        folder
    };
    let entries = fs::read_dir(folder).into_iter().flatten();
    let names = entries.take(MOST_NAMES).flatten();
    names.filter_map(|entry| entry.file_name().into_string().ok())
}

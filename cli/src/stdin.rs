//! Standard input in the place of a file: `-` among the paths.

use crate::outcome::Failure;
use ladder_workspace::{FileError, MAX_FILE_BYTES, Problem};
use std::io::Read;
use std::path::{Path, PathBuf};

/// The name in messages, where the person gave none.
const NAME: &str = "<stdin>";

/// Whether the text comes from stdin: the paths are `-`. `name` is what `--stdin-filename` says.
///
/// # Errors
/// `-` is next to other paths, or a name is given and no text that it is for.
pub(crate) fn is_meant(paths: &[PathBuf], name: Option<&Path>) -> Result<bool, Failure> {
    let meant = paths.iter().any(|path| path == Path::new("-"));
    if meant && paths.len() > 1 {
        return Err(Failure::new(
            "`-` (stdin) cannot be given together with other paths",
        ));
    }
    if !meant && name.is_some() {
        return Err(Failure::new(
            "--stdin-filename needs `-` as the path, which reads stdin",
        ));
    }
    Ok(meant)
}

/// The name that the text goes by in messages.
pub(crate) fn name_or_default(name: Option<&Path>) -> &Path {
    name.unwrap_or(Path::new(NAME))
}

/// Reads the text.
///
/// # Errors
/// As for a file: it is too large, is not UTF-8, or the operating system refuses.
pub(crate) fn read(name: &Path) -> Result<String, FileError> {
    ladder_workspace::decode(name, read_bytes(name)?)
}

/// Reads what need not be text. One byte too many is kept, so that a caller that takes it for a text can complain of it.
///
/// # Errors
/// The operating system refuses.
pub(crate) fn read_bytes(name: &Path) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    std::io::stdin()
        .lock()
        // One byte past the limit is enough to see that the text is too large.
        .take(MAX_FILE_BYTES as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| FileError {
            path: name.to_owned(),
            problem: Problem::Read(error),
        })?;
    Ok(bytes)
}

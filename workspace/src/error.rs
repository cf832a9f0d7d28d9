//! What can be wrong with a file, in words that say what to do.

use crate::MAX_FILE_BYTES;
use ladder_syntax::LineColumn;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// A file or folder that cannot be used.
#[derive(Debug)]
pub struct FileError {
    /// The file, as it was named.
    pub path: PathBuf,
    /// What is wrong with it.
    pub problem: Problem,
}

/// What is wrong with a file or folder.
#[derive(Debug)]
pub enum Problem {
    /// Nothing has this name.
    Missing,
    /// A folder, where a file is needed.
    Directory,
    /// A folder in which no program is found.
    NoPrograms,
    /// A folder in which no scenario file is found.
    NoScenarios,
    /// Larger than [`MAX_FILE_BYTES`].
    TooLarge,
    /// Bytes that are not UTF-8.
    NotUtf8 {
        /// Where the first such byte stands.
        place: LineColumn,
        /// Its value.
        byte: u8,
        /// The text begins with UTF-16's byte order mark, so it is written in that.
        utf16: bool,
    },
    /// The file may be read but not written.
    ReadOnly,
    /// The operating system refuses to read it.
    Read(io::Error),
    /// The operating system refuses to write it.
    Write(io::Error),
}

impl FileError {
    pub(crate) fn new(path: &Path, problem: Problem) -> FileError {
        FileError {
            path: path.to_owned(),
            problem,
        }
    }

    /// From a failed attempt to read.
    pub(crate) fn reading(path: &Path, error: io::Error) -> FileError {
        let problem = match error.kind() {
            io::ErrorKind::NotFound | io::ErrorKind::NotADirectory => Problem::Missing,
            io::ErrorKind::IsADirectory => Problem::Directory,
            _ => Problem::Read(error),
        };
        FileError::new(path, problem)
    }

    /// From a failed attempt to write.
    pub(crate) fn writing(path: &Path, error: io::Error) -> FileError {
        FileError::new(path, Problem::Write(error))
    }
}

impl fmt::Display for FileError {
    /// `motor.clad: no such file or folder`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path.display(), self.problem)
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Problem::Missing => f.write_str("no such file or folder"),
            Problem::Directory => f.write_str("this is a folder; name a file in it"),
            Problem::NoPrograms => f.write_str("no program (a file ending in .clad) is in this folder"),
            Problem::NoScenarios => {
                f.write_str("no scenarios (a file ending in .ladder-test) are in this folder")
            }
            Problem::TooLarge => write!(
                f,
                "the file is larger than {} MiB, the most that is read",
                MAX_FILE_BYTES >> 20
            ),
            Problem::NotUtf8 { utf16: true, .. } => {
                f.write_str("the file is not UTF-8 but UTF-16; save it as UTF-8 in your editor")
            }
            Problem::NotUtf8 { place, byte, .. } => write!(
                f,
                "the file is not UTF-8: byte 16#{byte:02X} at line {}, column {}; save it as UTF-8 in your editor",
                place.line, place.column
            ),
            Problem::ReadOnly => f.write_str("the file is write-protected"),
            Problem::Read(error) => write!(f, "cannot be read: {error}"),
            Problem::Write(error) => write!(f, "cannot be written: {error}"),
        }
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.problem {
            Problem::Read(error) | Problem::Write(error) => Some(error),
            _ => None,
        }
    }
}

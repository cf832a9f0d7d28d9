//! What can be wrong with a file, in words that say what to do.

use crate::shown;
use ladder_syntax::LineColumn;
use ladder_syntax::MAX_FILE_BYTES;
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
    /// A folder in which no program in ladder text is found.
    NoLadderText,
    /// A folder in which no scenario file is found.
    NoScenarios,
    /// A folder in which no file of the kind that is looked for is found.
    NoneOfThese,
    /// A settings file without tasks, where a program is needed.
    NoTasks,
    /// Larger than [`MAX_FILE_BYTES`].
    TooLarge,
    /// The files that may belong to a program, in this folder, are larger than [`MAX_FILE_BYTES`] together.
    ProjectTooLarge(PathBuf),
    /// Bytes that are not UTF-8.
    NotUtf8 {
        /// Where the first such byte is.
        place: LineColumn,
        /// Its value.
        byte: u8,
        /// The text begins with UTF-16's byte order mark, so it is written in that.
        utf16: bool,
    },
    /// Text that is not in the notation that its name says; why.
    Broken(String),
    /// The file may be read but not written.
    ReadOnly,
    /// Neither a regular file nor a folder.
    Special(Special),
    /// A workspace names it by its whole path.
    NotRelative,
    /// A workspace names it, and it lies outside.
    Outside,
    /// It was to be written over, but it is none of the tools' own files.
    NotOurs,
    /// Another run uses it.
    InUse,
    /// Writing failed in the middle, in a file that could only be written in its place.
    HalfWritten {
        /// Why.
        error: io::Error,
        /// Where its old content is.
        backup: PathBuf,
    },
    /// The operating system refuses to read it.
    Read(io::Error),
    /// The operating system refuses to write it.
    Write(io::Error),
}

/// What looks like a file and is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Special {
    /// A named pipe.
    Pipe,
    /// A socket.
    Socket,
    /// A device.
    Device,
    /// A file of `/proc` and the like.
    System,
}

impl fmt::Display for Special {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Special::Pipe => "a pipe",
            Special::Socket => "a socket",
            Special::Device => "a device",
            Special::System => "a file of the operating system itself",
        })
    }
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
        write!(f, "{}: {}", shown::path(&self.path), self.problem)?;
        if self.path == Path::new("-") && matches!(self.problem, Problem::Missing) {
            f.write_str("; of standard input only `ladder check -` and `ladder fmt -` read a program")?;
        }
        Ok(())
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Problem::Missing => f.write_str("no such file or folder"),
            Problem::Directory => f.write_str("this is a folder; name a file in it"),
            Problem::NoPrograms => f.write_str("no program (a file ending in .clad or .st) is in this folder"),
            Problem::NoLadderText => f.write_str("no program (a file ending in .clad) is in this folder"),
            Problem::NoScenarios => {
                f.write_str("no scenarios (a file ending in .ladder-test) are in this folder")
            }
            Problem::NoneOfThese => f.write_str("no file that could be meant is in this folder"),
            Problem::NoTasks => f.write_str(
                "there are no tasks to run: write [[task]] with `name`, `interval` and `programs`, or name a program",
            ),
            Problem::TooLarge => write!(
                f,
                "the file is larger than {} MiB, the most that is read",
                MAX_FILE_BYTES >> 20
            ),
            Problem::ProjectTooLarge(folder) => write!(
                f,
                "what may belong to this program is larger than {} MiB, the most that is read, in {}; an empty ladder.toml in the folder of its project keeps the rest out",
                MAX_FILE_BYTES >> 20,
                shown::path(folder)
            ),
            Problem::NotUtf8 { utf16: true, .. } => {
                f.write_str("the file is not UTF-8 but UTF-16; save it as UTF-8 in your editor")
            }
            Problem::NotUtf8 { place, byte, .. } => write!(
                f,
                "the file is not UTF-8: byte 16#{byte:02X} at line {}, column {}; save it as UTF-8 in your editor",
                place.line, place.column
            ),
            Problem::Broken(why) => f.write_str(why),
            Problem::ReadOnly => f.write_str("the file is write-protected"),
            Problem::Special(what) => write!(f, "this is {what}, and only a regular file is used here"),
            Problem::NotRelative => f.write_str(
                "a path in a workspace is relative: write it as it is seen from the file that names it",
            ),
            Problem::Outside => f.write_str(
                "this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one",
            ),
            Problem::NotOurs => f.write_str(
                "this is not a file of retentive values, and it stays as it is; name another file, or remove this one",
            ),
            Problem::InUse => f.write_str("another run uses this file; wait until that ends, or name another file"),
            Problem::HalfWritten { error, backup } => write!(
                f,
                "could only be written in part: {error}; its old content is in {}",
                shown::path(backup)
            ),
            Problem::Read(error) => write!(f, "cannot be read: {error}"),
            Problem::Write(error) => write!(f, "cannot be written: {error}"),
        }
    }
}

impl std::error::Error for FileError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match &self.problem {
            Problem::Read(error) | Problem::Write(error) | Problem::HalfWritten { error, .. } => Some(error),
            _ => None,
        }
    }
}

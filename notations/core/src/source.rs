//! A file in some notation, with the files next to it that belong to it.

use super::{LineColumn, Lines, ReadError};
use std::borrow::Cow;

/// A larger file is not read.
const MOST_BYTES: usize = 4 << 20;

/// The same of a file that holds a whole project.
const MOST_BYTES_OF_PROJECTS: usize = 16 << 20;

/// A file in some notation.
#[derive(Debug, Clone)]
pub struct Source<'s> {
    /// The stem of its name, which names the program.
    pub name: Cow<'s, str>,
    /// Its content.
    pub bytes: &'s [u8],
    /// The files next to it that [`Notation::has_companion`](super::Notation::has_companion) asked for, by name.
    pub companions: Vec<Companion>,
}

/// A file next to a program that belongs to it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Companion {
    /// Its whole name, without the folder of the program; after a `/` if it is in a folder of its own.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl<'s> Source<'s> {
    /// A file without companions.
    pub const fn alone(name: &'s str, bytes: &'s [u8]) -> Source<'s> {
        Source {
            name: Cow::Borrowed(name),
            bytes,
            companions: Vec::new(),
        }
    }

    /// Whether the file is small enough to be read.
    ///
    /// # Errors
    ///
    /// If it is not.
    pub fn bounded(&self) -> Result<(), ReadError> {
        self.at_most(MOST_BYTES)
    }

    /// Whether the file has at most so many bytes.
    ///
    /// # Errors
    ///
    /// If it has more.
    fn at_most(&self, bytes: usize) -> Result<(), ReadError> {
        if self.bytes.len() <= bytes {
            return Ok(());
        }
        let message = format!("the file is larger than {} MiB; programs are not", bytes >> 20);
        Err(ReadError::whole(message))
    }

    /// The content of a file that holds a whole project as text.
    ///
    /// # Errors
    ///
    /// If it is too large, or not UTF-8.
    pub fn text_of_project(&self) -> Result<&'s str, ReadError> {
        self.at_most(MOST_BYTES_OF_PROJECTS)?;
        text_of(self.bytes)
    }

    /// The content as text.
    ///
    /// # Errors
    ///
    /// If it is too large, or not UTF-8; the place is the first byte that is not.
    pub fn text(&self) -> Result<&'s str, ReadError> {
        self.bounded()?;
        text_of(self.bytes)
    }
}

/// Bytes as text.
///
/// # Errors
///
/// If they are not UTF-8; the place is the first byte that is not.
pub fn text_of(bytes: &[u8]) -> Result<&str, ReadError> {
    std::str::from_utf8(bytes).map_err(|error| {
        let good = String::from_utf8_lossy(&bytes[..error.valid_up_to()]).into_owned();
        let place: LineColumn = Lines::of(&good).place(&good, good.len());
        ReadError::at(
            place,
            "the file is not text in UTF-8 from here on: save it again as UTF-8",
        )
    })
}

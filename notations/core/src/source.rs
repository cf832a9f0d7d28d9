//! A file in some notation, with the files next to it that belong to it.

use super::{LineColumn, Lines, ReadError};
use std::borrow::Cow;

/// A larger file is not read.
const MOST_BYTES: usize = 4 << 20;

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
        if self.bytes.len() <= MOST_BYTES {
            return Ok(());
        }
        let message = format!(
            "the file is larger than {} MiB; programs are not",
            MOST_BYTES >> 20
        );
        Err(ReadError::whole(message))
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
        ReadError::at(place, "the file is not text in UTF-8 from here on")
    })
}

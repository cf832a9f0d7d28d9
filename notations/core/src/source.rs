//! A file in some notation, with the files next to it that belong to it.

use super::{LineColumn, Lines, ReadError};
use std::any::Any;
use std::borrow::Cow;
use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

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
    /// The other files that [`Notation::has_companion`](super::Notation::has_companion) asked for, the nearest first: of two
    /// that declare one name the first counts.
    pub companions: Vec<Companion>,
}

/// A file that belongs to a program in another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Companion {
    /// Its name as it is seen from the folder of the program, with `/`: `motor.s7res`, `../types/Motor.s7dcl`.
    pub name: String,
    /// Its content.
    pub bytes: Bytes,
}

/// The content of a file that many programs may be read with. Copies are one, and what was made of it once is kept with it.
#[derive(Clone, Default)]
pub struct Bytes(Arc<Held>);

#[derive(Default)]
struct Held {
    bytes: Vec<u8>,
    made: OnceLock<Box<dyn Any + Send + Sync>>,
}

impl Bytes {
    /// What a reader makes of the content, made at the first call. A file is of one notation, and asked for one type; of
    /// another type it is made each time.
    pub fn made<T: Any + Send + Sync + Clone>(&self, make: impl Fn(&[u8]) -> T) -> T {
        let made = self.0.made.get_or_init(|| Box::new(make(self)));
        made.downcast_ref::<T>().cloned().unwrap_or_else(|| make(self))
    }
}

impl From<Vec<u8>> for Bytes {
    fn from(bytes: Vec<u8>) -> Bytes {
        Bytes(Arc::new(Held {
            bytes,
            made: OnceLock::new(),
        }))
    }
}

impl From<String> for Bytes {
    fn from(text: String) -> Bytes {
        text.into_bytes().into()
    }
}

impl Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.0.bytes
    }
}

impl AsRef<[u8]> for Bytes {
    fn as_ref(&self) -> &[u8] {
        self
    }
}

impl PartialEq for Bytes {
    fn eq(&self, other: &Bytes) -> bool {
        **self == **other
    }
}

impl Eq for Bytes {}

impl fmt::Debug for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
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

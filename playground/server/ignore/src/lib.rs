//! Searches and patterns of a page. It has no folders of an operating system, so a search finds nothing; the patterns of a `ladder.toml`
//! are those of `.gitignore` with `*`, `**` and `?`, and without classes of characters.

pub mod gitignore;

use std::cmp::Ordering;
use std::fs::FileType;
use std::path::{Path, PathBuf};
use std::{fmt, io};

/// What patterns say of a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Match<T> {
    /// Nothing.
    None,
    /// It is passed over.
    Ignore(T),
    /// It is not passed over.
    Whitelist(T),
}

impl<T> Match<T> {
    /// Whether it is passed over.
    pub fn is_ignore(&self) -> bool {
        matches!(self, Match::Ignore(_))
    }
}

/// What is wrong. Only the last one happens.
#[derive(Debug)]
pub enum Error {
    /// With the file.
    WithPath { path: PathBuf, err: Box<Error> },
    /// With the depth.
    WithDepth { depth: usize, err: Box<Error> },
    /// With the line.
    WithLineNumber { line: u64, err: Box<Error> },
    /// A pattern cannot be read.
    Glob { glob: Option<String>, err: String },
}

impl Error {
    /// The error of the operating system, which there is none of.
    pub fn io_error(&self) -> Option<&io::Error> {
        None
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::WithPath { err, .. }
            | Error::WithDepth { err, .. }
            | Error::WithLineNumber { err, .. } => err.fmt(f),
            Error::Glob { err, .. } => f.write_str(err),
        }
    }
}

/// Something that a search finds: nothing.
#[derive(Debug)]
pub enum DirEntry {}

impl DirEntry {
    /// Its path.
    pub fn into_path(self) -> PathBuf {
        match self {}
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        match *self {}
    }

    /// How deep it lies.
    pub fn depth(&self) -> usize {
        match *self {}
    }

    /// Whether it is a link.
    pub fn path_is_symlink(&self) -> bool {
        match *self {}
    }

    /// What it is.
    pub fn file_type(&self) -> Option<FileType> {
        match *self {}
    }
}

/// A search that finds nothing, whatever it is told.
#[derive(Debug)]
pub struct WalkBuilder;

impl WalkBuilder {
    /// A search below a folder.
    pub fn new(_folder: impl AsRef<Path>) -> WalkBuilder {
        WalkBuilder
    }

    /// Adds a folder.
    pub fn add(&mut self, _folder: impl AsRef<Path>) -> &mut WalkBuilder {
        self
    }

    /// Whether there must be a repository.
    pub fn require_git(&mut self, _yes: bool) -> &mut WalkBuilder {
        self
    }

    /// Whether what git keeps counts.
    pub fn git_exclude(&mut self, _yes: bool) -> &mut WalkBuilder {
        self
    }

    /// Whether the folders above count.
    pub fn parents(&mut self, _yes: bool) -> &mut WalkBuilder {
        self
    }

    /// How deep it goes.
    pub fn max_depth(&mut self, _depth: Option<usize>) -> &mut WalkBuilder {
        self
    }

    /// The order of what is found.
    pub fn sort_by_file_path(
        &mut self,
        _compare: impl Fn(&Path, &Path) -> Ordering + Send + Sync + 'static,
    ) -> &mut WalkBuilder {
        self
    }

    /// What is entered.
    pub fn filter_entry(
        &mut self,
        _is_wanted: impl Fn(&DirEntry) -> bool + Send + Sync + 'static,
    ) -> &mut WalkBuilder {
        self
    }

    /// What is found.
    pub fn build(&self) -> std::iter::Empty<Result<DirEntry, Error>> {
        std::iter::empty()
    }
}

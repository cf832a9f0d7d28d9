//! The book in `docs/`, as mdBook reads it.

use crate::markdown::{self, Markdown};
use crate::project;
use std::path::{Path, PathBuf};

/// The folder of the book's pages.
pub fn source() -> PathBuf {
    project::root().join("docs/src")
}

/// A page of the book.
#[derive(Debug)]
pub struct Page {
    /// The file.
    pub path: PathBuf,
    /// What it says, with what it includes.
    pub content: Markdown,
}

/// Every page that the summary names, in its order.
pub fn pages() -> Vec<Page> {
    let summary = markdown::read(&project::read(&source().join("SUMMARY.md")));
    summary
        .links
        .iter()
        .map(|link| source().join(link))
        .map(|path| Page {
            content: markdown::read(&with_includes(&path)),
            path,
        })
        .collect()
}

/// The text of a page, with the files that it includes whole: `{{#include ../protocol.md}}`.
fn with_includes(path: &Path) -> String {
    let mut text = project::read(path);
    while let Some((before, rest)) = text.split_once("{{#include ") {
        let (file, after) = rest.split_once("}}").expect("an include is closed");
        let folder = path.parent().expect("a page is in a folder");
        text = format!("{before}{}{after}", project::read(&folder.join(file.trim())));
    }
    text
}

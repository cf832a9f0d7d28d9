//! `ladder.libraryBlock`: the source of a block of the library, for a client that opens its address.

use ladder_analysis::library::{self, Source};
use serde::{Deserialize, Serialize};

/// The scheme of the addresses of the library's sources: they are no files, and the server has their text.
const SCHEME: &str = "ladder-library";

/// The argument of `ladder.libraryBlock`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct AskedBlock {
    /// The block's name, with the `$`.
    pub block: String,
}

/// The answer to `ladder.libraryBlock`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub struct LibraryBlock {
    /// The source, in ladder text.
    pub text: String,
}

/// Address and text of a file of the library, by the name that findings and programs know it by.
pub(crate) fn file(name: &str) -> Option<(String, &'static str)> {
    let source = library::source(name)?;
    Some((
        format!("{SCHEME}:/{}.clad", source.name.trim_start_matches('$')),
        source.text,
    ))
}

/// The source of a block; none if the library has none of the name.
pub(crate) fn block(asked: &AskedBlock) -> Option<LibraryBlock> {
    let is_it = |source: &&Source| source.name.eq_ignore_ascii_case(asked.block.trim());
    let source = library::SOURCES.iter().find(is_it)?;
    Some(LibraryBlock {
        text: source.text.to_owned(),
    })
}

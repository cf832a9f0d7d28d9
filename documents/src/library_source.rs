//! The library's sources as documents that an editor opens.

use ladder_analysis::library;

/// The scheme of the addresses of the library's sources: they are no files, and the server has their text.
const SCHEME: &str = "ladder-library";

/// Address and text of a file of the library, by the name that findings and programs know it by.
pub(crate) fn file(name: &str) -> Option<(String, &'static str)> {
    let source = library::source(name)?;
    Some((
        format!("{SCHEME}:/{}.clad", source.name.trim_start_matches('$')),
        source.text,
    ))
}

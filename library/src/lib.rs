//! The library: user-defined blocks that every workspace sees (LANGUAGE §5.7), written in the language itself.
//!
//! A block is one file here, `NAME.clad`; the comments in it are its documentation. This crate holds the texts and nothing
//! else. `ladder-analysis` reads them when a program names a block that its workspace does not define, so that a program
//! without one pays nothing.

#![forbid(unsafe_code)]

/// A block of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Its name, with the `$`.
    pub name: &'static str,
    /// The text of its file: the comment that describes it, and its definition.
    pub text: &'static str,
}

impl Source {
    /// The first sentence of its description: what it is, before the colon.
    pub fn summary(&self) -> String {
        let text = self.text.trim_start_matches(['#', ' ']);
        let end = text.find([':', '.']).unwrap_or(text.len());
        text[..end].to_owned()
    }
}

macro_rules! sources {
    ($($name:literal),* $(,)?) => {
        &[$(Source { name: concat!("$", $name), text: include_str!(concat!("../", $name, ".clad")) }),*]
    };
}

/// All blocks, by their names.
pub const SOURCES: &[Source] = sources!["Blink", "Debounce",];

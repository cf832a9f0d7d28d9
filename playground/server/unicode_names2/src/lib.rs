//! The names of characters, of which the page knows none: Python writes `"\N{DEGREE SIGN}"` for `"°"`, and no program in Click's
//! notation was seen that does.

/// The character with this name.
pub fn character(_name: &str) -> Option<char> {
    None
}

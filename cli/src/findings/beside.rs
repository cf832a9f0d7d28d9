//! The files beside a program of another system that belong to it.

use crate::outcome::Failure;
use ladder_interchange::notation::{Companion, Notation};
use std::path::Path;

/// The files beside a program of another system that belong to it.
///
/// # Errors
/// One of them cannot be read.
pub(crate) fn companions(notation: &'static dyn Notation, program: &Path) -> Result<Vec<Companion>, Failure> {
    let stem = program
        .file_stem()
        .map(|stem| stem.to_string_lossy())
        .unwrap_or_default();
    let wanted = |file: &str| notation.has_companion(&stem, file);
    let found = ladder_workspace::read_beside(program, &wanted)?;
    Ok(found
        .into_iter()
        .map(|(name, bytes)| Companion { name, bytes })
        .collect())
}

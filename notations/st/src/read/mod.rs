//! Structured Text as ladder text.
//!
//! ```text
//! text --token--> tokens --statements, expressions, declarations, units--> tree --lower--> networks of a sketch
//! ```

mod cursor;
mod declarations;
mod declare;
mod declared;
mod dialect;
mod expressions;
mod initial;
mod lower;
mod program;
mod scope;
mod statements;
mod token;
pub mod tree;
mod types;
mod units;
mod uses;

pub use dialect::Dialect;
use ladder_notation::{Lines, Names, UnreadParts};
pub use lower::{Anew, Body, Instructions};
pub(crate) use program::read;
pub use scope::{Edge, Enumeration, Known, Parameter, ParameterRole, Scope, Shape, Structure, Type};
use tree::Problem;

/// A body that is in a file of another notation.
#[derive(Clone, Copy)]
pub struct Source<'s> {
    /// Its text; places are bytes of it.
    pub text: &'s str,
    /// What it is written in.
    pub dialect: Dialect,
    /// What the other system calls the unit.
    pub unit: &'s str,
    /// What names mean in it.
    pub scope: &'s Scope,
    /// What begins anew at each call.
    pub anew: &'s [Anew],
    /// What makes blocks of the other system's own instructions, where it has any.
    pub instructions: Option<&'s Instructions<'s>>,
    /// The number of the first origin.
    pub first_origin: u32,
}

/// Reads the statements of a body. `names` has the names of the unit's tags; unread parts are added to the others.
///
/// # Errors
///
/// Where it does not parse.
pub fn read_body(
    source: &Source<'_>,
    names: &mut Names,
    unread: &mut UnreadParts,
) -> Result<Body, Vec<Problem>> {
    let (statements, comments, problems) = units::body(source.text, source.dialect);
    if !problems.is_empty() {
        return Err(problems);
    }
    let around = lower::Surroundings {
        text: source.text,
        lines: &Lines::of(source.text),
        dialect: source.dialect,
        unit: source.unit,
        scope: source.scope,
        comments: &comments,
        instructions: source.instructions,
        first_origin: source.first_origin,
    };
    Ok(lower::lower(&statements, &around, source.anew, names, unread))
}

/// Whether a text begins as a file of Structured Text does, after comments.
pub(crate) fn begins_program(text: &str) -> bool {
    token::first_words(text).is_some_and(|(word, next)| {
        let is = |own: &str| own.eq_ignore_ascii_case(word);
        let is_name = next.starts_with(|c: char| c.is_alphabetic() || c == '_');
        is_name
            && ["PROGRAM", "FUNCTION_BLOCK", "FUNCTION", "CONFIGURATION"]
                .iter()
                .any(|own| is(own))
    })
}

#[cfg(test)]
mod tests;

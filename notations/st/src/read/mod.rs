//! Structured Text as ladder text.
//!
//! ```text
//! text --token--> tokens --statements, expressions, declarations, units--> tree --lower--> networks of a sketch
//! ```

mod body;
mod chart;
mod chart_syntax;
mod cursor;
mod declarations;
mod declare;
mod declared;
mod dialect;
mod expressions;
mod initial;
mod lower;
mod neighbours;
mod parts;
mod program;
mod scope;
mod statements;
mod token;
mod tree;
mod types;
mod undeclared;
mod units;
mod uses;

pub use body::Body;
pub use dialect::Dialect;
use ladder_notation::{Lines, Names, UnreadParts};
pub use lower::{Instructions, Restarted};
pub use parts::{FirstNumbers, PartKind, PartText, read_parts};
pub(crate) use program::read;
pub use scope::{Edge, Enumeration, Known, Parameter, ParameterRole, Scope, Shape, Structure, Type};
use tree::{Statement, StatementKind};
pub use undeclared::{names_in_scl, undeclared};

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
    /// What begins again at each call.
    pub restarted: &'s [Restarted],
    /// What makes blocks of the other system's own instructions, where it has any.
    pub instructions: Option<&'s Instructions<'s>>,
    /// The number of the first origin.
    pub first_origin: u32,
    /// Labels have higher numbers than this: those of the other bodies that are part of one.
    pub first_label: u32,
}

/// Reads the statements of a body. `names` has the names of the unit's tags; unread parts are added to the others. `line` is the line
/// of a byte, for a message.
///
/// # Errors
///
/// Why it is unread as a whole: it does not parse, or a statement without a counterpart may leave it.
pub fn read_body(
    source: &Source<'_>,
    names: &mut Names,
    unread: &mut UnreadParts,
    line: impl Fn(usize) -> u32,
) -> Result<Body, String> {
    let (statements, comments, problems) = units::body(source.text, source.dialect);
    if let Some(problem) = problems.first() {
        return Err(problem.in_words(line(problem.span.start)));
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
        first_label: source.first_label,
    };
    let mut body = lower::lower(&statements, &around, source.restarted, names, unread);
    body.unread.take().map_or(Ok(body), Err)
}

/// Whether statements parse.
pub fn parses(text: &str, dialect: Dialect) -> bool {
    units::body(text, dialect).2.is_empty()
}

/// The statements of a text that call something by its name alone, without operands: `Clear()`. Where each is, in bytes, and the name.
pub fn bare_calls(text: &str, dialect: Dialect) -> Vec<(std::ops::Range<usize>, String)> {
    let mut calls = Vec::new();
    add_bare_calls(&units::body(text, dialect).0, &mut calls);
    calls
}

fn add_bare_calls(statements: &[Statement], calls: &mut Vec<(std::ops::Range<usize>, String)>) {
    for Statement { kind, span } in statements {
        match kind {
            StatementKind::Call(call) if call.callee.steps.is_empty() && call.arguments.is_empty() => {
                calls.push((span.clone(), call.callee.root.clone()));
            }
            StatementKind::If(branches, otherwise) => {
                let bodies = branches.iter().map(|(_, body)| body).chain([otherwise]);
                bodies.for_each(|body| add_bare_calls(body, calls));
            }
            StatementKind::Case(_, arms, otherwise) => {
                let bodies = arms.iter().map(|arm| &arm.body).chain([otherwise]);
                bodies.for_each(|body| add_bare_calls(body, calls));
            }
            StatementKind::For(counting) => add_bare_calls(&counting.body, calls),
            StatementKind::While(_, body) | StatementKind::Repeat(body, _) => add_bare_calls(body, calls),
            _ => {}
        }
    }
}

/// A unit of a file, as it is written there.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitText {
    /// From its first word to the end of its variables, in bytes.
    pub head: std::ops::Range<usize>,
    /// What is between that and the word that ends it.
    pub body: std::ops::Range<usize>,
    /// The comment directly above it.
    pub comment: Option<String>,
}

/// The units of a file.
///
/// # Errors
///
/// What of one is not read: what does not parse, and methods.
pub fn unit_texts(text: &str) -> Result<Vec<UnitText>, String> {
    let (file, _) = units::file(text, Dialect::Iec);
    let lines = Lines::of(text);
    let texts = file.units.into_iter().map(|unit| {
        if let Some(problem) = unit.problems.first() {
            return Err(problem.in_words(lines.place(text, problem.span.start).line));
        }
        if let Some((_, method)) = unit.methods.first() {
            return Err(format!(
                "`{method}` of {} is a method, which is not read",
                unit.name
            ));
        }
        Ok(UnitText {
            head: unit.span.start..unit.text_span.start,
            body: unit.text_span,
            comment: unit.comment.map(|comment| lower::comment_of(comment.trim())),
        })
    });
    texts.collect()
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

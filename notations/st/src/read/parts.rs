//! The texts of a chart, or of the boxes of a drawing, in a file of another notation.

use super::cursor::{Cursor, Parsed};
use super::lower::{Piece, Surroundings, What, leaves, lower_pieces};
use super::token::Comment;
use super::tree::{Expression, Problem, Statement};
use super::{Body, Dialect, Scope, units};
use ladder_notation::{Lines, Names, UnreadParts};

/// A text of a chart or a drawing.
#[derive(Debug, Clone, Copy)]
pub struct PartText<'t> {
    /// What it says; places are bytes of it.
    pub text: &'t str,
    /// What it is.
    pub kind: PartKind,
}

/// What such a text is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartKind {
    /// The statements of an action.
    Statements,
    /// The statements of a box, which end where the box does.
    Enclosed,
    /// The condition of a transition: `a AND b`, `:= a AND b;`, `Go := a AND b;`.
    Condition,
}

enum Read {
    Statements(Vec<Statement>),
    Condition(Expression),
}

/// What the numbers of some texts begin with.
#[derive(Debug, Clone, Copy, Default)]
pub struct FirstNumbers {
    /// The number of the first origin, through all of them.
    pub origin: u32,
    /// Labels have higher numbers than this.
    pub label: u32,
}

/// Reads such texts, each as a body; the last network of a condition has power if it holds. The tags that they need are
/// those of the first.
///
/// # Errors
///
/// Which text cannot be read, by its number; and why.
pub fn read_parts(
    (parts, dialect): (&[PartText<'_>], Dialect),
    (unit, scope): (&str, &Scope),
    first: FirstNumbers,
    names: &mut Names,
    unread: &mut UnreadParts,
) -> Result<Vec<Body>, (Option<usize>, String)> {
    let mut all = Vec::new();
    for (number, part) in parts.iter().enumerate() {
        let (read, comments, problems) = match part.kind {
            PartKind::Statements | PartKind::Enclosed => {
                let (statements, comments, problems) = units::body(part.text, dialect);
                (Some(Read::Statements(statements)), comments, problems)
            }
            PartKind::Condition => condition(part.text, dialect),
        };
        let lines = Lines::of(part.text);
        if let Some(problem) = problems.first() {
            let line = lines.place(part.text, problem.span.start).line;
            return Err((Some(number), problem.in_words(line)));
        }
        if let (PartKind::Enclosed, Some(Read::Statements(statements))) = (part.kind, &read)
            && leaves(statements)
        {
            return Err((
                Some(number),
                "a RETURN, EXIT or GOTO may leave the text of a box".to_owned(),
            ));
        }
        all.extend(read.map(|read| (read, comments, lines)));
    }
    let around: Vec<Surroundings<'_>> = all
        .iter()
        .zip(parts)
        .map(|((_, comments, lines), part)| Surroundings {
            text: part.text,
            lines,
            dialect,
            unit,
            scope,
            comments,
            instructions: None,
            first_origin: first.origin,
            first_label: first.label,
        })
        .collect();
    let pieces: Vec<Piece<'_>> = all
        .iter()
        .zip(&around)
        .map(|((read, ..), around)| Piece {
            around,
            what: match read {
                Read::Statements(statements) => What::Statements(statements),
                Read::Condition(condition) => What::Condition(condition),
            },
        })
        .collect();
    lower_pieces(&pieces, names, unread).map_err(|why| (None, why))
}

fn condition(text: &str, dialect: Dialect) -> (Option<Read>, Vec<Comment>, Vec<Problem>) {
    let mut cursor = Cursor::new(text, dialect);
    let read = cursor.condition_alone();
    let read = read.ok().map(Read::Condition);
    (read, cursor.found.comments, cursor.problems)
}

impl Cursor<'_> {
    /// A condition, with what may be around it where it is the whole text.
    fn condition_alone(&mut self) -> Parsed<Expression> {
        if self.ahead(1).1 == ":=" {
            self.name()?;
        }
        self.take_sign(":=");
        let condition = self.expression()?;
        while self.take_sign(";") {}
        if !self.is_at_end() {
            return self.expected("the end of the condition");
        }
        Ok(condition)
    }
}
